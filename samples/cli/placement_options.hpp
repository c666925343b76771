// SPDX-License-Identifier: MIT
// --turn, --height and --floor of the commands that begin with a mesh.
#ifndef SINEW_CLI_PLACEMENT_OPTIONS_HPP
#define SINEW_CLI_PLACEMENT_OPTIONS_HPP

#include <CLI/CLI.hpp>

#include "sinew_character/pose/placement.hpp"

namespace sinew::cli {

void add_placement_options(CLI::App* sub, Placement* placement);

}  // namespace sinew::cli
#endif
