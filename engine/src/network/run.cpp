// SPDX-License-Identifier: MIT
// The memory of a stage, and which rows it has to load.
#include "network/run.hpp"

namespace sinew::network {
namespace {

// Marks what a stage reads from a region row by row.
void mark_loads(const NetworkPlan& plan, uint32_t stage, uint32_t reader, const Region& region, StageScratch* scratch,
                bool* touched) {
  touched[region.buffer] = true;
  for (uint32_t channel = region.offset; channel < region_end(region);) {
    const Segment segment = segment_at(plan.layers, plan.input_count, reader, region, channel);
    if (segment.producer == kFromInput) {
      scratch->load_input[region.buffer] = true;
    } else if (plan.stage[segment.producer] < stage) {
      scratch->load[segment.producer] = true;
    }
    channel += segment.count;
  }
}

}  // namespace

uint64_t table_values(const NetworkPlan& plan, const Layer& layer, const Sizes& sizes) {
  const bool by_joint = by_part(layer.kind) && has_slots(plan.buffers[layer.in.buffer].domain);
  return static_cast<uint64_t>(layer.in.channels) * (by_joint ? sizes.joints : 1u);
}

int16_t* allocate_storage(const NetworkPlan& plan, const Sizes& sizes, Arena& arena) {
  return arena.alloc<int16_t>(checked(plan.store_values * sizes.vertices));
}

bool allocate_stage(const NetworkPlan& plan, const ModelTables& tables, const NetworkOptions& options, uint32_t stage,
                    const Sizes& sizes, Arena& arena, StageScratch* scratch) {
  bool touched[kMaxBuffers] = {};
  for (uint32_t i = 0; i < kMaxLayers; ++i) scratch->load[i] = false;
  for (uint32_t i = 0; i < kMaxInputs; ++i) scratch->load_input[i] = false;
  uint64_t sums = 0, joint_sums = 0;
  for (uint32_t i = 0; i < plan.layer_count; ++i) {
    scratch->table[i] = nullptr;
    if (plan.stage[i] != stage) continue;
    const Layer& layer = plan.layers[i];
    touched[layer.out.buffer] = true;
    if (!reads_other_rows(layer.kind)) mark_loads(plan, stage, i, layer.in, scratch, touched);
    if ((layer.flags & kLayerResidual) != 0) mark_loads(plan, stage, i, layer.residual, scratch, touched);
    if (uses_table(layer.kind)) {
      const uint64_t values = table_values(plan, layer, sizes);
      scratch->table[i] = arena.alloc<int16_t>(checked(values * sizes.lanes));
      if (values > sums) sums = values;
    }
    if (kHasPackedWeights && layer.kind == LayerKind::kLinear && wants_packed(options)) {
      const LinearRecord record = tables.linear(layer.parameters);
      scratch->joint_sums[i] = checked(joint_sums);
      if (find_shared_columns(plan, i, record).by_joint.count > 0) {
        joint_sums += static_cast<uint64_t>(sizes.joints) * padded_outputs(record.out);
      }
    }
  }
  if (joint_sums / 2 > sums) sums = joint_sums / 2;  // padded_outputs() is even
  scratch->sums = arena.alloc<int64_t>(checked(sums * sizes.lanes));
  scratch->lane_sums = sums;
  for (uint32_t b = 0; b < plan.buffer_count; ++b) {
    scratch->tile[b] = nullptr;
    if (!touched[b]) continue;
    scratch->tile[b] = arena.alloc<int16_t>(
        checked(sizes.tile_vertices() * plan.slots(static_cast<uint16_t>(b)) * plan.buffers[b].channels));
  }
  scratch->vertices = arena.alloc<uint32_t>(checked(sizes.tile_vertices()));
  scratch->joints = arena.alloc<uint16_t>(checked(sizes.tile_vertices() * plan.candidates));
  return arena.ok();
}

}  // namespace sinew::network
