// SPDX-License-Identifier: MIT
// A skeleton fitted to itself, to copies, to chains of other counts; what is carried, symmetry, lengths.
#include "sinew_character/predict/fit_skeleton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "expect_error.hpp"
#include "sinew/sinew.h"
#include "sinew_character/rig/joint_mirror.hpp"

namespace sinew {
namespace {

struct Row {
  const char *name, *parent;
  Vec3 position;
  uint8_t joint_class;
  bool end = false;
};

LabeledSkeleton skeleton_of(const std::vector<Row>& rows) {
  LabeledSkeleton s;
  const auto index_of = [&](const std::string& name) {
    for (size_t j = 0; j < s.joints.size(); ++j)
      if (s.joints[j].name == name) return static_cast<int>(j);
    return -1;
  };
  const auto add = [&](const std::string& name, const std::string& parent, Vec3 position, const Row& row) {
    s.joints.push_back({name, position, index_of(parent), {}});
    s.classes.push_back(row.joint_class);
    s.ends.push_back(row.end ? 1 : 0);
  };
  for (const Row& row : rows) {
    add(row.name, row.parent, row.position, row);
    if (side_of_name(row.name) == Side::kNone) continue;
    add(other_side_name(row.name), other_side_name(row.parent), mirrored(row.position, 0, 0), row);
  }
  return s;
}

// A man in A pose with a root on the floor, fingers, a twist bone and a target of inverse kinematics.
std::vector<Row> man_rows() {
  return {{"root", "", {0, 0, 0}, SINEW_CLASS_PELVIS},
          {"hips", "root", {0, 1, 0}, SINEW_CLASS_PELVIS},
          {"spine1", "hips", {0, 1.12f, -0.02f}, SINEW_CLASS_SPINE},
          {"spine2", "spine1", {0, 1.3f, -0.03f}, SINEW_CLASS_SPINE},
          {"neck", "spine2", {0, 1.5f, -0.01f}, SINEW_CLASS_NECK},
          {"head", "neck", {0, 1.6f, 0.02f}, SINEW_CLASS_HEAD},
          {"head_end", "head", {0, 1.8f, 0.02f}, SINEW_CLASS_HEAD, true},
          {"eye_l", "head", {0.04f, 1.68f, 0.1f}, kClassDetail},
          {"clavicle_l", "spine2", {0.05f, 1.45f, 0}, SINEW_CLASS_CLAVICLE},
          {"arm_l", "clavicle_l", {0.18f, 1.43f, -0.02f}, SINEW_CLASS_UPPER_ARM},
          {"twist_l", "arm_l", {0.28f, 1.34f, -0.02f}, kClassDetail},
          {"forearm_l", "arm_l", {0.38f, 1.24f, -0.03f}, SINEW_CLASS_FOREARM},
          {"hand_l", "forearm_l", {0.55f, 1.07f, 0.02f}, SINEW_CLASS_HAND},
          {"index1_l", "hand_l", {0.62f, 0.99f, 0.06f}, kClassDetail},
          {"index2_l", "index1_l", {0.65f, 0.95f, 0.07f}, kClassDetail},
          {"thumb_l", "hand_l", {0.57f, 1.04f, 0.07f}, kClassDetail},
          {"thigh_l", "hips", {0.1f, 0.94f, 0}, SINEW_CLASS_THIGH},
          {"calf_l", "thigh_l", {0.11f, 0.52f, 0.02f}, SINEW_CLASS_CALF},
          {"foot_l", "calf_l", {0.12f, 0.1f, -0.03f}, SINEW_CLASS_FOOT},
          {"toe_l", "foot_l", {0.13f, 0.02f, 0.1f}, SINEW_CLASS_TOE},
          {"target_l", "root", {0.12f, 0.1f, -0.04f}, kClassDetail}};
}
LabeledSkeleton man() { return skeleton_of(man_rows()); }

// As a model says it: other counts in the spine, no details, bone ends.
LabeledSkeleton other_body() {
  return skeleton_of({{"Hips", "", {0, 1.3f, 0.1f}, SINEW_CLASS_PELVIS},
                      {"Spine", "Hips", {0, 1.4f, 0.1f}, SINEW_CLASS_SPINE},
                      {"Spine1", "Spine", {0, 1.5f, 0.12f}, SINEW_CLASS_SPINE},
                      {"Spine2", "Spine1", {0, 1.62f, 0.13f}, SINEW_CLASS_SPINE},
                      {"Neck", "Spine2", {0, 1.9f, 0.1f}, SINEW_CLASS_NECK},
                      {"Head", "Neck", {0, 2.05f, 0.12f}, SINEW_CLASS_HEAD},
                      {"Head_end", "Head", {0, 2.4f, 0.12f}, SINEW_CLASS_HEAD, true},
                      {"LeftShoulder", "Spine2", {0.08f, 1.85f, 0.1f}, SINEW_CLASS_CLAVICLE},
                      {"LeftArm", "LeftShoulder", {0.25f, 1.85f, 0.1f}, SINEW_CLASS_UPPER_ARM},
                      {"LeftForeArm", "LeftArm", {0.6f, 1.85f, 0.08f}, SINEW_CLASS_FOREARM},
                      {"LeftHand", "LeftForeArm", {0.9f, 1.85f, 0.1f}, SINEW_CLASS_HAND},
                      {"LeftHand_end", "LeftHand", {1.1f, 1.85f, 0.1f}, SINEW_CLASS_HAND, true},
                      {"LeftUpLeg", "Hips", {0.15f, 1.2f, 0.1f}, SINEW_CLASS_THIGH},
                      {"LeftLeg", "LeftUpLeg", {0.15f, 0.65f, 0.12f}, SINEW_CLASS_CALF},
                      {"LeftFoot", "LeftLeg", {0.15f, 0.12f, 0.08f}, SINEW_CLASS_FOOT},
                      {"LeftToeBase", "LeftFoot", {0.16f, 0.03f, 0.25f}, SINEW_CLASS_TOE}});
}

size_t index_of(const std::vector<Joint>& joints, const std::string& name) {
  for (size_t j = 0; j < joints.size(); ++j)
    if (joints[j].name == name) return j;
  ADD_FAILURE() << "no joint " << name;
  return 0;
}
Vec3 position(const std::vector<Joint>& joints, const std::string& name) {
  return joints[index_of(joints, name)].position;
}
float gap(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, std::hypot(a.y - b.y, a.z - b.z)); }
float bone(const std::vector<Joint>& joints, size_t j) {
  return gap(joints[j].position, joints[static_cast<size_t>(joints[j].parent)].position);
}

void expect_positions(const FittedSkeleton& fitted, const std::vector<Joint>& wanted, float near) {
  ASSERT_EQ(fitted.joints.size(), wanted.size());
  for (size_t j = 0; j < wanted.size(); ++j) {
    EXPECT_EQ(fitted.joints[j].name, wanted[j].name);
    EXPECT_EQ(fitted.joints[j].parent, wanted[j].parent);
    EXPECT_LT(gap(fitted.joints[j].position, wanted[j].position), near) << wanted[j].name;
  }
}
std::vector<Joint> moved(std::vector<Joint> joints, float scale, Vec3 shift) {
  for (Joint& joint : joints)
    joint.position = {scale * joint.position.x + shift.x, scale * joint.position.y + shift.y,
                      scale * joint.position.z + shift.z};
  return joints;
}

TEST(FitSkeleton, OntoItselfIsTheIdentity) {
  for (const bool keep : {false, true}) {
    FitOptions options;
    options.keep_lengths = keep;
    const FittedSkeleton fitted = fit_skeleton(man(), man(), options);
    expect_positions(fitted, man().joints, 2e-6f);
    EXPECT_TRUE(fitted.symmetric);
    EXPECT_NEAR(fitted.scale, 1, 1e-6);
  }
}

TEST(FitSkeleton, OntoAScaledAndMovedCopyIsExact) {
  LabeledSkeleton copy = man();
  copy.joints = moved(copy.joints, 100, {5, 300, -20});
  FitOptions options;
  for (const bool keep : {false, true}) {
    options.keep_lengths = keep;
    expect_positions(fit_skeleton(man(), copy, options), copy.joints, 3e-4f);
    expect_positions(fit_skeleton(copy, man(), options), man().joints, 3e-6f);
  }
}

TEST(FitSkeleton, AnotherUpAxisAndAQuarterTurnAreFound) {
  LabeledSkeleton lying = man();
  for (Joint& joint : lying.joints) {
    const Vec3 p = joint.position;
    joint.position = {-p.z, -p.x, p.y};  // z up, facing -x
  }
  FitOptions options;
  expect_positions(fit_skeleton(lying, man(), options), man().joints, 3e-6f);
  options.up_axis = Axis::kZ;
  expect_positions(fit_skeleton(man(), lying, options), lying.joints, 3e-6f);
}

TEST(FitSkeleton, AnAsymmetricSkeletonStaysItself) {
  LabeledSkeleton raised = man();
  for (const char* name : {"forearm_l", "hand_l", "index1_l", "index2_l", "thumb_l"})
    raised.joints[index_of(raised.joints, name)].position.y += 0.3f;
  const FittedSkeleton fitted = fit_skeleton(raised, raised, {});
  expect_positions(fitted, raised.joints, 3e-6f);
  EXPECT_FALSE(fitted.symmetric);
}

TEST(FitSkeleton, LimbsTakeTheOthersPlaces) {
  const FittedSkeleton fitted = fit_skeleton(man(), other_body(), {});
  const std::vector<Joint>& other = other_body().joints;
  EXPECT_LT(gap(position(fitted.joints, "calf_l"), position(other, "LeftLeg")), 1e-6f);
  EXPECT_LT(gap(position(fitted.joints, "foot_r"), position(other, "RightFoot")), 1e-6f);
  EXPECT_LT(gap(position(fitted.joints, "head_end"), position(other, "Head_end")), 1e-6f);
  // The maker's habits have a say in these.
  for (const auto& [mine, theirs] :
       {std::pair("hips", "Hips"), std::pair("neck", "Neck"), std::pair("arm_l", "LeftArm"),
        std::pair("hand_l", "LeftHand"), std::pair("thigh_r", "RightUpLeg")})
    EXPECT_LT(gap(position(fitted.joints, mine), position(other, theirs)), 0.15f) << mine;
  EXPECT_EQ(fitted.how[index_of(fitted.joints, "spine1")], FitHow::kBetween);
  EXPECT_EQ(fitted.how[index_of(fitted.joints, "index1_l")], FitHow::kCarried);
  EXPECT_EQ(fitted.how[index_of(fitted.joints, "calf_l")], FitHow::kMatched);
  EXPECT_EQ(fitted.matched, 20u);
}

TEST(FitSkeleton, ChainsOfOtherCountsKeepTheirOrderAlongTheChain) {
  const FittedSkeleton fitted = fit_skeleton(man(), other_body(), {});
  const char* chain[] = {"hips", "spine1", "spine2", "neck", "head", "head_end"};
  for (size_t i = 1; i < 6; ++i)
    EXPECT_GT(position(fitted.joints, chain[i]).y, position(fitted.joints, chain[i - 1]).y + 0.02f) << chain[i];
  LabeledSkeleton short_tail = skeleton_of({{"Hips", "", {0, 1, 0}, SINEW_CLASS_PELVIS},
                                            {"Spine", "Hips", {0, 1, 1}, SINEW_CLASS_SPINE},
                                            {"Head", "Spine", {0, 1, 2}, SINEW_CLASS_HEAD},
                                            {"Tail", "Hips", {0, 1, -1}, SINEW_CLASS_TAIL},
                                            {"Tail1", "Tail", {0, 1, -3}, SINEW_CLASS_TAIL},
                                            {"Tail1_end", "Tail1", {0, 1, -5}, SINEW_CLASS_TAIL, true}});
  LabeledSkeleton long_tail = skeleton_of({{"Hips", "", {0, 1, 0}, SINEW_CLASS_PELVIS},
                                           {"Spine", "Hips", {0, 1, 1}, SINEW_CLASS_SPINE},
                                           {"Head", "Spine", {0, 1, 2}, SINEW_CLASS_HEAD},
                                           {"Tail1", "Hips", {0, 1, -1}, SINEW_CLASS_TAIL},
                                           {"Tail2", "Tail1", {0, 1, -2}, SINEW_CLASS_TAIL},
                                           {"Tail3", "Tail2", {0, 1, -3}, SINEW_CLASS_TAIL},
                                           {"Tail4", "Tail3", {0, 1, -4}, SINEW_CLASS_TAIL},
                                           {"Tail4_end", "Tail4", {0, 1, -5}, SINEW_CLASS_TAIL, true}});
  expect_positions(fit_skeleton(long_tail, short_tail, {}), long_tail.joints, 1e-6f);
  expect_positions(fit_skeleton(short_tail, long_tail, {}), short_tail.joints, 1e-6f);
  // Without ends the last bones are thought on.
  long_tail.joints.pop_back();
  long_tail.classes.pop_back();
  long_tail.ends.pop_back();
  expect_positions(fit_skeleton(long_tail, short_tail, {}), long_tail.joints, 1e-6f);
}

TEST(FitSkeleton, DetailsGoWithTheirBones) {
  const FittedSkeleton fitted = fit_skeleton(man(), other_body(), {});
  const Vec3 arm = position(fitted.joints, "arm_l"), elbow = position(fitted.joints, "forearm_l");
  const Vec3 middle = {(arm.x + elbow.x) / 2, (arm.y + elbow.y) / 2, (arm.z + elbow.z) / 2};
  EXPECT_LT(gap(position(fitted.joints, "twist_l"), middle), 0.02f)
      << "half way along a bone that was turned by 45 degrees";
  const Vec3 hand = position(fitted.joints, "hand_l"), index = position(fitted.joints, "index2_l");
  EXPECT_GT(index.x - hand.x, 0.1f) << "fingers point where the hand's bone end is";
  EXPECT_LT(std::fabs(index.y - hand.y), 0.03f);
  EXPECT_GT(position(fitted.joints, "eye_l").z, position(fitted.joints, "head").z + 0.05f);
}

TEST(FitSkeleton, RootsStayOnTheFloorAndTargetsWithTheirJoints) {
  FitOptions options;
  options.floor = -0.5f;
  const FittedSkeleton fitted = fit_skeleton(man(), other_body(), options);
  EXPECT_FLOAT_EQ(position(fitted.joints, "root").y, -0.5f);
  EXPECT_NEAR(position(fitted.joints, "root").z, position(fitted.joints, "hips").z, 1e-5f);
  EXPECT_LT(gap(position(fitted.joints, "target_l"), position(fitted.joints, "foot_l")), 0.02f);
}

TEST(FitSkeleton, SymmetricInSymmetricOut) {
  LabeledSkeleton mine = man(), other = other_body();
  const FittedSkeleton at_zero = fit_skeleton(mine, other, {});
  EXPECT_TRUE(at_zero.symmetric);
  other.joints = moved(other.joints, 1, {0.75f, 0, 0});
  // One thing in the right hand alone changes nothing for the others.
  mine.joints.push_back({"gun", {-0.6f, 1, 0.1f}, static_cast<int>(index_of(mine.joints, "hand_r")), {}});
  mine.classes.push_back(kClassDetail);
  mine.ends.push_back(0);
  for (const bool keep : {false, true}) {
    FitOptions options;
    options.keep_lengths = keep;
    const FittedSkeleton fitted = fit_skeleton(mine, other, options);
    EXPECT_TRUE(fitted.symmetric);
    for (const Joint& joint : fitted.joints) {
      if (joint.name == "gun") continue;
      const Vec3 image = mirrored(joint.position, 0, 0.75f), p = position(fitted.joints, other_side_name(joint.name));
      EXPECT_FLOAT_EQ(p.x, image.x) << joint.name;
      EXPECT_EQ(p.y, image.y) << joint.name;
      EXPECT_EQ(p.z, image.z) << joint.name;
    }
  }
}

TEST(FitSkeleton, KeepLengthsKeepsThem) {
  FitOptions options;
  options.keep_lengths = true;
  const LabeledSkeleton mine = man();
  const FittedSkeleton fitted = fit_skeleton(mine, other_body(), options);
  for (size_t j = 0; j < mine.joints.size(); ++j) {
    if (mine.joints[j].parent < 0) continue;
    EXPECT_NEAR(bone(fitted.joints, j), fitted.scale * static_cast<double>(bone(mine.joints, j)), 1e-5)
        << mine.joints[j].name;
  }
  const FittedSkeleton free = fit_skeleton(mine, other_body(), {});
  const size_t elbow = index_of(mine.joints, "forearm_l");
  EXPECT_GT(std::fabs(bone(free.joints, elbow) - bone(fitted.joints, elbow)), 0.005f);
  EXPECT_NEAR(position(fitted.joints, "forearm_l").y, position(fitted.joints, "arm_l").y, 0.05f)
      << "turned all the same";
}

TEST(FitSkeleton, WhatCannotBeFittedIsRefused) {
  EXPECT_ERROR(fit_skeleton({}, man(), {}), "no joints");
  EXPECT_ERROR(fit_skeleton(man(), {}, {}), "no joint");
  const LabeledSkeleton strange =
      skeleton_of({{"a", "", {0, 0, 0}, kClassDetail}, {"b", "a", {0, 1, 0}, kClassDetail}});
  EXPECT_ERROR(fit_skeleton(strange, man(), {}), "fewer than two");
  LabeledSkeleton cycle = man();
  cycle.joints[index_of(cycle.joints, "root")].parent = static_cast<int>(index_of(cycle.joints, "head"));
  EXPECT_ERROR(fit_skeleton(cycle, man(), {}), "cycle");
}

}  // namespace
}  // namespace sinew
