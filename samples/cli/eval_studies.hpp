// SPDX-License-Identifier: MIT
// Studies of sinew-lab eval beside weights: skeletons, fingers, confidences, what `sinew check` finds.
#ifndef SINEW_CLI_EVAL_STUDIES_HPP
#define SINEW_CLI_EVAL_STUDIES_HPP

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_trainer/confidence.hpp"

namespace sinew::cli {

struct RigEvaluation {
  std::string folder;       // rigged characters
  std::string predictions;  // NAME.rig.txt of each of them, of which only joints are read; empty: the model predicts
  std::string model;        // of skeletons; empty: the bundled one
  std::string method;       // "" or "votes"; "shape" and "regions" need no model; "slots": the model is one of those
  std::string output;       // file for all figures; may be empty
  bool json = false;        // all figures on standard output instead of the table
  bool bind = false;        // with the bundled model of weights: what moves the surface
  std::string report;       // HTML page with a picture of every character; may be empty
  std::vector<std::pair<std::string, std::string>> facts;  // of the report: how its numbers were made
  unsigned jobs = 1;
  std::string checkpoint;  // of the float network that the model was made of, to measure beside it; may be empty
};

// Prints the table of the yardstick. A character or prediction that is missing or cannot be read counts as failed: it is
// named, the others are measured, and Error is thrown at the end.
void evaluate_rigs(const RigEvaluation& evaluation);

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

// Damages every rig of a folder with each kind of damage that `sinew check` should find, one at a time, and prints
// the share that is found, and how often a rule has findings on untouched rigs.
//   names  true: also every miss and every alarm by name
void study_check(const std::string& folder, unsigned jobs, bool names);

}  // namespace sinew::cli
#endif
