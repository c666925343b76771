// SPDX-License-Identifier: MIT
// The C API: argument checks of sinew_rig() and of what makes its skeletons grow.
#include "rig/rig.hpp"

#include <stddef.h>

#include "api/arguments.hpp"
#include "core/struct_size.hpp"
#include "details/details.hpp"
#include "front/front_points.hpp"
#include "kernels/select.hpp"
#include "model/reader.hpp"
#include "sinew/rig.h"
#include "votes/rig_task.hpp"

// The struct of the first release, 0.1.
static constexpr uint32_t kFirstRigOutputs = offsetof(sinew_rig_outputs, used_bytes) + sizeof(size_t);
static_assert(sizeof(sinew_rig_options) == 12 * sizeof(uint32_t) + 3 * sizeof(void*), "a hole in sinew_rig_options");
static_assert(sizeof(sinew_rig_outputs) == 12 * sizeof(uint32_t) + 9 * sizeof(void*), "a hole in sinew_rig_outputs");

extern "C" {

sinew_status sinew_rig_model_open(const void* bytes, size_t size_bytes, sinew_model* model) {
  if (bytes == nullptr || model == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::ModelHeader header;
  const sinew_status status = sinew::read_header(bytes, size_bytes, &header);
  if (status != SINEW_OK) return status;
  sinew::ModelTask task;
  if (header.task != sinew::kTaskRig) return SINEW_ERROR_MODEL_TASK;
  if (header.feature_set == sinew::rigging::kSlotsFeatureSet)
    return sinew::rigging::open_slots_model(bytes, size_bytes, model);
  if (!sinew::rigging::rig_task(header.feature_set, &task) && !sinew::rigging::front_task(header.feature_set, &task))
    return SINEW_ERROR_MODEL_VERSION;
  return sinew::open_model(bytes, size_bytes, task, model);
}

sinew_status sinew_rig_workspace_size(const sinew_model* model, uint32_t vertex_count, uint32_t face_count,
                                      uint32_t corner_count, const sinew_rig_options* options, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  sinew::rigging::RigPlan plan;
  const sinew_status status = sinew::rigging::plan_rig(model, vertex_count, face_count, corner_count, options, &plan);
  if (status != SINEW_OK) return status;
  return sinew::measure(size_bytes, [&](sinew::Arena& arena) {
    return sinew::rigging::run_rig(plan, {}, sinew::Kernels(), arena, nullptr);
  });
}

sinew_status sinew_rig(const sinew_model* model, const sinew_mesh* mesh, const sinew_rig_options* options,
                       void* workspace, size_t workspace_bytes, sinew_rig_outputs* outputs) {
  if (!sinew::is_mesh(mesh) || workspace == nullptr || outputs == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew_rig_outputs own;
  sinew_status status = sinew::read_struct(outputs, kFirstRigOutputs, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.positions == nullptr || own.parents == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::rigging::RigPlan plan;
  status = sinew::rigging::plan_rig(model, mesh->vertex_count, mesh->face_count, mesh->corner_count, options, &plan);
  if (status != SINEW_OK) return status;
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  sinew::Kernels kernels;
  if (!sinew::select_kernels(plan.kernel, &kernels)) return SINEW_ERROR_KERNEL;
  sinew::Arena arena(workspace, workspace_bytes);
  status = sinew::rigging::run_rig(plan, *mesh, kernels, arena, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

sinew_status sinew_rig_details_workspace_size(const sinew_model* hands_model, uint32_t vertex_count,
                                              uint32_t face_count, uint32_t corner_count, uint32_t wanted,
                                              const sinew_rig_options* options, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  sinew::rigging::DetailsPlan plan;
  const sinew_status status =
      sinew::rigging::plan_details(hands_model, vertex_count, face_count, corner_count, wanted, options, &plan);
  if (status != SINEW_OK) return status;
  return sinew::measure(size_bytes, [&](sinew::Arena& arena) {
    return sinew::rigging::run_details(plan, {}, sinew::Kernels(), arena, nullptr);
  });
}

sinew_status sinew_rig_details(const sinew_model* hands_model, const sinew_mesh* mesh, uint32_t wanted,
                               const sinew_rig_options* options, void* workspace, size_t workspace_bytes,
                               sinew_rig_outputs* outputs) {
  if (!sinew::is_mesh(mesh) || workspace == nullptr || outputs == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew_rig_outputs own;
  sinew_status status = sinew::read_struct(outputs, kFirstRigOutputs, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.positions == nullptr || own.parents == nullptr || own.joint_classes == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::rigging::DetailsPlan plan;
  status = sinew::rigging::plan_details(hands_model, mesh->vertex_count, mesh->face_count, mesh->corner_count, wanted,
                                        options, &plan);
  if (status != SINEW_OK) return status;
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  sinew::Kernels kernels;
  if ((wanted & SINEW_DETAIL_HANDS) != 0 && !sinew::select_kernels(plan.hands.kernel, &kernels))
    return SINEW_ERROR_KERNEL;
  sinew::Arena arena(workspace, workspace_bytes);
  status = sinew::rigging::run_details(plan, *mesh, kernels, arena, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

}  // extern "C"
