// SPDX-License-Identifier: MIT
// Which joint of a target stands for which of a source of weights, wherever that is known from.
#ifndef SINEW_CHARACTER_FIND_JOINT_MAP_HPP
#define SINEW_CHARACTER_FIND_JOINT_MAP_HPP

#include <string>

#include "sinew_character/bind/transfer.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Which joint of the target (a character of the file `path`) stands for which of the source's [source joints]: by the file `map` where
// it is not empty, by equal names where most joints have one, else by anatomy. Throws Error where none does.
JointMapping find_joint_map(const Character& source, const std::string& map, const std::string& path,
                            const Character& target, std::string* mapped_by);

}  // namespace sinew
#endif
