// SPDX-License-Identifier: MIT
// Which segments are the bones of a skeleton, for all stages that grow from bones or measure distances to them. The
// heat stage alone has one segment per joint (Skeleton::bone_tail).
#ifndef SINEW_SKELETON_BONES_HPP
#define SINEW_SKELETON_BONES_HPP

#include "skeleton/skeleton.hpp"

namespace sinew {

// Calls body(joint, head, tail) for every bone. A joint has a bone to each of its children; a leaf has one to its tip.
// The bones of one joint come in the order of its children's numbers. There are at most 2 J bones.
//   tips  [J] grid units; only those of leaves are read
template <class Body>
void each_bone(const Skeleton& skeleton, const Vec3i* tips, const Body& body) {
  for (uint32_t j = 0; j < skeleton.joint_count; ++j) {
    const int32_t parent = skeleton.parents[j];
    if (parent >= 0) body(static_cast<uint32_t>(parent), skeleton.positions[parent], skeleton.positions[j]);
    if (skeleton.child_count[j] == 0) body(j, skeleton.positions[j], tips[j]);
  }
}

// Bones of one joint.
inline uint32_t bone_count(const Skeleton& skeleton, uint32_t joint) {
  return skeleton.child_count[joint] != 0 ? skeleton.child_count[joint] : 1;
}

}  // namespace sinew
#endif
