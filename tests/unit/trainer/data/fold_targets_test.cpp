// SPDX-License-Identifier: MIT
// Which joints are end joints, and where their weight goes.
#include "sinew_trainer/fold_targets.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"

namespace sinew {
namespace {

TEST(FoldTargets, ChainsOfEndsFoldUpToABoundOrBranchingJoint) {
  Character c;
  c.vertices = {{0, 0.1f, 0}, {1, 0.1f, 0}, {2, 0.1f, 0}};
  c.influences = {{{0, 1.0f}}, {{0, 0.5f}, {1, 0.5f}}, {{1, 1.0f}}};
  c.joints = {{"a", {}, -1},   {"b", {}, 0}, {"e1", {}, 1}, {"e2", {}, 2},
              {"fork", {}, 0}, {"l", {}, 4}, {"r", {}, 4},  {"lone", {}, -1}};
  // e2 -> e1 -> b; l and r -> fork -> a, since nothing under the fork is bound; a lone root is no end.
  EXPECT_EQ(fold_targets(c), (std::vector<uint32_t>{0, 1, 1, 1, 0, 0, 0, 7}));
  c.influences[0] = {{5, 1.0f}};
  EXPECT_EQ(fold_targets(c), (std::vector<uint32_t>{0, 1, 1, 1, 4, 5, 4, 7}));
}

TEST(FoldTargets, RefusesAParentThatDoesNotExist) {
  Character c;
  c.name = "orphan";
  c.joints = {{"a", {}, 4}};
  EXPECT_ERROR(fold_targets(c), "orphan: joint 'a'", "parent");
}

}  // namespace
}  // namespace sinew
