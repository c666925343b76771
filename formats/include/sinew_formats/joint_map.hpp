// SPDX-License-Identifier: MIT
// Which joint of one skeleton stands for which of another: by names, or as a file says.
#ifndef SINEW_FORMATS_JOINT_MAP_HPP
#define SINEW_FORMATS_JOINT_MAP_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// [source joints] the target's joint that stands for it, or -1.
using JointMapping = std::vector<int32_t>;

// Joints of the same name.
JointMapping map_joints_by_name(const std::vector<Joint>& source, const std::vector<Joint>& target);

// From a file of lines TARGET_JOINT SOURCE_JOINT; # begins a comment line. A target's joint may stand for several of the
// source's, a source's joint has one counterpart. Names with blanks are written with '_' in their place, as rig.txt does. Throws
// Error with the line of a joint that does not exist or is mapped twice, and when no joint is mapped.
JointMapping read_joint_map(const std::string& path, const std::vector<Joint>& source,
                            const std::vector<Joint>& target);

size_t mapped_count(const JointMapping& mapping);

}  // namespace sinew
#endif
