// SPDX-License-Identifier: MIT
// Which joint is which bone of a convention.
#ifndef SINEW_CHARACTER_PROFILE_STANDARD_BONES_HPP
#define SINEW_CHARACTER_PROFILE_STANDARD_BONES_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// [J] sinew_joint_standard_name() of the joints that are the convention's bones by the classes of their names, "" of others. Of VRM's trunk,
// which has three parts, the first, the middle one and the last; of fingers the last three joints.
std::vector<std::string> standard_bones(const std::vector<Joint>& joints, uint32_t naming);

}  // namespace sinew
#endif
