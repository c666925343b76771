// SPDX-License-Identifier: MIT
// Which joint of a character moves as which joint of a motion, and what joints are for.
#ifndef SINEW_CLI_MOTION_MAP_HPP
#define SINEW_CLI_MOTION_MAP_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew::cli {

struct JointMap {
  std::vector<int> sources;  // [target] joint of the source, or -1
  std::string how;           // "their names", for the user
};

// From a file where `map_file` is not empty, else by equal names. The names of both files are for messages. Throws Error with the
// line for a joint that does not exist, and where no joint is mapped.
JointMap map_joints(const std::vector<Joint>& target, const std::vector<Joint>& source, const std::string& target_file,
                    const std::string& source_file, const std::string& map_file);

// sinew_joint_class [target]: by the joints' own names, else by those of their sources.
std::vector<uint8_t> motion_classes(const std::vector<Joint>& target, const std::vector<Joint>& source,
                                    const std::vector<int>& sources);

}  // namespace sinew::cli
#endif
