// SPDX-License-Identifier: MIT
// Runs the stages of a bind: those before the network (pipeline.cpp), the network, and the rows (weights/finish.cpp).
#include "bind/bind.hpp"

#include "bind/progress.hpp"
#include "kernels/select.hpp"

namespace sinew {
namespace {

int16_t* allocate_logits(Arena& arena, const Counts& counts) {
  return arena.alloc<int16_t>(static_cast<size_t>(counts.vertices) * counts.candidates);
}

}  // namespace

void measure_bind(Arena& arena, const BindPlan& plan) {
  measure_prepare(arena, plan.counts, plan.purpose());
  if (plan.with_network) {
    (void)allocate_logits(arena, plan.counts.surface());
    measure_run_network(arena, plan.model, plan.counts.surface(), plan.network);
  }
  if (!plan.rows.edits_rows()) return;
  (void)EditedRows().allocate(arena, plan.counts, plan.rows);
  measure_edit_rows(arena, plan.counts, plan.rows);
}

sinew_status run_bind(const BindPlan& plan, const sinew_mesh& mesh, const sinew_skeleton& skeleton, void* workspace,
                      size_t workspace_bytes, sinew_bind_outputs* outputs) {
  const uint16_t* const joints = outputs->joint_indices;
  const void* const weights = outputs->weights;
  Kernels kernels;
  if (!select_kernels(plan.kernel, &kernels)) return SINEW_ERROR_KERNEL;
  sinew_status status = check_given_rows(plan.rows, plan.counts.vertices, skeleton.joint_count, joints, weights);
  if (status != SINEW_OK) return status;
  Arena arena(workspace, workspace_bytes);
  Prepared p;
  status = prepare(mesh, skeleton, plan.up_axis, plan.counts, plan.purpose(), kernels, plan.progress, arena, &p);
  if (status != SINEW_OK) return status;

  int16_t* logits = nullptr;
  if (plan.with_network) {
    logits = allocate_logits(arena, plan.counts.surface());
    if (logits == nullptr) return SINEW_ERROR_WORKSPACE;
    const NetworkInput input = network_input(p, plan.counts);
    const uint32_t end = plan.rows.edits_rows() ? ends_at::kNetworkBeforeEdits : ends_at::kNetwork;
    const Progress network_progress = plan.progress.part(ends_at::kSpectral, end);
    status = run_network(plan.model, input, kernels, network_progress, arena, logits, plan.network);
    if (status != SINEW_OK) return status;
  }
  const Prediction prediction = {p.mesh,
                                 p.surface(),
                                 p.reduction,
                                 p.skeleton,
                                 p.heat.field[kFieldRule],
                                 logits,
                                 p.features.joints,
                                 plan.counts.candidates,
                                 kernels.softmax,
                                 plan.with_network ? &plan.model : nullptr};
  EditedRows edited;
  if (plan.rows.edits_rows()) {
    if (!edited.allocate(arena, plan.counts, plan.rows)) return SINEW_ERROR_WORKSPACE;
    const Progress edit_progress = plan.progress.part(ends_at::kNetworkBeforeEdits, ends_at::kEdits);
    status = edit_rows(prediction, plan.rows, plan.counts, joints, weights, edit_progress, arena, &edited);
    if (status != SINEW_OK) return status;
  }
  if (!plan.progress.report(ends_at::kRows)) return SINEW_ERROR_CANCELLED;
  write_rows(prediction, plan.rows, edited, plan.counts.threads, outputs);
  outputs->used_bytes = arena.high_water();
  return SINEW_OK;
}

}  // namespace sinew
