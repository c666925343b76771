// SPDX-License-Identifier: MIT
// The C API: argument checks of sinew_bind().
#include "bind/bind.hpp"

#include <stddef.h>

#include "api/arguments.hpp"
#include "core/read_skeleton.hpp"
#include "core/struct_size.hpp"
#include "sinew/bind.h"

// The struct of the first release, 0.1.
static constexpr uint32_t kFirstBindOutputs = offsetof(sinew_bind_outputs, used_bytes) + sizeof(size_t);
static_assert(sizeof(sinew_bind_options) == 16 * sizeof(uint32_t) + 7 * sizeof(void*), "a hole in sinew_bind_options");
static_assert(sizeof(sinew_bind_outputs) == 4 * sizeof(uint32_t) + 7 * sizeof(void*), "a hole in sinew_bind_outputs");

extern "C" {

sinew_status sinew_bind_workspace_size(const sinew_model* model, uint32_t vertex_count, uint32_t face_count,
                                       uint32_t corner_count, uint32_t joint_count, const sinew_bind_options* options,
                                       size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  sinew::BindPlan plan;
  const sinew_status status =
      sinew::plan_bind(model, vertex_count, face_count, corner_count, joint_count, options, &plan);
  if (status != SINEW_OK) return status;
  return sinew::measure(size_bytes, [&](sinew::Arena& arena) { return sinew::measure_bind(arena, plan), SINEW_OK; });
}

sinew_status sinew_bind(const sinew_model* model, const sinew_mesh* mesh, const sinew_skeleton* skeleton,
                        const sinew_bind_options* options, void* workspace, size_t workspace_bytes,
                        sinew_bind_outputs* outputs) {
  if (!sinew::is_mesh(mesh) || skeleton == nullptr || workspace == nullptr || outputs == nullptr)
    return SINEW_ERROR_ARGUMENT;
  sinew_bind_outputs own;
  sinew_status status = sinew::read_struct(outputs, kFirstBindOutputs, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.joint_indices == nullptr || own.weights == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew_skeleton joints;
  status = sinew::read_skeleton(skeleton, &joints);
  if (status != SINEW_OK) return status;
  sinew::BindPlan plan;
  status = sinew::plan_bind(model, mesh->vertex_count, mesh->face_count, mesh->corner_count, joints.joint_count,
                            options, &plan);
  if (status == SINEW_OK) status = sinew::read_up_axis(joints.up, &plan.up_axis);
  if (status != SINEW_OK) return status;
  if (plan.rows.question_count > 0 && own.questions == nullptr) return SINEW_ERROR_ARGUMENT;
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  status = sinew::run_bind(plan, *mesh, joints, workspace, workspace_bytes, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

}  // extern "C"
