// SPDX-License-Identifier: MIT
// The line that jobs end their notes with: what a check finds at once.
#ifndef SINEW_CHARACTER_CHECKED_NOTE_HPP
#define SINEW_CHARACTER_CHECKED_NOTE_HPP

#include <string>

#include "sinew_formats/character.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

// checked_line() of what is cheap; "" for a character without joints or weights.
std::string checked_note(const Character& character, const Motion* motion = nullptr);
// The same as a note of the character.
void add_checked_note(Character* character);

}  // namespace sinew
#endif
