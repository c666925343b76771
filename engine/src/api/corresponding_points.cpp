// SPDX-License-Identifier: MIT
// The C API: the match of a transfer by itself, in the caller's vertices.
#include "api/arguments.hpp"
#include "core/build.hpp"
#include "sinew/published.h"
#include "transfer/published.hpp"

namespace sinew::transferring {
namespace {

// Arguments with skeletons of this library's version, and their plan.
struct Arguments {
  sinew_bound_character source;
  sinew_skeleton source_skeleton, skeleton;
  TransferPlan plan;

  sinew_status read(decltype(read_skeleton) read_one, const sinew_bound_character& given, const sinew_mesh& target,
                    const sinew_skeleton* target_skeleton) {
    source = given;
    source.skeleton = &source_skeleton;
    sinew_status status = read_one(given.skeleton, &source_skeleton);
    if (status == SINEW_OK) status = read_one(target_skeleton, &skeleton);
    if (status != SINEW_OK) return status;
    sinew_transfer_options options = SINEW_INIT(sinew_transfer_options);
    options.method = SINEW_TRANSFER_NEAREST;
    return plan_transfer(nullptr, {source, target, skeleton}, &options, &plan);
  }
};

}  // namespace
}  // namespace sinew::transferring

extern "C" {

sinew_status sinew_corresponding_points_workspace_size(const sinew_bound_character* source, const sinew_mesh* target,
                                                       const sinew_skeleton* skeleton, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (!sinew::has_published_methods()) return SINEW_ERROR_NOT_BUILT;
  if (source == nullptr || source->mesh == nullptr || source->skeleton == nullptr || target == nullptr ||
      skeleton == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew::transferring::Arguments own;
  const sinew_status status = own.read(sinew::read_skeleton_counts, *source, *target, skeleton);
  if (status != SINEW_OK) return status;
  return sinew::measure(size_bytes, [&](sinew::Arena& arena) {
    return sinew::transferring::find_corresponding_points(own.plan, {own.source, *target, own.skeleton}, arena, nullptr,
                                                          nullptr);
  });
}

sinew_status sinew_corresponding_points(const sinew_bound_character* source, const sinew_mesh* target,
                                        const sinew_skeleton* skeleton, void* workspace, size_t workspace_bytes,
                                        uint32_t* vertices, float* shares) {
  if (!sinew::has_published_methods()) return SINEW_ERROR_NOT_BUILT;
  if (source == nullptr || !sinew::is_mesh(source->mesh) || source->skin.joint_indices == nullptr ||
      source->skin.weights == nullptr || source->joint_map == nullptr || !sinew::is_mesh(target) ||
      skeleton == nullptr || workspace == nullptr || vertices == nullptr || shares == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew::transferring::Arguments own;
  const sinew_status status = own.read(sinew::read_skeleton, *source, *target, skeleton);
  if (status != SINEW_OK) return status;
  if (!sinew::is_aligned(workspace)) return SINEW_ERROR_WORKSPACE;
  sinew::Arena arena(workspace, workspace_bytes);
  return sinew::transferring::find_corresponding_points(own.plan, {own.source, *target, own.skeleton}, arena, vertices,
                                                        shares);
}

}  // extern "C"
