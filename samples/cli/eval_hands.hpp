// SPDX-License-Identifier: MIT
// sinew eval hands: predicted fingers against those of a folder's characters.
#ifndef SINEW_CLI_EVAL_HANDS_HPP
#define SINEW_CLI_EVAL_HANDS_HPP

#include <string>

namespace sinew::cli {

struct HandsEvaluation {
  std::string folder;  // rigged characters
  std::string model;   // of hands; empty: the bundled one. Bodies are the bundled model's.
  std::string output;  // file for all figures; may be empty
  bool json = false;   // all figures on standard output instead of the table
  unsigned jobs = 1;
};

// Prints a table by families. A character that cannot be read counts as failed: the others are measured, and Error is
// thrown at the end.
void evaluate_hands(const HandsEvaluation& evaluation);

}  // namespace sinew::cli
#endif
