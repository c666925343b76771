// SPDX-License-Identifier: MIT
// Bone names of VMD files.
#ifndef SINEW_FORMATS_MOTION_VMD_BONES_HPP
#define SINEW_FORMATS_MOTION_VMD_BONES_HPP

#include <string>
#include <vector>

namespace sinew {

// The joint of person.hpp, or the control ("root", "center", "groove", "waist", "leftFootIk", "leftFootIkParent"),
// that a bone rotates; "" for a bone of none. Names are Japanese (Shift-JIS) or English, in any case, with the side
// before or behind: "\x8d\xb6\x98\x72", "arm_L", "Left arm", "Arm1-L[Y]".
std::string joint_of_vmd_bone(const std::string& name);

// Bones of one joint with different parts rotate it one after the other: "Ankle-L[Y]" and "Ankle-L[Z]".
std::string part_of_vmd_bone(const std::string& name);

// A goal of inverse kinematics, by its name.
bool is_vmd_ik(const std::string& name);

// The left side and the middle of all joints and controls, each once.
std::vector<std::string> vmd_joints();

}  // namespace sinew
#endif
