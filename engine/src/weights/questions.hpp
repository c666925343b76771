// SPDX-License-Identifier: MIT
// Asks about parts and takes answers (stage 9): sinew/questions.h says what they are.
#ifndef SINEW_WEIGHTS_QUESTIONS_HPP
#define SINEW_WEIGHTS_QUESTIONS_HPP

#include "weights/prediction.hpp"

namespace sinew {

// Questions for the user, kept in the workspace until the outputs are written.
struct Questions {
  uint32_t count = 0;
  sinew_question* questions = nullptr;  // [most] `vertex` and `vertex_count` are filled by write_questions()
  uint32_t* of_part = nullptr;          // [parts] index of the part's question, or SINEW_NO_QUESTION
  uint32_t* parts = nullptr;            // [most] the part that each question names

  bool allocate(Arena& arena, const Counts& counts, uint32_t most);
};

// Puts the answers into the rows, then lists up to `most` parts without one, by descending gain, with what each alternative
// would change.
//   answers    [answer_count] checked
//   given      rows that the caller gave: their vertices count neither for size nor for doubt, and no answer is for them
//   rows       in/out of all welded vertices
//   questions  in/out allocated by the caller with `most`
// Scratch is taken from the arena and released. Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status ask_and_answer(const Prediction& prediction, const sinew_answer* answers, uint32_t answer_count,
                            uint32_t most, const GivenRows& given, const Counts& counts, Arena& arena, Rows* rows,
                            Questions* questions);

// Fills the caller's arrays for questions and their number; arrays that are null are left out.
void write_questions(const Mesh& mesh, const Questions& questions, sinew_bind_outputs* outputs);

}  // namespace sinew
#endif
