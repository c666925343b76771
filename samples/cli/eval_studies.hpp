// SPDX-License-Identifier: MIT
// Studies of sinew eval that bind every character more than once: what hints do, and what changes of the input do.
#ifndef SINEW_CLI_EVAL_STUDIES_HPP
#define SINEW_CLI_EVAL_STUDIES_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_trainer/confidence.hpp"

namespace sinew::cli {

struct Study {
  std::string folder;
  const sinew_model* model = nullptr;  // null: heat
  uint32_t influences = 4;
  unsigned jobs = 1;
};

// Gives reference weights of some vertices as hints and prints L1 of the others without and with them, per family.
//   kind   "random": single vertices anywhere; "patch": one connected region
//   share  of the vertices that are given
void study_hints(const Study& study, const std::string& kind, double share);

// Prints how confidence and hits agree: without a table, with the model's own, and with one fitted on other families.
void study_confidence(const Study& study);
// Confidences of every character of the folder without a table.
std::vector<JudgedConfidence> judge_folder(const Study& study);
ConfidenceTable table_of(const sinew_model& model);
void print_reliability(const std::string& title, const Reliability& reliability);

// Prints how far the weights move when the character is moved, turned, renumbered, remeshed and so on.
void study_robustness(const Study& study);

// Prints how much of the weight around places that have grown together lies on the wrong side, bound plainly and kept apart.
void study_seams(const Study& study);

// Lets the reference answer up to `questions` questions of every character and prints L1 without and with the answers,
// per family.
void study_questions(const Study& study, uint32_t questions);
// Makes a style of the answers about each family's first character and prints L1 of the others without and with it.
void study_style(const Study& study, uint32_t questions);

}  // namespace sinew::cli
#endif
