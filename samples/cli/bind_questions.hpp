// SPDX-License-Identifier: MIT
// sinew bind --questions, --ask and --answer: parts that an artist should decide about, shown and asked.
#ifndef SINEW_CLI_BIND_QUESTIONS_HPP
#define SINEW_CLI_BIND_QUESTIONS_HPP

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sinew_character/bind/bind_character.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew::cli {

// The question with names instead of numbers, so that it outlives the bind.
struct PartQuestion {
  uint32_t vertex = 0;  // names the part in --answer
  uint32_t parts = 0, vertices = 0;
  std::string joint;                                         // with most of it as proposed
  double share = 0, doubt = 0, gain = 0;                     // 0 to 1; gain: doubt times share of the mesh
  std::vector<std::pair<std::string, double>> alternatives;  // as --answer takes them, and the L1 that they change
};
std::vector<PartQuestion> part_questions(const Character& character, const CharacterBind& bound);
// "part 812, 3 alike, 96 vertices: 62 % hand.L, 31 % doubt; rigid:hand.L, soft"
std::string question_text(const PartQuestion& part);
nlohmann::ordered_json question_json(const PartQuestion& part);

// Asks about each part on `out` and reads a number, an answer as --answer takes it without PART=, nothing (as proposed),
// or q (no more questions; so does the end of `in`). A picture with the part in orange is written for each:
// PICTURE.question1.png and so on.
//   picture  the output's path without its extension
std::vector<sinew_answer> ask(const Character& character, const CharacterBind& bound, const std::string& picture,
                              Axis up, std::istream& in, std::ostream& out);

}  // namespace sinew::cli
#endif
