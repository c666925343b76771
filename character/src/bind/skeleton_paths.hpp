// SPDX-License-Identifier: MIT
// How far apart two points of a body are along its skeleton.
#ifndef SINEW_CHARACTER_RIG_SKELETON_PATHS_HPP
#define SINEW_CHARACTER_RIG_SKELETON_PATHS_HPP

#include <cstdint>
#include <vector>

#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// A point on a joint's bones.
struct BonePoint {
  uint32_t joint = 0;
  uint32_t bone = 0;    // one for each child, or the stub of a leaf
  double along = 0;     // 0 at the joint, 1 at the bone's end
  double distance = 0;  // from where it was looked for
  Point3 position = {};
};

class SkeletonPaths {
 public:
  //   size  the mesh's longest side
  SkeletonPaths(const std::vector<Joint>& joints, double size);

  size_t joint_count() const { return positions_.size(); }
  // The nearest point on the bones of `joint`: segments to its children, of a leaf half its parent's bone on.
  BonePoint nearest(uint32_t joint, const Point3& from) const;
  // Along the bones; straight from limb to limb where both hang on one joint, so that hierarchies in which all limbs hang on a root at
  // the floor are as good as others. Negative where nothing joins them.
  double length(const BonePoint& a, const BonePoint& b) const;
  // Whether parts of the body that move apart meet where these two are near: the path is longer than 15 % of the size, and than two and
  // a half times the straight way.
  bool are_apart(const BonePoint& a, const BonePoint& b) const;

 private:
  double size_;
  std::vector<Point3> positions_;           // [J]
  std::vector<int> parents_, depths_;       // [J]
  std::vector<std::vector<Point3>> bones_;  // [J] from the joint to the end of each bone
};

}  // namespace sinew
#endif
