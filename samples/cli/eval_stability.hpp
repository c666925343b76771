// SPDX-License-Identifier: MIT
// The study of poses.
#ifndef SINEW_CLI_EVAL_STABILITY_HPP
#define SINEW_CLI_EVAL_STABILITY_HPP

#include <string>

#include "eval_studies.hpp"

namespace sinew::cli {

struct StabilitySettings {
  unsigned poses = 20;
  std::string output;  // .json
  bool json = false;   // in place of the table
};

// Prints how far skeletons and strongest joints move when every character stands in random poses. A character that fails is
// named, the others are measured; then Error.
void study_stability(const Study& study, const StabilitySettings& settings);

}  // namespace sinew::cli
#endif
