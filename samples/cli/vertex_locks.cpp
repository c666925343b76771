// SPDX-License-Identifier: MIT
// A list of vertices, or all of them.
#include "vertex_locks.hpp"

#include "support.hpp"

namespace sinew::cli {

std::vector<uint8_t> read_vertex_locks(const std::string& lock, const Character& character) {
  std::vector<uint8_t> locked(character.vertices.size(), 0);
  if (lock == "all") {
    for (size_t v = 0; v < locked.size(); ++v) locked[v] = character.influences[v].empty() ? 0 : 1;
    return locked;
  }
  for (const size_t v : read_vertex_list(lock, character)) {
    if (character.influences[v].empty())
      throw Error(lock + ": vertex " + std::to_string(v) + " has no weights to keep");
    locked[v] = 1;
  }
  return locked;
}

}  // namespace sinew::cli
