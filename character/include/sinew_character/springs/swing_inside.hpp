// SPDX-License-Identifier: MIT
// How much of what swings lies inside of the body.
#ifndef SINEW_CHARACTER_SWING_INSIDE_HPP
#define SINEW_CHARACTER_SWING_INSIDE_HPP

#include "sinew_formats/motion.hpp"
#include "sinew_formats/springs.hpp"

namespace sinew {

// [V] 1: a tenth of the vertex's weight or more is of joints that the springs turn.
std::vector<uint8_t> swinging_vertices(const Character& character, const Springs& springs);

struct InsideShare {
  size_t at_rest = 0;  // of the vertices that swing are inside in the rest pose
  double share = 0;    // 0..1 of the others, mean over frames
};

// Measures how many of the vertices that swing come into the rest of the surface, in 24 frames spread over a clip. A vertex is inside where lines through it
// along x and along z leave the surface on both sides.
//   swings  [V]
//   motion  whose joints are the character's, and of which `clip` is one
InsideShare inside_share(const Character& character, const std::vector<uint8_t>& swings, const Motion& motion,
                         const Clip& clip);

}  // namespace sinew
#endif
