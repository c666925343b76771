// SPDX-License-Identifier: MIT
// How far joints are apart, straight and along the skeleton.
#include <algorithm>
#include <utility>

#include "bind/seam_steps.hpp"

namespace sinew {
namespace {

constexpr double kApart = 0.15;  // of the mesh's longest side
constexpr double kDetour = 2.5;  // times the straight way

}  // namespace

SkeletonPaths::SkeletonPaths(const std::vector<Joint>& joints, double size)
    : size_(size), depths_(joints.size(), 0), bones_(joints.size()) {
  for (const Joint& joint : joints) {
    positions_.push_back(point(joint.position));
    parents_.push_back(joint.parent);
  }
  for (size_t j = 0; j < joints.size(); ++j) {
    for (int up = parents_[j]; up >= 0 && joint_index(depths_[j]) < joints.size(); up = parents_[joint_index(up)])
      ++depths_[j];
    if (parents_[j] >= 0)
      bones_[joint_index(parents_[j])].push_back(positions_[j] - positions_[joint_index(parents_[j])]);
  }
  for (size_t j = 0; j < joints.size(); ++j)
    if (bones_[j].empty() && parents_[j] >= 0)
      bones_[j].push_back(0.5 * (positions_[j] - positions_[joint_index(parents_[j])]));
}

BonePoint SkeletonPaths::nearest(uint32_t joint, const Point3& from) const {
  const Point3 way = from - positions_[joint];
  BonePoint best = {joint, 0, 0, sinew::length(way), positions_[joint]};
  for (uint32_t b = 0; b < bones_[joint].size(); ++b) {
    const Point3& bone = bones_[joint][b];
    const double square = dot(bone, bone);
    if (square <= 0) continue;
    const double along = std::clamp(dot(way, bone) / square, 0.0, 1.0);
    const Point3 position = positions_[joint] + along * bone;
    const double distance = sinew::length(from - position);
    if (distance < best.distance) best = {joint, b, along, distance, position};
  }
  return best;
}

double SkeletonPaths::length(const BonePoint& a, const BonePoint& b) const {
  struct Climb {
    int joint;
    Point3 top;
    double length;
  };
  Climb x = {static_cast<int>(a.joint), a.position, 0}, y = {static_cast<int>(b.joint), b.position, 0};
  const auto climb = [&](Climb* one) {
    const Point3& joint = positions_[joint_index(one->joint)];
    one->length += sinew::length(one->top - joint);
    one->top = joint;
    one->joint = parents_[joint_index(one->joint)];
  };
  while (x.joint != y.joint) {
    Climb* const deeper = depths_[joint_index(x.joint)] >= depths_[joint_index(y.joint)] ? &x : &y;
    climb(deeper);
    if (deeper->joint < 0) return -1;
  }
  return x.length + y.length + sinew::length(x.top - y.top);
}

bool SkeletonPaths::are_apart(const BonePoint& a, const BonePoint& b) const {
  if (a.joint == b.joint) return false;
  const double path = length(a, b);
  return path > kApart * size_ && path > kDetour * sinew::length(a.position - b.position);
}

}  // namespace sinew
