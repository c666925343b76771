// SPDX-License-Identifier: MIT
// Joints for garments that have none: skirts, coats and capes get chains that can swing.
#ifndef SINEW_CHARACTER_MAKE_CHAINS_HPP
#define SINEW_CHARACTER_MAKE_CHAINS_HPP

#include <string>
#include <vector>

#include "sinew_character/springs/find_springs.hpp"

namespace sinew {

// The chains that one garment received.
struct MadeChains {
  SpringKind kind = SpringKind::kSkirt;
  size_t on = 0;                  // the joint that the chains hang on
  size_t chains = 0, joints = 0;  // joints of all chains; they are the character's last ones
  size_t vertices = 0;            // that follow them
  bool closed = false;            // the chains stand in a ring
  float certainty = 0;            // 0..1
};

// Appends chains of three joints to a bound character wherever a garment hangs off its body without joints of its own, and binds the garment's
// vertices to them, by nothing at the top and by four tenths of their weight at the hem: the rest goes on following the body, so that legs stay
// inside a skirt. Between two lines of joints, and along them, weights change linearly. Everything else keeps its weights. Panels beside a leg hang
// on the leg, others on the hips or the chest. The chains are named after their garment (LeftSkirt1_1), so that find_springs() takes them. Finds nothing on bodies without two legs.
//   influence_count  of a vertex, the most; at least 1
// Throws Error for a character without joints or weights.
std::vector<MadeChains> make_chains(size_t influence_count, Character* character);

// "laid 8 chains of 3 joints into a skirt on Hips, 412 vertices follow them (certainty 90 %)".
std::string made_chains_text(const MadeChains& made, const std::vector<Joint>& joints);

}  // namespace sinew
#endif
