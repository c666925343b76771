// SPDX-License-Identifier: MIT
// Shared columns of linear layers: every column is in one range, and those that are shared hold the same in all slots.
#include "network/packed_layers.hpp"

#include "model/regions.hpp"
#include "network_fixture_model.hpp"

namespace sinew::test {
namespace {

TEST(PackedLayers, EveryColumnIsInOneRange) {
  const OpenedModel opened = field_model(8);
  const ModelTables tables(opened.model.bytes);
  size_t shared = 0, by_joint = 0;
  for (uint32_t i = 0; i < opened.plan.layer_count; ++i) {
    const Layer& layer = opened.plan.layers[i];
    if (!has_weights(layer.kind)) continue;
    const SharedColumns columns = find_shared_columns(opened.plan, i, tables.linear(layer.parameters));
    if (!columns.any()) continue;
    std::vector<int> met(layer.in.channels, 0);
    const auto count = [&](const ColumnRange& range) {
      for (uint32_t c = range.first; c < uint32_t{range.first} + range.count; ++c) ++met.at(c);
    };
    for (uint8_t r = 0; r < columns.own_count; ++r) count(columns.own[r]);
    for (uint8_t r = 0; r < columns.shared_count; ++r) {
      count(columns.shared[r]);
      for (uint32_t c = columns.shared[r].first; c < uint32_t{columns.shared[r].first} + columns.shared[r].count; ++c) {
        const Segment segment =
            segment_at(opened.plan.layers, opened.plan.input_count, i, layer.in, layer.in.offset + c);
        ASSERT_GE(segment.producer, 0);
        EXPECT_TRUE(traits_of(opened.plan.layers[segment.producer].kind).same_in_all_slots);
      }
    }
    count(columns.by_joint);
    for (size_t c = 0; c < met.size(); ++c) EXPECT_EQ(met[c], 1) << "layer " << i << " column " << c;
    shared += columns.shared_count;
    by_joint += columns.by_joint.count > 0;
  }
  EXPECT_GT(shared, 0u);
  EXPECT_GT(by_joint, 0u);
}

TEST(PackedLayers, NothingIsSharedOverVertices) {
  const FloatNetwork network = classic_like(4, 4, 12);
  const Graph g = random_graph(5, 60, 4, 20, 4, usual_feature);
  const OpenedModel opened(quantize(network, {run_float(network, g).layer_max}).bytes);
  const ModelTables tables(opened.model.bytes);
  for (uint32_t i = 0; i < opened.plan.layer_count; ++i) {
    const Layer& layer = opened.plan.layers[i];
    if (!has_weights(layer.kind) || has_slots(opened.plan.buffers[layer.in.buffer].domain)) continue;
    EXPECT_FALSE(find_shared_columns(opened.plan, i, tables.linear(layer.parameters)).any());
  }
}

}  // namespace
}  // namespace sinew::test
