// SPDX-License-Identifier: MIT
// Neighbours by positions and edges.
#include "sinew_character/rig/mesh_neighbours.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace sinew {

std::vector<uint32_t> first_at_position(const Character& character) {
  std::map<std::array<float, 3>, uint32_t> first;
  std::vector<uint32_t> positions;
  positions.reserve(character.vertices.size());
  for (uint32_t v = 0; v < character.vertices.size(); ++v) {
    const Vec3& p = character.vertices[v];
    positions.push_back(first.emplace(std::array<float, 3>{p.x, p.y, p.z}, v).first->second);
  }
  return positions;
}

std::vector<std::vector<uint32_t>> welded_rings(const Character& c, const std::vector<uint32_t>& first) {
  std::vector<std::vector<uint32_t>> rings(c.vertices.size());
  for (size_t f = 0; f < c.face_count(); ++f) {
    const uint32_t begin = c.face_offsets[f], end = c.face_offsets[f + 1];
    for (uint32_t k = begin; k < end; ++k) {
      const uint32_t a = first[c.face_vertices[k]], b = first[c.face_vertices[k + 1 < end ? k + 1 : begin]];
      if (a == b) continue;
      rings[a].push_back(b);
      rings[b].push_back(a);
    }
  }
  for (auto& ring : rings) {
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  }
  return rings;
}

std::vector<std::vector<uint32_t>> neighbours_of(const Character& character) {
  const std::vector<uint32_t> positions = first_at_position(character);
  std::vector<std::vector<uint32_t>> neighbours(positions.size());
  const auto join = [&](uint32_t a, uint32_t b) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  };
  for (uint32_t v = 0; v < positions.size(); ++v)
    if (positions[v] != v) join(v, positions[v]);
  for (size_t f = 0; f < character.face_count(); ++f) {
    const uint32_t first = character.face_offsets[f], end = character.face_offsets[f + 1];
    for (uint32_t c = first; c < end; ++c)
      join(character.face_vertices[c], character.face_vertices[c + 1 < end ? c + 1 : first]);
  }
  return neighbours;
}

}  // namespace sinew
