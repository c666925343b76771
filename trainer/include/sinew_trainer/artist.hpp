// SPDX-License-Identifier: MIT
// An artist who answers a bind's questions by reference weights: what asking is worth.
#ifndef SINEW_TRAINER_ARTIST_HPP
#define SINEW_TRAINER_ARTIST_HPP

#include <cstdint>
#include <vector>

#include "sinew_character/bind/bind.hpp"

namespace sinew {

struct Answered {
  BindResult before;                  // without answers; with the questions
  std::vector<sinew_answer> answers;  // one for each question
  BindResult after;                   // with them
};

// Binds, and answers up to `questions` of what the bind asks (1..SINEW_MAX_QUESTIONS). The artist names the joint that
// most of the part's reference weight belongs to, looks at the part rigid with it, soft, hard, softer, as its host and
// as proposed, and takes what has the lowest L1 over all the question's vertices, by at least 0.01 a vertex. Throws Error as bind() does.
Answered ask_artist(const Character& reference, BindOptions options, uint32_t questions);

}  // namespace sinew
#endif
