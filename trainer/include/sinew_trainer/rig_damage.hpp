// SPDX-License-Identifier: MIT
// Rigs damaged on purpose, one kind at a time: what `sinew check` should find.
#ifndef SINEW_TRAINER_RIG_DAMAGE_HPP
#define SINEW_TRAINER_RIG_DAMAGE_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

struct DamageKind {
  const char* name;                // "unweighted-patch"
  const char* what;                // one line
  std::vector<const char*> rules;  // of check_rules(): a new finding of any of them tells it
};
const std::vector<DamageKind>& damage_kinds();

struct DamagedRig {
  Character character;
  std::optional<Motion> motion;
};

// Condition of a damage: the character itself, a file of it, the walk that ships on it.
enum class DamageNeeds { kCharacter, kFile, kWalk };
DamageNeeds needs_of(const DamageKind& kind);

// The rig as it is, with what is needed: what a damaged one is compared with. nullopt where the character cannot have it.
std::optional<DamagedRig> undamaged(const Character& character, DamageNeeds needs);
// The same seed damages the same joints or vertices on every machine. nullopt where the rig has nothing that could be damaged so.
//   whole  undamaged(character, needs_of(kind))
std::optional<DamagedRig> damaged(const DamagedRig& whole, const DamageKind& kind, uint32_t seed);

}  // namespace sinew
#endif
