// SPDX-License-Identifier: MIT
// Left and right of a skeleton: by the names of its joints, and by their positions.
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
// The name of the other side's joint; the same name for one without a side.
std::string other_side_name(const std::string& name);

struct JointMirror {
  bool exact = false;             // every joint has its mirror image, as have parents; if not, partners hold -1 as well
  uint32_t axis = 0;              // that the plane is across: 0 = x
  float plane = 0;                // where it is on that axis
  std::vector<int32_t> partners;  // [J] mirror image, itself on the plane, or -1
};

// Partners are 0.5 % of the skeleton's longest side from each other's mirror images at most. Tries a plane across x, z, y,
// and takes the one with the most partners.
JointMirror find_joint_mirror(const std::vector<Joint>& joints);

// Where the plane across an axis would be: the middle of those that names pair, else of all joints. 0 without joints.
float mirror_plane(const std::vector<Joint>& joints, uint32_t axis);

// The point on the other side.
Vec3 mirrored(const Vec3& p, uint32_t axis, float plane);
float& component(Vec3* p, uint32_t axis);
float component(const Vec3& p, uint32_t axis);

}  // namespace sinew
#endif
