// SPDX-License-Identifier: MIT
// Vertices under the brush by a walk along edges, then one new row for each, all from the rows before.
#include "paint.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sinew_character/bind/bind.hpp"
#include "sinew_character/rig/mesh_surface.hpp"

namespace sinew::web {
namespace {

constexpr int kSmoothRounds = 2;  // of a stroke that smooths

using Row = std::vector<Influence>;

// (1 - share) one + share other.
Row blend(const Row& one, const Row& other, float share) {
  std::map<uint32_t, float> sums;
  for (const Influence& influence : one) sums[influence.joint] += (1 - share) * influence.weight;
  for (const Influence& influence : other) sums[influence.joint] += share * influence.weight;
  Row row;
  for (const auto& [joint, weight] : sums)
    if (weight > 0) row.push_back({joint, weight});
  return row;
}

Row mean_of(const std::vector<Row>& rows, const std::vector<uint32_t>& which) {
  std::map<uint32_t, float> sums;
  for (const uint32_t v : which)
    for (const Influence& influence : rows[v])
      sums[influence.joint] += influence.weight / static_cast<float>(which.size());
  Row row;
  for (const auto& [joint, weight] : sums) row.push_back({joint, weight});
  return row;
}

}  // namespace

void paint(const Character& character, const std::vector<float>& positions, const Stroke& stroke,
           uint32_t influence_count, std::vector<Row>* rows, std::vector<uint8_t>* painted) {
  const std::vector<std::vector<uint32_t>> neighbours = neighbors_of(character);
  const auto distance = [&](uint32_t v) {
    const float* const p = &positions[size_t{v} * 3];
    const float* const q = &positions[size_t{stroke.vertex} * 3];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  std::vector<std::pair<uint32_t, float>> under = {{stroke.vertex, stroke.strength}};  // vertex, share of the change
  std::vector<uint8_t> seen(character.vertices.size(), 0);
  seen[stroke.vertex] = 1;
  for (size_t next = 0; next < under.size(); ++next) {
    for (const uint32_t v : neighbours[under[next].first]) {
      if (seen[v] != 0) continue;
      seen[v] = 1;
      const float d = distance(v) / std::max(stroke.radius, 1e-20f);
      if (d < 1) under.emplace_back(v, stroke.strength * (1 - d * d) * (1 - d * d));
    }
  }
  for (int round = 0; round < (stroke.joint < 0 ? kSmoothRounds : 1); ++round) {
    const std::vector<Row> before = *rows;
    for (const auto& [v, share] : under) {
      if (stroke.joint < 0 && neighbours[v].empty()) continue;
      const Row other =
          stroke.joint >= 0 ? Row{{static_cast<uint32_t>(stroke.joint), 1.0f}} : mean_of(before, neighbours[v]);
      if (other.empty()) continue;  // unbound, as its surroundings are
      (*rows)[v] = round_influences(blend(before[v], other, share), influence_count);
      (*painted)[v] = 1;
    }
  }
}

}  // namespace sinew::web
