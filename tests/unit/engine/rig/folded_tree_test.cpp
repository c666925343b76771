// SPDX-License-Identifier: MIT
// A tree from given joints and votes for them: the root, parents by votes, ends by tips, and how sure they are.
#include "rig/folded_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "rig_votes.hpp"

namespace sinew::rigging {
namespace {

using sinew_test::Block;
using sinew_test::grid_point;
using sinew_test::known_humanoid;
using sinew_test::KnownJoint;
using sinew_test::units;
using sinew_test::votes_for;
using sinew_test::VoteScene;

FoldedJoint joint_at(double x, double y, double z, uint32_t joint_class) {
  FoldedJoint joint;
  joint.at = grid_point(x, y, z);
  joint.joint_class = static_cast<uint8_t>(joint_class);
  return joint;
}

struct GrownTree {
  sinew_status status = SINEW_OK;
  FoldedTree tree;
  bool scratch_kept = false;

  GrownTree(const VoteScene& scene, const std::vector<FoldedJoint>& joints, BodyKind kind = BodyKind::kAny,
            size_t missing = 0) {
    const Votes votes = scene.votes();
    const auto count = static_cast<uint32_t>(joints.size());
    VotePool pool;
    Arena measuring;
    EXPECT_TRUE(pool.build(votes, scene.folded, measuring));
    EXPECT_EQ(grow_tree(pool, joints.data(), count, kind, nullptr, measuring, &tree), SINEW_OK);
    Block block(measuring.high_water() - missing);
    EXPECT_TRUE(pool.build(votes, scene.folded, block.arena));
    const size_t used = block.arena.used();
    status = grow_tree(pool, joints.data(), count, kind, nullptr, block.arena, &tree);
    scratch_kept = block.arena.used() != used;
  }
  const FoldedNode& node(size_t j) const { return tree.nodes[j]; }
};

// The joints of a creature whose votes are known, bone ends aside: `kept` are their numbers there.
std::vector<FoldedJoint> joints_of(const std::vector<KnownJoint>& known, std::vector<int>* kept) {
  std::vector<FoldedJoint> joints;
  for (size_t i = 0; i < known.size(); ++i) {
    if (known[i].joint_class == kClassTip) continue;
    kept->push_back(static_cast<int>(i));
    joints.push_back(joint_at(known[i].x, known[i].y, known[i].z, known[i].joint_class));
  }
  return joints;
}

TEST(FoldedTree, ParentsAreThoseThatWereVotedForWhateverTheOrderOfTheJoints) {
  const std::vector<KnownJoint> known = known_humanoid();
  std::vector<int> kept;
  const std::vector<FoldedJoint> sorted = joints_of(known, &kept);
  std::vector<size_t> order(sorted.size());
  std::iota(order.begin(), order.end(), size_t{0});
  for (int turn = 0; turn < 3; ++turn) {
    std::vector<FoldedJoint> joints;
    for (const size_t i : order) joints.push_back(sorted[i]);
    const GrownTree grown(votes_for(known, 60, 0.004, 2), joints);
    ASSERT_EQ(grown.status, SINEW_OK);
    EXPECT_FALSE(grown.scratch_kept);
    ASSERT_EQ(grown.tree.count, joints.size());
    for (size_t j = 0; j < joints.size(); ++j) {
      EXPECT_EQ(grown.node(j).at, joints[j].at) << "nodes have the joints' numbers";
      EXPECT_EQ(grown.node(j).joint_class, joints[j].joint_class);
      const int parent = known[static_cast<size_t>(kept[order[j]])].parent;
      const int is = grown.node(j).parent;
      EXPECT_EQ(is < 0 ? -1 : kept[order[static_cast<size_t>(is)]], parent) << j;
      EXPECT_EQ(static_cast<int>(grown.tree.root) == static_cast<int>(j), parent < 0);
    }
    std::rotate(order.begin(), order.begin() + 5, order.end());
    std::reverse(order.begin(), order.begin() + 4);
  }
}

TEST(FoldedTree, EndsAreWhereTipsAreVotedForAndNowhereElse) {
  const std::vector<KnownJoint> known = known_humanoid();
  std::vector<int> kept;
  const GrownTree grown(votes_for(known, 60, 0.004, 2), joints_of(known, &kept));
  for (size_t j = 0; j < kept.size(); ++j) {
    const KnownJoint* tip = nullptr;
    for (const KnownJoint& joint : known)
      if (joint.joint_class == kClassTip && joint.parent == kept[j]) tip = &joint;
    ASSERT_EQ(grown.node(j).has_end, tip != nullptr) << j;
    if (tip == nullptr) continue;
    const Vec3i off = grown.node(j).end - grid_point(tip->x, tip->y, tip->z);
    EXPECT_LT(dot(off, off), dot(grid_point(0.006, 0, 0), grid_point(0.006, 0, 0))) << j;
    if (known[static_cast<size_t>(kept[j])].x == 0) {
      EXPECT_EQ(grown.node(j).end.x, 0) << "the end of a joint on the plane lies there too";
    }
    EXPECT_GT(grown.node(j).end_confidence, 0);
    EXPECT_LE(grown.node(j).end_confidence, 32768);
  }
}

TEST(FoldedTree, ConfidenceIsTheTrustInTheVotesAndNoneWhereThereAreNone) {
  VoteScene scene;
  const Vec3i pelvis = grid_point(0, .5, 0), spine = grid_point(0, .7, 0);
  for (int i = 0; i < 50; ++i) scene.add(pelvis, kClassPelvis, spine, kClassSpine, 0.05);
  const GrownTree grown(
      scene, {joint_at(0, .5, 0, kClassPelvis), joint_at(0, .7, 0, kClassSpine), joint_at(.4, .1, .3, kClassOther)});
  EXPECT_NEAR(grown.node(0).confidence, 8192, 8) << "1 / (1 + 0.05 / 0.05)^2";
  EXPECT_NEAR(grown.node(1).confidence, 8192, 8);
  EXPECT_EQ(grown.node(2).confidence, 0);
  EXPECT_EQ(grown.node(0).parent_confidence, 32768) << "the root's";
  EXPECT_LE(grown.node(1).parent_confidence, 32768);
  EXPECT_GT(grown.node(1).parent_confidence, 8 * grown.node(2).parent_confidence) << "voted for against far and alone";
}

TEST(FoldedTree, AJointThatIsLeftOverOnABoneOfItsLimbDividesTheBone) {
  const std::vector<KnownJoint> known = known_humanoid();
  std::vector<int> kept;
  std::vector<FoldedJoint> joints = joints_of(known, &kept);
  const auto number_of = [&](uint32_t joint_class) {
    return std::find_if(joints.begin(), joints.end(),
                        [&](const FoldedJoint& j) { return j.joint_class == joint_class; }) -
           joints.begin();
  };
  const auto arm = number_of(kClassUpperArm), forearm = number_of(kClassForearm), toe = number_of(kClassToe);
  const auto in_arm = static_cast<std::ptrdiff_t>(joints.size());
  joints.push_back(joint_at(.20, .795, 0, kClassUpperArm));
  joints.push_back(joint_at(.07, .022, .12, kClassToe));
  joints.push_back(joint_at(.10, .385, 0, kClassThigh));  // 3 % beside the thigh's
  const GrownTree grown(votes_for(known, 60, 0.004, 2), joints);
  const auto node = [&](std::ptrdiff_t j) { return grown.node(static_cast<size_t>(j)); };
  EXPECT_EQ(node(in_arm).parent, arm);
  EXPECT_EQ(node(forearm).parent, in_arm);
  EXPECT_EQ(node(in_arm + 1).parent, toe);
  EXPECT_TRUE(node(in_arm + 1).has_end) << "the end goes on from the joint that divides the bone";
  EXPECT_FALSE(node(toe).has_end);
  EXPECT_NEAR(node(in_arm + 1).end.z, grid_point(.07, .02, .15).z, grid_point(0, 0, .006).z);
  EXPECT_EQ(node(number_of(kClassCalf)).parent, number_of(kClassThigh));
}

TEST(FoldedTree, TheRootIsTheHeaviestPelvisOnThePlane) {
  for (const int heavy : {0, 1}) {
    VoteScene scene;
    const double heights[] = {.3, .6};
    for (int i = 0; i < 60; ++i)
      scene.add(grid_point(0, heights[heavy], 0), kClassPelvis, grid_point(0, .8, 0), kClassSpine);
    for (int i = 0; i < 20; ++i)
      scene.add(grid_point(0, heights[1 - heavy], 0), kClassPelvis, grid_point(0, .8, 0), kClassSpine);
    for (int i = 0; i < 100; ++i)  // the heaviest of all lies beside the plane, the nearest to the mean is no pelvis
      scene.add(grid_point(.2, .5, 0), kClassPelvis, grid_point(0, .5, 0), kClassSpine);
    const GrownTree grown(
        scene, {joint_at(0, .3, 0, kClassPelvis), joint_at(0, .6, 0, kClassPelvis), joint_at(.2, .5, 0, kClassPelvis),
                joint_at(0, .5, 0, kClassSpine), joint_at(0, .8, 0, kClassSpine)});
    EXPECT_EQ(grown.tree.root, static_cast<uint32_t>(heavy));
    EXPECT_EQ(grown.node(grown.tree.root).parent, -1);
  }
}

TEST(FoldedTree, WithoutAPelvisTheRootIsNearestToTheMean) {
  VoteScene scene;  // whose mean is at a height of 0.5
  for (const double y : {.1, .45, .9})
    for (int i = 0; i < 30; ++i) scene.add(grid_point(0, y, 0), kClassTail, grid_point(0, y + .05, 0), kClassTip);
  const GrownTree grown(
      scene, {joint_at(0, .1, 0, kClassTail), joint_at(0, .45, 0, kClassTail), joint_at(0, .9, 0, kClassTail)});
  EXPECT_EQ(grown.tree.root, 1u);
}

TEST(FoldedTree, WhereAllLieBesideThePlaneTheRootGoesThere) {
  VoteScene scene;
  for (int i = 0; i < 40; ++i) scene.add(grid_point(.2, .5, 0), kClassThigh, grid_point(.2, .2, 0), kClassFoot);
  const GrownTree grown(scene, {joint_at(.2, .5, 0, kClassThigh), joint_at(.2, .2, 0, kClassFoot)});
  const FoldedNode& root = grown.node(grown.tree.root);
  EXPECT_EQ(root.at.x, 0);
  EXPECT_EQ(root.at.y, units(.5));
  EXPECT_EQ(grown.node(1).at.x, units(.2)) << "no other one is moved";
}

// The structure that both sides are made of: any joints, any votes.
TEST(FoldedTree, OfAnythingIsATreeInWhichNoneOnThePlaneHangsBesideIt) {
  for (uint32_t seed = 0; seed < 60; ++seed) {
    VoteScene scene = sinew_test::random_votes(200, 60, seed);
    scene.folded = seed % 3 != 0;
    test::Random random(seed);
    std::vector<FoldedJoint> joints;
    const uint32_t count = seed % 10 == 0 ? kMaxFoldedJoints : 1 + random.below(kMaxFoldedJoints);
    for (uint32_t j = 0; j < count; ++j) {
      const double x = random.below(3) == 0 ? 0 : 0.5 * random.uniform();
      joints.push_back(
          joint_at(scene.folded ? x : x - 0.25, random.uniform(), random.uniform() - 0.5, random.below(kJointClasses)));
    }
    const GrownTree grown(scene, joints);
    ASSERT_EQ(grown.status, SINEW_OK);
    ASSERT_EQ(grown.tree.count, count);
    EXPECT_EQ(grown.tree.mirrored, scene.folded);
    for (uint32_t j = 0; j < count; ++j) {
      uint32_t steps = 0;
      int above = static_cast<int>(j);
      for (; grown.node(static_cast<size_t>(above)).parent >= 0 && steps < count; ++steps)
        above = grown.node(static_cast<size_t>(above)).parent;
      EXPECT_EQ(static_cast<uint32_t>(above), grown.tree.root) << seed << " joint " << j;
      const int parent = grown.node(j).parent;
      if (parent >= 0 && grown.tree.beside(static_cast<uint32_t>(parent))) {
        EXPECT_TRUE(grown.tree.beside(j)) << seed << " joint " << j;
      }
    }
  }
}

TEST(FoldedTree, AFullBlockIsAStatus) {
  std::vector<int> kept;
  const std::vector<FoldedJoint> joints = joints_of(known_humanoid(), &kept);
  EXPECT_EQ(GrownTree(votes_for(known_humanoid(), 20, 0.01, 1), joints, BodyKind::kAny, 64).status,
            SINEW_ERROR_WORKSPACE);
}

}  // namespace
}  // namespace sinew::rigging
