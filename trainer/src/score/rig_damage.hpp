// SPDX-License-Identifier: MIT
// Damages by what they spoil.
#ifndef SINEW_SCORE_RIG_DAMAGE_HPP
#define SINEW_SCORE_RIG_DAMAGE_HPP

#include <random>
#include <string>

#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_trainer/rig_damage.hpp"

namespace sinew {

class Draws {
 public:
  explicit Draws(uint32_t seed) : draws_(seed) {}
  size_t below(size_t count) { return draws_() % count; }
  double share() { return static_cast<double>(draws_()) / 4294967296.0; }
  template <class T>
  const T& of(const std::vector<T>& list) {
    return list[below(list.size())];
  }

 private:
  std::mt19937 draws_;
};

// False where there is nothing to damage; the character may be half changed then.
bool damage_weights(const std::string& kind, Draws* draws, Character* character);
bool damage_skeleton(const std::string& kind, Draws* draws, Character* character);
bool is_file_damage(const std::string& kind);
bool is_clip_damage(const std::string& kind);
// Written as .glb and read again; kind "" as it is.
std::optional<Character> damage_file(const std::string& kind, Draws* draws, const Character& character);
// The walk that ships, on the character.
std::optional<Motion> walk_of(const Character& character);
bool damage_clip(const std::string& kind, Draws* draws, const Character& character, Motion* motion);

// Joints of arms, legs and the head with at least 8 vertices of their own that deform.
std::vector<size_t> limb_joints(const Character& character, const JointVerdicts& verdicts);
std::vector<std::vector<uint32_t>> vertices_by_joint(const Character& character);
float longest_side(const Character& character);

}  // namespace sinew
#endif
