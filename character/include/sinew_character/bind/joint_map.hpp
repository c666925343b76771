// SPDX-License-Identifier: MIT
// Which joint of one skeleton stands for which of another, by their names. By anatomy and from files: map_skeleton.hpp.
#ifndef SINEW_CHARACTER_JOINT_MAP_HPP
#define SINEW_CHARACTER_JOINT_MAP_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// [source joints] the target's joint that stands for it, or -1.
using JointMapping = std::vector<int32_t>;

// Joints of the same name.
JointMapping map_joints_by_name(const std::vector<Joint>& source, const std::vector<Joint>& target);

size_t mapped_count(const JointMapping& mapping);

}  // namespace sinew
#endif
