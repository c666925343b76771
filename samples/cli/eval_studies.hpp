// SPDX-License-Identifier: MIT
// Studies of sinew-lab eval beside weights and skeletons: fingers, confidences, what `sinew check` finds.
#ifndef SINEW_CLI_EVAL_STUDIES_HPP
#define SINEW_CLI_EVAL_STUDIES_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_trainer/confidence.hpp"

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

struct ConfidenceStudy {
  std::string folder;
  const sinew_model* model = nullptr;  // null: heat
  uint32_t influences = 4;
  unsigned jobs = 1;
};

// Prints how confidence and hits agree: without a table, with the model's own, and with one fitted on other families.
void study_confidence(const ConfidenceStudy& study);
// Confidences of every character of the folder without a table.
std::vector<JudgedConfidence> judge_folder(const ConfidenceStudy& study);

// Damages every rig of a folder in every way that `sinew check` should find, one at a time, and prints the share that is found, and how often a
// rule has findings on untouched ones.
//   names  true: also every miss and every alarm by name
void study_check(const std::string& folder, unsigned jobs, bool names);

}  // namespace sinew::cli
#endif
