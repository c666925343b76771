// SPDX-License-Identifier: MIT
// Checks the options, then runs the stages: those before the network (pipeline.cpp), the network, and the rows
// (weights/finish.cpp).
#include "bind/bind.hpp"

#include <stddef.h>

#include "bind/progress.hpp"
#include "core/build.hpp"
#include "core/struct_size.hpp"
#include "kernels/select.hpp"
#include "model/task.hpp"
#include "sinew/published.h"

namespace sinew {
namespace {

// sinew_bind_options of the first release, 0.1.
constexpr uint32_t kFirstOptionsSize = offsetof(sinew_bind_options, progress_user) + sizeof(void*);

uint32_t or_default(uint32_t value, uint32_t fallback) { return value != 0 ? value : fallback; }

// 0 represents the default wherever an option has one.
bool is_default_or_in(uint32_t value, uint32_t least, uint32_t most) {
  return value == 0 || (value >= least && value <= most);
}

// Checks the options without the model and the counts.
sinew_status check_options(const sinew_bind_options& o) {
  if (o.symmetric > 1 || o.method > SINEW_METHOD_DISTANCE || o.influence_count > SINEW_MAX_INFLUENCES ||
      o.weights_in_place > 1 || o.thread_count > SINEW_MAX_THREADS || kernel_name(o.kernel) == nullptr ||
      o.weight_format > SINEW_WEIGHT_FLOAT || o.rigid_parts > SINEW_RIGID_PARTS_NEVER ||
      !is_default_or_in(o.surface_vertices, 16, SINEW_MAX_VERTICES) || !is_default_or_in(o.softness_percent, 25, 400) ||
      o.answer_count > SINEW_MAX_QUESTIONS || o.question_count > SINEW_MAX_QUESTIONS ||
      (o.answer_count > 0 && o.answers == nullptr)) {
    return SINEW_ERROR_ARGUMENT;
  }
  if (o.reserved != 0) return SINEW_ERROR_VERSION;
  if (o.method == SINEW_METHOD_DISTANCE && !(kHasExtras && has_published_methods())) return SINEW_ERROR_NOT_BUILT;
  if (!kHasExtras && (o.hints != nullptr || o.symmetric != 0 || o.rigid_parts != SINEW_RIGID_PARTS_AUTO ||
                      o.surface_vertices != 0 || o.answer_count != 0 || o.question_count != 0)) {
    return SINEW_ERROR_NOT_BUILT;
  }
  return SINEW_OK;
}

RowOptions row_options(const sinew_bind_options& o) {
  RowOptions rows;
  rows.influence_count = or_default(o.influence_count, 4);
  rows.weight_format = o.weight_format;
  rows.rigid_parts = o.rigid_parts;
  rows.softness_percent = or_default(o.softness_percent, 100);
  rows.symmetric = o.symmetric != 0;
  rows.locked = o.locked;
  rows.hints = o.hints;
  rows.answers = o.answers;
  rows.answer_count = o.answer_count;
  rows.question_count = o.question_count;
  return rows;
}

}  // namespace

bool bind_task(uint32_t feature_set, ModelTask* task) {
  if ((feature_set & ~kFeatureFlags) != kFeatureSet) return false;
  if (kHasExtras && (feature_set & kAttributesFlag) != 0 && !has_published_methods()) return false;
  *task = ModelTask();
  task->id = kTaskBind;
  task->input_count = 2;
  task->inputs[kVertexInput] = {input_name("vert"),
                                {Domain::kVertex, static_cast<uint16_t>(vertex_channels(feature_set))}};
  task->inputs[kPairInput] = {input_name("pair"), {Domain::kPair, static_cast<uint16_t>(pair_channels(feature_set))}};
  task->output = {Domain::kPair, 1};
  return true;
}

sinew_status plan_bind(const sinew_model* model, uint32_t vertices, uint32_t faces, uint32_t corners, uint32_t joints,
                       const sinew_bind_options* options, BindPlan* plan) {
  sinew_bind_options o = SINEW_INIT(sinew_bind_options);
  sinew_status status = options == nullptr ? SINEW_OK : read_struct(options, kFirstOptionsSize, sizeof o, &o);
  if (status == SINEW_OK) status = check_options(o);
  if (status != SINEW_OK) return status;
  plan->with_network = o.method == SINEW_METHOD_MODEL;
  plan->by_distance = o.method == SINEW_METHOD_DISTANCE;
  uint32_t candidates = or_default(o.candidate_count, 8), grid = or_default(o.grid_size, 64), feature_flags = 0;
  if (plan->with_network) {
    if (model == nullptr || model->bytes == nullptr) return SINEW_ERROR_ARGUMENT;
    if (model->task != kTaskBind) return SINEW_ERROR_MODEL_TASK;
    plan->model = *model;
    candidates = or_default(o.candidate_count, model->candidate_count);
    grid = or_default(o.grid_size, model->grid_size);
    feature_flags = model->feature_set & kFeatureFlags;
    if (model->fixed_candidates != 0 && candidates != model->candidate_count) return SINEW_ERROR_ARGUMENT;
  }
  status = make_counts(vertices, faces, corners, joints, candidates, grid, &plan->counts);
  plan->counts.feature_flags = feature_flags;
  plan->counts.surface_vertices = or_default(o.surface_vertices, kSurfaceVertices);
  plan->counts.threads = Threads{or_default(o.thread_count, 1), o.parallel_for, o.parallel_user};
  plan->network = NetworkOptions();
  // The size query does not ask the processor: packed weights have room wherever the caller does not rule them out.
  plan->network.weights_in_place = o.weights_in_place != 0 || o.kernel == SINEW_KERNEL_REF;
  plan->kernel = o.kernel;
  plan->up_axis = 0;
  plan->rows = row_options(o);
  plan->progress = Progress{o.progress, o.progress_user};
  return status;
}

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
