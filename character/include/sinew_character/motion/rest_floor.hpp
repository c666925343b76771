// SPDX-License-Identifier: MIT
// Motions whose frames have another up than their rest pose.
#ifndef SINEW_CHARACTER_REST_FLOOR_HPP
#define SINEW_CHARACTER_REST_FLOOR_HPP

#include <optional>

#include "sinew_formats/motion.hpp"

namespace sinew {

// The same motion with its frames turned upright: some captures draw their skeleton with y up and go over a floor across z. nullopt where rest pose and
// frames agree on up, where the rest pose does not stand, and where the body lies on the rest pose's own floor, as somebody asleep does. A guess, which a
// note of the motion tells.
std::optional<Motion> motion_on_rest_floor(const Motion& motion);

}  // namespace sinew
#endif
