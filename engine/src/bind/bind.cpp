// SPDX-License-Identifier: MIT
// Runs the stages of a bind: those before the network (pipeline.cpp), the network, and the rows (weights/finish.cpp).
#include "bind/bind.hpp"

#include "bind/progress.hpp"
#include "kernels/select.hpp"

namespace sinew {
namespace {

sinew_status run_stages(const BindPlan& plan, const sinew_mesh& mesh, const sinew_skeleton& skeleton,
                        const Kernels& kernels, const Progress& progress, Arena& arena, sinew_bind_outputs* outputs) {
  PreparedBind p;
  sinew_status status =
      prepare(mesh, skeleton, plan.up_axis, plan.counts, plan.purpose(), kernels, progress, arena, &p);
  if (status != SINEW_OK) return status;

  const bool edits = plan.rows.edits_rows();
  int16_t* logits = nullptr;
  if (plan.with_network) {
    const Counts surface = plan.counts.surface();
    logits = arena.alloc<int16_t>(static_cast<size_t>(surface.vertices) * surface.candidates);
    if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
    const NetworkInput input = arena.measuring() ? largest_network_input(surface) : network_input(p, surface);
    const uint32_t end = edits ? ends_at::kNetworkBeforeEdits : ends_at::kNetwork;
    status =
        run_network(plan.model, input, kernels, progress.part(ends_at::kSpectral, end), arena, logits, plan.network);
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
                                 plan.with_network ? &plan.model : nullptr,
                                 p.part_owners};
  EditedRows edited;
  if (edits) {
    if (!edited.allocate(arena, plan.counts, plan.rows)) return SINEW_ERROR_WORKSPACE;
    status = edit_rows(prediction, plan.rows, plan.counts, outputs->joint_indices, outputs->weights,
                       progress.part(ends_at::kNetworkBeforeEdits, ends_at::kEdits), arena, &edited);
    if (status != SINEW_OK) return status;
  }
  if (arena.measuring()) return SINEW_OK;
  if (!progress.report(ends_at::kRows)) return SINEW_ERROR_CANCELLED;
  write_rows(prediction, plan.rows, edited, plan.counts.threads, outputs);
  return SINEW_OK;
}

}  // namespace

void measure_bind(Arena& arena, const BindPlan& plan) {
  sinew_bind_outputs nowhere = {};
  (void)run_stages(plan, {}, {}, Kernels(), Progress(), arena, &nowhere);
}

sinew_status run_bind(const BindPlan& plan, const sinew_mesh& mesh, const sinew_skeleton& skeleton, void* workspace,
                      size_t workspace_bytes, sinew_bind_outputs* outputs) {
  Kernels kernels;
  if (!select_kernels(plan.kernel, &kernels)) return SINEW_ERROR_KERNEL;
  sinew_status status =
      check_given_rows(plan.rows, plan.counts.vertices, skeleton.joint_count, outputs->joint_indices, outputs->weights);
  if (status == SINEW_OK && kHasExtras) status = check_answers(plan.rows, plan.counts.vertices, skeleton);
  if (status != SINEW_OK) return status;
  Arena arena(workspace, workspace_bytes);
  status = run_stages(plan, mesh, skeleton, kernels, plan.progress, arena, outputs);
  if (status == SINEW_OK) outputs->used_bytes = arena.high_water();
  return status;
}

}  // namespace sinew
