// SPDX-License-Identifier: MIT
// sinew_retarget_contacts(): limbs reach, feet stand, hands touch and stay outside, and what is wrong is refused.
#include "motion/contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/arena.hpp"
#include "motion/retarget.hpp"
#include "motion_clip.hpp"

namespace {

using namespace sinew_test;
using sinew::ContactSettings;

// The source stands still while its hips sway; the longer legs of the target would slide.
TEST(Contacts, FeetThatStandStayWhereTheyStand) {
  for (const bool with_source : {false, true}) {
    MotionScene longer = body(20);
    for (uint32_t j = 0; j < longer.count(); ++j)  // longer shins: all above the knee is higher
      if (j != kLeftFoot && j != kRightFoot) longer.positions[3 * j + 1] += 0.15f;
    PlayedClip clip(body(20), longer);
    // Knees bend and the hips sink: the source's feet stay.
    for (int f = 0; f < 30; ++f) {
      const double bend = 0.3 + 0.2 * std::sin(0.5 * f);
      Pose pose = rest_pose(clip.source);
      const Quat knee = sinew::motion::normalized({std::sin(bend), 0, 0, std::cos(bend)});
      const Quat hip = sinew::motion::normalized({-std::sin(bend / 4), 0, 0, std::cos(bend / 4)});
      for (const uint32_t thigh : {kLeftThigh, kRightThigh}) {
        pose.set(thigh, hip, vec(&pose.translations[3 * thigh]));
        pose.set(thigh + 1, knee, vec(&pose.translations[3 * (thigh + 1)]));
        pose.set(thigh + 2, conjugate(hip * knee), vec(&pose.translations[3 * (thigh + 2)]));
      }
      const Vec3d foot = world_pose(clip.source, pose).positions[kLeftFoot];
      const Vec3d back = clip.source.at(kLeftFoot) - foot;
      pose.set(0, sinew::motion::kNoRotation, clip.source.at(0) + Vec3d{0, back.y, back.z});
      ASSERT_LT(distance(world_pose(clip.source, pose).positions[kLeftFoot], clip.source.at(kLeftFoot)), 1e-6);
      clip.add(pose);
    }
    const auto slide = [&] {
      double most = 0;
      for (uint32_t f = 1; f < clip.frames; ++f)
        for (const uint32_t foot : {kLeftFoot, kRightFoot})
          most = std::max(most, std::hypot(clip.frame(f).positions[foot].x - clip.frame(f - 1).positions[foot].x,
                                           clip.frame(f).positions[foot].z - clip.frame(f - 1).positions[foot].z));
      return most;
    };
    EXPECT_GT(slide(), 0.01) << "copied";
    double lowest = 1, highest = 0;
    for (uint32_t f = 0; f < clip.frames; ++f) {
      lowest = std::min(lowest, clip.frame(f).positions[kLeftFoot].y);
      highest = std::max(highest, clip.frame(f).positions[kLeftFoot].y);
    }
    EXPECT_GT(highest - lowest, 0.01) << "copied";
    const BoxBody a(clip.source, 0.1), b(clip.target, 0.1);
    ASSERT_EQ(clip.contacts(with_source ? &a : nullptr, b), SINEW_OK);
    EXPECT_LT(slide(), 1e-4);
    for (uint32_t f = 0; f < clip.frames; ++f) {
      const WorldPose pose = clip.frame(f);
      EXPECT_NEAR(pose.positions[kLeftFoot].y, 0.1, 2e-3) << "on the floor";
      EXPECT_NEAR(distance(pose.positions[kLeftThigh], pose.positions[kLeftCalf]),
                  distance(longer.at(kLeftThigh), longer.at(kLeftCalf)), 1e-5);
    }
  }
}

void reach_forward(PlayedClip* clip, Vec3d upper_arm, uint32_t frames = 12) {
  for (uint32_t f = 0; f < frames; ++f) clip->add(reaching_pose(clip->source, upper_arm));
}

// A hand that lies on one belly lies on a thinner or thicker one.
TEST(Contacts, AHandThatTouchesTouches) {
  const MotionScene scene = body(20);
  const Vec3d forward = {0.1, -0.8, 0.35};
  for (const double belly : {0.06, 0.10, 0.15}) {
    PlayedClip clip(scene, scene);
    reach_forward(&clip, forward);
    const BoxBody source(scene, 0.12), target(scene, belly);
    const double before = clip.frame(6).positions[kLeftHand].z;
    ASSERT_EQ(clip.contacts(&source, target), SINEW_OK);
    const WorldPose after = clip.frame(6);
    EXPECT_NEAR(after.positions[kLeftHand].z - before, belly - 0.12, 0.015) << belly;
    EXPECT_LT(distance(after.positions[kRightHand], scene.at(kRightHand)), 1e-5) << "the other hand stays";
    for (uint32_t f = 1; f < clip.frames; ++f)
      EXPECT_LT(distance(clip.frame(f).positions[kLeftHand], clip.frame(f - 1).positions[kLeftHand]), 1e-3)
          << "no jitter";
  }
}

// A touch is the source's, so spread arms touch again, on the source's own body too.
TEST(Contacts, AHandOfASpreadArmTouchesAgain) {
  const MotionScene scene = body(20);
  sinew::RetargetSettings spread;
  spread.arm_spread = 25;
  PlayedClip clip(scene, scene), lifted(scene, scene, spread);
  for (PlayedClip* one : {&clip, &lifted}) reach_forward(one, {0.1, -0.8, 0.35});
  const BoxBody box(scene, 0.12);
  const Vec3d touching = clip.frame(6).positions[kLeftHand];
  EXPECT_GT(distance(lifted.frame(6).positions[kLeftHand], touching), 0.1);
  ASSERT_EQ(lifted.contacts(&box, box), SINEW_OK);
  const Vec3d found = lifted.frame(6).positions[kLeftHand];
  EXPECT_LT(distance(found, touching), 0.05) << "the size of a hand, which has rotated";
  EXPECT_NEAR(found.z, touching.z, 0.005) << "on the belly";
  EXPECT_GT(distance(lifted.frame(6).positions[kLeftForearm], clip.frame(6).positions[kLeftForearm]), 0.02);
}

// One that is far from its own body does not touch, but comes out of another.
TEST(Contacts, AHandInsideOfTheBodyComesOut) {
  const MotionScene scene = body(20);
  PlayedClip clip(scene, scene);
  reach_forward(&clip, {0.05, -0.3, 0.95});
  const BoxBody thin(scene, 0.05), thick(scene, 0.36);
  ASSERT_LT(clip.frame(6).positions[kLeftHand].z, 0.33) << "inside of it: the test needs that";
  ASSERT_EQ(clip.contacts(&thin, thick), SINEW_OK);
  EXPECT_GT(clip.frame(6).positions[kLeftHand].z, 0.36);
  EXPECT_LT(clip.frame(6).positions[kLeftHand].z, 0.45) << "and no farther";
}

// A motion without a body: what is deeper in the target's than at rest comes out, and the rest stays.
TEST(Contacts, AnArmOfAMotionWithoutABodyComesOut) {
  const MotionScene scene = body(20), longer = body(20, 1.2);
  for (const uint32_t frames : {12u, 1u, 2u}) {
    PlayedClip clip(longer, scene);
    reach_forward(&clip, {0.05, -0.3, 0.95}, frames);
    const BoxBody thick(scene, 0.36);
    const uint32_t f = frames / 2;
    const WorldPose before = clip.frame(f);
    ASSERT_LT(before.positions[kLeftHand].z, 0.33) << "inside of it: the test needs that";
    ASSERT_EQ(clip.contacts(nullptr, thick), SINEW_OK);
    EXPECT_GT(clip.frame(f).positions[kLeftHand].z, 0.36) << frames;
    EXPECT_LT(clip.frame(f).positions[kLeftHand].z, 0.45) << "and no farther";
    EXPECT_LT(distance(clip.frame(f).positions[kRightHand], before.positions[kRightHand]), 1e-6)
        << "the other hand stays";
    for (uint32_t i = 1; i < clip.frames; ++i)
      EXPECT_LT(distance(clip.frame(i).positions[kLeftHand], clip.frame(i - 1).positions[kLeftHand]), 1e-3)
          << "no jitter";
  }
}

// From the belly's front to its middle.
TEST(Contacts, WithoutABodyArmsThatDifferLittleComeOutAlike) {
  const MotionScene scene = body(20), longer = body(20, 1.2);
  const BoxBody thick(scene, 0.36);
  Vec3d before = {0, 0, 0};
  for (int k = 0; k <= 20; ++k) {
    PlayedClip clip(longer, scene);
    reach_forward(&clip, {0.05, -0.3, 0.95 - 0.04 * k}, 3);
    ASSERT_EQ(clip.contacts(nullptr, thick), SINEW_OK);
    const Vec3d now = clip.frame(1).positions[kLeftHand];
    if (k > 0) {
      EXPECT_LT(distance(now, before), 0.06) << k;
    }
    before = now;
  }
}

// A hand behind a sheet is in no body.
TEST(Contacts, WithoutABodyAHandBehindASheetStays) {
  const MotionScene scene = body(20), longer = body(20, 1.2);
  PlayedClip clip(longer, scene);
  reach_forward(&clip, {0.05, -0.3, 0.95}, 3);
  const Vec3d before = clip.frame(1).positions[kLeftHand];
  BoxBody sheet(scene, 0.05);
  const uint32_t first = static_cast<uint32_t>(sheet.positions.size() / 3);
  for (int corner = 0; corner < 4; ++corner) {
    const double x = corner % 3 == 0 ? -0.06 : 0.06, y = corner < 2 ? -0.06 : 0.06;
    for (const double p : {before.x + x, before.y + y, before.z + 0.06})
      sheet.positions.push_back(static_cast<float>(p));
    sheet.joints.push_back(kSpine);
    sheet.weights.push_back(65535);
  }
  for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) sheet.triangles.push_back(first + corner);
  ASSERT_EQ(clip.contacts(nullptr, sheet), SINEW_OK);
  EXPECT_LT(distance(clip.frame(1).positions[kLeftHand], before), 1e-6);
}

// As deep as at rest is no fault of the motion.
TEST(Contacts, WithoutABodyAnArmMayBeAsDeepAsAtRest) {
  const MotionScene scene = body(80), longer = body(80, 1.2);
  PlayedClip clip(longer, scene);
  for (int f = 0; f < 4; ++f) clip.add(rest_pose(longer));
  const BoxBody thick(scene, 0.45);  // over the hands of hanging arms
  const std::vector<float> before = clip.rotations;
  ASSERT_EQ(clip.contacts(nullptr, thick), SINEW_OK);
  for (uint32_t f = 0; f < 4; ++f)
    EXPECT_LT(distance(clip.frame(f).positions[kLeftHand], scene.at(kLeftHand)), 1e-4) << f;
}

// A knee bent to the front is straightened, one that is hardly so is left alone, and nothing pops on the way.
TEST(Contacts, KneesAndElbowsStayInTheirRange) {
  const MotionScene scene = body(20), longer = body(20, 1.2);  // knees are bent forward at rest, so calves turn back
  const BoxBody own(scene, 0.1);
  const auto bend = [&](PlayedClip* clip, double angle) {
    Pose pose = rest_pose(clip->source);
    const Quat knee = sinew::motion::normalized({std::sin(angle / 2), 0, 0, std::cos(angle / 2)});
    pose.set(kLeftCalf, knee, vec(&pose.translations[3 * kLeftCalf]));
    pose.set(0, sinew::motion::kNoRotation, clip->source.at(0) + Vec3d{0, 3, 0});  // in the air: no foot stands
    clip->add(pose);
  };
  const auto angle_of = [&](const WorldPose& pose) {  // of the calf to the back, degrees
    const Vec3d calf = sinew::unit(pose.positions[kLeftFoot] - pose.positions[kLeftCalf]);
    const Vec3d thigh = sinew::unit(pose.positions[kLeftCalf] - pose.positions[kLeftThigh]);
    return std::atan2(sinew::cross(thigh, calf).x, sinew::dot(thigh, calf)) * 180 / 3.14159265358979;
  };
  PlayedClip clip(longer, scene), free(longer, scene);
  for (int f = 0; f < 90; ++f) {
    bend(&clip, 0.05 * (f - 30));
    bend(&free, 0.05 * (f - 30));
  }
  ASSERT_EQ(clip.keep_range(own), SINEW_OK);
  EXPECT_LT(angle_of(free.frame(0)), -70) << "as it was copied";
  EXPECT_GT(angle_of(clip.frame(0)), -6);
  double fastest = 0;
  for (uint32_t f = 0; f < clip.frames; ++f) {
    const double own_angle = angle_of(clip.frame(f)), copied = angle_of(free.frame(f));
    EXPECT_GT(own_angle, -6) << f;
    EXPECT_LT(own_angle, 156) << f;
    if (copied > -4 && copied < 154) {
      EXPECT_NEAR(own_angle, copied, 1e-2) << f;
    }
    if (f > 0) fastest = std::max(fastest, std::abs(own_angle - angle_of(clip.frame(f - 1))));
    EXPECT_NEAR(distance(clip.frame(f).positions[kLeftCalf], clip.frame(f).positions[kLeftFoot]),
                distance(scene.at(kLeftCalf), scene.at(kLeftFoot)), 1e-5);
  }
  EXPECT_LT(fastest, 4) << "0.05 is 2.9 degrees";
}

TEST(Measure, CountsWhatIsLeftToBeMended) {
  const MotionScene scene = body(20);
  const BoxBody thin(scene, 0.05), thick(scene, 0.36);
  PlayedClip clip(scene, scene);
  reach_forward(&clip, {0.05, -0.3, 0.95});
  for (const bool with_source : {true, false}) {
    std::vector<sinew_limb_quality> before = clip.measure(with_source ? &thin : nullptr, thick);
    ASSERT_EQ(before.size(), 4u);
    EXPECT_EQ(before[0].joint, uint32_t{kLeftHand});
    EXPECT_EQ(before[3].joint, uint32_t{kRightFoot});
    EXPECT_EQ(before[0].leg, 0u);
    EXPECT_EQ(before[2].leg, 1u);
    EXPECT_EQ(before[0].frames, 12u);
    EXPECT_EQ(before[0].deep_frames, 12u) << "inside of the belly";
    EXPECT_GT(before[0].greatest_depth * 1.68, 0.36 - clip.frame(6).positions[kLeftHand].z)
        << "the hand's box is deeper";
    EXPECT_LT(before[0].greatest_depth * 1.68, 0.2);
    EXPECT_NEAR(before[0].depth, before[0].greatest_depth, 1e-4);
    EXPECT_EQ(before[1].deep_frames, 0u);
    EXPECT_EQ(before[2].contact_frames, 11u) << "stands from the first frame on";
    EXPECT_LT(before[2].error, 1e-6);
  }
  const float copied_depth = clip.measure(&thin, thick)[0].depth;
  ASSERT_EQ(clip.contacts(&thin, thick), SINEW_OK);
  EXPECT_LT(clip.measure(&thin, thick)[0].depth, 0.7f * copied_depth) << "all but the elbow's box";

  // A hand on a belly, copied onto a thinner one.
  PlayedClip touching(scene, scene);
  reach_forward(&touching, {0.1, -0.8, 0.35});
  const BoxBody source(scene, 0.12), target(scene, 0.06);
  const sinew_limb_quality copied = touching.measure(&source, target)[0];
  EXPECT_EQ(copied.contact_frames, 12u);
  EXPECT_GT(copied.error, 0.01);
  ASSERT_EQ(touching.contacts(&source, target), SINEW_OK);
  EXPECT_LT(touching.measure(&source, target)[0].error, 0.3 * copied.error);

  // Feet that slide, and one under the floor.
  PlayedClip sliding(scene, scene);
  for (int f = 0; f < 6; ++f) sliding.add(rest_pose(scene));
  for (uint32_t f = 0; f < 6; ++f) {
    sliding.translations[3 * 17 * f] += 0.01f * static_cast<float>(f);
    sliding.translations[3 * 17 * f + 1] -= 0.05f;
  }
  const sinew_limb_quality foot = sliding.measure(nullptr, thin)[2];
  EXPECT_NEAR(foot.error * 1.58, 0.01, 1e-4);
  EXPECT_EQ(foot.contact_frames, 5u);
  EXPECT_EQ(foot.deep_frames, 6u);
  EXPECT_NEAR(foot.depth * 1.58, 0.05, 1e-3);
  EXPECT_EQ(foot.range_frames, 0u);
}

TEST(Spots, AreTheMeasureFrameByFrame) {
  const MotionScene scene = body(20);
  const BoxBody thin(scene, 0.05), thick(scene, 0.36);
  PlayedClip clip(scene, scene);
  reach_forward(&clip, {0.05, -0.3, 0.95});
  for (const bool with_source : {true, false}) {
    std::vector<sinew_contact_spot> spots;
    const std::vector<sinew_limb_quality> limbs = clip.measure(with_source ? &thin : nullptr, thick, &spots);
    const std::vector<sinew_limb_quality> plain = clip.measure(with_source ? &thin : nullptr, thick);
    ASSERT_EQ(limbs.size(), 4u);
    EXPECT_EQ(std::memcmp(limbs.data(), plain.data(), limbs.size() * sizeof limbs[0]), 0);
    for (uint32_t f = 0; f < clip.frames; ++f) {
      const sinew_contact_spot* const row = &spots[size_t{f} * SINEW_MAX_MOTION_LIMBS];
      EXPECT_EQ(row[0].kind, uint32_t{SINEW_SPOT_INSIDE}) << f;
      EXPECT_NEAR(row[0].error, limbs[0].depth, 1e-4);
      const WorldPose posed = clip.frame(f);
      const Vec3d position = {row[0].position[0], row[0].position[1], row[0].position[2]};
      EXPECT_LT(
          std::min(distance(position, posed.positions[kLeftHand]), distance(position, posed.positions[kLeftForearm])),
          0.07)
          << "a corner of the hand's box or the elbow's";
      EXPECT_EQ(row[1].kind, uint32_t{SINEW_SPOT_NONE});
      EXPECT_EQ(row[2].kind, uint32_t{SINEW_SPOT_STANDS});
      EXPECT_LT(row[2].error, 1e-6);
      EXPECT_EQ(row[4].kind, uint32_t{SINEW_SPOT_NONE}) << "behind the limbs there is nothing";
      EXPECT_EQ(row[4].reserved, 0u);
    }
  }

  // A hand on a belly, copied onto a thinner one: it touches, as far off as the measure says.
  PlayedClip touching(scene, scene);
  reach_forward(&touching, {0.1, -0.8, 0.35});
  const BoxBody source(scene, 0.12), target(scene, 0.06);
  std::vector<sinew_contact_spot> spots;
  const sinew_limb_quality copied = touching.measure(&source, target, &spots)[0];
  EXPECT_EQ(spots[0].kind, uint32_t{SINEW_SPOT_TOUCHES});
  EXPECT_NEAR(spots[0].error, copied.error, 1e-4);

  // Feet that slide: the first frame has none before it.
  PlayedClip sliding(scene, scene);
  for (int f = 0; f < 3; ++f) sliding.add(rest_pose(scene));
  for (uint32_t f = 0; f < 3; ++f) sliding.translations[3 * 17 * f] += 0.01f * static_cast<float>(f);
  (void)sliding.measure(nullptr, thin, &spots);
  EXPECT_EQ(spots[2].error, 0);
  EXPECT_NEAR(spots[SINEW_MAX_MOTION_LIMBS + 2].error * 1.58, 0.01, 1e-4);
  EXPECT_EQ(
      sinew_retarget_spots(sliding.plan, nullptr, nullptr, nullptr, nullptr, nullptr, 0, nullptr, nullptr, nullptr),
      SINEW_ERROR_ARGUMENT);
}

TEST(Contacts, TheSameBodyIsLeftAsItIs) {
  const MotionScene scene = body(20);
  PlayedClip clip(scene, scene);
  for (uint32_t f = 0; f < 10; ++f) clip.add(random_pose(scene, f / 3, 1.2));
  const BoxBody own(scene, 0.2);
  const std::vector<float> before = clip.rotations;
  ASSERT_EQ(clip.contacts(&own, own), SINEW_OK);
  EXPECT_EQ(clip.rotations, before);
  ASSERT_EQ(clip.contacts(nullptr, own), SINEW_OK);
  EXPECT_EQ(clip.rotations, before);
}

TEST(Contacts, WhatIsWrongIsRefused) {
  const MotionScene scene = body(20);
  PlayedClip clip(body(40, 0.9), scene);
  for (uint32_t f = 0; f < 4; ++f) clip.add(random_pose(clip.source, f, 0.5));
  const BoxBody source(clip.source, 0.1, 0.9), target(scene, 0.2);
  const std::vector<float> before = clip.rotations;
  BoxBody broken = target;
  broken.joints[5] = 17;
  EXPECT_EQ(clip.contacts(&source, broken), SINEW_ERROR_RANGE);
  EXPECT_EQ(clip.contacts(&broken, target), SINEW_ERROR_RANGE);
  broken = target;
  broken.triangles[7] = 99999;
  EXPECT_EQ(clip.contacts(&source, broken), SINEW_ERROR_INDEX);
  broken = target;
  broken.positions[4] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(clip.contacts(&source, broken), SINEW_ERROR_NOT_FINITE);
  broken = target;
  broken.positions.resize(30);
  EXPECT_EQ(clip.contacts(&source, broken), SINEW_ERROR_ARGUMENT) << "another number of vertices";
  ContactSettings settings;
  settings.fps = -1;
  EXPECT_EQ(clip.contacts(&source, target, settings), SINEW_ERROR_ARGUMENT);
  settings.fps = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(clip.contacts(&source, target, settings), SINEW_ERROR_ARGUMENT);
  const float good = clip.from_rotations[30];
  clip.from_rotations[30] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(clip.contacts(&source, target), SINEW_ERROR_NOT_FINITE);
  clip.from_rotations[30] = good;
  const sinew_motion_body own = target.view();
  size_t bytes = 0;
  sinew_retarget* const none = nullptr;
  EXPECT_EQ(sinew_retarget_contacts_workspace_size(none, &own, 4, &bytes), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(clip.rotations, before);

  // A callback stops it.
  int calls = 0;
  settings = ContactSettings();
  settings.progress_user = &calls;
  settings.progress = [](void* user, uint32_t) { return ++*static_cast<int*>(user) == 2 ? 1 : 0; };
  EXPECT_EQ(clip.contacts(&source, target, settings), SINEW_ERROR_CANCELLED);
  EXPECT_EQ(calls, 2);
}

}  // namespace
