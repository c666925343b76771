// SPDX-License-Identifier: MIT
// Vertices that keep their weights: --lock of bind and transfer.
#ifndef SINEW_CLI_VERTEX_LOCKS_HPP
#define SINEW_CLI_VERTEX_LOCKS_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew::cli {

// [V] non-zero: keeps its weights. `lock` is a file with a 0-based index per line, each of a vertex with weights, or
// "all": every vertex that has some. Throws Error naming the line or the vertex.
std::vector<uint8_t> read_vertex_locks(const std::string& lock, const Character& character);

}  // namespace sinew::cli

#endif
