// SPDX-License-Identifier: MIT
// Share of the swinging mesh that is inside the body.
#ifndef SINEW_CHARACTER_SWING_INSIDE_HPP
#define SINEW_CHARACTER_SWING_INSIDE_HPP

#include "sinew_formats/motion.hpp"
#include "sinew_formats/springs.hpp"

namespace sinew {

// Returns [V] 1: at least a tenth of the vertex's weight is on joints that the springs rotate.
std::vector<uint8_t> swinging_vertices(const Character& character, const Springs& springs);

struct InsideShare {
  size_t at_rest = 0;  // number of swinging vertices that are inside in the rest pose
  double share = 0;    // 0..1 of the others, mean over frames
};

// Measures how many swinging vertices are inside the rest of the surface, in 24 frames spread over a clip. A vertex
// is inside if lines through it along x and along z hit the surface on both sides.
//   swings  [V]
//   motion  motion of the character's joints that contains `clip`
InsideShare inside_share(const Character& character, const std::vector<uint8_t>& swings, const Motion& motion,
                         const Clip& clip);

}  // namespace sinew
#endif
