// SPDX-License-Identifier: MIT
// Checks the caller's options and plans the binds.
#include "transfer/plan.hpp"

#include <stddef.h>

#include "core/build.hpp"
#include "core/read_skeleton.hpp"
#include "core/struct_size.hpp"
#include "kernels/select.hpp"
#include "sinew/published.h"

namespace sinew::transferring {
namespace {

// The struct of the first release, 0.1.
constexpr uint32_t kFirstOptionsSize = offsetof(sinew_transfer_options, progress_user) + sizeof(void*);

sinew_status check_options(const sinew_transfer_options& o) {
  if (o.method > SINEW_TRANSFER_REBIND || o.influence_count > SINEW_MAX_INFLUENCES ||
      o.weight_format > SINEW_WEIGHT_FLOAT || o.garment > 1 || o.as_drawn > 1 || o.weights_in_place > 1 ||
      kernel_name(o.kernel) == nullptr || o.thread_count > SINEW_MAX_THREADS ||
      o.pair_count > SINEW_MAX_TRANSFER_PAIRS || (o.pair_count > 0 && o.pairs == nullptr)) {
    return SINEW_ERROR_ARGUMENT;
  }
  if (o.method == SINEW_TRANSFER_BIHARMONIC && !has_published_methods()) return SINEW_ERROR_NOT_BUILT;
  return o.garment != 0 && o.method == SINEW_TRANSFER_BIHARMONIC ? SINEW_ERROR_ARGUMENT : SINEW_OK;
}

}  // namespace

sinew_status plan_transfer(const sinew_model* model, const TransferInput& input, const sinew_transfer_options* options,
                           TransferPlan* plan) {
  sinew_transfer_options o = SINEW_INIT(sinew_transfer_options);
  sinew_status status = options == nullptr ? SINEW_OK : read_struct(options, kFirstOptionsSize, sizeof o, &o);
  if (status == SINEW_OK) status = check_options(o);
  if (status == SINEW_OK) status = read_up_axis(input.skeleton.up, &plan->up_axis);
  if (status == SINEW_OK) status = read_up_axis(input.source.skeleton->up, &plan->source_up_axis);
  if (status != SINEW_OK) return status;
  const sinew_mesh& source = *input.source.mesh;
  const sinew_mesh& target = input.target;
  const sinew_skin& skin = input.source.skin;
  if (skin.influence_count == 0 || skin.influence_count > SINEW_MAX_INFLUENCES ||
      skin.weight_format > SINEW_WEIGHT_FLOAT || (o.garment != 0 && plan->up_axis != plan->source_up_axis))
    return SINEW_ERROR_ARGUMENT;
  status = make_counts(source.vertex_count, source.face_count, source.corner_count, input.source.skeleton->joint_count,
                       1, 0, &plan->source);
  if (status == SINEW_OK)
    status = make_counts(target.vertex_count, target.face_count, target.corner_count, input.skeleton.joint_count, 1, 0,
                         &plan->target);
  plan->garment = o.garment != 0;
  if (status == SINEW_OK && plan->garment) {
    const uint64_t corners = static_cast<uint64_t>(source.corner_count) + target.corner_count;
    if (corners > UINT32_MAX) return SINEW_ERROR_COUNT;
    status = make_counts(source.vertex_count + target.vertex_count, source.face_count + target.face_count,
                         static_cast<uint32_t>(corners), input.skeleton.joint_count, 1, 0, &plan->dressed);
  }
  if (status != SINEW_OK) return status;
  plan->method = o.method;
  plan->influence_count = o.influence_count != 0 ? o.influence_count : 4;
  plan->weight_format = o.weight_format;
  plan->as_drawn = o.as_drawn != 0;
  plan->locked = o.locked;
  plan->pairs = o.pairs;
  plan->pair_count = o.pair_count;
  plan->progress = Progress{o.progress, o.progress_user};
  const Threads threads = {o.thread_count != 0 ? o.thread_count : 1, o.parallel_for, o.parallel_user};
  plan->source.threads = plan->target.threads = plan->dressed.threads = threads;
  plan->with_model = model != nullptr;
  if (plan->method == SINEW_TRANSFER_BIHARMONIC &&
      (plan->source.vertices > SINEW_MAX_BIHARMONIC_VERTICES || plan->target.vertices > SINEW_MAX_BIHARMONIC_VERTICES))
    return SINEW_ERROR_COUNT;
  if (!plan->binds()) return SINEW_OK;
  for (uint32_t method = plan->with_model ? SINEW_METHOD_MODEL : SINEW_METHOD_HEAT; method <= SINEW_METHOD_HEAT;
       ++method) {
    sinew_bind_options bind = SINEW_INIT(sinew_bind_options);
    bind.method = method;
    bind.influence_count = plan->influence_count;
    bind.weights_in_place = o.weights_in_place;
    bind.kernel = o.kernel;
    bind.thread_count = o.thread_count;
    bind.parallel_for = o.parallel_for;
    bind.parallel_user = o.parallel_user;
    const auto make = [&](const Counts& counts, uint32_t up_axis, BindPlan* out) {
      const sinew_status made =
          plan_bind(model, counts.vertices, counts.faces, counts.corners, counts.joints, &bind, out);
      out->up_axis = up_axis;
      return made;
    };
    if (plan->garment) {
      status = make(plan->dressed, plan->up_axis, &plan->target_binds[method]);
    } else {
      status = make(plan->target, plan->up_axis, &plan->target_binds[method]);
      if (status == SINEW_OK) status = make(plan->source, plan->source_up_axis, &plan->source_binds[method]);
    }
    if (status != SINEW_OK) return status;
  }
  return SINEW_OK;
}

}  // namespace sinew::transferring
