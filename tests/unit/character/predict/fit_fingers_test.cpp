// SPDX-License-Identifier: MIT
// Fingers of a skeleton that is put into a mesh go where those of the mesh were found.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "predict/fit_details.hpp"
#include "sinew_character/predict/skeleton_template.hpp"

namespace sinew {
namespace {

// As find_lone_hand() gives it: a hand and fingers of three joints and an end, along -z, in a row along x; thumb first.
PredictedSkeleton found_hand(uint32_t fingers = 5) {
  constexpr const char* kNames[5] = {"Thumb", "Index", "Middle", "Ring", "Pinky"};
  PredictedSkeleton found;
  const auto add = [&](const std::string& name, const Vec3& p, int parent, uint8_t joint_class, bool end) {
    found.joints.push_back({name, p, parent, !end});
    found.classes.push_back(joint_class);
    found.ends.push_back(end ? 1 : 0);
    found.partners.push_back(-1);
    return static_cast<int>(found.joints.size()) - 1;
  };
  add("LeftHand", {10, 5, 0}, -1, SINEW_CLASS_HAND, false);
  for (uint32_t f = 0; f < fingers; ++f) {
    int above = 0;
    for (int k = 0; k < 4; ++k)
      above = add(std::string("LeftHand") + kNames[f] + std::to_string(k + 1),
                  {12.0f - static_cast<float>(f), 5, -4.0f - 2.0f * static_cast<float>(k)}, above,
                  static_cast<uint8_t>(SINEW_CLASS_THUMB + f), k == 3);
  }
  return found;
}

const Joint& joint(const std::vector<Joint>& joints, const std::string& name) {
  for (const Joint& one : joints)
    if (one.name == name) return one;
  throw std::runtime_error("no joint " + name);
}

void expect_at(const Vec3& is, const Vec3& wanted, const char* what) {
  EXPECT_NEAR(std::hypot(is.x - wanted.x, is.y - wanted.y, is.z - wanted.z), 0, 1e-4) << what;
}

TEST(FitFingers, ATemplateOfAHandLiesInALoneOne) {
  const PredictedSkeleton found = found_hand();
  ASSERT_TRUE(is_lone_hand(found));
  const std::optional<FittedSkeleton> fitted = fit_lone_hand(skeleton_template("hand"), found);
  ASSERT_TRUE(fitted);
  expect_at(joint(fitted->joints, "wrist").position, {10, 5, 0}, "wrist");
  expect_at(joint(fitted->joints, "index_proximal").position, {11, 5, -4}, "first");
  expect_at(joint(fitted->joints, "index_distal").position, {11, 5, -8}, "last");
  expect_at(joint(fitted->joints, "index_tip").position, {11, 5, -10}, "tip");
  expect_at(joint(fitted->joints, "thumb_metacarpal").position, {12, 5, -4}, "a thumb's first");
  const Vec3 palm = joint(fitted->joints, "index_metacarpal").position;  // on the way from the wrist to the finger
  EXPECT_GT(palm.x, 10.05f);
  EXPECT_LT(palm.x, 10.95f);
  EXPECT_NEAR(palm.z, -4 * (palm.x - 10), 1e-4);
  const Vec3 end = joint(fitted->joints, "wrist_end").position;  // carried with the whole
  EXPECT_LT(end.z, -3);
}

TEST(FitFingers, TwoFingersSayTooLittle) { EXPECT_FALSE(fit_lone_hand(skeleton_template("hand"), found_hand(2))); }

// Of a body: the nearest hand's, and what was not found stays.
TEST(FitFingers, OfABodyGoToTheNearestHand) {
  PredictedSkeleton found = found_hand(3);
  FittedSkeleton fitted;
  fitted.joints = skeleton_template("mixamo");
  fitted.how.assign(fitted.joints.size(), FitHow::kCarried);
  const std::vector<Joint> before = fitted.joints;
  for (Joint& one : found.joints) one.position.x = 0.01f * one.position.x + 0.6f;  // near the left hand at x 0.71
  for (Joint& one : found.joints) one.position = {one.position.x, 1.42f, 0.01f * one.position.z};
  EXPECT_TRUE(has_fingers(before));
  EXPECT_EQ(fit_fingers(found, &fitted), 3u);  // the other hand is too far away
  expect_at(joint(fitted.joints, "mixamorig:RightHandIndex1").position,
            joint(before, "mixamorig:RightHandIndex1").position, "the other hand");
  expect_at(joint(fitted.joints, "mixamorig:LeftHandIndex1").position, {0.71f, 1.42f, -0.04f}, "index");
  expect_at(joint(fitted.joints, "mixamorig:LeftHandIndex4").position, {0.71f, 1.42f, -0.10f}, "index end");
  expect_at(joint(fitted.joints, "mixamorig:LeftHandPinky1").position,
            joint(before, "mixamorig:LeftHandPinky1").position, "was not found");
  expect_at(joint(fitted.joints, "mixamorig:LeftHand").position, joint(before, "mixamorig:LeftHand").position, "hand");
}

}  // namespace
}  // namespace sinew
