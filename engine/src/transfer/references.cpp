// SPDX-License-Identifier: MIT
// Rays across the bones of both skeletons.
#include "transfer/references.hpp"

namespace sinew {
namespace {

constexpr uint32_t kRays = 4, kStations = 2;
constexpr double kShortestBone = 1e-3, kLongestRay = 0.25;  // of the longest side
constexpr double kLeastRatio = 0.35, kMostRatio = 2.8;      // of the two rays' lengths, beside the skeletons' ratio
constexpr double kHalfRoot = 0.70710678118654752440;        // the cosine of 45 degrees

// The first triangle that the ray hits. False where there is none.
bool first_hit(const Mesh& mesh, Vec3d origin, Vec3d direction, TrianglePosition* position, double* distance) {
  bool any = false;
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
    const uint32_t* const c = mesh.triangles + 3 * static_cast<size_t>(t);
    const Vec3d a = position_of(mesh.positions[c[0]]);
    const Vec3d e1 = position_of(mesh.positions[c[1]]) - a, e2 = position_of(mesh.positions[c[2]]) - a;
    const Vec3d h = cross(direction, e2);
    const double det = dot(e1, h);
    if (absolute(det) < 1e-14) continue;
    const Vec3d s = origin - a;
    const double u = dot(s, h) / det;
    if (u < 0 || u > 1) continue;
    const Vec3d q = cross(s, e1);
    const double w = dot(direction, q) / det;
    if (w < 0 || u + w > 1) continue;
    const double length = dot(e2, q) / det;
    if (length <= 1e-6 || (any && length >= *distance)) continue;
    any = true;
    *distance = length;
    *position = {{c[0], c[1], c[2]}, {1 - u - w, u, w}};
  }
  return any;
}

// The part of v across the unit vector u, as a unit vector.
Vec3d across(Vec3d v, Vec3d u) { return unit(v - dot(v, u) * u); }

Vec3d point_of(const Mesh& mesh, const TrianglePosition& position) {
  Vec3d sum;
  for (uint32_t k = 0; k < 3; ++k) sum = sum + position.shares[k] * position_of(mesh.positions[position.corners[k]]);
  return sum;
}

struct Bone {
  Vec3d source, target;                      // where it begins
  Vec3d source_direction, target_direction;  // to its end
};

// From the joint to its first mapped joint below; of a leaf half its parent's bone on.
bool bone_of(const Pair& pair, uint32_t joint, Bone* bone) {
  const Skeleton& source = pair.source_joints;
  const Skeleton& target = pair.target_joints;
  bone->source = position_of(source.positions[joint]);
  bone->target = position_of(target.positions[pair.map.same[joint]]);
  for (uint32_t k = 0; k < source.joint_count; ++k) {
    if (pair.map.same[k] < 0) continue;
    int32_t above = source.parents[k];
    while (above >= 0 && pair.map.same[above] < 0) above = source.parents[above];
    if (above != static_cast<int32_t>(joint)) continue;
    bone->source_direction = position_of(source.positions[k]) - bone->source;
    bone->target_direction = position_of(target.positions[pair.map.same[k]]) - bone->target;
    return true;
  }
  const int32_t parent = source.parents[joint];
  if (parent < 0 || pair.map.same[parent] < 0) return false;
  bone->source_direction = 0.5 * (bone->source - position_of(source.positions[parent]));
  bone->target_direction = 0.5 * (bone->target - position_of(target.positions[pair.map.same[parent]]));
  return true;
}

// Keeps `most` places that lie far apart on the source, the first one and then always the farthest.
uint32_t thin_out(const Mesh& source, uint32_t count, uint32_t most, double* distance, Reference* points) {
  if (count <= most) return count;
  for (uint32_t i = 0; i < count; ++i) distance[i] = 1e300;
  for (uint32_t kept = 0; kept < most; ++kept) {
    uint32_t best = kept;
    for (uint32_t i = kept; i < count && kept > 0; ++i) best = distance[i] > distance[best] ? i : best;
    const Reference point = points[best];
    points[best] = points[kept];
    distance[best] = distance[kept];
    points[kept] = point;
    const Vec3d at = point_of(source, point.source);
    for (uint32_t i = kept + 1; i < count; ++i)
      distance[i] = lesser(distance[i], length(point_of(source, points[i].source) - at));
  }
  return most;
}

}  // namespace

uint32_t References::capacity(const TransferPlan& plan) {
  return plan.pair_count > 0 ? plan.pair_count : kRays * kStations * plan.source.joints;
}

bool References::allocate(Arena& arena, const TransferPlan& plan) {
  points = arena.alloc<Reference>(capacity(plan));
  return arena.ok();
}

sinew_status References::find(const TransferPlan& plan, const Pair& pair, Arena& arena) {
  const ArenaScope scope(arena);
  Alignment alignment;
  (void)alignment.allocate(arena, plan.source.joints);
  uint32_t* const scratch = arena.alloc<uint32_t>(3 * size_t{plan.source.joints} + 1);
  double* const distance = arena.alloc<double>(capacity(plan));
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  count = 0;
  if (arena.measuring()) return SINEW_OK;
  for (uint32_t i = 0; i < plan.pair_count; ++i) {
    const sinew_vertex_pair& one = plan.pairs[i];
    if (one.source >= pair.source.vertex_count || one.target >= pair.target.vertex_count) return SINEW_ERROR_RANGE;
    const uint32_t s = pair.source.vertex_to_welded[one.source], t = pair.target.vertex_to_welded[one.target];
    points[count++] = {{{s, s, s}, {1, 0, 0}}, {{t, t, t}, {1, 0, 0}}};
  }
  if (plan.pair_count > 0) return SINEW_OK;

  alignment.find(pair.map, pair.source_joints, pair.target_joints, scratch);
  for (uint32_t j = 0; j < pair.source_joints.joint_count; ++j) {
    Bone bone;
    if (pair.map.same[j] < 0 || !bone_of(pair, j, &bone)) continue;
    if (length(bone.source_direction) < kShortestBone || length(bone.target_direction) < kShortestBone) continue;
    const Vec3d along = unit(bone.source_direction), target_along = unit(bone.target_direction);
    const Vec3d first = across(absolute(along.z) < 0.8 ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0}, along);
    const Vec3d second = cross(along, first);
    for (uint32_t station = 0; station < kStations; ++station) {
      const double at = 0.5 * station;
      for (uint32_t ray = 0; ray < kRays; ++ray) {
        // Quarter turns, at the middle by an eighth on.
        Vec3d direction = ray % 2 == 0 ? first : second, next = ray % 2 == 0 ? second : -1.0 * first;
        if (ray >= 2) {
          direction = -1.0 * direction;
          next = -1.0 * next;
        }
        if (station > 0) direction = kHalfRoot * (direction + next);
        const Vec3d target_direction = across(alignment.joints[j].rotation * direction, target_along);
        Reference found;
        double source_length = 0, target_length = 0;
        if (!first_hit(pair.source, bone.source + at * bone.source_direction, direction, &found.source,
                       &source_length) ||
            source_length > kLongestRay ||
            !first_hit(pair.target, bone.target + at * bone.target_direction, target_direction, &found.target,
                       &target_length))
          continue;
        const double ratio = target_length / (source_length * alignment.scale);
        if (ratio > kLeastRatio && ratio < kMostRatio) points[count++] = found;
      }
    }
  }
  count = thin_out(pair.source, count, kFoundReferences, distance, points);
  return SINEW_OK;
}

}  // namespace sinew
