// SPDX-License-Identifier: MIT
// Bones in a picture's plane: lengths as drawn, swings to the viewer shown sideways, feet on the floor, places back and forth.
#include "picture/plane_bones.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sinew {
namespace {

constexpr double kPi = 3.14159265358979323846;

// A pelvis with one leg, hanging down.
Motion leg() {
  return motion_of({{"Hips", {0, 1, 0}, -1, {}},
                    {"Thigh", {0.1f, 0.9f, 0}, 0, {}},
                    {"Calf", {0.1f, 0.5f, 0}, 1, {}},
                    {"Foot", {0.1f, 0, 0}, 2, {}}});
}
const std::vector<uint8_t> kClasses = {SINEW_CLASS_PELVIS, SINEW_CLASS_THIGH, SINEW_CLASS_CALF, SINEW_CLASS_FOOT};

MotionFrame rest_of(const Motion& motion) {
  MotionFrame frame;
  for (const MotionJoint& joint : motion.joints) {
    frame.rotations.push_back(kNoRotation4);
    frame.translations.push_back(joint.offset);
  }
  return frame;
}

// The thigh swings forwards and back about x, by up to half a radian.
Clip swing(const Motion& motion) {
  Clip clip;
  for (int f = 0; f < 20; ++f) {
    const double angle = 0.5 * std::sin(2 * kPi * f / 20);
    clip.frames.push_back(rest_of(motion));
    clip.frames.back().rotations[1] = {std::sin(-0.5 * angle), 0, 0, std::cos(0.5 * angle)};
  }
  return clip;
}

TEST(PlaneBones, ASwingToTheViewerIsShownSideways) {
  const Motion motion = leg();
  const Clip flat = clip_in_plane(motion, swing(motion), kClasses, PictureView::kFront, motion);
  double widest = 0;
  for (const MotionFrame& frame : flat.frames) {
    const WorldPose pose = world_pose(motion, frame);
    EXPECT_NEAR(std::hypot(pose.positions[3][0] - pose.positions[1][0], pose.positions[3][1] - pose.positions[1][1]),
                0.9, 1e-6);
    EXPECT_NEAR(pose.positions[3][2], 0, 1e-9);
    widest = std::max(widest, pose.positions[3][0] - 0.1);
  }
  EXPECT_NEAR(widest, 0.9 * std::sin(0.5), 0.01);
}

// From its side the character's forward is the way it faces.
TEST(PlaneBones, FromTheSideForwardIsWhereItFaces) {
  const Motion motion = leg();
  for (const PictureView view : {PictureView::kFacesRight, PictureView::kFacesLeft}) {
    Motion plane = motion;
    plane.joints[1].offset[0] = 0;
    const Clip flat = clip_in_plane(motion, swing(motion), kClasses, view, plane);
    const WorldPose pose = world_pose(plane, flat.frames[5]);  // forwards
    EXPECT_NEAR(pose.positions[3][0], (view == PictureView::kFacesRight ? 0.9 : -0.9) * std::sin(0.5), 0.01);
  }
}

TEST(PlaneBones, TheLowestFootIsAsHighAsTheBodys) {
  const Motion motion = leg();
  Clip clip = swing(motion);
  for (size_t f = 0; f < clip.frames.size(); ++f) clip.frames[f].translations[0][1] += 0.05 * static_cast<double>(f);
  const Clip flat = clip_in_plane(motion, clip, kClasses, PictureView::kFront, motion);
  for (size_t f = 0; f < clip.frames.size(); ++f) {
    const WorldPose body = world_pose(motion, clip.frames[f]), plane = world_pose(motion, flat.frames[f]);
    EXPECT_NEAR(std::min(plane.positions[3][1], plane.positions[2][1]),
                std::min(body.positions[3][1], body.positions[2][1]), 1e-6);
  }
}

TEST(PlaneBones, DepthKeepsTheWholeMotion) {
  const Motion motion = leg();
  const Clip deep = clip_with_depth(motion, swing(motion), PictureView::kFront, motion);
  EXPECT_NEAR(world_pose(motion, deep.frames[5]).positions[3][2], 0.9 * std::sin(0.5), 0.01);
}

TEST(PictureView, PlacesComeBack) {
  for (const PictureView view : {PictureView::kFront, PictureView::kFacesRight, PictureView::kFacesLeft}) {
    const Vec3 back = to_picture(view, from_picture(view, {1, 2, 3}));
    EXPECT_EQ(back.x, 1);
    EXPECT_EQ(back.y, 2);
    EXPECT_EQ(back.z, 3);
  }
  EXPECT_EQ(from_picture(PictureView::kFacesRight, {1, 0, 0}).z, 1);
  EXPECT_EQ(from_picture(PictureView::kFacesLeft, {-1, 0, 0}).z, 1);
}

TEST(BodyClass, WordsAreOfTheClassesInTheirOrder) {
  for (const std::string& word : body_class_words()) {
    ASSERT_TRUE(body_class_of(word)) << word;
    EXPECT_EQ(body_class_word(*body_class_of(word)), word);
  }
  EXPECT_EQ(body_class_word(BodyClass::kManyLegged), "many-legged");
  EXPECT_EQ(body_class_word(BodyClass::kOther), "other");
  EXPECT_FALSE(body_class_of("cat"));
}

}  // namespace
}  // namespace sinew
