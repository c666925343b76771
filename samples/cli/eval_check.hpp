// SPDX-License-Identifier: MIT
// The study of `sinew check`.
#ifndef SINEW_CLI_EVAL_CHECK_HPP
#define SINEW_CLI_EVAL_CHECK_HPP

#include <string>

namespace sinew::cli {

// Damages every rig of a folder in every way that `sinew check` should find, one at a time, and prints the share that is found, and how often a
// rule has findings on untouched ones.
//   names  true: also every miss and every alarm by name
void study_check(const std::string& folder, unsigned jobs, bool names);

}  // namespace sinew::cli
#endif
