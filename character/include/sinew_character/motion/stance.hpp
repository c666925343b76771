// SPDX-License-Identifier: MIT
// Motions whose rest pose is no stance: bones along one axis, joints in frames of their own, a frame of the clip. What moves tells a
// stance all the same.
#ifndef SINEW_CHARACTER_STANCE_HPP
#define SINEW_CHARACTER_STANCE_HPP

#include <optional>
#include <string>

#include "sinew_formats/base/axis.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// The same motion with another rest pose: that of a body which stands upright, arms to its sides, as its own frames tell it. nullopt
// where the rest pose is a stance already, or where nobody can tell: no frames, no two legs.
//   up  of the motion's world
std::optional<Motion> standing_motion(const Motion& motion, MaybeAxis up = {});

}  // namespace sinew
#endif
