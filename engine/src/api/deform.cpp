// SPDX-License-Identifier: MIT
// The C API: argument checks of deformers.
#include "sinew/deform.h"

#include <stddef.h>

#include "api/arguments.hpp"
#include "core/struct_size.hpp"
#include "deform/rest.hpp"

// The struct of the first release, 0.1.
static constexpr uint32_t kFirstDeformOutputs = offsetof(sinew_deform_outputs, inverted_tetrahedra) + sizeof(uint32_t);
static_assert(sizeof(sinew_deform_options) == 12 * sizeof(uint32_t) + 2 * sizeof(void*),
              "a hole in sinew_deform_options");
static_assert(sizeof(sinew_deform_outputs) == 4 * sizeof(uint32_t) + sizeof(void*), "a hole in sinew_deform_outputs");

extern "C" {

sinew_status sinew_deform_create_workspace_size(const sinew_mesh* mesh, uint32_t joint_count, uint32_t influence_count,
                                                const sinew_deform_options* options, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (!sinew::is_mesh(mesh)) return SINEW_ERROR_ARGUMENT;
  sinew::deform::RestInput input;
  const sinew_status status = sinew::deform::read_deform_options(options, &input.options);
  if (status != SINEW_OK) return status;
  input.mesh = *mesh;
  input.skeleton.joint_count = joint_count;
  input.skin.influence_count = influence_count;
  return sinew::measure(size_bytes,
                        [&](sinew::Arena& arena) { return sinew::deform::create_deformer(input, arena, nullptr); });
}

sinew_status sinew_deform_create(const sinew_mesh* mesh, const sinew_skeleton* skeleton, const sinew_skin* skin,
                                 const sinew_deform_options* options, void* memory, size_t memory_bytes,
                                 sinew_deformer* deformer) {
  if (!sinew::is_mesh(mesh) || skin == nullptr || memory == nullptr || deformer == nullptr ||
      skin->joint_indices == nullptr || skin->weights == nullptr || skin->weight_format != SINEW_WEIGHT_UNORM16) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew::deform::RestInput input;
  sinew_status status = sinew::read_skeleton(skeleton, &input.skeleton);
  if (status == SINEW_OK) status = sinew::deform::read_deform_options(options, &input.options);
  if (status != SINEW_OK) return status;
  if (!sinew::is_aligned(memory)) return SINEW_ERROR_WORKSPACE;
  input.mesh = *mesh;
  input.skin = *skin;
  sinew::Arena arena(memory, memory_bytes);
  return sinew::deform::create_deformer(input, arena, deformer);
}

sinew_status sinew_deform_pose(const sinew_deformer* deformer, const float* palette, void* workspace,
                               size_t workspace_bytes, sinew_deform_outputs* outputs) {
  if (deformer == nullptr || deformer->memory == nullptr || palette == nullptr || workspace == nullptr ||
      outputs == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew_deform_outputs own;
  sinew_status status = sinew::read_struct(outputs, kFirstDeformOutputs, sizeof own, &own);
  if (status != SINEW_OK) return status;
  if (own.positions == nullptr) return SINEW_ERROR_ARGUMENT;
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  sinew::Arena arena(workspace, workspace_bytes);
  status = sinew::deform::pose_deformer(*static_cast<const sinew::deform::DeformRest*>(deformer->memory), palette,
                                        arena, &own);
  if (status == SINEW_OK) sinew::write_struct(&own, sizeof own, outputs);
  return status;
}

}  // extern "C"
