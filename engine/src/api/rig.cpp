// SPDX-License-Identifier: MIT
// The C API: argument checks of sinew_rig() and of what makes its skeletons grow.
#include "rig/rig.hpp"

#include <stddef.h>

#include "api/arguments.hpp"
#include "core/struct_size.hpp"
#include "kernels/select.hpp"
#include "model/reader.hpp"
#include "rig/face.hpp"
#include "rig/hands.hpp"
#include "rig/props.hpp"
#include "rig/rig_task.hpp"
#include "sinew/rig.h"

// The struct of the first release, 0.1.
static constexpr uint32_t kFirstSize = offsetof(sinew_rig_outputs, used_bytes) + sizeof(size_t);
static_assert(sizeof(sinew_rig_options) == 10 * sizeof(uint32_t) + 2 * sizeof(void*), "a hole in sinew_rig_options");
static_assert(sizeof(sinew_rig_outputs) == 6 * sizeof(uint32_t) + 9 * sizeof(void*), "a hole in sinew_rig_outputs");

extern "C" {

sinew_status sinew_rig_model_open(const void* bytes, size_t size_bytes, sinew_model* model) {
  if (bytes == nullptr || model == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::ModelHeader header;
  const sinew_status status = sinew::read_header(bytes, size_bytes, &header);
  if (status != SINEW_OK) return status;
  sinew::ModelTask task;
  if (header.task != sinew::kTaskRig) return SINEW_ERROR_MODEL_TASK;
  if (!sinew::rig_task(header.feature_set, &task)) return SINEW_ERROR_MODEL_VERSION;
  return sinew::open_model(bytes, size_bytes, task, model);
}

sinew_status sinew_rig_workspace_size(const sinew_model* model, uint32_t vertex_count, uint32_t face_count,
                                      uint32_t corner_count, const sinew_rig_options* options, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  sinew::RigPlan plan;
  const sinew_status status = sinew::plan_rig(model, vertex_count, face_count, corner_count, options, &plan);
  if (status != SINEW_OK) return status;
  return sinew::measure(
      size_bytes, [&](sinew::Arena& arena) { return sinew::run_rig(plan, {}, sinew::Kernels(), arena, nullptr); });
}

sinew_status sinew_rig(const sinew_model* model, const sinew_mesh* mesh, const sinew_rig_options* options,
                       void* workspace, size_t workspace_bytes, sinew_rig_outputs* outputs) {
  if (!sinew::is_mesh(mesh) || workspace == nullptr || outputs == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew_rig_outputs own;
  sinew_status status = sinew::read_struct(outputs, kFirstSize, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.positions == nullptr || own.parents == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::RigPlan plan;
  status = sinew::plan_rig(model, mesh->vertex_count, mesh->face_count, mesh->corner_count, options, &plan);
  if (status != SINEW_OK) return status;
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  sinew::Kernels kernels;
  if (!sinew::select_kernels(plan.kernel, &kernels)) return SINEW_ERROR_KERNEL;
  sinew::Arena arena(workspace, workspace_bytes);
  status = sinew::run_rig(plan, *mesh, kernels, arena, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

sinew_status sinew_rig_hands_workspace_size(const sinew_model* model, uint32_t vertex_count, uint32_t face_count,
                                            uint32_t corner_count, const sinew_rig_options* options,
                                            size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  sinew::RigPlan plan;
  sinew_status status =
      sinew::plan_rig(model, vertex_count, face_count, corner_count, options, &plan, sinew::kHandsFeatureSet);
  if (status != SINEW_OK) return status;
  return sinew::measure(
      size_bytes, [&](sinew::Arena& arena) { return sinew::run_hands(plan, {}, sinew::Kernels(), arena, nullptr); });
}

// The caller's mesh, memory and skeleton that is to grow.
static sinew_status read_skeleton(const sinew_mesh* mesh, const void* workspace, const sinew_rig_outputs* outputs,
                                  sinew_rig_outputs* own) {
  if (!sinew::is_mesh(mesh) || workspace == nullptr || outputs == nullptr) return SINEW_ERROR_ARGUMENT;
  const sinew_status status = sinew::read_struct(outputs, sizeof *own, sizeof *own, own);
  if (status != SINEW_OK) return status;
  const bool given = own->positions != nullptr && own->parents != nullptr && own->joint_classes != nullptr;
  return given ? SINEW_OK : SINEW_ERROR_ARGUMENT;
}

sinew_status sinew_rig_hands(const sinew_model* model, const sinew_mesh* mesh, const sinew_rig_options* options,
                             void* workspace, size_t workspace_bytes, sinew_rig_outputs* outputs) {
  sinew_rig_outputs own;
  sinew_status status = read_skeleton(mesh, workspace, outputs, &own);
  if (status != SINEW_OK) return status;
  sinew::RigPlan plan;
  status = sinew::plan_rig(model, mesh->vertex_count, mesh->face_count, mesh->corner_count, options, &plan,
                           sinew::kHandsFeatureSet);
  if (status != SINEW_OK) return status;
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  sinew::Kernels kernels;
  if (!sinew::select_kernels(plan.kernel, &kernels)) return SINEW_ERROR_KERNEL;
  sinew::Arena arena(workspace, workspace_bytes);
  status = sinew::run_hands(plan, *mesh, kernels, arena, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

// Faces and props come from the shape alone.
static sinew_status plan_details(uint32_t vertex_count, uint32_t face_count, uint32_t corner_count,
                                 const sinew_rig_options* options, sinew::RigPlan* plan) {
  sinew_rig_options own = sinew_rig_options_init();
  const sinew_status status =
      options == nullptr ? SINEW_OK : sinew::read_struct(options, sinew::kFirstRigOptionsSize, sizeof own, &own);
  if (status != SINEW_OK) return status;
  own.struct_size = sizeof own;
  own.method = SINEW_RIG_SHAPE;
  return sinew::plan_rig(nullptr, vertex_count, face_count, corner_count, &own, plan);
}

sinew_status sinew_rig_face_workspace_size(uint32_t vertex_count, uint32_t face_count, uint32_t corner_count,
                                           const sinew_rig_options* options, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  sinew::RigPlan plan;
  sinew_status status = plan_details(vertex_count, face_count, corner_count, options, &plan);
  if (status != SINEW_OK) return status;
  size_t face = 0, props = 0;
  status = sinew::measure(&face, [&](sinew::Arena& arena) { return sinew::run_face(plan, {}, arena, nullptr); });
  if (status == SINEW_OK)
    status = sinew::measure(&props, [&](sinew::Arena& arena) { return sinew::run_props(plan, {}, arena, nullptr); });
  if (status == SINEW_OK) *size_bytes = face > props ? face : props;
  return status;
}

static sinew_status run_details(decltype(sinew::run_face) run, const sinew_mesh* mesh, const sinew_rig_options* options,
                                void* workspace, size_t workspace_bytes, sinew_rig_outputs* outputs) {
  sinew_rig_outputs own;
  sinew_status status = read_skeleton(mesh, workspace, outputs, &own);
  if (status != SINEW_OK) return status;
  sinew::RigPlan plan;
  status = plan_details(mesh->vertex_count, mesh->face_count, mesh->corner_count, options, &plan);
  if (status != SINEW_OK) return status;
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  sinew::Arena arena(workspace, workspace_bytes);
  status = run(plan, *mesh, arena, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

sinew_status sinew_rig_face(const sinew_mesh* mesh, const sinew_rig_options* options, void* workspace,
                            size_t workspace_bytes, sinew_rig_outputs* outputs) {
  return run_details(sinew::run_face, mesh, options, workspace, workspace_bytes, outputs);
}

sinew_status sinew_rig_props(const sinew_mesh* mesh, const sinew_rig_options* options, void* workspace,
                             size_t workspace_bytes, sinew_rig_outputs* outputs) {
  return run_details(sinew::run_props, mesh, options, workspace, workspace_bytes, outputs);
}

}  // extern "C"
