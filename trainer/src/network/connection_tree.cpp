// SPDX-License-Identifier: MIT
// Reverse deletion, and a walk from the root.
#include "network/connection_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sinew {

double connection_weight(double probability) { return -std::log(probability + 0.01); }

std::vector<int> parents_from(uint32_t root, uint32_t count, const std::vector<Connection>& tree) {
  std::vector<int> parents(count, -1);
  std::vector<uint8_t> met(count, 0);
  std::vector<uint32_t> reached = {root};
  met[root] = 1;
  for (size_t next = 0; next < reached.size(); ++next) {
    const uint32_t joint = reached[next];
    for (const Connection& c : tree) {
      if (c.a != joint && c.b != joint) continue;
      const uint32_t other = c.a == joint ? c.b : c.a;
      if (met[other] != 0) continue;
      met[other] = 1;
      parents[other] = static_cast<int>(joint);
      reached.push_back(other);
    }
  }
  return parents;
}

std::vector<Connection> without_redundant(uint32_t count, const std::vector<Connection>& connections) {
  std::vector<size_t> order(connections.size());
  std::iota(order.rbegin(), order.rend(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return connections[a].weight > connections[b].weight; });
  std::vector<uint8_t> kept(connections.size(), 1);
  std::vector<Connection> left;
  const auto keep_those = [&] {
    left.clear();
    for (size_t i = 0; i < connections.size(); ++i)
      if (kept[i] != 0) left.push_back(connections[i]);
  };
  for (const size_t i : order) {
    kept[i] = 0;
    keep_those();
    const Connection& c = connections[i];
    if (c.a != c.b && parents_from(c.a, count, left)[c.b] < 0) kept[i] = 1;
  }
  keep_those();
  return left;
}

}  // namespace sinew
