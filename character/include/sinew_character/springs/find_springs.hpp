// SPDX-License-Identifier: MIT
// Chains of a character that should swing: what joints' names say, and what hangs off a body and ends freely; numbers for them by kind.
#ifndef SINEW_CHARACTER_FIND_SPRINGS_HPP
#define SINEW_CHARACTER_FIND_SPRINGS_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/springs.hpp"

namespace sinew {

// What swings. To add a kind: a row of kPresets in spring_presets.cpp, words for it in swing_words.cpp.
enum class SpringKind : uint8_t { kHair, kLongHair, kSkirt, kTail, kEar, kCape, kBust, kRibbon };

const char* spring_kind_text(SpringKind kind);                      // "hair", "long-hair", "skirt", ...
std::optional<SpringKind> spring_kind_of(const std::string& text);  // nullopt for another word
std::string spring_kinds_text();                                    // "hair, long-hair, ..."

constexpr float kKeptCertainty = 0.5f;  // chains of less are proposed, not kept

// A chain that is proposed.
struct FoundChain {
  SpringChain chain;  // its name is that of its first joint, or the file's
  SpringKind kind = SpringKind::kRibbon;
  double length = 0;    // from the first joint to the end
  std::string reason;   // why it swings, for the user
  float certainty = 1;  // 0..1
  bool own = false;     // the file's own
  bool kept = true;
};

// Chains of joints with numbers by preset_chain() and without colliders, in the order of their first joints. Bones' ends come from the skin of
// the last joint where no joint says them. A bare mesh's skeleton by sinew rig has such chains as well.
// Throws Error for a character without joints or weights.
std::vector<FoundChain> find_springs(const Character& character);

// The kind that joints' names and the chain's length speak for; for chains of a file.
SpringKind kind_of_chain(const SpringChain& chain, const Character& character);

// The length of a chain's bones and, beside it, each bone's [turning joints].
double chain_length(const SpringChain& chain, const std::vector<Joint>& joints, std::vector<double>* bones = nullptr);

// Numbers for the joints of a chain by its kind: stiffness goes with bones' lengths, so that chains of any size swing alike, and falls along the
// chain; gravity is a share of it; hit radii are those of the skin around the bones.
void preset_chain(SpringKind kind, const Character& character, SpringChain* chain);

}  // namespace sinew
#endif
