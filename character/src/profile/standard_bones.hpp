// SPDX-License-Identifier: MIT
// Which joint is which bone of a convention.
#ifndef SINEW_CHARACTER_PROFILE_STANDARD_BONES_HPP
#define SINEW_CHARACTER_PROFILE_STANDARD_BONES_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// The part of a joint in a body with one pelvis, one trunk, one neck, and one limb per kind and side.
struct BodyBone {
  uint8_t joint_class;  // sinew_joint_class
  int side;             // 1 left, -1 right, 0 in the middle
  uint32_t index;       // along the torso, the neck or a finger, from the body outwards
};

// How many joints of a chain count.
struct BodyChains {
  size_t trunk = SIZE_MAX, neck = SIZE_MAX;
};

// [J] by the classes of names; nullopt for joints that are none of these. Of a longer trunk the first, the middle one
// and the last, of fingers the last three joints.
std::vector<std::optional<BodyBone>> body_bones(const std::vector<Joint>& joints, const BodyChains& most = {});

// [J] sinew_joint_standard_name() of the joints that are the convention's bones by the classes of their names, "" of
// others. Of VRM's trunk, which has three parts, the first, the middle one and the last; of fingers the last three
// joints.
std::vector<std::string> standard_bones(const std::vector<Joint>& joints, uint32_t naming);

}  // namespace sinew
#endif
