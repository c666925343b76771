// SPDX-License-Identifier: MIT
// Finds chains of a character that should swing, by joint names or as chains off the body with a free end; gives them
// parameters by kind.
#ifndef SINEW_CHARACTER_FIND_SPRINGS_HPP
#define SINEW_CHARACTER_FIND_SPRINGS_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/springs.hpp"

namespace sinew {

// Kind of a chain. To add one: a row of kPresets in spring_presets.cpp, words for it in swing_words.cpp.
enum class SpringKind : uint8_t { kHair, kLongHair, kSkirt, kTail, kEar, kCape, kBust, kRibbon };

const char* spring_kind_text(SpringKind kind);                      // "hair", "long-hair", "skirt", ...
std::optional<SpringKind> spring_kind_of(const std::string& text);  // nullopt for another word
std::string spring_kinds_text();                                    // "hair, long-hair, ..."

constexpr float kKeptCertainty = 0.5f;  // chains below are proposed, not kept

// A proposed chain.
struct FoundChain {
  SpringChain chain;  // its name is that of its first joint, or from the file
  SpringKind kind = SpringKind::kRibbon;
  double length = 0;    // from the first joint to the end
  std::string reason;   // reason for the user
  float certainty = 1;  // 0..1
  bool own = false;     // the file's own
  bool kept = true;
};

// Returns chains with parameters by preset_chain() and without colliders, in the order of their first joints. Without
// an end joint the end of the last bone is taken from the skin. Skeletons made by sinew rig may have such chains too.
// Throws Error for a character without joints or weights.
std::vector<FoundChain> find_springs(const Character& character);

// Returns the kind by joint names and the chain's length, for chains of a file.
SpringKind kind_of_chain(const SpringChain& chain, const Character& character);

// Returns the length of a chain, and of each bone [rotating joints].
double chain_length(const SpringChain& chain, const std::vector<Joint>& joints, std::vector<double>* bones = nullptr);

// Sets the parameters of a chain's joints by its kind: stiffness is proportional to bone length, so that chains of
// any size swing alike, and decreases along the chain; gravity is a share of it; hit radii are those of the skin
// around the bones.
void preset_chain(SpringKind kind, const Character& character, SpringChain* chain);

}  // namespace sinew
#endif
