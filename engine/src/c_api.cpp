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
#include "deform/deformer.hpp"
#include "mapping/map.hpp"
#include "motion/contacts.hpp"
#include "motion/retarget.hpp"
#include "rig/hands.hpp"
#include "rig/rig.hpp"
#include "rig/rig_task.hpp"
#include "simplify/simplify.hpp"
#include "transfer/transfer.hpp"
#endif
#include "sinew/sinew.h"

#define SINEW_STRING_(x) #x
#define SINEW_STRING(x) SINEW_STRING_(x)

// The library writes the whole struct: callers with an older header have no room for a longer one.
static_assert(sizeof(sinew_model) == (sizeof(void*) == 8 ? 128 : 116), "new members take their room from reserved");

// The structs of the first release, 0.1.
constexpr uint32_t kFirstOutputsSize = offsetof(sinew_bind_outputs, used_bytes) + sizeof(size_t);
constexpr uint32_t kFirstTransferOutputsSize = offsetof(sinew_transfer_outputs, used_bytes) + sizeof(size_t);
constexpr uint32_t kFirstDeformOutputsSize = offsetof(sinew_deform_outputs, inverted_tetrahedra) + sizeof(uint32_t);
constexpr uint32_t kFirstRigOutputsSize = offsetof(sinew_rig_outputs, used_bytes) + sizeof(size_t);

// No padding: the bytes behind a struct that an older library knows belong to members, so that 0 means "not set".
static_assert(sizeof(sinew_options) == 16 * sizeof(uint32_t) + 7 * sizeof(void*), "a hole in sinew_options");
static_assert(sizeof(sinew_bind_outputs) == 4 * sizeof(uint32_t) + 7 * sizeof(void*), "a hole in sinew_bind_outputs");
static_assert(sizeof(sinew_rig_options) == 10 * sizeof(uint32_t) + 2 * sizeof(void*), "a hole in sinew_rig_options");
static_assert(sizeof(sinew_transfer_options) == 12 * sizeof(uint32_t) + 6 * sizeof(void*),
              "a hole in sinew_transfer_options");
static_assert(sizeof(sinew_transfer_outputs) == 8 * sizeof(uint32_t) + 6 * sizeof(void*),
              "a hole in sinew_transfer_outputs");
static_assert(sizeof(sinew_transfer_part) == 8 * sizeof(uint32_t), "sinew_transfer_part never changes");
static_assert(sizeof(sinew_simplify_options) == 4 * sizeof(uint32_t), "a hole in sinew_simplify_options");
static_assert(sizeof(sinew_map_rig) == 6 * sizeof(uint32_t) + 4 * sizeof(void*), "a hole in sinew_map_rig");
static_assert(sizeof(sinew_map_options) == 4 * sizeof(uint32_t) + sizeof(void*), "a hole in sinew_map_options");
static_assert(sizeof(sinew_map_outputs) == 4 * sizeof(uint32_t) + 4 * sizeof(void*), "a hole in sinew_map_outputs");
static_assert(sizeof(sinew_retarget_options) == 6 * sizeof(uint32_t), "a hole in sinew_retarget_options");
static_assert(sizeof(sinew_deform_options) == 8 * sizeof(uint32_t), "a hole in sinew_deform_options");
static_assert(sizeof(sinew_deform_outputs) == 4 * sizeof(uint32_t) + sizeof(void*), "a hole in sinew_deform_outputs");
static_assert(sizeof(sinew_rig_outputs) == 6 * sizeof(uint32_t) + 9 * sizeof(void*), "a hole in sinew_rig_outputs");

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

sinew_status sinew_map_workspace_size(uint32_t target_count, uint32_t source_count, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (target_count == 0 || target_count > SINEW_MAX_JOINTS || source_count == 0 || source_count > SINEW_MAX_JOINTS)
    return SINEW_ERROR_COUNT;
  sinew::mapping::MapPlan plan = {};
  plan.target.joint_count = target_count;
  plan.source.joint_count = source_count;
  sinew::Arena arena;
  const sinew_status status = sinew::mapping::run_map(plan, arena, nullptr);
  if (status != SINEW_OK || !arena.ok()) return SINEW_ERROR_COUNT;
  *size_bytes = arena.high_water();
  return SINEW_OK;
}

sinew_status sinew_map(const sinew_map_rig* target, const sinew_map_rig* source, const sinew_map_options* options,
                       void* workspace, size_t workspace_bytes, sinew_map_outputs* outputs) {
  if (target == nullptr || source == nullptr || workspace == nullptr || outputs == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew_map_outputs own;
  sinew_status status = sinew::read_struct(outputs, sizeof own, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.sources == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::mapping::MapPlan plan;
  status = sinew::mapping::plan_map(target, source, options, &plan);
  if (status != SINEW_OK) return status;
  if (reinterpret_cast<uintptr_t>(workspace) % SINEW_WORKSPACE_ALIGNMENT != 0) return SINEW_ERROR_WORKSPACE;
  sinew::Arena arena(workspace, workspace_bytes);
  status = sinew::mapping::run_map(plan, arena, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

sinew_status sinew_deform_memory_size(const sinew_mesh* mesh, uint32_t joint_count, uint32_t influence_count,
                                      const sinew_deform_options* options, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (mesh == nullptr || mesh->positions == nullptr || (mesh->face_count > 0 && mesh->face_vertices == nullptr)) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew::RestInput input;
  sinew_status status = sinew::read_deform_options(options, &input.options);
  if (status != SINEW_OK) return status;
  input.mesh = *mesh;
  input.skeleton.joint_count = joint_count;
  input.skin.influence_count = influence_count;
  sinew::Arena arena;
  status = sinew::create_deformer(input, arena, nullptr);
  if (status == SINEW_ERROR_WORKSPACE || !arena.ok()) return SINEW_ERROR_COUNT;
  if (status == SINEW_OK) *size_bytes = arena.high_water();
  return status;
}

sinew_status sinew_deform_create(const sinew_mesh* mesh, const sinew_skeleton* skeleton, const sinew_skin* skin,
                                 const sinew_deform_options* options, void* memory, size_t memory_bytes,
                                 sinew_deformer* deformer) {
  if (mesh == nullptr || skeleton == nullptr || skin == nullptr || memory == nullptr || deformer == nullptr ||
      mesh->positions == nullptr || (mesh->face_count > 0 && mesh->face_vertices == nullptr) ||
      skeleton->positions == nullptr || skeleton->parents == nullptr || skin->joint_indices == nullptr ||
      skin->weights == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew::RestInput input;
  const sinew_status status = sinew::read_deform_options(options, &input.options);
  if (status != SINEW_OK) return status;
  if (reinterpret_cast<uintptr_t>(memory) % SINEW_WORKSPACE_ALIGNMENT != 0) return SINEW_ERROR_WORKSPACE;
  input.mesh = *mesh;
  input.skeleton = *skeleton;
  input.skin = *skin;
  sinew::Arena arena(memory, memory_bytes);
  return sinew::create_deformer(input, arena, deformer);
}

sinew_status sinew_deform_pose(const sinew_deformer* deformer, const float* palette, void* workspace,
                               size_t workspace_bytes, sinew_deform_outputs* outputs) {
  if (deformer == nullptr || deformer->memory == nullptr || palette == nullptr || workspace == nullptr ||
      outputs == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew_deform_outputs own;
  sinew_status status = sinew::read_struct(outputs, kFirstDeformOutputsSize, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.positions == nullptr) return SINEW_ERROR_ARGUMENT;
  if (reinterpret_cast<uintptr_t>(workspace) % SINEW_WORKSPACE_ALIGNMENT != 0) return SINEW_ERROR_WORKSPACE;
  sinew::Arena arena(workspace, workspace_bytes);
  status = sinew::pose_deformer(*static_cast<const sinew::DeformRest*>(deformer->memory), palette, arena, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

sinew_status sinew_simplify_workspace_size(uint32_t joint_count, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  sinew::SimplifyPlan plan;
  const sinew_status status = sinew::plan_simplify(joint_count, nullptr, &plan);
  if (status != SINEW_OK) return status;
  sinew::Arena arena;
  if (sinew::run_simplify(plan, arena, nullptr) != SINEW_OK || !arena.ok()) return SINEW_ERROR_COUNT;
  *size_bytes = arena.high_water();
  return SINEW_OK;
}

sinew_status sinew_simplify(const float* positions, const int32_t* parents, uint32_t joint_count, const float* areas,
                            const uint8_t* keep, const sinew_simplify_options* options, void* workspace,
                            size_t workspace_bytes, uint32_t* into) {
  if (positions == nullptr || parents == nullptr || workspace == nullptr || into == nullptr)
    return SINEW_ERROR_ARGUMENT;
  sinew::SimplifyPlan plan;
  const sinew_status status = sinew::plan_simplify(joint_count, options, &plan);
  if (status != SINEW_OK) return status;
  if (reinterpret_cast<uintptr_t>(workspace) % SINEW_WORKSPACE_ALIGNMENT != 0) return SINEW_ERROR_WORKSPACE;
  plan.positions = positions;
  plan.parents = parents;
  plan.areas = areas;
  plan.keep = keep;
  sinew::Arena arena(workspace, workspace_bytes);
  return sinew::run_simplify(plan, arena, into);
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
sinew_status sinew_simplify_workspace_size(uint32_t, size_t*) { return SINEW_ERROR_ARGUMENT; }
sinew_status sinew_simplify(const float*, const int32_t*, uint32_t, const float*, const uint8_t*,
                            const sinew_simplify_options*, void*, size_t, uint32_t*) {
  return SINEW_ERROR_ARGUMENT;
}
sinew_status sinew_map_workspace_size(uint32_t, uint32_t, size_t*) { return SINEW_ERROR_ARGUMENT; }
sinew_status sinew_map(const sinew_map_rig*, const sinew_map_rig*, const sinew_map_options*, void*, size_t,
                       sinew_map_outputs*) {
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

sinew_status sinew_deform_memory_size(const sinew_mesh*, uint32_t, uint32_t, const sinew_deform_options*, size_t*) {
  return SINEW_ERROR_ARGUMENT;
}
sinew_status sinew_deform_create(const sinew_mesh*, const sinew_skeleton*, const sinew_skin*,
                                 const sinew_deform_options*, void*, size_t, sinew_deformer*) {
  return SINEW_ERROR_ARGUMENT;
}
sinew_status sinew_deform_pose(const sinew_deformer*, const float*, void*, size_t, sinew_deform_outputs*) {
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

#if !defined(SINEW_SMALL_CODE)

sinew_status sinew_retarget_size(uint32_t source_joints, uint32_t target_joints, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (source_joints == 0 || target_joints == 0 || source_joints > SINEW_MAX_JOINTS || target_joints > SINEW_MAX_JOINTS)
    return SINEW_ERROR_COUNT;
  *size_bytes = sinew::measure_plan(source_joints, target_joints);
  return SINEW_OK;
}

sinew_status sinew_retarget_create(const sinew_motion_rig* source, const sinew_motion_rig* target, const int32_t* map,
                                   const uint8_t* target_classes, const sinew_retarget_options* options, void* memory,
                                   size_t memory_bytes, sinew_retarget** plan) {
  if (source == nullptr || target == nullptr || map == nullptr || memory == nullptr || plan == nullptr ||
      source->positions == nullptr || source->parents == nullptr || target->positions == nullptr ||
      target->parents == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew::RetargetOptions own;
  sinew_status status = sinew::read_retarget_options(options, &own);
  size_t bytes = 0;
  if (status == SINEW_OK) status = sinew_retarget_size(source->joint_count, target->joint_count, &bytes);
  if (status != SINEW_OK) return status;
  if (memory_bytes < bytes || reinterpret_cast<uintptr_t>(memory) % SINEW_WORKSPACE_ALIGNMENT != 0)
    return SINEW_ERROR_WORKSPACE;
  return sinew::create_plan(*source, *target, map, target_classes, own, memory, memory_bytes, plan);
}

sinew_status sinew_retarget_height(sinew_retarget* plan, const float* rotations, const float* translations,
                                   float* height) {
  if (plan == nullptr || rotations == nullptr || translations == nullptr || height == nullptr)
    return SINEW_ERROR_ARGUMENT;
  return sinew::source_height(plan, rotations, translations, height);
}

sinew_status sinew_retarget_ground(const sinew_retarget* plan, float* heights, size_t count, float* ground) {
  if (plan == nullptr || ground == nullptr || (heights == nullptr && count > 0)) return SINEW_ERROR_ARGUMENT;
  return sinew::standing_height(*plan, heights, count, ground);
}

sinew_status sinew_retarget_frame(sinew_retarget* plan, const float* rotations, const float* translations, float ground,
                                  float* out_rotations, float* out_translations) {
  if (plan == nullptr || rotations == nullptr || translations == nullptr || out_rotations == nullptr ||
      out_translations == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  return sinew::retarget_frame(plan, rotations, translations, ground, out_rotations, out_translations);
}

sinew_status sinew_retarget_contacts_size(const sinew_retarget* plan, const sinew_motion_body* target,
                                          uint32_t frame_count, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (plan == nullptr || target == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = sinew::measure_contacts(plan->source.count, plan->target.count, target->vertex_count,
                                        target->triangle_count, frame_count);
  return *size_bytes == 0 ? SINEW_ERROR_COUNT : SINEW_OK;
}

sinew_status sinew_retarget_contacts(sinew_retarget* plan, const sinew_motion_body* source,
                                     const sinew_motion_body* target, const sinew_motion_clip* clip,
                                     const sinew_contact_options* options, void* workspace, size_t workspace_bytes) {
  if (plan == nullptr || target == nullptr || clip == nullptr || workspace == nullptr ||
      (source != nullptr && source->vertex_count != target->vertex_count)) {
    return SINEW_ERROR_ARGUMENT;
  }
  if (clip->frame_count > 0 && (clip->source_rotations == nullptr || clip->source_translations == nullptr ||
                                clip->rotations == nullptr || clip->translations == nullptr)) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew_contact_options own = sinew_contact_options_init();
  sinew_status status = options == nullptr ? SINEW_OK : sinew::read_struct(options, sizeof own, sizeof own, &own);
  if (status != SINEW_OK) return status;
  const double fps = own.fps == 0 ? 30.0 : static_cast<double>(own.fps);
  if (!(fps >= 1 && fps <= 1000)) return SINEW_ERROR_ARGUMENT;
  status = sinew::check_body(*target, plan->target.count);
  if (status == SINEW_OK && source != nullptr) {
    sinew_motion_body same = *source;
    same.triangle_count = 0;
    status = sinew::check_body(same, plan->source.count);
  }
  if (status != SINEW_OK) return status;
  if (!sinew::is_finite(static_cast<double>(clip->ground))) return SINEW_ERROR_NOT_FINITE;
  if (reinterpret_cast<uintptr_t>(workspace) % SINEW_WORKSPACE_ALIGNMENT != 0) return SINEW_ERROR_WORKSPACE;
  sinew::ContactInputs inputs;
  inputs.frames = clip->frame_count;
  inputs.source_rotations = clip->source_rotations;
  inputs.source_translations = clip->source_translations;
  inputs.ground = static_cast<double>(clip->ground);
  inputs.fps = fps;
  inputs.rotations = clip->rotations;
  inputs.translations = clip->translations;
  inputs.progress = sinew::Progress{own.progress, own.progress_user};
  sinew::Arena arena(workspace, workspace_bytes);
  return sinew::run_contacts(plan, source, *target, inputs, arena);
}

#else

sinew_status sinew_retarget_contacts_size(const sinew_retarget*, const sinew_motion_body*, uint32_t, size_t*) {
  return SINEW_ERROR_ARGUMENT;
}
sinew_status sinew_retarget_contacts(sinew_retarget*, const sinew_motion_body*, const sinew_motion_body*,
                                     const sinew_motion_clip*, const sinew_contact_options*, void*, size_t) {
  return SINEW_ERROR_ARGUMENT;
}
sinew_status sinew_retarget_size(uint32_t, uint32_t, size_t*) { return SINEW_ERROR_ARGUMENT; }
sinew_status sinew_retarget_create(const sinew_motion_rig*, const sinew_motion_rig*, const int32_t*, const uint8_t*,
                                   const sinew_retarget_options*, void*, size_t, sinew_retarget**) {
  return SINEW_ERROR_ARGUMENT;
}
sinew_status sinew_retarget_height(sinew_retarget*, const float*, const float*, float*) { return SINEW_ERROR_ARGUMENT; }
sinew_status sinew_retarget_ground(const sinew_retarget*, float*, size_t, float*) { return SINEW_ERROR_ARGUMENT; }
sinew_status sinew_retarget_frame(sinew_retarget*, const float*, const float*, float, float*, float*) {
  return SINEW_ERROR_ARGUMENT;
}

#endif

}  // extern "C"
