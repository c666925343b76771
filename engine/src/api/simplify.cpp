// SPDX-License-Identifier: MIT
// The C API: argument checks of sinew_simplify().
#include "simplify/simplify.hpp"

#include "api/arguments.hpp"
#include "sinew/simplify.h"

static_assert(sizeof(sinew_simplify_options) == 4 * sizeof(uint32_t) + sizeof(void*),
              "a hole in sinew_simplify_options");

extern "C" {

sinew_status sinew_simplify_workspace_size(uint32_t joint_count, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  sinew::simplifying::SimplifyPlan plan;
  const sinew_status status = sinew::simplifying::plan_simplify(joint_count, nullptr, &plan);
  if (status != SINEW_OK) return status;
  return sinew::measure(size_bytes,
                        [&](sinew::Arena& arena) { return sinew::simplifying::run_simplify(plan, arena, nullptr); });
}

sinew_status sinew_simplify(const sinew_skeleton* skeleton, const float* areas, const uint8_t* keep,
                            const sinew_simplify_options* options, void* workspace, size_t workspace_bytes,
                            uint32_t* into) {
  if (workspace == nullptr || into == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew_skeleton joints;
  sinew_status status = sinew::read_skeleton(skeleton, &joints);
  if (status != SINEW_OK) return status;
  sinew::simplifying::SimplifyPlan plan;
  status = sinew::simplifying::plan_simplify(joints.joint_count, options, &plan);
  if (status != SINEW_OK) return status;
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  plan.skeleton = joints;
  plan.areas = areas;
  plan.keep = keep;
  sinew::Arena arena(workspace, workspace_bytes);
  return sinew::simplifying::run_simplify(plan, arena, into);
}

}  // extern "C"
