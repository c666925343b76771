// SPDX-License-Identifier: MIT
// Checks the caller's options and fills in their defaults.
#include "bind/plan.hpp"

#include <stddef.h>

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

// 0 stands for the default wherever an option has one.
bool is_default_or_in(uint32_t value, uint32_t least, uint32_t most) {
  return value == 0 || (value >= least && value <= most);
}

// What can be said of the options without the model and the counts.
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

}  // namespace sinew
