// SPDX-License-Identifier: MIT
// Joints are paired by what they are, whatever they hang on.
#include "sinew_character/jobs/plane_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "sinew/rig.h"
#include "sinew_character/jobs/picture_view.hpp"

namespace sinew {
namespace {

LabeledSkeleton skeleton_of(const std::vector<std::pair<std::string, uint8_t>>& joints) {
  LabeledSkeleton out;
  for (const auto& [name, joint_class] : joints) {
    out.joints.push_back({name, {}, static_cast<int>(out.joints.size()) - 1, {}});
    out.classes.push_back(joint_class);
    out.ends.push_back(name.ends_with("_end") ? 1 : 0);
  }
  return out;
}

TEST(PinsByClass, LimbsArePairedBySideAndOrder) {
  const LabeledSkeleton target = skeleton_of({{"Hips", SINEW_CLASS_PELVIS},
                                              {"Spine", SINEW_CLASS_SPINE},
                                              {"RightForeArm", SINEW_CLASS_FOREARM},
                                              {"LeftArm", SINEW_CLASS_UPPER_ARM},
                                              {"LeftArm1", SINEW_CLASS_UPPER_ARM},
                                              {"LeftHand_end", SINEW_CLASS_HAND},
                                              {"Tail", SINEW_CLASS_TAIL}});
  const LabeledSkeleton source = skeleton_of({{"mixamorig:Hips", SINEW_CLASS_PELVIS},
                                              {"mixamorig:Spine", SINEW_CLASS_SPINE},
                                              {"mixamorig:LeftArm", SINEW_CLASS_UPPER_ARM},
                                              {"mixamorig:LeftForeArm", SINEW_CLASS_FOREARM},
                                              {"mixamorig:LeftHand", SINEW_CLASS_HAND},
                                              {"mixamorig:RightForeArm", SINEW_CLASS_FOREARM},
                                              {"mixamorig:Tail", SINEW_CLASS_TAIL}});
  std::vector<int32_t> sources(target.joints.size(), -1);
  for (const sinew_map_pin& pin : pins_by_class(target, source)) sources[pin.target] = pin.source;
  EXPECT_EQ(sources[0], 0);
  EXPECT_EQ(sources[1], -1) << "spines follow";
  EXPECT_EQ(sources[2], 5) << "not the left one";
  EXPECT_EQ(sources[3], 2);
  EXPECT_EQ(sources[4], -1) << "the source has one";
  EXPECT_EQ(sources[5], -1) << "an end";
  EXPECT_EQ(sources[6], -1) << "no limb";
}

// Bones in a picture's plane: lengths as drawn, swings to the viewer shown sideways, feet on the floor, positions back and forth.

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

// An arm of two bones that points to the side, without legs.
Motion arm() {
  return motion_of({{"Hips", {0, 1, 0}, -1, {}},
                    {"Arm", {0.2f, 1, 0}, 0, {}},
                    {"Fore", {0.5f, 1, 0}, 1, {}},
                    {"Hand", {0.8f, 1, 0}, 2, {}}});
}
const std::vector<uint8_t> kArmClasses = {SINEW_CLASS_PELVIS, SINEW_CLASS_UPPER_ARM, SINEW_CLASS_FOREARM,
                                          SINEW_CLASS_HAND};

Quaternion about(size_t axis, double angle) {
  Quaternion q = {0, 0, 0, std::cos(0.5 * angle)};
  q[axis] = std::sin(0.5 * angle);
  return q;
}

// Frames in which one joint has these rotations.
Clip turned(const Motion& motion, size_t joint, const std::vector<Quaternion>& rotations) {
  Clip clip;
  for (const Quaternion& q : rotations) {
    clip.frames.push_back(rest_of(motion));
    clip.frames.back().rotations[joint] = q;
  }
  return clip;
}

// Where a joint's bone points in the plane against its rest, in degrees.
double turn_of(const Motion& motion, const MotionFrame& frame, size_t from, size_t to) {
  MotionFrame rest = rest_of(motion);
  const WorldPose pose = world_pose(motion, frame), before = world_pose(motion, rest);
  const auto angle = [&](const WorldPose& w) {
    return std::atan2(w.positions[to][1] - w.positions[from][1], w.positions[to][0] - w.positions[from][0]);
  };
  const double turn = angle(pose) - angle(before);
  return (turn - 2 * kPi * std::round(turn / (2 * kPi))) * 180 / kPi;
}

TEST(PlaneBones, WhatTurnsInThePlaneTurnsAlike) {
  const Motion motion = arm();
  std::vector<Quaternion> round;
  for (int f = 0; f <= 24; ++f) round.push_back(about(2, f * kPi / 12));  // once round, over the half turn
  const Clip clip = clip_in_plane(motion, turned(motion, 1, round), kArmClasses, PictureView::kFront, motion);
  for (int f = 0; f <= 24; ++f) {
    const double expected = f * 15 - 360 * std::round(f * 15 / 360.0);
    EXPECT_NEAR(std::cos((turn_of(motion, clip.frames[static_cast<size_t>(f)], 1, 3) - expected) * kPi / 180), 1, 1e-9)
        << f;
  }
  // Seen from its left side the same turn of the body's own, about x, goes the other way round than from its right.
  const Motion swinging = leg();
  const Clip forwards = turned(swinging, 1, {about(0, -kPi / 6)});
  const Clip right = clip_in_plane(swinging, forwards, kClasses, PictureView::kFacesRight, swinging),
             left = clip_in_plane(swinging, forwards, kClasses, PictureView::kFacesLeft, swinging);
  EXPECT_NEAR(turn_of(swinging, right.frames[0], 1, 3), 30, 1e-4);
  EXPECT_NEAR(turn_of(swinging, left.frames[0], 1, 3), -30, 1e-4);
}

// A bone that points to the viewer says nothing of where it points in the plane; one that nearly does, little.
TEST(PlaneBones, WhatPointsToTheViewerKeepsItsDirection) {
  const Motion motion = arm();
  const double nearly = std::acos(0.2);  // a fifth of its length is seen, half of what tells
  const Clip clip = clip_in_plane(motion, turned(motion, 1, {about(2, kPi / 4), about(1, -kPi / 2), about(1, -nearly)}),
                                  kArmClasses, PictureView::kFront, motion);
  EXPECT_NEAR(turn_of(motion, clip.frames[0], 1, 2), 45, 1e-6);
  EXPECT_NEAR(turn_of(motion, clip.frames[1], 1, 2), 45, 1e-6);
  EXPECT_NEAR(turn_of(motion, clip.frames[2], 1, 2), 45 * 0.75, 1e-3) << "a quarter of the way back";
  // Over the half turn the short way is taken.
  const Quaternion behind = about(2, 170 * kPi / 180);
  const Clip over = turned(motion, 1, {behind, about(1, kPi - nearly)});  // a fifth of it, to the other side
  const Clip flat = clip_in_plane(motion, over, kArmClasses, PictureView::kFront, motion);
  EXPECT_NEAR(turn_of(motion, flat.frames[1], 1, 2), 172.5, 1e-3);
}

// The calf swings little by itself, but is of the leg that is shown from its side: the knee bends where it is seen.
TEST(PlaneBones, ALimbIsShownAsAWhole) {
  const Motion motion = leg();
  Clip clip = swing(motion);
  for (MotionFrame& frame : clip.frames) frame.rotations[2] = about(0, 0.6);
  const Clip flat = clip_in_plane(motion, clip, kClasses, PictureView::kFront, motion);
  for (const MotionFrame& frame : flat.frames)
    EXPECT_NEAR(turn_of(motion, frame, 2, 3) - turn_of(motion, frame, 1, 2), -0.6 * 180 / kPi, 1e-3);
}

// Of several bones at a joint, the one along the trunk says how it turns.
TEST(PlaneBones, HipsTurnAsTheSpineDoes) {
  const Motion motion = motion_of({{"Hips", {0, 1, 0}, -1, {}},
                                   {"LeftUpLeg", {0.1f, 1, 0}, 0, {}},
                                   {"LeftFoot", {0.1f, 0, 0}, 1, {}},
                                   {"Spine", {0, 1.05f, 0}, 0, {}},
                                   {"Head", {0, 1.5f, 0}, 3, {}}});
  const std::vector<uint8_t> classes = {SINEW_CLASS_PELVIS, SINEW_CLASS_THIGH, SINEW_CLASS_FOOT, SINEW_CLASS_SPINE,
                                        SINEW_CLASS_HEAD};
  // From the side the thigh's bone, across the picture, says nothing.
  const Clip clip =
      clip_in_plane(motion, turned(motion, 0, {about(0, 0.3)}), classes, PictureView::kFacesRight, motion);
  EXPECT_NEAR(turn_of(motion, clip.frames[0], 0, 3), -0.3 * 180 / kPi, 1e-4);
  EXPECT_NEAR(turn_of(motion, clip.frames[0], 3, 4), -0.3 * 180 / kPi, 1e-4);
}

// The root goes where the picture shows it going; what has no legs is not put on the floor.
TEST(PlaneBones, TheRootGoesAsItIsSeen) {
  const Motion motion = arm();
  Clip clip = turned(motion, 1, {kNoRotation4});
  clip.frames[0].translations[0] = {0.3, 1.5, 0.7};
  for (const auto& [view, x] :
       {std::pair{PictureView::kFront, 0.3}, {PictureView::kFacesRight, 0.7}, {PictureView::kFacesLeft, -0.7}}) {
    const Clip flat = clip_in_plane(motion, clip, kArmClasses, view, motion);
    EXPECT_NEAR(flat.frames[0].translations[0][0], x, 1e-6);
    EXPECT_NEAR(flat.frames[0].translations[0][1], 1.5, 1e-6);
    EXPECT_NEAR(flat.frames[0].translations[0][2], 0, 1e-6);
  }
  const Motion hanging =
      motion_of({{"Hips", {0, 1, 0}, -1, {}}, {"Arm", {0.2f, 1, 0}, 0, {}}, {"Hand", {0.2f, 0.4f, 0}, 1, {}}});
  const Clip raised =
      clip_in_plane(hanging, turned(hanging, 1, {about(0, -kPi / 2)}),
                    {SINEW_CLASS_PELVIS, SINEW_CLASS_UPPER_ARM, SINEW_CLASS_HAND}, PictureView::kFront, hanging);
  EXPECT_NEAR(raised.frames[0].translations[0][1], 1, 1e-6) << "a hand at the viewer is no foot";
  const Clip deep = clip_with_depth(motion, clip, PictureView::kFacesLeft, motion);
  EXPECT_NEAR(deep.frames[0].translations[0][0], -0.7, 1e-6);
  EXPECT_NEAR(deep.frames[0].translations[0][2], 0.3, 1e-6);
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

TEST(PictureView, BipedsAreSeenFromTheFrontWhereVotesHardlyTell) {
  const auto seen = [](PictureView view, BodyClass body, float spread) {
    SeenBody one;
    one.view = view;
    one.body = body;
    one.skeleton.spread = spread;
    return one;
  };
  using enum PictureView;
  const SeenBody front = seen(kFront, BodyClass::kOther, 0.103f);
  EXPECT_EQ(choose_view({front, seen(kFacesRight, BodyClass::kBiped, 0.095f)}), 0u);
  EXPECT_EQ(choose_view({front, seen(kFacesRight, BodyClass::kBiped, 0.09f)}), 1u) << "they tell";
  EXPECT_EQ(choose_view({front, seen(kFacesRight, BodyClass::kQuadruped, 0.1f)}), 1u);
  EXPECT_EQ(choose_view({front, seen(kFacesRight, BodyClass::kFish, 0.2f), seen(kFacesLeft, BodyClass::kFish, 0.1f)}),
            2u);
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
