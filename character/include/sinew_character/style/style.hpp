// SPDX-License-Identifier: MIT
// A studio's style: answers about parts of one character (sinew/questions.h), so that similar parts of other
// characters are bound alike without questions. A style file is JSON; formats/spec/style.md describes it.
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

// Features for recognizing a part; lengths are in longest sides of the character's box.
struct PartFeatures {
  bool body = false;                    // the part with most vertices
  double size = 0;                      // its share of the vertices
  double radius = 0;                    // mean distance of its vertices from their center
  std::array<double, 3> position = {};  // that center, relative to the center of the box
  std::string joint;                    // joint with most of its proposed weight
};

// One answer and its part.
struct StyleRule {
  PartFeatures part;
  uint16_t kind = 0;  // sinew_answer_kind
  std::string joint;  // of SINEW_ANSWER_RIGID
  int steps_up = -1;  // levels from part.joint up to `joint`, 0 = the same; -1 if it is not an ancestor
  std::array<double, 3> joint_position = {};  // as part.position
};

// The answers about one character, and its joints, for recognizing similar rigs.
struct StyleSheet {
  std::vector<std::pair<std::string, std::array<double, 3>>> joints;  // names and positions
  std::vector<StyleRule> rules;
};

struct Style {
  std::vector<StyleSheet> sheets;  // one per character with answers
};

// A bind's questions and parts, as in BindResult and CharacterBind.
struct BindQuestions {
  const std::vector<sinew_question>& questions;
  const std::vector<uint32_t>& vertex_parts;  // [V]
  Axis up_axis = Axis::kY;                    // of the character; a style has y up
};

// Returns the rules from the answers about a character; answers about parts without a question are ignored.
StyleSheet learn_style(const Character& character, const BindQuestions& asked,
                       const std::vector<sinew_answer>& answers);

// Returns answers for questions about parts similar to those of a rule, from the sheets of characters of the same
// kind: at least two thirds of the joints of each have a namesake in the other, for rigid answers at the same
// position. Parts also match mirrored ones, across the center of the box. A joint is found by its name, by the words
// of its name, or as an ancestor of the part's joint, at the same position; a rule without its joint gives no answer.
//   flags  [J] SINEW_JOINT_* or empty: joints that must not get weight are ignored
std::vector<sinew_answer> answer_by_style(const Style& style, const Character& character, const BindQuestions& asked,
                                          const std::vector<uint8_t>& flags);

// Throws Error with the file and what was expected.
Style read_style(const std::string& path);
void write_style(const std::string& path, const Style& style);

}  // namespace sinew
#endif
