// SPDX-License-Identifier: MIT
// sinew-lab eval rig: predicted skeletons against those of a folder's characters.
#ifndef SINEW_CLI_EVAL_RIG_HPP
#define SINEW_CLI_EVAL_RIG_HPP

#include <string>
#include <utility>
#include <vector>

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

}  // namespace sinew::cli
#endif
