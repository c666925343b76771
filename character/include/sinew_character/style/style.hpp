// SPDX-License-Identifier: MIT
// A studio's style: answers about parts of one character (sinew/questions.h), so that parts like them are bound alike in
// the next ones without asking. A style file is JSON; formats/spec/style.md describes it.
#ifndef SINEW_CHARACTER_STYLE_HPP
#define SINEW_CHARACTER_STYLE_HPP

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// What tells a part again: lengths are in longest sides of the character's box.
struct PartFeatures {
  bool body = false;                    // the part with most vertices
  double size = 0;                      // its share of the vertices
  double radius = 0;                    // mean distance of its vertices from their middle
  std::array<double, 3> position = {};  // that middle, from the middle of the box
  std::string joint;                    // with most of its weight as proposed
};

// One answer, and the part that it was about.
struct StyleRule {
  PartFeatures part;
  uint16_t kind = 0;  // sinew_answer_kind
  std::string joint;  // of SINEW_ANSWER_RIGID
  int steps_up = -1;  // from part.joint up to `joint`, 0 = the same; -1 where it is not above it
  std::array<double, 3> joint_position = {};  // as part.position
};

// The answers about one character, and its joints: other rigs are left alone.
struct StyleSheet {
  std::vector<std::pair<std::string, std::array<double, 3>>> joints;  // names and positions
  std::vector<StyleRule> rules;
};

struct Style {
  std::vector<StyleSheet> sheets;  // one for each character that answers were about
};

// A bind's questions and where its parts are, as BindResult and CharacterBind have them.
struct BindQuestions {
  const std::vector<sinew_question>& questions;
  const std::vector<uint32_t>& vertex_parts;  // [V]
  Axis up_axis = Axis::kY;                    // of the character; a style has y up
};

// The rules that the answers about a character make; answers about parts that are no question make none.
StyleSheet learn_style(const Character& character, const BindQuestions& asked,
                       const std::vector<sinew_answer>& answers);

// Answers for the questions about parts that look like those of a rule, from the sheets of characters of the same kind:
// at least two thirds of the joints of either have a namesake in the other, for rigid answers at the same position. Parts match mirrored ones
// as well, across the middle of the box. A joint is found by its name, by the words of its name, or by its position above
// the part's own joint, and has to stand where it stood; a rule whose joint is not there gives no answer.
//   flags  [J] SINEW_JOINT_* or empty: joints that must get no weight are not there
std::vector<sinew_answer> answer_by_style(const Style& style, const Character& character, const BindQuestions& asked,
                                          const std::vector<uint8_t>& flags);

// Throws Error with file, and what was expected.
Style read_style(const std::string& path);
void write_style(const std::string& path, const Style& style);

}  // namespace sinew
#endif
