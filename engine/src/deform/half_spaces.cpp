// SPDX-License-Identifier: MIT
// One plane a folding joint, and the vertices near it that belong to one of its sides.
#include "deform/half_spaces.hpp"

namespace sinew {
namespace {

constexpr double kLeastFold = 0.1;        // growth of the cosine between the bones, below which nothing touches
constexpr double kFullFold = 0.3;         // from here on the plane holds; before, it comes nearer
constexpr double kLeastNormal = 0.2;      // of the difference of the bones: no plane where they lie on each other
constexpr double kReach = 0.9;            // of the shorter bone
constexpr uint32_t kLeastWeight = 39321;  // 0.6 for the joint and its parent together
constexpr double kGap = 0.0005;           // of the size, between the two sides

Vec3d turned(const PosedJoint& joint, Vec3d v) { return rotate(joint.motion.real, v); }

BendPlane find_plane(const PosedJoints& posed, uint32_t j) {
  BendPlane plane = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 0};
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
  plane.centre = move(posed.joints[j].motion, joint.place);
  const double own = joint.bone_length > 0.3 * joint.parent_length ? joint.bone_length : 0.3 * joint.parent_length;
  plane.reach = kReach * (own < joint.parent_length ? own : joint.parent_length);
  if (fold < kFullFold) plane.slack = plane.reach * (kFullFold - fold) / (kFullFold - kLeastFold);
  return plane;
}

}  // namespace

void find_half_spaces(const PosedJoints& posed, BendPlane* planes, HalfSpace* spaces) {
  const DeformRest& rest = *posed.rest;
  bool any = false;
  for (uint32_t j = 0; j < rest.joint_count; ++j) {
    planes[j] = find_plane(posed, j);
    any = any || planes[j].reach > 0;
  }
  for (uint32_t v = 0; v < rest.vertex_count; ++v) spaces[v] = {{0, 0, 0}, 0};
  if (!any) return;
  const uint32_t n = rest.influence_count;
  const double gap = kGap * rest.size;
  for (uint32_t j = 0; j < rest.joint_count; ++j) {  // a later joint's plane takes the place of an earlier one's
    const BendPlane& plane = planes[j];
    if (!(plane.reach > 0)) continue;
    const RestJoint& joint = rest.skeleton[j];
    for (uint32_t v = 0; v < rest.vertex_count; ++v) {
      uint32_t own = 0, above = 0;
      for (uint32_t i = 0; i < n; ++i) {
        const size_t at = static_cast<size_t>(v) * n + i;
        if (rest.joints[at] == j) own += rest.weights[at];
        if (static_cast<int32_t>(rest.joints[at]) == joint.parent) above += rest.weights[at];
      }
      if (own + above <= kLeastWeight) continue;
      const Vec3d from = rest.position(v) - joint.place;
      if (dot(from, from) >= plane.reach * plane.reach) continue;
      const double side = above >= own ? 1 : -1;
      const double at_rest = side * dot(plane.rest_normal, from);
      const double least = at_rest > gap ? gap : at_rest < 0 ? at_rest : 0;
      spaces[v].normal = side * plane.normal;
      spaces[v].offset = side * dot(plane.normal, plane.centre) + least - plane.slack;
    }
  }
}

}  // namespace sinew
