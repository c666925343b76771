// SPDX-License-Identifier: MIT
// Chains of two skeletons side by side, the joints in them that are the same, and how well the whole fits.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "predict/limbs.hpp"
#include "sinew/sinew.h"

namespace sinew {
namespace {

struct LimbRow {
  const char* name;
  int parent;
  Vec3 position;
  uint8_t joint_class;
  bool end = false;
};

LabeledSkeleton labeled(const std::vector<LimbRow>& rows) {
  LabeledSkeleton s;
  for (const LimbRow& row : rows) {
    s.joints.push_back({row.name, row.position, row.parent, {}});
    s.classes.push_back(row.joint_class);
    s.ends.push_back(row.end ? 1 : 0);
  }
  return s;
}

// Pelvis, chest, neck and head with its end; arms of three, legs of three.
std::vector<LimbRow> person_rows() {
  return {{"hips", -1, {0, 1, 0}, SINEW_CLASS_PELVIS},
          {"chest", 0, {0, 1.3f, 0}, SINEW_CLASS_SPINE},
          {"neck", 1, {0, 1.5f, 0}, SINEW_CLASS_NECK},
          {"head", 2, {0, 1.6f, 0}, SINEW_CLASS_HEAD},
          {"head_end", 3, {0, 1.8f, 0}, SINEW_CLASS_HEAD, true},
          {"arm_l", 1, {0.2f, 1.45f, 0}, SINEW_CLASS_UPPER_ARM},
          {"forearm_l", 5, {0.5f, 1.45f, 0}, SINEW_CLASS_FOREARM},
          {"hand_l", 6, {0.8f, 1.45f, 0}, SINEW_CLASS_HAND},
          {"arm_r", 1, {-0.2f, 1.45f, 0}, SINEW_CLASS_UPPER_ARM},
          {"forearm_r", 8, {-0.5f, 1.45f, 0}, SINEW_CLASS_FOREARM},
          {"hand_r", 9, {-0.8f, 1.45f, 0}, SINEW_CLASS_HAND},
          {"thigh_l", 0, {0.1f, 0.95f, 0}, SINEW_CLASS_THIGH},
          {"calf_l", 11, {0.1f, 0.5f, 0}, SINEW_CLASS_CALF},
          {"foot_l", 12, {0.1f, 0.1f, 0}, SINEW_CLASS_FOOT},
          {"thigh_r", 0, {-0.1f, 0.95f, 0}, SINEW_CLASS_THIGH},
          {"calf_r", 14, {-0.1f, 0.5f, 0}, SINEW_CLASS_CALF},
          {"foot_r", 15, {-0.1f, 0.1f, 0}, SINEW_CLASS_FOOT}};
}

LabeledSkeleton scaled(LabeledSkeleton s, float scale, Vec3 shift) {
  for (Joint& joint : s.joints)
    joint.position = {scale * joint.position.x + shift.x, scale * joint.position.y + shift.y,
                      scale * joint.position.z + shift.z};
  return s;
}

void expect_ascending(const LimbMatches& matches) {
  for (const MatchedLimb& limb : matches.limbs()) {
    ASSERT_FALSE(limb.knots.empty());
    for (size_t k = 0; k < limb.knots.size(); ++k) {
      ASSERT_LT(limb.knots[k].mine, limb.mine_points.size());
      ASSERT_LT(limb.knots[k].other, limb.other_points.size());
      if (k == 0) continue;
      EXPECT_GT(limb.knots[k].mine, limb.knots[k - 1].mine);
      EXPECT_GT(limb.knots[k].other, limb.knots[k - 1].other);
    }
  }
}

TEST(MatchLimbs, ASkeletonMatchesItselfJointForJoint) {
  const LabeledSkeleton person = labeled(person_rows());
  const LimbMatches matches(person, person, 0);
  expect_ascending(matches);
  EXPECT_EQ(matches.pelvis(), 0);
  ASSERT_EQ(matches.limbs().size(), 5u) << "a trunk and four limbs";
  for (const MatchedLimb& limb : matches.limbs()) {
    EXPECT_EQ(limb.mine.joints, limb.other.joints);
    for (const Knot& knot : limb.knots) EXPECT_EQ(knot.mine, knot.other);
  }
  Similar best;
  EXPECT_NEAR(matches.misfit(&best), 0, 1e-9);
  EXPECT_NEAR(best.scale, 1, 1e-9);
  for (const double x : best.shift) EXPECT_NEAR(x, 0, 1e-9);
}

TEST(MatchLimbs, TheBestScaleAndShiftAreFound) {
  const LabeledSkeleton person = labeled(person_rows());
  const LimbMatches matches(person, scaled(person, 40, {3, -7, 11}), 0);
  Similar best;
  EXPECT_NEAR(matches.misfit(&best), 0, 1e-6);
  EXPECT_NEAR(best.scale, 40, 1e-4);
  EXPECT_NEAR(best.shift[0], 3, 1e-4);
  EXPECT_NEAR(best.shift[1], -7, 1e-4);
  EXPECT_NEAR(best.shift[2], 11, 1e-4);
  const Point3 head = best.apply({0, 1.6, 0});
  EXPECT_NEAR(head[1], 40 * 1.6 - 7, 1e-4);
}

// One of three joints is off by d to the side: with the best shift d / 3 is left of two and 2 d / 3 of one.
TEST(MatchLimbs, TheMisfitIsTheRootOfTheMeanSquareAsAShareOfTheSize) {
  const std::vector<LimbRow> rows = {{"hips", -1, {0, 0, 0}, SINEW_CLASS_PELVIS},
                                     {"neck", 0, {0, 1, 0}, SINEW_CLASS_NECK},
                                     {"head", 1, {0, 2, 0}, SINEW_CLASS_HEAD}};
  std::vector<LimbRow> bent = rows;
  bent[1].position.z = 0.3f;
  Similar best;
  const double misfit = LimbMatches(labeled(rows), labeled(bent), 0).misfit(&best);
  EXPECT_NEAR(misfit, 0.3 * std::sqrt(2.0) / 3 / 2, 1e-6);
  EXPECT_NEAR(best.scale, 1, 1e-6);
  EXPECT_NEAR(best.shift[2], 0.1, 1e-6);
}

TEST(MatchLimbs, TooFewMatchesAreNoFit) {
  const LabeledSkeleton one = labeled({{"hips", -1, {0, 0, 0}, SINEW_CLASS_PELVIS}});
  Similar best;
  EXPECT_TRUE(std::isinf(LimbMatches(one, labeled(person_rows()), 0).misfit(&best)));
  const LabeledSkeleton piled = labeled({{"hips", -1, {0, 0, 0}, SINEW_CLASS_PELVIS},
                                         {"neck", 0, {0, 0, 0}, SINEW_CLASS_NECK},
                                         {"head", 1, {0, 0, 0}, SINEW_CLASS_HEAD}});
  EXPECT_TRUE(std::isinf(LimbMatches(piled, labeled(person_rows()), 0).misfit(&best))) << "all in one position";
}

TEST(MatchLimbs, SidesAreThoseOfPositions) {
  // The other's joints in another order, its right arm first, by other names.
  std::vector<LimbRow> rows = person_rows();
  for (const size_t k : {size_t{5}, size_t{6}, size_t{7}}) std::swap(rows[k].position, rows[k + 3].position);
  for (size_t k = 0; k < rows.size(); ++k) rows[k].name = "bone";
  const LabeledSkeleton person = labeled(person_rows()), other = labeled(rows);
  const LimbMatches matches(person, other, 0);
  int arms = 0;
  for (const MatchedLimb& limb : matches.limbs()) {
    EXPECT_EQ(limb.mine.side, limb.other.side);
    EXPECT_EQ(limb.mine.kind, limb.other.kind);
    if (limb.mine.kind != LimbKind::kArm) continue;
    ++arms;
    EXPECT_EQ(limb.mine.joints[0], limb.mine.side > 0 ? 5 : 8);
    EXPECT_EQ(limb.other.joints[0], limb.mine.side > 0 ? 8 : 5);
  }
  EXPECT_EQ(arms, 2);
}

TEST(MatchLimbs, AnArmHasNoMatchOnTheOtherSide) {
  std::vector<LimbRow> rows = person_rows();
  rows.erase(rows.begin() + 5, rows.begin() + 8);  // the left one
  for (LimbRow& row : rows) row.parent -= row.parent > 7 ? 3 : 0;
  const LabeledSkeleton person = labeled(person_rows()), other = labeled(rows);
  const LimbMatches matches(person, other, 0);
  int arms = 0;
  for (const MatchedLimb& limb : matches.limbs()) {
    if (limb.mine.kind != LimbKind::kArm) continue;
    ++arms;
    EXPECT_EQ(limb.mine.joints[0], 8);
    EXPECT_LT(limb.other.side, 0);
  }
  EXPECT_EQ(arms, 1);
}

TEST(MatchLimbs, JointsOfAnArmAreMatchedByClass) {
  std::vector<LimbRow> rows = person_rows();
  // A clavicle before the other's left arm, and no hand.
  rows[5] = {"clavicle", 1, {0.1f, 1.45f, 0}, SINEW_CLASS_CLAVICLE};
  rows[6] = {"arm", 5, {0.2f, 1.45f, 0}, SINEW_CLASS_UPPER_ARM};
  rows[7] = {"forearm", 6, {0.5f, 1.45f, 0}, SINEW_CLASS_FOREARM};
  const LabeledSkeleton mine = labeled(person_rows()), other = labeled(rows);
  const LimbMatches matches(mine, other, 0);
  expect_ascending(matches);
  bool found = false;
  for (const MatchedLimb& limb : matches.limbs()) {
    if (limb.mine.kind != LimbKind::kArm || limb.mine.side < 0) continue;
    found = true;
    ASSERT_EQ(limb.knots.size(), 2u);
    EXPECT_EQ(limb.mine.joints[limb.knots[0].mine], 5);
    EXPECT_EQ(limb.other.joints[limb.knots[0].other], 6) << "arm on arm";
    EXPECT_EQ(limb.other.joints[limb.knots[1].other], 7) << "forearm on forearm";
  }
  EXPECT_TRUE(found);
}

TEST(MatchLimbs, SpinesOfAnyCountBeginAtThePelvisAndEndInTheHead) {
  std::vector<LimbRow> rows = person_rows();
  rows[1].position.y = 1.1f;
  rows.push_back({"chest2", 1, {0, 1.35f, 0}, SINEW_CLASS_SPINE});
  rows[2].parent = 17;
  const LabeledSkeleton mine = labeled(person_rows()), other = labeled(rows);
  const LimbMatches matches(mine, other, 0);
  const MatchedLimb& trunk = matches.limbs()[0];
  ASSERT_EQ(trunk.mine.kind, LimbKind::kTrunk);
  EXPECT_EQ(trunk.mine_points.size() + 1, trunk.other_points.size());
  for (const Knot& knot : trunk.knots) {
    const auto a = static_cast<size_t>(trunk.mine.joints[knot.mine]),
               b = static_cast<size_t>(trunk.other.joints[knot.other]);
    EXPECT_EQ(mine.classes[a], other.classes[b]);
    EXPECT_NE(mine.classes[a], SINEW_CLASS_SPINE) << "which of them is the same is not known";
  }
  EXPECT_EQ(trunk.knots.front().mine, 0u);
  EXPECT_EQ(trunk.knots.back().mine, trunk.mine_points.size() - 1) << "the end of the head";
  EXPECT_EQ(trunk.knots.back().other, trunk.other_points.size() - 1);
}

// The person with a tail of `joints`, half a unit long.
LabeledSkeleton tailed(int joints) {
  std::vector<LimbRow> rows = person_rows();
  for (int k = 0; k < joints; ++k)
    rows.push_back({"tail",
                    k == 0 ? 0 : static_cast<int>(rows.size()) - 1,
                    {0, 0.95f, -0.1f - 0.4f * static_cast<float>(k) / static_cast<float>(joints)},
                    SINEW_CLASS_TAIL});
  return labeled(rows);
}

const MatchedLimb* tail_of(const LimbMatches& matches) {
  for (const MatchedLimb& limb : matches.limbs())
    if (limb.mine.kind == LimbKind::kTail) return &limb;
  return nullptr;
}

TEST(MatchLimbs, TailsOfOneCountEndInTheirLastJointsOthersBehindThem) {
  const LabeledSkeleton two = tailed(2), four = tailed(4);
  const LimbMatches same(two, two, 0), apart(two, four, 0);
  const MatchedLimb* const alike = tail_of(same);
  ASSERT_NE(alike, nullptr);
  EXPECT_EQ(alike->mine_points.size(), 2u);
  EXPECT_EQ(alike->knots.back().mine, 1u);
  const MatchedLimb* const other = tail_of(apart);
  ASSERT_NE(other, nullptr);
  ASSERT_EQ(other->mine_points.size(), 3u) << "an end is made up for both";
  ASSERT_EQ(other->other_points.size(), 5u);
  EXPECT_EQ(other->knots.back().mine, 2u);
  EXPECT_EQ(other->knots.back().other, 4u);
  const Point3 bone = other->mine_points[1] - other->mine_points[0];
  const Point3 made = other->mine_points[2] - other->mine_points[1];
  for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(made[i], bone[i], 1e-9) << "as long as the bone before it";
}

// Chains that no class tells: by nearness, on their side, none across the body.
TEST(MatchLimbs, UnknownChainsAreMatchedWithWhatIsNearThem) {
  std::vector<LimbRow> mine = person_rows(), near = person_rows(), far = person_rows();
  mine.push_back({"bone", 1, {0.3f, 1.2f, -0.2f}, SINEW_CLASS_OTHER});
  mine.push_back({"bone", 17, {0.6f, 1.2f, -0.4f}, SINEW_CLASS_OTHER});
  near.push_back({"wing", 1, {0.32f, 1.22f, -0.2f}, SINEW_CLASS_WING});
  near.push_back({"wing", 17, {0.6f, 1.25f, -0.4f}, SINEW_CLASS_WING});
  far.push_back({"fin", 1, {0.3f, 0, 1.5f}, SINEW_CLASS_OTHER});
  far.push_back({"fin", 17, {0.3f, 0, 2.5f}, SINEW_CLASS_OTHER});
  const auto matched_with = [&](const std::vector<LimbRow>& rows) {
    const LabeledSkeleton a = labeled(mine), b = labeled(rows);
    const LimbMatches matches(a, b, 0);
    for (const MatchedLimb& limb : matches.limbs())
      if (limb.mine.joints[0] == 17) return limb.other.joints[0];
    return -1;
  };
  EXPECT_EQ(matched_with(near), 17);
  EXPECT_EQ(matched_with(far), -1);
  EXPECT_EQ(matched_with(person_rows()), -1) << "arms and legs are taken";
}

TEST(MatchLimbs, DetailsAreNoChains) {
  std::vector<LimbRow> rows = person_rows();
  rows.push_back({"finger", 7, {0.9f, 1.45f, 0}, kClassDetail});
  const LabeledSkeleton mine = labeled(rows), other = labeled(person_rows());
  const LimbMatches matches(mine, other, 0);
  for (const MatchedLimb& limb : matches.limbs())
    for (const int joint : limb.mine.joints) EXPECT_NE(joint, 17);
  Similar best;
  EXPECT_NEAR(matches.misfit(&best), 0, 1e-9);
}

TEST(MatchLimbs, WithoutAPelvisThereIsNone) {
  const LabeledSkeleton snake =
      labeled({{"neck", -1, {0, 0, 0}, SINEW_CLASS_NECK}, {"head", 0, {0, 0, 1}, SINEW_CLASS_HEAD}});
  const LimbMatches matches(snake, snake, 0);
  EXPECT_EQ(matches.pelvis(), -1);
  Similar best;
  EXPECT_NEAR(matches.misfit(&best), 0, 1e-9);
}

}  // namespace
}  // namespace sinew
