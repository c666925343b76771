// SPDX-License-Identifier: MIT
// Stages and storage of a model: what is read is there, and outputs that live at the same time share no memory.
#include "network/plan.hpp"

#include "model/regions.hpp"
#include "network_fixture_model.hpp"

namespace sinew::test {
namespace {

// Calls visit(producer, whether all of its rows are read at once).
template <class Visit>
void each_read(const NetworkPlan& plan, uint32_t reader, Visit visit) {
  const Layer& layer = plan.layers[reader];
  for (const Region& region : {layer.in, layer.residual})
    for (uint32_t channel = region.offset; channel < region_end(region);) {
      const Segment segment = segment_at(plan.layers, plan.input_count, reader, region, channel);
      if (segment.producer >= 0)
        visit(static_cast<uint32_t>(segment.producer),
              reads_other_rows(layer.kind) && region.offset == layer.in.offset && region.buffer == layer.in.buffer);
      channel += segment.count;
    }
}

TEST(NetworkPlan, ALayerReadsWhatItsStageOrAnEarlierOneMade) {
  for (uint32_t seed = 1; seed <= 60; ++seed) {
    const OpenedModel opened(write_model(random_model(seed, 1 + seed % 9)));
    const NetworkPlan& plan = opened.plan;
    for (uint32_t i = 0; i < plan.layer_count; ++i) {
      EXPECT_LT(plan.stage[i], plan.stage_count);
      each_read(plan, i, [&](uint32_t producer, bool all_rows) {
        EXPECT_LE(plan.stage[producer] + (all_rows ? 1 : 0), plan.stage[i]) << "seed " << seed << " layer " << i;
        EXPECT_GE(plan.last_use[producer], plan.stage[i]);
        EXPECT_TRUE(plan.stored[producer] || plan.stage[producer] == plan.stage[i]) << seed;
      });
    }
  }
}

TEST(NetworkPlan, StoredOutputsThatLiveTogetherLieApart) {
  size_t shared = 0;
  for (uint32_t seed = 1; seed <= 60; ++seed) {
    const OpenedModel opened(write_model(random_model(seed, 1 + seed % 9)));
    const NetworkPlan& plan = opened.plan;
    const auto size_of = [&](uint32_t i) {
      return uint64_t{plan.layers[i].out.channels} * plan.slots(plan.layers[i].out.buffer);
    };
    for (uint32_t a = 0; a < plan.layer_count; ++a) {
      if (!plan.stored[a]) continue;
      EXPECT_LE(plan.store_offset[a] + size_of(a), plan.store_values);
      for (uint32_t b = 0; b < a; ++b) {
        if (!plan.stored[b]) continue;
        const bool together = plan.stage[a] <= plan.last_use[b] && plan.stage[b] <= plan.last_use[a];
        const bool apart = plan.store_offset[a] >= plan.store_offset[b] + size_of(b) ||
                           plan.store_offset[b] >= plan.store_offset[a] + size_of(a);
        EXPECT_TRUE(apart || !together) << "seed " << seed << " layers " << a << " and " << b;
        shared += !apart;
      }
    }
  }
  EXPECT_GT(shared, 0u) << "memory is used again";
}

}  // namespace
}  // namespace sinew::test
