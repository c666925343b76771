// SPDX-License-Identifier: MIT
// Binds of the session's character, as the page wishes them: shown ones, previews of answers, a style's answers.
#ifndef SINEW_WEB_BINDS_HPP
#define SINEW_WEB_BINDS_HPP

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "session.hpp"
#include "sinew/sinew.h"

namespace sinew::web {

using Json = nlohmann::json;

// How the page wants characters bound.
struct Wish {
  Axis up_axis = Axis::kY;
  uint32_t method = 0, rigid_parts = 0, softness_percent = 100, influences = 4;
  bool symmetric = false;
  std::vector<size_t> never, always;  // joints that the user switched off, and those that were off
  std::string to_pose;                // rest pose that it is shown and written in: "t", "a", "" as it stands
  sinew_progress progress = nullptr;
};

// text: {method, upAxis, symmetric, rigidParts, softness, influences, never, always, toPose}
Wish read_wish(const char* text, sinew_progress progress);
// text: [[vertex, kind, joint], ...]
std::vector<sinew_answer> read_answers(const std::string& text);
// What is shown and written from then on. Returns figures, the result's hash and the questions.
Json bind_shown(Session& s, const Wish& wish, const std::vector<sinew_answer>& answers);
// A bind that shows weights while a joint is dragged: no questions, no sums.
Json rebind(Session& s, const Wish& wish, const std::vector<sinew_answer>& answers);
// Shows the character as these answers would bind it; what was taken stays what is written.
Json preview(Session& s, const Wish& wish, const std::vector<sinew_answer>& answers);
// Answers that the loaded style has for the character: with each its question, and the question's number in
// web_buffer(kVertexQuestions).
Json style_answers(Session& s, const Wish& wish);
// The loaded style with these answers.
void save_style(Session& s, const Wish& wish, const std::vector<sinew_answer>& answers, const std::string& path);

}  // namespace sinew::web
#endif
