// SPDX-License-Identifier: MIT
// Distances from points to the bones of a skeleton, in longest sides of the mesh: for label checks and nearest bones.
#ifndef SINEW_CHARACTER_BONE_DISTANCE_HPP
#define SINEW_CHARACTER_BONE_DISTANCE_HPP

#include <array>
#include <vector>

#include "sinew_formats/base/point.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// A joint moves the segments to its children; a leaf is a point until it is given an end.
class BoneDistance {
 public:
  explicit BoneDistance(const Character& character);
  double operator()(const Vec3& point, size_t joint) const;
  void set_leaf_end(size_t joint, const Point3& end);  // does nothing for a joint with children

 private:
  std::vector<Point3> joints_, ends_;
  std::vector<std::vector<size_t>> children_;
  double scale_ = 1;
};

}  // namespace sinew
#endif
