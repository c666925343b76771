// SPDX-License-Identifier: MIT
// Figures of predicted skeletons that can be worked out by hand.
#include "sinew_trainer/rig_score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "expect_error.hpp"

namespace sinew {
namespace {

using namespace rigging;

// A side of 2, so that lengths in the file are twice those of the figures.
constexpr double kSide = 2;

ScoredSkeleton skeleton(const std::vector<Joint>& joints) { return scored_skeleton(joints, kSide); }

std::vector<Joint> chain() {
  return {{"Hips", {0, 0, 0}, -1}, {"Spine", {0, 1, 0}, 0}, {"Head", {0, 1.5f, 0}, 1}, {"Head_end", {0, 1.75f, 0}, 2}};
}

TEST(RigScore, AReferenceIsItself) {
  const RigScore score = score_rig(skeleton(chain()), skeleton(chain()));
  for (const double distance : {score.j2j, score.j2b, score.b2b}) EXPECT_EQ(distance, 0);
  for (const double share : {score.precision, score.recall, score.iou, score.joined, score.classes, score.symmetric})
    EXPECT_EQ(share, 1);
}

TEST(RigScore, DistancesAreSharesOfTheSide) {
  std::vector<Joint> moved = chain();
  for (Joint& joint : moved) joint.position.z = 0.0625f;
  const RigScore score = score_rig(skeleton(moved), skeleton(chain()));
  for (const double distance : {score.j2j, score.j2b, score.b2b}) EXPECT_NEAR(distance, 0.03125, 1e-12);
  EXPECT_EQ(score.iou, 1);
  for (Joint& joint : moved) joint.position.z = 0.125f;
  EXPECT_EQ(score_rig(skeleton(moved), skeleton(chain())).iou, 0) << "0.0625 is too far for a pair";
}

TEST(RigScore, AMissingJointCountsOnceOnItsSide) {
  std::vector<Joint> cut = chain();
  cut.resize(3);
  const RigScore score = score_rig(skeleton(cut), skeleton(chain()));
  EXPECT_NEAR(score.j2j, 0.5 * (0.125 / 4), 1e-12) << "the end is an eighth from the head";
  EXPECT_NEAR(score.j2b, 0.5 * (0.125 / 4), 1e-12);
  EXPECT_EQ(score.precision, 1);
  EXPECT_EQ(score.recall, 0.75);
  EXPECT_NEAR(score.iou, 6.0 / 7, 1e-12);
  EXPECT_EQ(score.joined, 1) << "a bone without a pair at one end does not count";
}

TEST(RigScore, BonesAreSampled) {
  // Points of the bone: both joints, and 0, 0.0045, 0.009 along it.
  const std::vector<Joint> bone = {{"Hips", {0, 0, 0}, -1}, {"Spine", {0.018f, 0, 0}, 0}}, point = {bone[0]};
  const RigScore score = score_rig(skeleton(point), skeleton(bone));
  EXPECT_NEAR(score.b2b, 0.5 * (0.009 + 0.0045 + 0.009) / 5, 1e-9);
  EXPECT_NEAR(score.j2j, 0.5 * 0.009 / 2, 1e-9);
}

TEST(RigScore, JoinedThroughUnpairedJointsOnly) {
  // An extra joint far off between hips and spine does no harm.
  std::vector<Joint> detour = chain();
  detour.push_back({"Bone", {1, 0.5f, 0}, 0});
  detour[1].parent = 4;
  EXPECT_EQ(score_rig(skeleton(detour), skeleton(chain())).joined, 1);
  // The head on the hips and the spine on the head: hips and spine hang together by a paired joint.
  std::vector<Joint> turned = chain();
  turned[2].parent = 0;
  turned[1].parent = 2;
  EXPECT_NEAR(score_rig(skeleton(turned), skeleton(chain())).joined, 2.0 / 3, 1e-12);
}

TEST(RigScore, ClassesOfPairsThatAreNoEnds) {
  std::vector<Joint> other = chain();
  other[1].name = "Neck";
  EXPECT_NEAR(score_rig(skeleton(other), skeleton(chain())).classes, 2.0 / 3, 1e-12);
  other[0].name = "Thumb";  // a detail is of no class
  EXPECT_NEAR(score_rig(skeleton(other), skeleton(chain())).classes, 1.0 / 3, 1e-12);
  other[3].name = "Hair";  // no end by its name: the reference's is one
  EXPECT_NEAR(score_rig(skeleton(other), skeleton(chain())).classes, 1.0 / 3, 1e-12);
  for (Joint& joint : other) joint.position.z = 1;
  EXPECT_TRUE(std::isnan(score_rig(skeleton(other), skeleton(chain())).classes));
  EXPECT_TRUE(std::isnan(score_rig(skeleton(other), skeleton(chain())).joined));
}

TEST(RigScore, SymmetricToTheLastDigit) {
  std::vector<Joint> pair = {{"Hips", {3, 0, 0}, -1}, {"Hand.L", {3.5f, 0, 0}, 0}, {"Hand.R", {2.5f, 0, 0}, 0}};
  EXPECT_EQ(score_rig(skeleton(pair), skeleton(chain())).symmetric, 1) << "about the middle of the joints";
  pair[2].position.y = 5e-6f;
  EXPECT_EQ(score_rig(skeleton(pair), skeleton(chain())).symmetric, 0) << "2.5e-6 of the side";
  pair[2].position.y = 1e-6f;
  EXPECT_EQ(score_rig(skeleton(pair), skeleton(chain())).symmetric, 1);
}

TEST(RigScore, TargetsAreReadLikeFiles) {
  TargetSkeleton target;
  target.side = kSide;
  for (const Joint& joint : chain()) {
    TargetJoint one;
    one.name = joint.name;
    one.position = {joint.position.x, joint.position.y, joint.position.z};
    one.parent = joint.parent;
    one.tip = joint.name == "Head_end";
    target.joints.push_back(one);
  }
  const JointClass classes[] = {kClassPelvis, kClassSpine, kClassHead, kClassHead};
  for (size_t j = 0; j < 4; ++j) target.joints[j].joint_class = classes[j];
  const ScoredSkeleton from_target = scored_skeleton(target), from_file = skeleton(chain());
  EXPECT_EQ(from_target.positions, from_file.positions);
  EXPECT_EQ(from_target.parents, from_file.parents);
  EXPECT_EQ(from_target.classes, from_file.classes);
  EXPECT_EQ(from_target.tips, from_file.tips);
  EXPECT_ERROR(score_rig({}, from_target), "without joints");
}

// The 15 bones, feet at x = 0.2 and hands at 0.9.
std::vector<Joint> humanoid() {
  std::vector<Joint> joints = {{"Hips", {0, 1, 0}, -1}, {"Spine", {0, 1.3f, 0}, 0}, {"Head", {0, 1.7f, 0}, 1}};
  for (const float side : {1.0f, -1.0f}) {
    const std::string letter = side > 0 ? ".L" : ".R";
    const char* const names[] = {"UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot"};
    for (int k = 0; k < 6; ++k) {
      const bool arm = k < 3;
      const float along = 0.3f * static_cast<float>(arm ? k + 1 : k - 3);
      const int parent = k == 0 ? 1 : k == 3 ? 0 : static_cast<int>(joints.size()) - 1;
      joints.push_back({names[k] + letter, {side * (arm ? along : 0.2f), arm ? 1.5f : 0.9f - along, 0}, parent});
    }
  }
  return joints;
}

TEST(HumanoidGaps, FifteenBonesInOrder) {
  using Gaps = std::vector<std::string>;
  EXPECT_TRUE(is_humanoid(skeleton(humanoid())));
  EXPECT_EQ(humanoid_gaps(skeleton(humanoid())), Gaps{});
  std::vector<Joint> changed = humanoid();
  changed.push_back({"Tail", {0, 1, -1}, 0});
  EXPECT_FALSE(is_humanoid(skeleton(changed)));
  EXPECT_EQ(humanoid_gaps(skeleton(changed)), Gaps{}) << "a tail does no harm";
  changed = humanoid();
  changed[2].position.x = 0.1f;
  EXPECT_EQ(humanoid_gaps(skeleton(changed)), (Gaps{"no head in the middle"}));
  changed = humanoid();
  changed[5].name = "Hand_end";
  EXPECT_EQ(humanoid_gaps(skeleton(changed)), (Gaps{"no left hand"}));
  changed = humanoid();
  changed.push_back({"Foot2.R", {-0.2f, 0, 0.2f}, 14});
  EXPECT_EQ(humanoid_gaps(skeleton(changed)), (Gaps{"2 of right foot"}));
  changed = humanoid();
  changed[4].parent = 1;
  EXPECT_EQ(humanoid_gaps(skeleton(changed)), (Gaps{"left forearm is not below the bone before it"}));
  changed = humanoid();
  changed.push_back({"Bone", {0, 0.5f, 0}, -1});
  changed[0].parent = 15;
  EXPECT_EQ(humanoid_gaps(skeleton(changed)), (Gaps{"the pelvis is not the root"}));
  EXPECT_EQ(humanoid_gaps(skeleton(chain())).size(), 12u) << "no limb at all";
}

TEST(RigScores, MeansAndTable) {
  RigScore good, bad;
  good.j2j = 0.01;
  good.joined = std::nan("");
  bad.j2j = 0.05;
  bad.joined = 0.5;
  RigScores scores = summarize({{"b__2", good}, {"a__1", good}, {"a__2", bad}});
  EXPECT_NEAR(scores.families.at("a").j2j, 0.03, 1e-12);
  EXPECT_NEAR(scores.all.j2j, 0.07 / 3, 1e-12);
  EXPECT_NEAR(scores.family_mean.j2j, 0.02, 1e-12);
  EXPECT_EQ(scores.all.joined, 0.5) << "what has nothing to count does not count";
  EXPECT_TRUE(std::isnan(scores.families.at("b").joined));
  EXPECT_EQ(scores.family_sizes.at("a"), 2u);
  scores.failures["c__1"] = "there is no such prediction";
  scores.humanoids = {{"a__1", {}}, {"a__2", {"no head in the middle", "no left foot"}}};
  const std::string table = rig_scores_markdown(scores);
  for (const char* part : {"| a | 2 | 3.00 |", "| mean of characters | 3 | 2.33 |", "| mean of families | 2 | 2.00 |",
                           "15 bones: 1 of 2", "a__2: no head in the middle, no left foot", "failed 1: c__1", "| - |"})
    EXPECT_NE(table.find(part), std::string::npos) << part << "\n" << table;
  const auto json = nlohmann::json::parse(rig_scores_json(scores));
  EXPECT_EQ(json["families"]["a"]["characters"], 2);
  EXPECT_TRUE(json["families"]["b"]["joined"].is_null());
  EXPECT_EQ(json["failed"], nlohmann::json::array({"c__1"}));
  EXPECT_EQ(json["characters"]["a__2"]["humanoid_gaps"].size(), 2u);
  EXPECT_EQ(json["humanoids"]["complete"], 1);
  EXPECT_NEAR(json["characters_mean"]["J2J"].get<double>(), 0.07 / 3, 1e-12);
}

}  // namespace
}  // namespace sinew
