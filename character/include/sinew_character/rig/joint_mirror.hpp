// SPDX-License-Identifier: MIT
// Left and right of a skeleton, by names and by positions of its joints.
#ifndef SINEW_CHARACTER_JOINT_MIRROR_HPP
#define SINEW_CHARACTER_JOINT_MIRROR_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

enum class Side : int8_t { kNone = 0, kLeft = 1, kRight = -1 };

// LeftArm, arm_l, Arm.L, L_Arm, l-arm, LHipJoint, lHand. kNone for a name without a side.
Side side_of_name(const std::string& name);
// Returns the name of the joint on the other side; the same name if it has no side.
std::string other_side_name(const std::string& name);

struct JointMirror {
  bool exact = false;             // every joint has a mirror image, and parents match; if not, some partners are -1
  uint32_t axis = 0;              // axis across the plane: 0 = x
  float plane = 0;                // position on that axis
  std::vector<int32_t> partners;  // [J] mirror image, itself on the plane, or -1
};

// Partners are at most 0.5 % of the skeleton's longest side from each other's mirror images. Tries planes across x,
// z, y and returns the one with the most partners.
JointMirror find_joint_mirror(const std::vector<Joint>& joints);

// Returns the position of the plane across an axis: the center of joints paired by name, else of all joints. 0
// without joints.
float mirror_plane(const std::vector<Joint>& joints, uint32_t axis);

// Returns the mirrored point.
Vec3 mirrored(const Vec3& p, uint32_t axis, float plane);
float& component(Vec3* p, uint32_t axis);
float component(const Vec3& p, uint32_t axis);

}  // namespace sinew
#endif
