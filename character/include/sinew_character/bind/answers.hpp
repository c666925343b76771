// SPDX-License-Identifier: MIT
// Text form of answers about parts (sinew/questions.h).
#ifndef SINEW_CHARACTER_ANSWERS_HPP
#define SINEW_CHARACTER_ANSWERS_HPP

#include <string>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_formats/character.hpp"

namespace sinew {

// Words of sinew_answer_kind: "proposed", "rigid", ...
const std::vector<std::string>& answer_names();

// "rigid:hand.L", "soft", "hard", "softer", "host" or "proposed".
std::string answer_text(const std::vector<Joint>& joints, uint16_t kind, uint16_t joint);

// Parses PART=ANSWER: a vertex of the part, and an answer as above. The answer is for all equal parts.
// Throws Error that lists the possible joints or answers.
sinew_answer parse_answer(const std::string& text, const Character& character);

}  // namespace sinew
#endif
