// SPDX-License-Identifier: MIT
// What sinew rig does, for commands that need a skeleton on the way.
#ifndef SINEW_CLI_RIG_MESH_HPP
#define SINEW_CLI_RIG_MESH_HPP

#include <string>

#include "sinew_formats/character.hpp"

namespace sinew::cli {

// Reads a bare mesh and gives it a skeleton and weights by the bundled models, as `sinew rig MESH` does. Throws Error.
Character rig_bare_mesh(const std::string& path);

}  // namespace sinew::cli
#endif
