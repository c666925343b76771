// SPDX-License-Identifier: MIT
// The C API: the match of a transfer by itself, in the caller's vertices.
#include "api/arguments.hpp"
#include "core/build.hpp"
#include "sinew/published.h"
#include "transfer/match.hpp"
#include "transfer/rebind.hpp"

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
    sinew_transfer_options options = sinew_transfer_options_init();
    options.method = SINEW_TRANSFER_NEAREST;
    return plan_transfer(nullptr, {source, target, skeleton}, &options, &plan);
  }
};

sinew_status find_points(const TransferPlan& plan, const TransferInput& input, Arena& arena, uint32_t* vertices,
                         float* shares) {
  Pair pair;
  OwnRows rows;
  Match match;
  (void)pair.allocate(arena, plan);
  uint32_t* const scratch = arena.alloc<uint32_t>(size_t{2} * plan.source.joints);
  uint32_t* const caller = arena.alloc<uint32_t>(plan.source.vertices);  // [welded] a vertex of the caller's
  (void)rows.allocate(arena, plan.source);
  if (!match.allocate(arena, plan.target)) return SINEW_ERROR_WORKSPACE;
  const sinew_bound_character& source = input.source;
  sinew_status status = pair.build(plan, input, arena);
  if (status != SINEW_OK) return status;
  if (!arena.measuring()) {
    pair.map.complete(source.joint_map, pair.source_joints, pair.target_joints, scratch);
    rows.gather(pair.source, source.skin.joint_indices, source.skin.weights, source.skin.weight_format,
                source.skin.influence_count);
  }
  status = find_match(plan, input, pair, rows.rows(), arena, &match);
  if (status != SINEW_OK || arena.measuring()) return status;
  for (uint32_t v = plan.source.vertices; v-- > 0;) caller[pair.source.vertex_to_welded[v]] = v;
  for (uint32_t v = 0; v < plan.target.vertices; ++v) {
    const MatchedPoint& point = match.points[pair.target.vertex_to_welded[v]];
    for (size_t k = 0; k < 3; ++k) {
      vertices[size_t{3} * v + k] = caller[point.corners[k]];
      shares[size_t{3} * v + k] = static_cast<float>(point.shares[k]);
    }
  }
  return SINEW_OK;
}

}  // namespace
}  // namespace sinew::transferring

extern "C" {

sinew_status sinew_corresponding_points_workspace_size(const sinew_bound_character* source, const sinew_mesh* target,
                                                       const sinew_skeleton* skeleton, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (!sinew::kHasPublished) return SINEW_ERROR_NOT_BUILT;
  if (source == nullptr || source->mesh == nullptr || source->skeleton == nullptr || target == nullptr ||
      skeleton == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew::transferring::Arguments own;
  const sinew_status status = own.read(sinew::read_skeleton_counts, *source, *target, skeleton);
  if (status != SINEW_OK) return status;
  return sinew::measure(size_bytes, [&](sinew::Arena& arena) {
    return sinew::transferring::find_points(own.plan, {own.source, *target, own.skeleton}, arena, nullptr, nullptr);
  });
}

sinew_status sinew_corresponding_points(const sinew_bound_character* source, const sinew_mesh* target,
                                        const sinew_skeleton* skeleton, void* workspace, size_t workspace_bytes,
                                        uint32_t* vertices, float* shares) {
  if (!sinew::kHasPublished) return SINEW_ERROR_NOT_BUILT;
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
  return sinew::transferring::find_points(own.plan, {own.source, *target, own.skeleton}, arena, vertices, shares);
}

}  // extern "C"
