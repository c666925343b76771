// SPDX-License-Identifier: MIT
// Alignment, then the tree of the aligned source, then one query a vertex.
#include "transfer/match.hpp"

#include "bind/pipeline.hpp"
#include "grid/caller_units.hpp"

namespace sinew::transferring {
namespace {

// Rows of the source and its map name joints that exist.
sinew_status check_source(const TransferInput& input) {
  const sinew_bound_character& source = input.source;
  for (uint32_t j = 0; j < source.skeleton->joint_count; ++j) {
    const int32_t to = source.joint_map[j];
    if (to < -1 || to >= static_cast<int32_t>(input.skeleton.joint_count)) return SINEW_ERROR_RANGE;
  }
  const size_t n = source.skin.influence_count;
  for (size_t v = 0; v < source.mesh->vertex_count; ++v) {
    for (size_t i = v * n; i < (v + 1) * n; ++i)
      if (source.skin.joint_indices[i] >= source.skeleton->joint_count) return SINEW_ERROR_RANGE;
  }
  return SINEW_OK;
}

}  // namespace

bool Pair::allocate(Arena& arena, const TransferPlan& plan) {
  (void)source.allocate(arena, plan.source);
  (void)target.allocate(arena, plan.target);
  (void)source_joints.allocate(arena, plan.source);
  (void)target_joints.allocate(arena, plan.target);
  (void)map.allocate(arena, plan.source.joints, plan.target.joints);
  return arena.ok();
}

sinew_status Pair::build(const TransferPlan& plan, const TransferInput& input, Arena& arena) {
  sinew_status status = build_mesh_and_skeleton(*input.source.mesh, *input.source.skeleton, plan.source_up_axis,
                                                plan.source, arena, &source, &source_joints);
  if (status == SINEW_OK)
    status = build_mesh_and_skeleton(input.target, input.skeleton, plan.up_axis, plan.target, arena, &target,
                                     &target_joints);
  return status != SINEW_OK || arena.measuring() ? status : check_source(input);
}

uint32_t row_distance(const Rows& a, uint32_t a_vertex, const Rows& b, uint32_t b_vertex) {
  const uint16_t *const aj = a.joints_of(a_vertex), *const bj = b.joints_of(b_vertex);
  const uint32_t *const aw = a.weights_of(a_vertex), *const bw = b.weights_of(b_vertex);
  uint32_t sum = 0;
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    if (aj[i] == kNoJoint) continue;
    const uint32_t other = b.weight(b_vertex, aj[i]);
    sum += aw[i] > other ? aw[i] - other : other - aw[i];
  }
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    if (bj[i] == kNoJoint) continue;
    bool both = false;
    for (uint32_t k = 0; k < kRowSlots; ++k) both = both || aj[k] == bj[i];
    sum += both ? 0 : bw[i];
  }
  return sum;
}

bool has_weight(const Rows& rows, uint32_t vertex) {
  const uint32_t* const weights = rows.weights_of(vertex);
  uint32_t any = 0;
  for (uint32_t i = 0; i < kRowSlots; ++i) any |= weights[i];
  return any != 0;
}

void make_whole(const Rows& rows, uint32_t vertex) {
  uint32_t* const weights = rows.weights_of(vertex);
  uint64_t sum = 0;
  for (uint32_t i = 0; i < kRowSlots; ++i) sum += weights[i];
  if (sum == 0) return;
  for (uint32_t i = 0; i < kRowSlots; ++i)
    weights[i] = static_cast<uint32_t>((static_cast<uint64_t>(weights[i]) * kWholeRow + sum / 2) / sum);
}

void map_row(const JointCounterparts& map, const Rows& rows, uint32_t vertex) {
  uint16_t joints[kRowSlots];
  uint32_t weights[kRowSlots];
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    joints[i] = rows.joints_of(vertex)[i];
    weights[i] = rows.weights_of(vertex)[i];
  }
  rows.clear(vertex);
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    if (joints[i] != kNoJoint && map.target_of[joints[i]] >= 0)
      rows.add(vertex, static_cast<uint16_t>(map.target_of[joints[i]]), weights[i]);
  }
  make_whole(rows, vertex);
}

void Match::carry(const Rows& source_rows, uint32_t vertex, const Rows& out, uint32_t out_vertex) const {
  out.clear(out_vertex);
  const MatchedPoint& p = points[vertex];
  for (uint32_t k = 0; k < 3; ++k) {
    const uint16_t* const joints = source_rows.joints_of(p.corners[k]);
    const uint32_t* const weights = source_rows.weights_of(p.corners[k]);
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      if (joints[i] == kNoJoint) continue;
      const uint32_t weight = static_cast<uint32_t>(p.shares[k] * weights[i] + 0.5);
      if (weight > 0) out.add(out_vertex, joints[i], weight);
    }
  }
  // The point may lie in the one corner without weight.
  for (uint32_t k = 0; k < 3 && !has_weight(out, out_vertex); ++k) out.copy(out_vertex, source_rows, p.corners[k]);
  make_whole(out, out_vertex);
}

sinew_status find_match(const TransferPlan& plan, const TransferInput& input, const Pair& pair, const Rows& source_rows,
                        Arena& arena, Match* match) {
  const ArenaScope scope(arena);
  Alignment alignment;
  SurfaceTree tree;
  Vec3d* const positions = arena.alloc<Vec3d>(plan.source.vertices);
  uint8_t* const of_use = arena.alloc<uint8_t>(plan.source.vertices);
  uint32_t* const scratch = arena.alloc<uint32_t>(3 * size_t{plan.source.joints} + 1);
  (void)alignment.allocate(arena, plan.source.joints);
  if (!tree.allocate(arena, plan.source)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) {
    SurfaceTree::measure(arena, plan.source);
    return SINEW_OK;
  }
  const Mesh& source = pair.source;
  const Mesh& target = pair.target;
  if (plan.garment) {
    const Units from(*input.source.mesh, plan.source_up_axis), to(input.target, plan.up_axis);
    for (uint32_t v = 0; v < source.welded_count; ++v) {
      const Vec3i p = source.positions[v];
      positions[v] = {(from.zero(0) + from.length(p.x) - to.zero(0)) / to.side,
                      (from.zero(1) + from.length(p.y) - to.zero(1)) / to.side,
                      (from.zero(2) + from.length(p.z) - to.zero(2)) / to.side};
    }
  } else {
    alignment.find(pair.map, pair.source_joints, pair.target_joints, scratch);
    for (uint32_t v = 0; v < source.welded_count; ++v)
      positions[v] =
          alignment.warp(position_of(source.positions[v]), source_rows.joints_of(v), source_rows.weights_of(v));
  }
  for (uint32_t v = 0; v < source.welded_count; ++v) {
    of_use[v] = 0;
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      const uint16_t joint = source_rows.joints_of(v)[i];
      if (joint != kNoJoint && source_rows.weights_of(v)[i] > 0 && pair.map.target_of[joint] >= 0) of_use[v] = 1;
    }
  }
  tree.build(source, positions, of_use, arena);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (tree.item_count() == 0) return SINEW_ERROR_RANGE;
  constexpr uint32_t kVertexPiece = 256;
  constexpr double kNormalUnit = 1.0 / (1 << kNormalBits);
  plan.target.threads.ranges(target.welded_count, kVertexPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    for (uint32_t v = begin; v < end; ++v) {
      const Vec3i n = target.normals[v];
      const Vec3d normal = {n.x * kNormalUnit, n.y * kNormalUnit, n.z * kNormalUnit};
      match->points[v] =
          tree.nearest(position_of(target.positions[v]), normal, plan.garment ? Facing::kEither : Facing::kSame);
    }
  });
  return SINEW_OK;
}

}  // namespace sinew::transferring
