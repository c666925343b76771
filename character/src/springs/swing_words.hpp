// SPDX-License-Identifier: MIT
// Words of a joint's name that mean swinging.
#ifndef SINEW_SPRINGS_SWING_WORDS_HPP
#define SINEW_SPRINGS_SWING_WORDS_HPP

#include <optional>
#include <string>

#include "sinew_character/springs/find_springs.hpp"

namespace sinew {

struct SwingWord {
  SpringKind kind;
  std::string word;
};
// The first word of the name that names something that swings: skirt in J_Sec_L_CoatSkirtBack1. nullopt where none does.
std::optional<SwingWord> swing_word(const std::string& name);
// Words of things that are held or worn and do not swing: a sword, a bag.
bool names_stiff_thing(const std::string& name);

}  // namespace sinew
#endif
