// SPDX-License-Identifier: MIT
// Makes chains of joints for garments without joints: skirts, coats and capes.
#ifndef SINEW_CHARACTER_MAKE_CHAINS_HPP
#define SINEW_CHARACTER_MAKE_CHAINS_HPP

#include <string>
#include <vector>

#include "sinew_character/springs/find_springs.hpp"

namespace sinew {

// The new chains of one garment.
struct MadeChains {
  SpringKind kind = SpringKind::kSkirt;
  size_t on = 0;                  // parent joint of the chains
  size_t chains = 0, joints = 0;  // joints of all chains, which are the character's last ones
  size_t vertices = 0;            // number of vertices that follow them
  bool closed = false;            // the chains form a ring
  float certainty = 0;            // 0..1
};

// Appends chains of three joints to a bound character for each garment without joints, and binds the garment's
// vertices to them: with weight 0 at the top and 0.4 at the hem, so that the rest follows the body and legs stay
// inside a skirt. Between and along the lines of joints, weights change linearly. Everything else keeps its weights.
// Panels beside a leg are children of the leg, others of the hips or the chest. The chains are named after their
// garment (LeftSkirt1_1), so that find_springs() recognizes them. Finds nothing on bodies without two legs.
//   influence_count  maximum number of influences per vertex; at least 1
// Throws Error for a character without joints or weights.
std::vector<MadeChains> make_chains(size_t influence_count, Character* character);

// "laid 8 chains of 3 joints into a skirt on Hips, 412 vertices follow them (certainty 90 %)".
std::string made_chains_text(const MadeChains& made, const std::vector<Joint>& joints);

}  // namespace sinew
#endif
