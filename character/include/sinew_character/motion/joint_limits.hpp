// SPDX-License-Identifier: MIT
// How far joints may turn: from a text file (formats/spec/limits.md), a robot's URDF, or by what they are for.
#ifndef SINEW_CHARACTER_JOINT_LIMITS_HPP
#define SINEW_CHARACTER_JOINT_LIMITS_HPP

#include <string>
#include <vector>

#include "sinew/joint_limits.h"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {

// For sinew_keep_joint_limits(), of poses of motion_of(target.joints): axes are those of the world at rest.
//   source  "human", a .urdf, or a text file of lines hinge, ball and fixed
//   up      of the target's world, for "human": "x", "y", "z", or "auto"
// Throws Error with the file and line: a joint that does not exist, a range that is none, a body or a robot that is another one.
std::vector<sinew_joint_limit> joint_limits(const std::string& source, const MapRig& target, MaybeAxis up);

// The three of them. A human body has hard ends, wider than what one does in everyday life: thighs from straight down, upper arms from
// straight aside, knees and elbows from the straight limb to the side that feet and bends at rest show.
std::vector<sinew_joint_limit> read_joint_limits(const std::string& path, const MapRig& target);
// Of revolute, continuous and fixed joints whose link or own name is a joint of the target, which stands as the URDF does at zero,
// however its world is turned.
std::vector<sinew_joint_limit> urdf_joint_limits(const std::string& path, const MapRig& target);
std::vector<sinew_joint_limit> human_joint_limits(const MapRig& target, MaybeAxis up);

}  // namespace sinew
#endif
