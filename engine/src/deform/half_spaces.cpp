// SPDX-License-Identifier: MIT
// One plane a folding joint, and the vertices near it that belong to one of its sides.
#include "deform/half_spaces.hpp"

namespace sinew::deform {
namespace {

constexpr double kLeastFold = 0.1;        // growth of the cosine between the bones, below which nothing touches
constexpr double kFullFold = 0.3;         // from here on the plane holds; before, it comes nearer
constexpr double kLeastNormal = 0.2;      // of the difference of the bones: no plane where they lie on each other
constexpr double kReach = 0.9;            // of the shorter bone
constexpr uint32_t kLeastWeight = 39321;  // 0.6 for the joint and its parent together
constexpr double kGap = 0.0005;           // of the size, between the two sides

Vec3d turned(const PosedJoint& joint, Vec3d v) { return rotate(joint.motion.real, v); }

BendPlane find_plane(const PosedJoints& posed, uint32_t j) {
  BendPlane plane = {j, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 0};
  const RestJoint& joint = posed.rest->skeleton[j];
  if (joint.parent < 0 || joint.hinge == 0) return plane;
  if (posed.joints[j].group == posed.joints[joint.parent].group) return plane;
  const Vec3d up = turned(posed.joints[joint.parent], joint.to_parent),
              along = turned(posed.joints[j], joint.to_children);
  const double fold = dot(up, along) - dot(joint.to_parent, joint.to_children);
  if (fold < kLeastFold) return plane;
  const Vec3d across = up - along;
  if (length(across) < kLeastNormal) return plane;
  plane.rest_normal = unit(joint.to_parent - joint.to_children);
  plane.normal = unit(across);
  plane.center = move(posed.joints[j].motion, joint.position);
  const double own = joint.bone_length > 0.3 * joint.parent_length ? joint.bone_length : 0.3 * joint.parent_length;
  plane.reach = kReach * (own < joint.parent_length ? own : joint.parent_length);
  if (fold < kFullFold) plane.slack = plane.reach * (kFullFold - fold) / (kFullFold - kLeastFold);
  return plane;
}

// The half space of a vertex by a plane, if it is near its joint and belongs to its two bones.
bool find_side(const DeformRest& rest, const BendPlane& plane, uint32_t v, HalfSpace* space) {
  const RestJoint& joint = rest.skeleton[plane.joint];
  const Vec3d from = rest.position(v) - joint.position;
  if (dot(from, from) >= plane.reach * plane.reach) return false;
  const size_t n = rest.influence_count;
  uint32_t own = 0, above = 0;
  for (size_t at = v * n; at < (v + 1) * n; ++at) {
    if (rest.joints[at] == plane.joint) own += rest.weights[at];
    if (static_cast<int32_t>(rest.joints[at]) == joint.parent) above += rest.weights[at];
  }
  if (own + above <= kLeastWeight) return false;
  const double side = above >= own ? 1 : -1, gap = kGap * rest.size;
  const double at_rest = side * dot(plane.rest_normal, from);
  const double least = at_rest > gap ? gap : at_rest < 0 ? at_rest : 0;
  space->normal = side * plane.normal;
  space->offset = side * dot(plane.normal, plane.center) + least - plane.slack;
  return true;
}

}  // namespace

void find_half_spaces(const PosedJoints& posed, const Threads& threads, BendPlane* planes, HalfSpace* spaces) {
  const DeformRest& rest = *posed.rest;
  uint32_t count = 0;
  for (uint32_t j = 0; j < rest.joint_count; ++j) {
    const BendPlane plane = find_plane(posed, j);
    if (plane.reach > 0) planes[count++] = plane;
  }
  threads.ranges(rest.vertex_count, kPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    for (uint32_t v = begin; v < end; ++v) {
      spaces[v] = {{0, 0, 0}, 0};
      for (uint32_t p = count; p > 0 && !find_side(rest, planes[p - 1], v, spaces + v); --p) {  // the last joint's
      }
    }
  });
}

}  // namespace sinew::deform
