// SPDX-License-Identifier: MIT
// Disjoint sets: joined in any order they have the smallest number as their root, and nothing else is joined.
#include "core/union_find.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace sinew {
namespace {

TEST(UnionFind, TheSmallestIsTheRoot) {
  std::vector<uint32_t> parents(10);
  std::iota(parents.begin(), parents.end(), 0);
  join_sets(parents.data(), 9, 7);
  join_sets(parents.data(), 4, 5);
  join_sets(parents.data(), 7, 5);
  join_sets(parents.data(), 5, 9);  // again
  join_sets(parents.data(), 3, 3);
  for (const uint32_t i : {4u, 5u, 7u, 9u}) EXPECT_EQ(find_root(parents.data(), i), 4u) << i;
  for (const uint32_t i : {0u, 1u, 2u, 3u, 6u, 8u}) EXPECT_EQ(find_root(parents.data(), i), i);
  join_sets(parents.data(), 9, 0);
  EXPECT_EQ(find_root(parents.data(), 7), 0u);
}

TEST(UnionFind, ALongChainIsOneSet) {
  constexpr uint32_t kCount = 100000;
  std::vector<uint32_t> parents(kCount);
  std::iota(parents.begin(), parents.end(), 0);
  for (uint32_t i = kCount - 1; i > 0; --i) join_sets(parents.data(), i, i - 1);
  for (uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(find_root(parents.data(), i), 0u);
}

}  // namespace
}  // namespace sinew
