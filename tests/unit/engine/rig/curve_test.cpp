// SPDX-License-Identifier: MIT
// The middle line of shapes whose line is known: a rod, a cross, a figure of two arms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "block_interior.hpp"
#include "rig/folded_tree.hpp"

namespace sinew::rigging {
namespace {

using sinew_test::Block3;

struct GrownCurve {
  sinew_status status = SINEW_OK;
  FoldedTree tree;
  bool scratch_kept = false;

  explicit GrownCurve(const std::vector<Block3>& blocks, bool folded = false, size_t missing = 0) {
    const sinew_test::BlockInterior body(blocks);
    Arena growing;
    EXPECT_EQ(grow_curve(body.interior, folded, growing, &tree), SINEW_OK);
    Workspace scratch(growing.high_water());
    std::memset(scratch.data(), 0xA5, growing.high_water());
    Arena rest(scratch.data(), growing.high_water() - missing);
    status = grow_curve(body.interior, folded, rest, &tree);
    scratch_kept = rest.used() != 0;
  }
  std::vector<Vec3i> ends() const {
    std::vector<Vec3i> found;
    for (uint32_t j = 0; j < tree.count; ++j)
      if (tree.nodes[j].has_end) found.push_back(tree.nodes[j].end);
    return found;
  }
};

constexpr int32_t kHundredth = kSide / 100;

bool is_near(Vec3i p, Vec3i hundredths, double within) {
  const double x = p.x / static_cast<double>(kHundredth) - hundredths.x,
               y = p.y / static_cast<double>(kHundredth) - hundredths.y,
               z = p.z / static_cast<double>(kHundredth) - hundredths.z;
  return std::sqrt(x * x + y * y + z * z) < within;
}

// One root, which parents lead to, no longer bones than a quarter of the side, and nothing that only votes know.
void expect_curve(const GrownCurve& grown) {
  const FoldedTree& tree = grown.tree;
  ASSERT_EQ(grown.status, SINEW_OK);
  EXPECT_FALSE(grown.scratch_kept);
  ASSERT_GE(tree.count, 1u);
  ASSERT_LE(tree.count, kMaxFoldedJoints);
  for (uint32_t j = 0; j < tree.count; ++j) {
    const FoldedNode& node = tree.nodes[j];
    EXPECT_EQ(node.parent < 0, j == tree.root) << j;
    EXPECT_EQ(node.joint_class, kClassOther);
    EXPECT_EQ(node.confidence, 0);
    const auto is_short = [&](Vec3i a, Vec3i b) {
      return dot(a - b, a - b) < static_cast<int64_t>(26 * kHundredth) * (26 * kHundredth);
    };
    if (node.parent >= 0) {
      ASSERT_LT(node.parent, static_cast<int>(tree.count));
      EXPECT_TRUE(is_short(node.at, tree.nodes[node.parent].at)) << j;
    }
    if (node.has_end) {
      EXPECT_TRUE(is_short(node.at, node.end)) << j;
    }
  }
}

const std::vector<Block3> kRod = {{{0, 0, 0}, {8, 100, 8}}};

TEST(Curve, OfARodIsItsAxis) {
  const GrownCurve grown(kRod);
  expect_curve(grown);
  EXPECT_TRUE(is_near(grown.tree.nodes[grown.tree.root].at, {0, 50, 0}, 5)) << "the root is in its middle";
  for (uint32_t j = 0; j < grown.tree.count; ++j) {
    EXPECT_LT(std::abs(grown.tree.nodes[j].at.x), 2 * kHundredth);
    EXPECT_LT(std::abs(grown.tree.nodes[j].at.z), 2 * kHundredth);
  }
  const std::vector<Vec3i> ends = grown.ends();
  ASSERT_EQ(ends.size(), 2u);
  for (const Vec3i tip : {Vec3i{0, 0, 0}, Vec3i{0, 100, 0}})
    EXPECT_TRUE(std::any_of(ends.begin(), ends.end(), [&](Vec3i end) { return is_near(end, tip, 8); })) << tip.y;
  EXPECT_FALSE(grown.tree.mirrored);
}

TEST(Curve, ACrossEndsInItsFourArms) {
  const GrownCurve grown(std::vector<Block3>{{{-4, 0, -4}, {4, 100, 4}}, {{-50, 46, -4}, {50, 54, 4}}});
  expect_curve(grown);
  EXPECT_TRUE(is_near(grown.tree.nodes[grown.tree.root].at, {0, 50, 0}, 5));
  const std::vector<Vec3i> ends = grown.ends();
  ASSERT_EQ(ends.size(), 4u);
  for (const Vec3i tip : {Vec3i{0, 0, 0}, Vec3i{0, 100, 0}, Vec3i{-50, 50, 0}, Vec3i{50, 50, 0}})
    EXPECT_TRUE(std::any_of(ends.begin(), ends.end(), [&](Vec3i end) { return is_near(end, tip, 8); }))
        << tip.x << " " << tip.y;
}

TEST(Curve, AnElbowHasAJointWhereItBends) {
  // From the floor up, then along x. Both are 104 long, so that 1.04 of their units are a hundredth of the side.
  const GrownCurve grown(std::vector<Block3>{{{-4, 0, -4}, {4, 104, 4}}, {{-4, 96, -4}, {100, 104, 4}}});
  expect_curve(grown);
  bool bends = false;
  for (uint32_t j = 0; j < grown.tree.count; ++j) {
    const Vec3i at = grown.tree.nodes[j].at;
    const Vec3i corner = {static_cast<int32_t>(-48 / 1.04), static_cast<int32_t>(100 / 1.04), 0};
    bends = bends || is_near(at, corner, 8);
  }
  EXPECT_TRUE(bends);
  EXPECT_EQ(grown.ends().size(), 2u);
}

TEST(Curve, BumpsAreNoBranches) {
  const GrownCurve bare(kRod);
  const GrownCurve bumpy(std::vector<Block3>{{{0, 0, 0}, {8, 95, 8}},
                                             {{0, 94, 0}, {2, 100, 8}},
                                             {{6, 94, 0}, {8, 100, 8}},
                                             {{6, 20, 2}, {13, 24, 6}}});  // two horns and a knob
  expect_curve(bumpy);
  EXPECT_EQ(bumpy.ends().size(), bare.ends().size());
  const GrownCurve branched(std::vector<Block3>{{{0, 0, 0}, {8, 100, 8}}, {{6, 20, 2}, {30, 24, 6}}});
  EXPECT_EQ(branched.ends().size(), bare.ends().size() + 1) << "longer ones are";
}

// A trunk on the plane with an arm to each side.
TEST(Curve, OfAMirroredMeshOneSideIsLookedAt) {
  const std::vector<Block3> figure = {{{-5, 0, -5}, {5, 100, 5}}, {{-45, 66, -4}, {45, 74, 4}}};
  const GrownCurve grown(figure, true);
  expect_curve(grown);
  EXPECT_TRUE(grown.tree.mirrored);
  uint32_t beside = 0;
  for (uint32_t j = 0; j < grown.tree.count; ++j) {
    const FoldedNode& node = grown.tree.nodes[j];
    ASSERT_GE(node.at.x, 0);
    beside += grown.tree.beside(j) ? 1 : 0;
    if (node.parent >= 0 && !grown.tree.beside(j)) {
      EXPECT_FALSE(grown.tree.beside(static_cast<uint32_t>(node.parent))) << "a trunk that hangs on an arm";
    }
    if (std::abs(node.at.y - 70 * kHundredth) > 12 * kHundredth) {
      EXPECT_EQ(node.at.x, 0) << "the trunk lies on the plane";
    }
  }
  EXPECT_GT(beside, 0u);
  EXPECT_EQ(grown.tree.nodes[grown.tree.root].at.x, 0);
  const std::vector<Vec3i> ends = grown.ends();
  ASSERT_EQ(ends.size(), 3u) << "below, above, one arm for both";
  EXPECT_TRUE(std::any_of(ends.begin(), ends.end(), [](Vec3i end) { return is_near(end, {45, 70, 0}, 8); }));
  EXPECT_EQ(GrownCurve(figure, false).ends().size(), 4u);
}

// Fifteen teeth are more than a tree has room for with all their joints.
TEST(Curve, StaysWithinWhatCanBeRead) {
  std::vector<Block3> comb = {{{0, 0, 0}, {100, 6, 6}}};
  for (int32_t k = 0; k < 15; ++k) comb.push_back({{7 * k, 4, 0}, {7 * k + 2, 90, 6}});
  const GrownCurve grown(comb);
  expect_curve(grown);
  EXPECT_GT(grown.tree.count, 10u);
}

TEST(Curve, WithoutASolidCellIsOneJoint) {
  Interior interior;
  Arena measuring;
  (void)interior.allocate(measuring);
  Workspace memory(measuring.high_water());
  Arena arena(memory.data(), measuring.high_water());
  ASSERT_TRUE(interior.allocate(arena));
  interior.grid.cell_size = kSide / 64;
  for (int32_t& size : interior.grid.size) size = 5;
  interior.grid.cell_count = 125;
  clear_cells(&interior.grid);
  for (uint32_t c = 0; c < 125; ++c) {
    interior.depth[c] = 0;
    interior.distance[c] = kNoDistance;
  }
  Arena growing;
  FoldedTree tree;
  ASSERT_EQ(grow_curve(interior, true, growing, &tree), SINEW_OK);
  Workspace scratch(growing.high_water());
  Arena rest(scratch.data(), growing.high_water());
  ASSERT_EQ(grow_curve(interior, true, rest, &tree), SINEW_OK);
  EXPECT_EQ(tree.count, 1u);
  EXPECT_EQ(tree.nodes[tree.root].parent, -1);
  EXPECT_EQ(tree.nodes[tree.root].joint_class, kClassOther);
}

TEST(Curve, ATooSmallBlockIsAStatus) { EXPECT_EQ(GrownCurve(kRod, false, 64).status, SINEW_ERROR_WORKSPACE); }

}  // namespace
}  // namespace sinew::rigging
