// SPDX-License-Identifier: MIT
// Answers by reference weights: every kind of answer is tried on all questions at once.
#include "sinew_trainer/artist.hpp"

#include <map>

#include "sinew_trainer/evaluate.hpp"

namespace sinew {
namespace {

constexpr double kSeen = 0.01;  // L1 of a vertex: what is less of a gain, nobody sees

// L1 over the vertices of every question.
std::vector<double> l1_of_questions(const Character& reference, const BindResult& bound, const BindResult& asked) {
  std::vector<float> l1;
  (void)measure(reference, bound.influences, reference.name, 0, &l1);
  std::vector<double> sums(asked.questions.size(), 0);
  for (size_t v = 0; v < l1.size(); ++v) {
    const uint32_t question = asked.vertex_questions[v];
    if (question != SINEW_NO_QUESTION) sums[question] += static_cast<double>(l1[v]);
  }
  return sums;
}

// The joint with most reference weight over the part that the question names; false where none has any.
bool joint_of_part(const Character& reference, const BindResult& asked, const sinew_question& question,
                   const std::vector<uint8_t>& flags, uint16_t* joint) {
  std::map<uint32_t, double> sums;
  for (size_t v = 0; v < reference.influences.size(); ++v) {
    if (asked.vertex_parts[v] != asked.vertex_parts[question.vertex]) continue;
    for (const Influence& i : reference.influences[v]) sums[i.joint] += static_cast<double>(i.weight);
  }
  double most = 0;
  for (const auto& [j, sum] : sums) {
    if (sum <= most || (!flags.empty() && (flags[j] & SINEW_JOINT_NEVER) != 0)) continue;
    most = sum;
    *joint = static_cast<uint16_t>(j);
  }
  return most > 0;
}

}  // namespace

Answered ask_artist(const Character& reference, BindOptions options, uint32_t questions) {
  Answered out;
  options.question_count = questions;
  out.before = bind(reference, options);
  options.question_count = 0;
  const std::vector<sinew_question>& asked = out.before.questions;
  std::vector<double> best = l1_of_questions(reference, out.before, out.before);
  for (const sinew_question& question : asked) out.answers.push_back({question.vertex, SINEW_ANSWER_PROPOSED, 0, 0});
  for (const uint16_t kind :
       {SINEW_ANSWER_RIGID, SINEW_ANSWER_SOFT, SINEW_ANSWER_HARD, SINEW_ANSWER_SOFTER, SINEW_ANSWER_HOST}) {
    options.answers.clear();
    for (const sinew_question& question : asked) {
      sinew_answer answer = {question.vertex, kind, 0, 0};
      if (kind == SINEW_ANSWER_RIGID &&
          !joint_of_part(reference, out.before, question, options.joint_flags, &answer.joint))
        answer.kind = SINEW_ANSWER_PROPOSED;
      options.answers.push_back(answer);
    }
    const std::vector<double> l1 = l1_of_questions(reference, bind(reference, options), out.before);
    for (size_t q = 0; q < asked.size(); ++q) {
      if (l1[q] >= best[q] - kSeen * asked[q].vertex_count) continue;
      best[q] = l1[q];
      out.answers[q] = options.answers[q];
    }
  }
  options.answers = out.answers;
  out.after = bind(reference, options);
  return out;
}

}  // namespace sinew
