// SPDX-License-Identifier: MIT
// Shells: closed, wound outward, as large as the body, grown together, without what lies inside.
#include "data/grown_shell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

namespace sinew {
namespace {

struct Boxes {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;
  void add(const std::array<double, 3>& low, const std::array<double, 3>& high) {
    const auto first = static_cast<uint32_t>(vertices.size());
    for (uint32_t c = 0; c < 8; ++c)
      vertices.push_back({c & 1 ? high[0] : low[0], c & 2 ? high[1] : low[1], c & 4 ? high[2] : low[2]});
    constexpr uint32_t kQuads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& q : kQuads) {
      triangles.push_back({first + q[0], first + q[1], first + q[2]});
      triangles.push_back({first + q[0], first + q[2], first + q[3]});
    }
  }
};

double volume(const GrownShell& shell) {
  double sum = 0;
  for (const auto& t : shell.triangles) {
    const auto &a = shell.vertices[t[0]], &b = shell.vertices[t[1]], &c = shell.vertices[t[2]];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

bool is_closed(const GrownShell& shell) {
  std::map<std::pair<uint32_t, uint32_t>, int> ways;
  for (const auto& t : shell.triangles) {
    for (size_t i = 0; i < 3; ++i) {
      ++ways[{t[i], t[(i + 1) % 3]}];
      --ways[{t[(i + 1) % 3], t[i]}];
    }
  }
  for (const auto& [edge, balance] : ways)
    if (balance != 0) return false;
  return !ways.empty();
}

uint32_t components(const GrownShell& shell) {
  std::vector<uint32_t> root(shell.vertices.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](uint32_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const auto& t : shell.triangles) {
    root[find(t[1])] = find(t[0]);
    root[find(t[2])] = find(t[0]);
  }
  uint32_t count = 0;
  for (uint32_t v = 0; v < root.size(); ++v) count += root[v] == v ? 1 : 0;
  return count;
}

TEST(GrownShell, OfABoxIsClosedAndAsLarge) {
  Boxes boxes;
  boxes.add({0, 0, 0}, {1, 2, 0.5});
  const GrownShell shell = grow_shell(boxes.vertices, boxes.triangles, 96);
  EXPECT_TRUE(is_closed(shell));
  EXPECT_EQ(components(shell), 1u);
  EXPECT_NEAR(volume(shell), 1, 0.12);
  ASSERT_EQ(shell.source.size(), shell.vertices.size());
  for (size_t v = 0; v < shell.vertices.size();
       ++v) {  // a corner of the triangle that has a third of the point or more
    const auto &p = shell.vertices[v], &q = boxes.vertices[shell.source[v]];
    EXPECT_LT(std::abs(p[1] - q[1]), 2 * 2 / 3.0 + 0.06) << v;
  }
}

TEST(GrownShell, WhatTouchesGrowsTogetherAndWhatLiesInsideGoes) {
  Boxes boxes;
  boxes.add({0, 0, 0}, {1, 1, 1});
  boxes.add({1.005, 0, 0}, {2, 1, 1});          // half a cell away
  boxes.add({0.3, 0.3, 0.3}, {0.6, 0.6, 0.6});  // eyes, an inner hull
  const GrownShell shell = grow_shell(boxes.vertices, boxes.triangles, 100);
  EXPECT_TRUE(is_closed(shell));
  EXPECT_EQ(components(shell), 1u);
  EXPECT_NEAR(volume(shell), 2, 0.2);
  for (size_t v = 0; v < shell.vertices.size(); ++v) {
    EXPECT_LT(shell.source[v], 16u) << "of what lies inside";
    if (std::abs(shell.vertices[v][0] - 1) < 0.05) continue;
    EXPECT_EQ(shell.source[v] >= 8, shell.vertices[v][0] > 1) << "of the box that is there";
  }
}

TEST(GrownShell, FarPartsStayApart) {
  Boxes boxes;
  boxes.add({0, 0, 0}, {1, 1, 1});
  boxes.add({1.1, 0, 0}, {2, 1, 1});
  const GrownShell shell = grow_shell(boxes.vertices, boxes.triangles, 100);
  EXPECT_TRUE(is_closed(shell));
  EXPECT_EQ(components(shell), 2u);
}

TEST(GrownShell, SmallHolesAreClosed) {
  Boxes boxes;
  boxes.add({0, 0, 0}, {1, 1, 1});
  for (auto& t : boxes.triangles)  // all faces have corners of their own, a little away from each other
    for (uint32_t& v : t) {
      auto p = boxes.vertices[v];
      for (double& x : p) x = 0.5 + (x - 0.5) * 0.992;
      boxes.vertices.push_back(p);
      v = static_cast<uint32_t>(boxes.vertices.size()) - 1;
    }
  for (size_t f = 0; f < boxes.triangles.size(); f += 2)
    for (size_t i = 0; i < 3; ++i) boxes.vertices[boxes.triangles[f][i]][f % 3] += 0.008;
  const GrownShell shell = grow_shell(boxes.vertices, boxes.triangles, 64);
  EXPECT_TRUE(is_closed(shell));
  EXPECT_NEAR(volume(shell), 1, 0.15) << "filled, not two walls";
}

}  // namespace
}  // namespace sinew
