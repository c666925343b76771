// SPDX-License-Identifier: MIT
// Runs the stages, the network, and writes influences in the caller's order. Nothing is written before nothing can
// fail.
#include "bind/bind.hpp"

#include "network/network.hpp"
#include "weights/influences.hpp"

namespace sinew {
namespace {

uint32_t or_default(uint32_t value, uint32_t fallback) { return value != 0 ? value : fallback; }

struct Logits {
  int16_t* values = nullptr;  // [U x K] log2 units, Q10

  bool allocate(Arena& arena, const Counts& counts) {
    values = arena.alloc<int16_t>(static_cast<size_t>(counts.vertices) * counts.candidates);
    return arena.ok();
  }
};

// One row of the result in the welded vertex' terms.
void welded_row(const BindPlan& plan, const Prepared& p, const Logits& logits, uint32_t vertex, uint32_t total,
                uint16_t* joints, uint16_t* weights) {
  uint32_t wide[SINEW_MAX_CANDIDATES > kHeatSlots ? SINEW_MAX_CANDIDATES : kHeatSlots] = {};
  if (plan.purpose == PrepareFor::kHeat) {
    uint16_t row_joints[kHeatSlots], row_weights[kHeatSlots];
    const uint32_t count = finish_heat_row(p.heat.field[kFieldRule], vertex, row_joints, row_weights);
    for (uint32_t i = 0; i < count; ++i) wide[i] = row_weights[i];
    keep_largest(row_joints, wide, count, plan.influence_count, total, joints, weights);
    return;
  }
  const uint32_t k = plan.counts.candidates;
  const uint16_t* candidates = p.features.joints + static_cast<size_t>(vertex) * k;
  softmax_q16(logits.values + static_cast<size_t>(vertex) * k, candidates, k, wide);
  prune_q16(wide, k);
  keep_largest(candidates, wide, k, plan.influence_count, total, joints, weights);
}

sinew_status check_locked(const BindPlan& plan, const uint16_t* joints, uint32_t joint_count) {
  if (plan.locked == nullptr) return SINEW_OK;
  for (uint32_t v = 0; v < plan.counts.vertices; ++v) {
    if (plan.locked[v] == 0) continue;
    for (uint32_t i = 0; i < plan.influence_count; ++i) {
      if (joints[static_cast<size_t>(v) * plan.influence_count + i] >= joint_count) return SINEW_ERROR_RANGE;
    }
  }
  return SINEW_OK;
}

void write_rows(const BindPlan& plan, const Prepared& p, const Logits& logits, uint16_t* joints, void* weights) {
  const uint32_t n = plan.influence_count;
  const uint32_t total = plan.weight_format == SINEW_WEIGHT_UNORM8 ? 255u : 65535u;
  for (uint32_t v = 0; v < p.mesh.vertex_count; ++v) {
    if (plan.locked != nullptr && plan.locked[v] != 0) continue;
    const size_t first = static_cast<size_t>(v) * n;
    uint16_t row[SINEW_MAX_INFLUENCES];
    welded_row(plan, p, logits, p.mesh.vertex_to_welded[v], total, joints + first, row);
    for (uint32_t i = 0; i < n; ++i) {
      switch (plan.weight_format) {
        case SINEW_WEIGHT_UNORM8:
          static_cast<uint8_t*>(weights)[first + i] = static_cast<uint8_t>(row[i]);
          break;
        case SINEW_WEIGHT_UNORM16:
          static_cast<uint16_t*>(weights)[first + i] = row[i];
          break;
        // One correctly rounded IEEE division: the same on every target.
        default:
          static_cast<float*>(weights)[first + i] = static_cast<float>(row[i]) / 65535.0f;
          break;
      }
    }
  }
}

}  // namespace

sinew_status plan_bind(const sinew_model* model, uint32_t vertices, uint32_t faces, uint32_t corners, uint32_t joints,
                       const sinew_options* options, BindPlan* plan) {
  const sinew_options defaults = {};
  const sinew_options& o = options != nullptr ? *options : defaults;
  if (o.version != 0 || o.reserved != 0 || o.method > SINEW_METHOD_HEAT || o.influence_count > SINEW_MAX_INFLUENCES ||
      o.up_axis > 1 || o.weight_format > SINEW_WEIGHT_FLOAT) {
    return SINEW_ERROR_ARGUMENT;
  }
  plan->purpose = o.method == SINEW_METHOD_HEAT ? PrepareFor::kHeat : PrepareFor::kNetwork;
  uint32_t candidates = or_default(o.candidate_count, 8), grid = or_default(o.grid_size, 64);
  if (plan->purpose == PrepareFor::kNetwork) {
    if (model == nullptr || model->bytes == nullptr) return SINEW_ERROR_ARGUMENT;
    plan->model = *model;
    candidates = or_default(o.candidate_count, model->candidate_count);
    grid = or_default(o.grid_size, model->grid_size);
    if (model->fixed_candidates != 0 && candidates != model->candidate_count) return SINEW_ERROR_ARGUMENT;
  }
  plan->influence_count = or_default(o.influence_count, 4);
  plan->up_axis = o.up_axis;
  plan->weight_format = o.weight_format;
  plan->locked = o.locked;
  plan->progress = Progress{o.progress, o.progress_user};
  return make_counts(vertices, faces, corners, joints, candidates, grid, &plan->counts);
}

void measure_bind(Arena& arena, const BindPlan& plan) {
  measure_prepare(arena, plan.counts, plan.purpose);
  if (plan.purpose == PrepareFor::kHeat) return;
  Logits().allocate(arena, plan.counts);
  measure_run_network(arena, plan.model, plan.counts);
}

sinew_status run_bind(const BindPlan& plan, const sinew_mesh& mesh, const sinew_skeleton& skeleton, void* workspace,
                      size_t workspace_bytes, uint16_t* joints, void* weights, size_t* used_bytes) {
  sinew_status status = check_locked(plan, joints, skeleton.joint_count);
  if (status != SINEW_OK) return status;
  Arena arena(workspace, workspace_bytes);
  Prepared p;
  status = prepare(mesh, skeleton, plan.up_axis, plan.counts, plan.purpose, plan.progress, arena, &p);
  if (status != SINEW_OK) return status;

  Logits logits;
  if (plan.purpose == PrepareFor::kNetwork) {
    if (!logits.allocate(arena, plan.counts)) return SINEW_ERROR_WORKSPACE;
    NetworkInput input;
    input.vertex_count = p.mesh.welded_count;
    input.candidate_count = plan.counts.candidates;
    input.vertex_features = p.features.vertex;
    input.pair_features = p.features.pair;
    input.joints = p.features.joints;
    input.row_offsets = p.mesh.row_offsets;
    input.col_indices = p.mesh.col_indices;
    input.component = p.mesh.component;
    input.component_offsets = p.mesh.component_offsets;
    input.component_vertices = p.mesh.component_vertices;
    input.component_count = p.mesh.component_count;
    input.joint_count = p.skeleton.joint_count;
    status = run_network(plan.model, input, plan.progress.part(650, 990), arena, logits.values);
    if (status != SINEW_OK) return status;
  }
  if (!plan.progress.report(1000)) return SINEW_ERROR_CANCELLED;
  write_rows(plan, p, logits, joints, weights);
  if (used_bytes != nullptr) *used_bytes = arena.high_water();
  return SINEW_OK;
}

}  // namespace sinew
