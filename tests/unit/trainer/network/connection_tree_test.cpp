// SPDX-License-Identifier: MIT
// Weights of connections, edges that are one too many, and the tree that is left.
#include "network/connection_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace sinew {
namespace {

double sum(const std::vector<Connection>& connections) {
  double total = 0;
  for (const Connection& c : connections) total += c.weight;
  return total;
}

TEST(ConnectionTree, LikelyConnectionsAreLight) {
  EXPECT_NEAR(connection_weight(1), 0, 0.01);
  EXPECT_NEAR(connection_weight(0), 4.605, 1e-3);
  EXPECT_GT(connection_weight(0.3), connection_weight(0.7));
}

TEST(ConnectionTree, OfACircleTheHeaviestEdgeGoes) {
  const std::vector<Connection> circle = {{0, 1, 1}, {1, 2, 3}, {2, 3, 2}, {3, 0, 1}};
  const std::vector<Connection> tree = without_redundant(4, circle);
  ASSERT_EQ(tree.size(), 3u);
  EXPECT_EQ(sum(tree), 4);
  EXPECT_EQ(parents_from(0, 4, tree), (std::vector<int>{-1, 0, 3, 0}));
  EXPECT_EQ(parents_from(2, 4, tree), (std::vector<int>{3, 0, -1, 2}));
}

TEST(ConnectionTree, BridgesStayHoweverHeavy) {
  const std::vector<Connection> tree = without_redundant(4, {{0, 1, 1}, {1, 0, 2}, {1, 2, 9}, {3, 3, 0}});
  ASSERT_EQ(tree.size(), 2u) << "twice the same edge and an edge to itself go";
  EXPECT_EQ(tree[1].weight, 9);
  EXPECT_EQ(parents_from(0, 4, tree), (std::vector<int>{-1, 0, 1, -1})) << "nothing reaches 3";
}

TEST(ConnectionTree, IsTheLightestOfAllOfACompleteGraph) {
  std::mt19937 random(5);
  constexpr uint32_t kCount = 6;
  for (int round = 0; round < 20; ++round) {
    std::vector<Connection> graph;
    for (uint32_t a = 0; a < kCount; ++a)
      for (uint32_t b = a + 1; b < kCount; ++b) graph.push_back({a, b, static_cast<double>(random() % 10)});
    const std::vector<Connection> tree = without_redundant(kCount, graph);
    ASSERT_EQ(tree.size(), kCount - 1);
    // Every choice of five of the fifteen edges that reaches all joints.
    double least = 1e9;
    for (uint32_t chosen = 0; chosen < (1u << graph.size()); ++chosen) {
      std::vector<Connection> some;
      for (uint32_t e = 0; e < graph.size(); ++e)
        if ((chosen >> e & 1) != 0) some.push_back(graph[e]);
      if (some.size() != kCount - 1 || sum(some) >= least) continue;
      const std::vector<int> parents = parents_from(0, kCount, some);
      if (std::count(parents.begin(), parents.end(), -1) == 1) least = sum(some);
    }
    EXPECT_EQ(sum(tree), least);
  }
}

}  // namespace
}  // namespace sinew
