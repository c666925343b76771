// SPDX-License-Identifier: MIT
// The options --deform, --cells, --rounds, --body-contact and those of xpbd, of commands that pose characters.
#ifndef SINEW_CLI_DEFORM_OPTIONS_HPP
#define SINEW_CLI_DEFORM_OPTIONS_HPP

#include <optional>
#include <string>
#include <vector>

#include "sinew/deform.h"

namespace CLI {
class App;
}

namespace sinew::cli {

struct DeformSettings {
  std::string method;  // empty: what the command does by itself
  unsigned cells = 0, rounds = 0;
  bool body_contact = false;
  double stiffness = 0;  // 0: the method's own
  uint32_t tet_weights = SINEW_TET_WEIGHTS_SKIN;
  bool no_smoothing = false;
};

// The engine's options for volume, xpbd and delta-mush; nullopt for plain skinning. UsageError for the others without one
// of these.
std::optional<sinew_deform_options> deform_options(const DeformSettings& settings);

// Adds --deform with these methods. `what` comes before what they mean.
void add_deform_options(CLI::App* sub, const std::vector<std::string>& methods, const std::string& what,
                        DeformSettings* settings);
// Adds --cells, --rounds, --body-contact and those of xpbd alone under a heading of their own.
void add_solver_options(CLI::App* sub, DeformSettings* settings);

}  // namespace sinew::cli
#endif
