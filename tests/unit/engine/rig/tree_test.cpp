// SPDX-License-Identifier: MIT
// Skeletons from votes: a known humanoid comes back, symmetry is exact, the order of points does not matter, any votes
// give a tree, and options are kept.
#include "rig/tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "rig_votes.hpp"

namespace sinew::rigging {
namespace {

using sinew_test::FoundRig;
using sinew_test::grid_point;
using sinew_test::known_humanoid;
using sinew_test::KnownJoint;
using sinew_test::random_votes;
using sinew_test::same_joints;
using sinew_test::units;
using sinew_test::votes_for;
using sinew_test::VoteScene;

double distance(Vec3i a, Vec3i b) { return std::sqrt(static_cast<double>(square_distance(a, b))) / kSide; }

// What holds of any skeleton.
void expect_sound(const FoundRig& found, bool mirrored, const std::string& what) {
  const std::vector<RigJoint>& joints = found.joints;
  ASSERT_EQ(found.status, SINEW_OK) << what;
  EXPECT_FALSE(found.scratch_kept) << what;
  ASSERT_GE(joints.size(), 1u) << what;
  ASSERT_LE(joints.size(), kMaxRigJoints) << what;
  std::vector<int> ends(joints.size()), copies(joints.size());
  for (size_t i = 0; i < joints.size(); ++i) {
    const RigJoint& joint = joints[i];
    EXPECT_EQ(joint.parent < 0, i == 0) << what << " joint " << i;
    ASSERT_LT(joint.parent, static_cast<int>(i)) << what;
    EXPECT_LT(joint.joint_class, kJointClasses) << what;
    EXPECT_LE(joint.confidence, 32768) << what;
    EXPECT_LE(joint.parent_confidence, 32768) << what;
    if (i > 0) {
      EXPECT_EQ(joints[static_cast<size_t>(joint.parent)].tip, 0) << what;
    }
    if (joint.tip != 0) {
      EXPECT_EQ(joint.joint_class, joints[static_cast<size_t>(joint.parent)].joint_class) << what;
    }
    if (!mirrored) {
      EXPECT_EQ(joint.partner, -1) << what;
      continue;
    }
    ASSERT_GE(joint.partner, 0) << what;
    ASSERT_LT(static_cast<size_t>(joint.partner), joints.size()) << what;
    const RigJoint& partner = joints[static_cast<size_t>(joint.partner)];
    EXPECT_EQ(partner.partner, static_cast<int>(i)) << what;
    EXPECT_TRUE((partner.position == Vec3i{-joint.position.x, joint.position.y, joint.position.z})) << what;
    EXPECT_EQ(partner.joint_class, joint.joint_class) << what;
    EXPECT_EQ(partner.tip, joint.tip) << what;
    EXPECT_EQ(partner.confidence, joint.confidence) << what;
    EXPECT_EQ(partner.parent_confidence, joint.parent_confidence) << what;
    if (i > 0) {
      EXPECT_EQ(partner.parent, joints[static_cast<size_t>(joint.parent)].partner) << what << " joint " << i;
    }
  }
}

TEST(Rig, AKnownHumanoidComesBack) {
  const std::vector<KnownJoint> known = known_humanoid();
  for (uint32_t seed = 0; seed < 10; ++seed) {
    const FoundRig found(votes_for(known, 60, 0.004, seed));
    expect_sound(found, true, std::to_string(seed));
    size_t wanted = 0;
    for (const KnownJoint& joint : known) wanted += joint.x > 0 ? 2 : 1;
    EXPECT_EQ(found.joints.size(), wanted) << seed;
    for (const KnownJoint& joint : known) {
      for (const double side : {1.0, -1.0}) {
        const Vec3i at = grid_point(side * joint.x, joint.y, joint.z);
        size_t nearest = 0;
        for (size_t i = 0; i < found.joints.size(); ++i) {
          if (distance(found.joints[i].position, at) < distance(found.joints[nearest].position, at)) nearest = i;
        }
        const RigJoint& hit = found.joints[nearest];
        EXPECT_LT(distance(hit.position, at), 0.006) << seed;
        const bool tip = joint.joint_class == kClassTip;
        EXPECT_EQ(hit.tip != 0, tip) << seed;
        if (joint.parent < 0) {
          EXPECT_EQ(nearest, 0u);
          continue;
        }
        const KnownJoint& above = known[static_cast<size_t>(joint.parent)];
        EXPECT_EQ(hit.joint_class, tip ? above.joint_class : joint.joint_class) << seed;
        const RigJoint& parent = found.joints[static_cast<size_t>(hit.parent)];
        EXPECT_LT(distance(parent.position, grid_point(above.x * side, above.y, above.z)), 0.006) << seed;
        EXPECT_NEAR(hit.confidence, 16718, 40);  // 1 / (1 + 0.02 / 0.05)^2
        EXPECT_GT(hit.parent_confidence, 1000) << seed << " " << joint.y;
      }
    }
    EXPECT_NEAR(found.spread, 0.02 * 65536, 2);
  }
}

TEST(Rig, ADepthFirstListWithTheLeftBranchFirst) {
  const FoundRig found(votes_for(known_humanoid(), 60, 0.002, 1));
  std::vector<int> classes;
  for (const RigJoint& joint : found.joints) {
    if (joint.tip == 0) classes.push_back(joint.position.x < 0 ? -joint.joint_class : joint.joint_class);
  }
  EXPECT_EQ(classes, (std::vector<int>{kClassPelvis,    kClassSpine,    kClassSpine,   kClassNeck,  kClassHead,
                                       kClassClavicle,  kClassUpperArm, kClassForearm, kClassHand,  -kClassClavicle,
                                       -kClassUpperArm, -kClassForearm, -kClassHand,   kClassThigh, kClassCalf,
                                       kClassFoot,      kClassToe,      -kClassThigh,  -kClassCalf, -kClassFoot,
                                       -kClassToe}));
}

TEST(Rig, AnyVotesGiveASoundTree) {
  size_t most = 0;
  for (uint32_t seed = 0; seed < 150; ++seed) {
    test::Random random(seed);
    const uint32_t points = seed % 15 == 0 ? kMaxRigPoints : 1 + random.below(600);
    const VoteScene scene = random_votes(points, random.below(101), seed);
    RigOptions options;
    options.fold = random.below(5) != 0;
    options.spine = random.between(-1, 20);
    options.toes = random.below(2) != 0;
    options.ends = random.below(4) != 0;
    const FoundRig found(scene, options);
    expect_sound(found, scene.folded && options.fold, std::to_string(seed));
    for (const RigJoint& joint : found.joints) {
      EXPECT_TRUE(options.ends || joint.tip == 0) << seed;
      EXPECT_TRUE(options.toes || joint.joint_class != kClassToe || joint.parent < 0 ||
                  (joint.tip != 0 && joint.parent == 0))
          << seed;
    }
    most = std::max(most, found.joints.size());
  }
  EXPECT_GT(most, 60u);
}

TEST(Rig, TheOrderOfPointsDoesNotMatter) {
  for (uint32_t seed = 0; seed < 20; ++seed) {
    VoteScene scene = seed % 2 == 0 ? votes_for(known_humanoid(), 20, 0.02, seed) : random_votes(500, 70, seed);
    if (seed % 4 == 0) {  // votes that are alike but for what they vote for
      for (Vec3i& p : scene.starts) p = {p.x & ~0x7FFF, p.y & ~0x7FFF, p.z & ~0x7FFF};
      for (Vec3i& p : scene.ends) p = {p.x & ~0x7FFF, p.y & ~0x7FFF, p.z & ~0x7FFF};
    }
    const FoundRig found(scene), again(scene.shuffled(seed + 1));
    ASSERT_EQ(found.joints.size(), again.joints.size()) << seed;
    EXPECT_TRUE(same_joints(found.joints, again.joints)) << seed;
    EXPECT_EQ(found.spread, again.spread);
  }
}

TEST(Rig, TheOrderOfVotesThatAreAlikeDoesNotMatter) {
  for (uint32_t seed = 0; seed < 20; ++seed) {  // equally sure, on a lattice finer than the kernel
    test::Random random(seed);
    VoteScene scene;
    const auto node = [&] {
      return grid_point(random.between(-6, 6) * 0.02, random.between(0, 4) * 0.02, random.between(0, 4) * 0.02);
    };
    for (int i = 0; i < 400; ++i) {
      const Vec3i start = node();
      scene.add(start, random.below(3) * 5, node(), random.below(3) * 5);
    }
    EXPECT_TRUE(same_joints(FoundRig(scene).joints, FoundRig(scene.shuffled(seed + 1)).joints)) << seed;
  }
}

TEST(Rig, EndsOfJointsOnThePlaneLieOnItOrComeTwice) {
  for (const double x : {0.03, 0.2}) {
    std::vector<KnownJoint> known = known_humanoid();
    known[5] = {x, .99, .01, kClassTip, 4};
    const FoundRig found(votes_for(known, 60, 0.004, 7));
    expect_sound(found, true, "end");
    EXPECT_EQ(found.count_of(kClassHead, true), x < 0.04 ? 1u : 2u);
  }
}

TEST(Rig, AParentOfWhatIsOnThePlaneIsOnItTooOrNone) {
  for (const double x : {0.012, 0.1}) {
    const FoundRig found(votes_for({{0, .5, 0, kClassPelvis, -1},
                                    {0, .9, 0, kClassHead, 0},
                                    {x, .4, 0, kClassThigh, 0},
                                    {0, .32, 0, kClassTail, 2},
                                    {0, .2, 0, kClassTip, 3}},
                                   60, 0.001, 7));
    expect_sound(found, true, "middle");
    EXPECT_EQ(found.count_of(kClassThigh), x < 0.02 ? 1u : 2u);
    for (const RigJoint& joint : found.joints) {
      if (joint.joint_class != kClassTail || joint.tip != 0) continue;
      EXPECT_EQ(found.joints[static_cast<size_t>(joint.parent)].joint_class, x < 0.02 ? kClassThigh : kClassPelvis);
    }
  }
}

TEST(Rig, NothingIsAPelvisAtTheMean) {
  const FoundRig none{VoteScene()};
  expect_sound(none, true, "no points");
  ASSERT_EQ(none.joints.size(), 1u);
  EXPECT_EQ(none.joints[0].joint_class, kClassPelvis);
  EXPECT_TRUE((none.joints[0].position == grid_point(0, 0.5, 0.01)));
  EXPECT_EQ(none.joints[0].confidence, 0);
  EXPECT_EQ(none.spread, 65535);
}

TEST(Rig, TheSpineThatLegsStandOnIsThePelvis) {
  std::vector<KnownJoint> known = known_humanoid();
  double height = 0;
  for (KnownJoint& joint : known) {
    if (joint.joint_class != kClassPelvis) continue;
    joint.joint_class = kClassSpine;
    height = joint.y;
  }
  const FoundRig found(votes_for(known, 60, 0.004, 3));
  expect_sound(found, true, "without votes for a pelvis");
  size_t count = 0;
  for (const RigJoint& joint : found.joints) {
    if (joint.joint_class != kClassPelvis || joint.tip != 0) continue;
    ++count;
    EXPECT_LT(distance(joint.position, grid_point(0, height, 0)), 0.05);
  }
  EXPECT_EQ(count, 1u);
}

TEST(Rig, OneVoteAndAllVotesInOnePlace) {
  VoteScene scene;
  scene.add(grid_point(0.2, 0.3, 0), kClassHand, grid_point(0.3, 0.3, 0), kClassTip, 0.02, 1);
  for (int more = 0; more < 2; ++more) {
    const FoundRig found(scene);
    expect_sound(found, true, "one place");
    ASSERT_EQ(found.joints[0].joint_class, kClassHand) << more;
    // Folded, but nothing on the plane: the root is put there.
    EXPECT_TRUE((found.joints[0].position == grid_point(0, 0.3, 0)));
    for (int i = 0; i < 500; ++i) scene.add(grid_point(0.2, 0.3, 0), kClassHand, grid_point(0.2, 0.3, 0), kClassHand);
  }
}

TEST(Rig, UnfoldedSidesAreFoundApart) {
  VoteScene scene = votes_for(known_humanoid(), 60, 0.004, 7);
  const FoundRig folded(scene);
  RigOptions options;
  options.fold = false;
  const FoundRig apart(scene, options);
  expect_sound(apart, false, "not folded");
  EXPECT_EQ(apart.joints.size(), folded.joints.size());
  EXPECT_EQ(apart.count_of(kClassHand), 2u);
  scene.folded = false;
  const FoundRig same(scene);
  ASSERT_EQ(same.joints.size(), apart.joints.size());
  EXPECT_TRUE(same_joints(same.joints, apart.joints));
}

TEST(Rig, SpineHasAsManyJointsAsWished) {
  const VoteScene scene = votes_for(known_humanoid(), 60, 0.004, 7);
  const FoundRig free(scene);
  for (int32_t spine = 0; spine <= 16; ++spine) {
    RigOptions options;
    options.spine = spine;
    const FoundRig found(scene, options);
    expect_sound(found, true, "spine " + std::to_string(spine));
    EXPECT_EQ(found.count_of(kClassSpine), static_cast<uint32_t>(spine));
    EXPECT_EQ(found.joints.size() + free.count_of(kClassSpine), free.joints.size() + static_cast<size_t>(spine));
    // A chain from the pelvis to the neck, upwards; clavicles hang on its last joint.
    int16_t last = 0;
    for (size_t i = 0; i < found.joints.size(); ++i) {
      const RigJoint& joint = found.joints[i];
      if (joint.joint_class == kClassSpine) {
        EXPECT_EQ(joint.parent, last);
        EXPECT_GT(joint.position.y, found.joints[static_cast<size_t>(last)].position.y);
        EXPECT_EQ(joint.position.x, 0);
        last = static_cast<int16_t>(i);
      }
      if (joint.joint_class == kClassNeck || joint.joint_class == kClassClavicle) {
        EXPECT_EQ(joint.parent, last);
      }
    }
    if (spine == 2) {  // as there were: nothing moves
      EXPECT_TRUE(same_joints(found.joints, free.joints));
    }
  }
}

TEST(Rig, SpinesAreMadeWhereThereWereNone) {
  std::vector<KnownJoint> known = known_humanoid();
  known[1].joint_class = known[2].joint_class = kClassPelvis;
  for (uint32_t i = 0; i < 2; ++i) {
    const VoteScene scene = votes_for(known, 60, 0.004, 7);
    RigOptions options;
    options.spine = 3;
    const FoundRig found(scene, options);
    expect_sound(found, true, "made");
    EXPECT_EQ(found.count_of(kClassSpine), 3u);
    known.resize(3);  // no neck: a chain of one spine joint alone
    known[2].joint_class = kClassSpine;
    known.push_back({0, .75, -.02, kClassTip, 2});
  }
}

TEST(Rig, ToesAndEndsGoWhereTheyAreNotWanted) {
  const VoteScene scene = votes_for(known_humanoid(), 60, 0.004, 7);
  RigOptions options;
  options.toes = false;
  const FoundRig flat(scene, options);
  expect_sound(flat, true, "no toes");
  EXPECT_EQ(flat.count_of(kClassToe), 0u);
  EXPECT_EQ(flat.count_of(kClassToe, true), 0u);
  EXPECT_EQ(flat.count_of(kClassFoot), 2u);
  EXPECT_EQ(flat.count_of(kClassFoot, true), 2u);
  for (const RigJoint& joint : flat.joints) {
    if (joint.joint_class == kClassFoot && joint.tip != 0 && joint.position.x > 0) {
      EXPECT_LT(distance(joint.position, grid_point(.07, .02, .09)), 0.006);
    }
  }
  options.ends = false;
  for (const RigJoint& joint : FoundRig(scene, options).joints) EXPECT_EQ(joint.tip, 0);
}

TEST(Rig, AClavicleOrAHipThatHoldsNothingHoldsTheLimbBesideItOrGoes) {
  FoldedTree tree;
  tree.mirrored = true;
  const auto add = [&](double x, double y, uint32_t joint_class, int parent) {
    FoldedNode& node = tree.nodes[tree.count++];
    node.at = grid_point(x, y, 0);
    node.joint_class = static_cast<uint8_t>(joint_class);
    node.parent = static_cast<int16_t>(parent);
  };
  add(0, .5, kClassPelvis, -1);
  add(0, .7, kClassSpine, 0);
  add(.05, .5, kClassHip, 0);        // of a leg that has another one
  add(.04, .78, kClassClavicle, 1);  // of the arm
  add(.12, .79, kClassUpperArm, 1);
  add(.06, .5, kClassHip, 0);
  add(.07, .45, kClassThigh, 5);
  add(.2, .79, kClassClavicle, 1);  // farther out than the arm
  settle_stubs(&tree);
  const std::vector<uint8_t> classes = {kClassPelvis,   kClassSpine, kClassClavicle,
                                        kClassUpperArm, kClassHip,   kClassThigh};
  const std::vector<int> parents = {-1, 0, 1, 2, 0, 4};
  ASSERT_EQ(tree.count, classes.size());
  for (size_t j = 0; j < classes.size(); ++j) {
    EXPECT_EQ(tree.nodes[j].joint_class, classes[j]) << j;
    EXPECT_EQ(tree.nodes[j].parent, parents[j]) << j;
  }
}

TEST(Rig, AFullBlockIsAStatus) {
  const VoteScene scene = votes_for(known_humanoid(), 5, 0.004, 7);
  EXPECT_EQ(FoundRig(scene).status, SINEW_OK);
  EXPECT_EQ(FoundRig(scene, {}, 64).status, SINEW_ERROR_WORKSPACE);
}

}  // namespace
}  // namespace sinew::rigging
