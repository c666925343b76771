// SPDX-License-Identifier: MIT
// Ways between joints through bodies of blocks, and chains for what no bone explains.
#include "rig/body_ways.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "block_interior.hpp"
#include "rig/coverage.hpp"

namespace sinew::rigging {
namespace {

using sinew_test::Block3;
using sinew_test::BlockInterior;

Vec3i hundredths(int32_t x, int32_t y, int32_t z) {
  constexpr int32_t kHundredth = kSide / 100;
  return {x * kHundredth, y * kHundredth, z * kHundredth};
}

struct PlacedJoint {
  Vec3i at;
  int16_t parent;
  uint8_t joint_class;
};

FoldedTree tree_of(const std::vector<PlacedJoint>& joints, bool mirrored) {
  FoldedTree tree;
  tree.mirrored = mirrored;
  for (const PlacedJoint& joint : joints) {
    FoldedNode& node = tree.nodes[tree.count++];
    node.at = joint.at;
    node.parent = joint.parent;
    node.joint_class = joint.joint_class;
  }
  return tree;
}

std::vector<int32_t> ways_of(BlockInterior* body, const FoldedTree& tree) {
  std::vector<int32_t> costs(size_t{tree.count} * tree.count);
  Arena measuring;
  EXPECT_TRUE(find_body_ways(nullptr, measuring, &body->interior, nullptr));
  Workspace memory(measuring.high_water());
  Arena full(memory.data(), measuring.high_water() - 64), arena(memory.data(), measuring.high_water());
  EXPECT_FALSE(find_body_ways(&tree, full, &body->interior, costs.data()));
  EXPECT_TRUE(find_body_ways(&tree, arena, &body->interior, costs.data()));
  EXPECT_EQ(arena.used(), 0u);
  return costs;
}

// Two legs under a beam: their feet are near each other through the air and far through the body.
const std::vector<Block3> kGate = {{{-20, 60, -5}, {20, 70, 5}},
                                   {{-20, 0, -5}, {-10, 65, 5}},
                                   {{10, 0, -5}, {20, 65, 5}},
                                   {{-5, 65, -5}, {5, 100, 5}}};

TEST(BodyWays, LeadThroughTheBodyFromNeighborToNeighbor) {
  BlockInterior body(kGate);
  const FoldedTree tree = tree_of({{hundredths(0, 65, 0), -1, kClassPelvis},
                                   {hundredths(15, 35, 0), 0, kClassCalf},
                                   {hundredths(15, 5, 0), 1, kClassFoot},
                                   {hundredths(-15, 5, 0), 0, kClassFoot}},
                                  false);
  const std::vector<int32_t> costs = ways_of(&body, tree);
  const auto bits = [&](size_t i, size_t j) { return costs[i * 4 + j] / 65536.0; };
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(bits(i, i), 0);
    for (size_t j = 0; j < 4; ++j) EXPECT_EQ(bits(i, j), bits(j, i));
  }
  const double whole_side = straight_cost(hundredths(0, 0, 0), hundredths(0, 100, 0)) / 65536.0;
  EXPECT_NEAR(whole_side, 14.43, 0.05);
  EXPECT_NEAR(bits(1, 2), .3 * whole_side, 0.6) << "straight down the leg";
  EXPECT_NEAR(bits(0, 2), bits(0, 1) + bits(1, 2) + 3, 0.1) << "through the knee's cells, for three bits";
  EXPECT_LT(bits(0, 3), bits(2, 3)) << "the other foot hangs on the hips, not on this foot";
  EXPECT_GT(bits(2, 3), 4) << "though it is near: the air counts four times";
}

TEST(BodyWays, OfAMirroredTreeBothSidesCount) {
  BlockInterior body(kGate);
  const FoldedTree tree = tree_of({{hundredths(0, 65, 0), -1, kClassPelvis},
                                   {hundredths(15, 35, 0), 0, kClassCalf},
                                   {hundredths(15, 5, 0), 1, kClassFoot}},
                                  true);
  FoldedTree right = tree;
  right.nodes[1].only = 1;
  right.nodes[2].only = -1;
  EXPECT_GT(ways_of(&body, right)[1 * 3 + 2], ways_of(&body, tree)[1 * 3 + 2]) << "knee and foot of two legs";
}

FoldedTree covered(const std::vector<Block3>& blocks, FoldedTree tree) {
  BlockInterior body(blocks);
  Arena measuring;
  EXPECT_TRUE(cover_body(measuring, &body.interior, nullptr));
  Workspace memory(measuring.high_water());
  std::memset(memory.data(), 0xA5, measuring.high_water());
  Arena full(memory.data(), measuring.high_water() - 64), arena(memory.data(), measuring.high_water());
  EXPECT_FALSE(cover_body(full, &body.interior, &tree));
  EXPECT_TRUE(cover_body(arena, &body.interior, &tree));
  EXPECT_EQ(arena.used(), 0u);
  return tree;
}

// A trunk along z whose spine is known.
const Block3 kTrunk = {{-8, 40, -30}, {8, 56, 30}};
std::vector<PlacedJoint> spine(int32_t longest_side, int32_t floor, int32_t behind) {
  std::vector<PlacedJoint> joints = {{hundredths(0, 48, -20), -1, kClassPelvis},
                                     {hundredths(0, 48, 0), 0, kClassSpine},
                                     {hundredths(0, 48, 25), 1, kClassHead}};
  for (PlacedJoint& joint : joints) {
    const Vec3i at = joint.at + hundredths(0, -floor, behind);
    joint.at = {at.x / longest_side * 100, at.y / longest_side * 100, at.z / longest_side * 100};
  }
  return joints;
}

TEST(Coverage, ABodyWhoseBonesReachEverywhereGetsNone) {
  EXPECT_EQ(covered({kTrunk}, tree_of(spine(60, 40, 0), true)).count, 3u);
  EXPECT_EQ(covered({kTrunk, {{-4, 0, -30}, {4, 4, 30}}}, tree_of(spine(60, 0, 0), true)).count, 3u)
      << "what does not touch the body is no limb of it";
}

TEST(Coverage, ATailBehindTheHipsIsAChainOfTails) {
  // The box's middle in z goes from 0 to -17.5.
  const FoldedTree tree = covered({kTrunk, {{-2, 46, -65}, {2, 50, -29}}}, tree_of(spine(95, 40, 18), true));
  ASSERT_GE(tree.count, 5u);
  for (uint32_t j = 3; j < tree.count; ++j) {
    const FoldedNode& node = tree.nodes[j];
    EXPECT_EQ(node.joint_class, kClassTail);
    EXPECT_EQ(node.parent, j == 3 ? 0 : static_cast<int16_t>(j - 1));
    EXPECT_EQ(node.at.x, 0);
    EXPECT_EQ(node.confidence, 0) << "no vote speaks for it";
    EXPECT_EQ(node.has_end, j + 1 == tree.count);
    EXPECT_LT(node.at.z, tree.nodes[static_cast<size_t>(node.parent)].at.z);
  }
  EXPECT_NEAR(tree.nodes[tree.count - 1].end.z / static_cast<double>(kSide), -.49, .03);
}

// Legs at x = 4 .. 8 below the trunk, on the right side or on both.
std::vector<Block3> with_legs(bool both) {
  std::vector<Block3> blocks = {kTrunk, {{4, 0, -4}, {8, 41, 0}}};
  if (both) blocks.push_back({{-8, 0, -4}, {-4, 41, 0}});
  return blocks;
}

TEST(Coverage, LegsOnBothSidesAreOneOfAMirroredTreeAndALoneOneHasNoImage) {
  for (const bool both : {true, false}) {
    const FoldedTree tree = covered(with_legs(both), tree_of(spine(60, 0, 0), true));
    ASSERT_GE(tree.count, 5u) << both;
    for (uint32_t j = 3; j < tree.count; ++j) {
      EXPECT_TRUE(tree.beside(j));
      EXPECT_EQ(tree.only(j), both ? 0 : 1);
      EXPECT_EQ(limb_of(tree.nodes[j].joint_class) == LimbClass::kLeg, both) << "a leg has a partner";
    }
    EXPECT_EQ(tree.nodes[3].parent, 0) << "the bone from the hips is nearest";
    EXPECT_LT(tree.nodes[tree.count - 1].end.y, kSide / 20);
  }
}

}  // namespace
}  // namespace sinew::rigging
