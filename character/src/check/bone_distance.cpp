// SPDX-License-Identifier: MIT
// Distances from points to segments.
#include <algorithm>
#include <cmath>

#include "sinew_character/check/label_check.hpp"

namespace sinew {

BoneDistance::BoneDistance(const Character& character) : children_(character.joints.size()) {
  Point3 low{}, high{};
  for (size_t v = 0; v < character.vertices.size(); ++v) {
    const Vec3& p = character.vertices[v];
    const Point3 q = {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
    for (size_t i = 0; i < 3; ++i) {
      low[i] = v == 0 ? q[i] : std::min(low[i], q[i]);
      high[i] = v == 0 ? q[i] : std::max(high[i], q[i]);
    }
  }
  const double side = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  if (side > 0) scale_ = 1 / side;
  for (size_t j = 0; j < character.joints.size(); ++j) {
    const Vec3& p = character.joints[j].position;
    joints_.push_back({static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
    const int parent = character.joints[j].parent;
    if (parent >= 0 && static_cast<size_t>(parent) < children_.size())
      children_[static_cast<size_t>(parent)].push_back(j);
  }
  ends_ = joints_;
}

void BoneDistance::set_leaf_end(size_t joint, const Point3& end) {
  if (children_[joint].empty()) ends_[joint] = end;
}

double BoneDistance::operator()(const Vec3& point, size_t joint) const {
  const Point3 p = {static_cast<double>(point.x), static_cast<double>(point.y), static_cast<double>(point.z)};
  const Point3& a = joints_[joint];
  const auto squared_to = [&](const Point3& b) {  // the segment from the joint to b
    double along = 0, length = 0, result = 0;
    for (size_t i = 0; i < 3; ++i) {
      along += (p[i] - a[i]) * (b[i] - a[i]);
      length += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
    for (size_t i = 0; i < 3; ++i) {
      const double d = p[i] - a[i] - t * (b[i] - a[i]);
      result += d * d;
    }
    return result;
  };
  double best = squared_to(ends_[joint]);
  for (const size_t child : children_[joint]) best = std::min(best, squared_to(joints_[child]));
  return scale_ * std::sqrt(best);
}

}  // namespace sinew
