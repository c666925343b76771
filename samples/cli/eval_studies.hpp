// SPDX-License-Identifier: MIT
// Studies of sinew eval that bind every character more than once: what hints do, and what changes of the input do.
#ifndef SINEW_CLI_EVAL_STUDIES_HPP
#define SINEW_CLI_EVAL_STUDIES_HPP

#include <cstdint>
#include <string>

#include "sinew/sinew.h"

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

}  // namespace sinew::cli
#endif
