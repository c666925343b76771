// SPDX-License-Identifier: MIT
// sinew eval --task hands: predicted fingers against those of a folder's characters.
#ifndef SINEW_CLI_EVAL_HANDS_HPP
#define SINEW_CLI_EVAL_HANDS_HPP

#include <string>

namespace sinew::cli {

struct HandsEvaluation {
  std::string folder;  // rigged characters
  std::string model;   // of hands; empty: the bundled one. Bodies are the bundled model's.
  std::string json;    // file for all figures, "-" = standard output instead of the table; may be empty
  unsigned jobs = 1;
};

// Prints a table by families. A character that cannot be read counts as failed: the others are measured, and Error is
// thrown at the end.
void evaluate_hands(const HandsEvaluation& evaluation);

}  // namespace sinew::cli
#endif
