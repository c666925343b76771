// SPDX-License-Identifier: MIT
// The C API: argument checks and calls inward; sinew_bind() strings the stages together.
#include <stddef.h>

#include "bind/bind.hpp"
#include "bind/bind_task.hpp"
#include "core/struct_size.hpp"
#include "deform/skinning.hpp"
#include "kernels/select.hpp"
#include "model/reader.hpp"
#include "network/packed_layers.hpp"
#if !defined(SINEW_SMALL_CODE)
#include "rig/hands.hpp"
#include "rig/rig.hpp"
#include "rig/rig_task.hpp"
#include "transfer/transfer.hpp"
#endif
#include "sinew/sinew.h"

#define SINEW_STRING_(x) #x
#define SINEW_STRING(x) SINEW_STRING_(x)

// The library writes the whole struct: callers with an older header have no room for a longer one.
static_assert(sizeof(sinew_model) == (sizeof(void*) == 8 ? 128 : 116), "new members take their room from reserved");

// The structs of the first release, 0.1.
constexpr uint32_t kFirstOutputsSize = offsetof(sinew_bind_outputs, used_bytes) + sizeof(size_t);
constexpr uint32_t kFirstRigOutputsSize = offsetof(sinew_rig_outputs, used_bytes) + sizeof(size_t);
constexpr uint32_t kFirstTransferOutputsSize = offsetof(sinew_transfer_outputs, used_bytes) + sizeof(size_t);

// No padding: the bytes behind a struct that an older library knows belong to members, so that 0 means "not set".
static_assert(sizeof(sinew_options) == 16 * sizeof(uint32_t) + 7 * sizeof(void*), "a hole in sinew_options");
static_assert(sizeof(sinew_bind_outputs) == 4 * sizeof(uint32_t) + 7 * sizeof(void*), "a hole in sinew_bind_outputs");
static_assert(sizeof(sinew_rig_options) == 10 * sizeof(uint32_t) + 2 * sizeof(void*), "a hole in sinew_rig_options");
static_assert(sizeof(sinew_rig_outputs) == 6 * sizeof(uint32_t) + 9 * sizeof(void*), "a hole in sinew_rig_outputs");
static_assert(sizeof(sinew_transfer_options) == 12 * sizeof(uint32_t) + 6 * sizeof(void*),
              "a hole in sinew_transfer_options");
static_assert(sizeof(sinew_transfer_outputs) == 8 * sizeof(uint32_t) + 6 * sizeof(void*),
              "a hole in sinew_transfer_outputs");
static_assert(sizeof(sinew_transfer_part) == 8 * sizeof(uint32_t), "sinew_transfer_part never changes");

extern "C" {

const char* sinew_version(void) {
  return SINEW_STRING(SINEW_VERSION_MAJOR) "." SINEW_STRING(SINEW_VERSION_MINOR) "." SINEW_STRING(SINEW_VERSION_PATCH);
}

const char* sinew_status_text(sinew_status status) {
  switch (status) {
    case SINEW_OK:
      return "ok";
    case SINEW_ERROR_ARGUMENT:
      return "a pointer is null or an option is out of its range";
    case SINEW_ERROR_WORKSPACE:
      return "the workspace is too small or not aligned to 64 bytes";
    case SINEW_ERROR_COUNT:
      return "too many or no vertices, corners or joints, or fewer than two corners a face";
    case SINEW_ERROR_NOT_FINITE:
      return "a position is NaN or infinite";
    case SINEW_ERROR_INDEX:
      return "a face names a vertex, or a parent a joint, that does not exist, or a face has fewer than two corners";
    case SINEW_ERROR_HIERARCHY:
      return "the joint parents form a cycle";
    case SINEW_ERROR_NO_JOINT:
      return "every joint is excluded from binding";
    case SINEW_ERROR_CANCELLED:
      return "cancelled by the progress callback";
    case SINEW_ERROR_MODEL_MAGIC:
      return "not a sinew model file";
    case SINEW_ERROR_MODEL_VERSION:
      return "the model needs another version of this library";
    case SINEW_ERROR_MODEL_TRUNCATED:
      return "the model file is shorter or longer than its header says";
    case SINEW_ERROR_MODEL_CHECKSUM:
      return "the model file's checksum does not match its bytes";
    case SINEW_ERROR_MODEL_LAYOUT:
      return "the model file contradicts itself";
    case SINEW_ERROR_MODEL_OVERFLOW:
      return "the model file has an accumulator that could overflow";
    case SINEW_ERROR_MODEL_ALIGNMENT:
      return "the model bytes must start at an address divisible by 8";
    case SINEW_ERROR_RANGE:
      return "a joint index or weight is out of its range";
    case SINEW_ERROR_MODEL_TASK:
      return "the model is made for another task than this call";
    case SINEW_ERROR_KERNEL:
      return "this library or this processor lacks the kernels asked for";
    case SINEW_ERROR_VERSION:
      return "an option is set that this library does not know";
  }
  return "unknown status";
}

const char* sinew_kernel_name(uint32_t kernel) { return sinew::kernel_name(kernel); }

uint32_t sinew_kernel_select(uint32_t kernel) {
  sinew::Kernels kernels;
  return sinew::select_kernels(kernel, &kernels) ? kernels.id : 0;
}

sinew_status sinew_model_open(const void* bytes, size_t size_bytes, sinew_model* model) {
  if (bytes == nullptr || model == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::ModelHeader header;
  const sinew_status status = sinew::read_header(bytes, size_bytes, &header);
  if (status != SINEW_OK) return status;
  sinew::ModelTask task;
  if (header.task != sinew::kTaskBind || !sinew::bind_task(header.feature_set, &task)) return SINEW_ERROR_MODEL_VERSION;
  return sinew::open_model(bytes, size_bytes, task, model);
}

#if !defined(SINEW_SMALL_CODE)

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
  sinew_status status = sinew::plan_rig(model, vertex_count, face_count, corner_count, options, &plan);
  if (status != SINEW_OK) return status;
  sinew::Arena arena;
  status = sinew::run_rig(plan, {}, sinew::Kernels(), arena, nullptr);
  if (status == SINEW_ERROR_WORKSPACE || !arena.ok()) return SINEW_ERROR_COUNT;
  if (status == SINEW_OK) *size_bytes = arena.high_water();
  return status;
}

sinew_status sinew_rig(const sinew_model* model, const sinew_mesh* mesh, const sinew_rig_options* options,
                       void* workspace, size_t workspace_bytes, sinew_rig_outputs* outputs) {
  if (mesh == nullptr || workspace == nullptr || outputs == nullptr || mesh->positions == nullptr ||
      (mesh->face_count > 0 && mesh->face_vertices == nullptr)) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew_rig_outputs own;
  sinew_status status = sinew::read_struct(outputs, kFirstRigOutputsSize, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.positions == nullptr || own.parents == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::RigPlan plan;
  status = sinew::plan_rig(model, mesh->vertex_count, mesh->face_count, mesh->corner_count, options, &plan);
  if (status != SINEW_OK) return status;
  if (reinterpret_cast<uintptr_t>(workspace) % SINEW_WORKSPACE_ALIGNMENT != 0) return SINEW_ERROR_WORKSPACE;
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
  sinew::Arena arena;
  status = sinew::run_hands(plan, {}, sinew::Kernels(), arena, nullptr);
  if (status == SINEW_ERROR_WORKSPACE || !arena.ok()) return SINEW_ERROR_COUNT;
  if (status == SINEW_OK) *size_bytes = arena.high_water();
  return status;
}

sinew_status sinew_rig_hands(const sinew_model* model, const sinew_mesh* mesh, const sinew_rig_options* options,
                             void* workspace, size_t workspace_bytes, sinew_rig_outputs* outputs) {
  if (mesh == nullptr || workspace == nullptr || outputs == nullptr || mesh->positions == nullptr ||
      (mesh->face_count > 0 && mesh->face_vertices == nullptr)) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew_rig_outputs own;
  sinew_status status = sinew::read_struct(outputs, sizeof own, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.positions == nullptr || own.parents == nullptr || own.joint_classes == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::RigPlan plan;
  status = sinew::plan_rig(model, mesh->vertex_count, mesh->face_count, mesh->corner_count, options, &plan,
                           sinew::kHandsFeatureSet);
  if (status != SINEW_OK) return status;
  if (reinterpret_cast<uintptr_t>(workspace) % SINEW_WORKSPACE_ALIGNMENT != 0) return SINEW_ERROR_WORKSPACE;
  sinew::Kernels kernels;
  if (!sinew::select_kernels(plan.kernel, &kernels)) return SINEW_ERROR_KERNEL;
  sinew::Arena arena(workspace, workspace_bytes);
  status = sinew::run_hands(plan, *mesh, kernels, arena, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

sinew_status sinew_transfer_workspace_size(const sinew_model* model, const sinew_bound_character* source,
                                           const sinew_mesh* target, const sinew_skeleton* skeleton,
                                           const sinew_transfer_options* options, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (source == nullptr || source->mesh == nullptr || source->skeleton == nullptr || target == nullptr ||
      skeleton == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  const sinew::TransferInput input = {*source, *target, *skeleton};
  sinew::TransferPlan plan;
  sinew_status status = sinew::plan_transfer(model, input, options, &plan);
  if (status != SINEW_OK) return status;
  sinew::Arena arena;
  status = sinew::run_transfer(plan, input, arena, nullptr);
  if (status == SINEW_ERROR_WORKSPACE || !arena.ok()) return SINEW_ERROR_COUNT;
  if (status == SINEW_OK) *size_bytes = arena.high_water();
  return status;
}

sinew_status sinew_transfer(const sinew_model* model, const sinew_bound_character* source, const sinew_mesh* target,
                            const sinew_skeleton* skeleton, const sinew_transfer_options* options, void* workspace,
                            size_t workspace_bytes, sinew_transfer_outputs* outputs) {
  const auto is_mesh = [](const sinew_mesh* mesh) {
    return mesh != nullptr && mesh->positions != nullptr && (mesh->face_count == 0 || mesh->face_vertices != nullptr);
  };
  const auto is_skeleton = [](const sinew_skeleton* one) {
    return one != nullptr && one->positions != nullptr && one->parents != nullptr;
  };
  if (source == nullptr || !is_mesh(source->mesh) || !is_skeleton(source->skeleton) ||
      source->joint_indices == nullptr || source->weights == nullptr || source->joint_map == nullptr ||
      !is_mesh(target) || !is_skeleton(skeleton) || workspace == nullptr || outputs == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew_transfer_outputs own;
  sinew_status status = sinew::read_struct(outputs, kFirstTransferOutputsSize, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.joint_indices == nullptr || own.weights == nullptr || (own.part_capacity > 0 && own.parts == nullptr))
    return SINEW_ERROR_ARGUMENT;
  const sinew::TransferInput input = {*source, *target, *skeleton};
  sinew::TransferPlan plan;
  status = sinew::plan_transfer(model, input, options, &plan);
  if (status != SINEW_OK) return status;
  if (reinterpret_cast<uintptr_t>(workspace) % SINEW_WORKSPACE_ALIGNMENT != 0) return SINEW_ERROR_WORKSPACE;
  sinew::Arena arena(workspace, workspace_bytes);
  status = sinew::run_transfer(plan, input, arena, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

#else

sinew_status sinew_transfer_workspace_size(const sinew_model*, const sinew_bound_character*, const sinew_mesh*,
                                           const sinew_skeleton*, const sinew_transfer_options*, size_t* size_bytes) {
  if (size_bytes != nullptr) *size_bytes = 0;
  return SINEW_ERROR_ARGUMENT;
}
sinew_status sinew_transfer(const sinew_model*, const sinew_bound_character*, const sinew_mesh*, const sinew_skeleton*,
                            const sinew_transfer_options*, void*, size_t, sinew_transfer_outputs*) {
  return SINEW_ERROR_ARGUMENT;
}
sinew_status sinew_rig_model_open(const void*, size_t, sinew_model*) { return SINEW_ERROR_ARGUMENT; }
sinew_status sinew_rig_workspace_size(const sinew_model*, uint32_t, uint32_t, uint32_t, const sinew_rig_options*,
                                      size_t*) {
  return SINEW_ERROR_ARGUMENT;
}
sinew_status sinew_rig(const sinew_model*, const sinew_mesh*, const sinew_rig_options*, void*, size_t,
                       sinew_rig_outputs*) {
  return SINEW_ERROR_ARGUMENT;
}
sinew_status sinew_rig_hands_workspace_size(const sinew_model*, uint32_t, uint32_t, uint32_t, const sinew_rig_options*,
                                            size_t*) {
  return SINEW_ERROR_ARGUMENT;
}
sinew_status sinew_rig_hands(const sinew_model*, const sinew_mesh*, const sinew_rig_options*, void*, size_t,
                             sinew_rig_outputs*) {
  return SINEW_ERROR_ARGUMENT;
}

#endif

size_t sinew_model_packed_size(const sinew_model* model) {
  return model == nullptr || model->bytes == nullptr ? 0 : sinew::packed_bytes(*model);
}

sinew_status sinew_model_pack(sinew_model* model, void* memory, size_t memory_bytes) {
  if (model == nullptr || model->bytes == nullptr || memory == nullptr) return SINEW_ERROR_ARGUMENT;
  const size_t bytes = sinew::packed_bytes(*model);
  if (memory_bytes < bytes || reinterpret_cast<uintptr_t>(memory) % SINEW_WORKSPACE_ALIGNMENT != 0)
    return SINEW_ERROR_WORKSPACE;
  if (bytes == 0) return SINEW_OK;
  sinew::pack_model(*model, static_cast<uint8_t*>(memory));
  model->packed = memory;
  return SINEW_OK;
}

sinew_status sinew_bind_workspace_size(const sinew_model* model, uint32_t vertex_count, uint32_t face_count,
                                       uint32_t corner_count, uint32_t joint_count, const sinew_options* options,
                                       size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  sinew::BindPlan plan;
  const sinew_status status =
      sinew::plan_bind(model, vertex_count, face_count, corner_count, joint_count, options, &plan);
  if (status != SINEW_OK) return status;
  sinew::Arena arena;
  sinew::measure_bind(arena, plan);
  if (!arena.ok()) return SINEW_ERROR_COUNT;
  *size_bytes = arena.high_water();
  return SINEW_OK;
}

sinew_status sinew_bind(const sinew_model* model, const sinew_mesh* mesh, const sinew_skeleton* skeleton,
                        const sinew_options* options, void* workspace, size_t workspace_bytes,
                        sinew_bind_outputs* outputs) {
  if (mesh == nullptr || skeleton == nullptr || workspace == nullptr || outputs == nullptr ||
      mesh->positions == nullptr || skeleton->positions == nullptr || skeleton->parents == nullptr ||
      (mesh->face_count > 0 && mesh->face_vertices == nullptr)) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew_bind_outputs own;
  sinew_status status = sinew::read_struct(outputs, kFirstOutputsSize, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.joint_indices == nullptr || own.weights == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::BindPlan plan;
  status = sinew::plan_bind(model, mesh->vertex_count, mesh->face_count, mesh->corner_count, skeleton->joint_count,
                            options, &plan);
  if (status != SINEW_OK) return status;
  if (plan.rows.question_count > 0 && own.questions == nullptr) return SINEW_ERROR_ARGUMENT;
  if (reinterpret_cast<uintptr_t>(workspace) % SINEW_WORKSPACE_ALIGNMENT != 0) return SINEW_ERROR_WORKSPACE;
  status = sinew::run_bind(plan, *mesh, *skeleton, workspace, workspace_bytes, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

sinew_status sinew_skin_linear(const float* positions, uint32_t vertex_count, const uint16_t* joints,
                               const uint16_t* weights, uint32_t influence_count, const float* palette,
                               uint32_t joint_count, float* out) {
  if (positions == nullptr || joints == nullptr || weights == nullptr || palette == nullptr || out == nullptr ||
      influence_count == 0) {
    return SINEW_ERROR_ARGUMENT;
  }
  return sinew::skin_linear(positions, vertex_count, joints, weights, influence_count, palette, joint_count, out);
}

sinew_status sinew_skin_dual_quaternion(const float* positions, uint32_t vertex_count, const uint16_t* joints,
                                        const uint16_t* weights, uint32_t influence_count, const float* palette,
                                        uint32_t joint_count, float* out) {
  if (positions == nullptr || joints == nullptr || weights == nullptr || palette == nullptr || out == nullptr ||
      influence_count == 0) {
    return SINEW_ERROR_ARGUMENT;
  }
  return sinew::skin_dual_quaternion(positions, vertex_count, joints, weights, influence_count, palette, joint_count,
                                     out);
}

}  // extern "C"
