// SPDX-License-Identifier: MIT
// Rotation limits of joints: from a text file (formats/spec/limits.md), a robot's URDF, or for a human body.
#ifndef SINEW_CHARACTER_JOINT_LIMITS_HPP
#define SINEW_CHARACTER_JOINT_LIMITS_HPP

#include <string>
#include <vector>

#include "sinew/joint_limits.h"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {

// Returns limits for sinew_keep_joint_limits() and poses of motion_of(target.joints), with world axes at rest.
//   source  "human", a .urdf, or a text file of lines hinge, ball and fixed
//   up      up axis of the target's world, for "human": "x", "y", "z", or "auto"
// Throws Error with the file and line for a joint that does not exist, an invalid range, or a body or robot that does
// not match.
std::vector<sinew_joint_limit> joint_limits(const std::string& source, const MapRig& target, MaybeAxis up);

// The three sources. Human limits are hard limits, wider than everyday motion: thighs relative to straight down,
// upper arms to straight sideways, knees and elbows to the straight limb, in the bend direction of the feet and the
// rest pose.
std::vector<sinew_joint_limit> read_joint_limits(const std::string& path, const MapRig& target);
// URDF: revolute, continuous and fixed joints whose link or name is a joint of the target. The target at rest must be
// in the zero pose of the URDF, in any orientation.
std::vector<sinew_joint_limit> urdf_joint_limits(const std::string& path, const MapRig& target);
std::vector<sinew_joint_limit> human_joint_limits(const MapRig& target, MaybeAxis up);

}  // namespace sinew
#endif
