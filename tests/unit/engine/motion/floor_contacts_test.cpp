// SPDX-License-Identifier: MIT
// The whole body on the floor: crawl, plank, push-up, kneel and sit of one body on bodies of other proportions.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "floor_motions.hpp"

namespace {

using namespace sinew_test;

struct Figures {
  double off = 0, below = 0;  // shares of the height
  int contacts = 0;
};

// Plays a motion, and looks where hands, knees and pelvis of the source touch its floor.
Figures play(const Motion& motion, const Proportions& p, bool with_source, int stands_with, double along) {
  const MotionScene source = built({}), target = built(p);
  const BoxBody a(source, 0.1), b(target, 0.1 * p.size, p.size);
  PlayedClip clip(source, target);
  std::vector<WorldPose> poses;
  for (int f = 0; f < 30; ++f) {
    Directions d = motion(f / 15.0);
    if (stands_with >= 0) fit_trunk(source, a, static_cast<uint32_t>(stands_with), &d);
    Pose pose = posed(source, d, {0, 0, 2 * along * f});
    const double low = lowest(source, a, world_pose(source, pose), -1);
    pose = posed(source, d, {0, -low, 2 * along * f});
    poses.push_back(world_pose(source, pose));
    clip.add(pose);
  }
  EXPECT_EQ(clip.contacts(with_source ? &a : nullptr, b), SINEW_OK);
  Figures out;
  const double height = 1.58 * p.size;
  for (uint32_t f = 0; f < clip.frames; ++f) {
    const WorldPose now = clip.frame(f);
    out.below = std::max(out.below, -lowest(target, b, now, -1) / height);
    for (const uint32_t j : {kLeftHand, kRightHand, kLeftCalf, kRightCalf, kLeftForearm, kRightForearm, kLeftThigh,
                             kRightThigh, kLeftFoot, kRightFoot}) {
      if (lowest(source, a, poses[f], static_cast<int>(j)) > 0.012) continue;
      ++out.contacts;
      double low = lowest(target, b, now, static_cast<int>(j));
      if (j == kLeftHand) low = std::min(low, lowest(target, b, now, kLeftFinger));
      const double off = std::abs(low) / height;
      out.off = std::max(out.off, off);
    }
  }
  return out;
}

void expect_on_floor(const Motion& motion, int stands_with, double along, int contacts) {
  for (const Proportions& p : builds()) {
    for (const bool with_source : {true, false}) {
      const Figures found = play(motion, p, with_source, stands_with, along);
      const auto what = ::testing::Message() << "arms " << p.arms << " trunk " << p.trunk << " thighs " << p.thighs
                                             << " size " << p.size << (with_source ? "" : ", no body");
      EXPECT_GE(found.contacts, contacts) << what;
      EXPECT_LT(found.off, 0.01) << what;
      EXPECT_LT(found.below, 0.005) << what;
    }
  }
}

TEST(FloorContacts, HandsAndKneesCrawl) { expect_on_floor(crawling, kLeftCalf, 0.01, 60); }
TEST(FloorContacts, HandsCarryAPlank) { expect_on_floor(planking, kLeftFoot, 0, 90); }
TEST(FloorContacts, HandsStayDownInAPushUp) { expect_on_floor(pushing, kLeftFoot, 0, 90); }
TEST(FloorContacts, KneesKneel) { expect_on_floor(kneeling, -1, 0, 60); }
TEST(FloorContacts, TheSeatSits) { expect_on_floor(sitting, -1, 0, 60); }

// A hand that stays where it is in the source does so in the target, although its shoulders go elsewhere.
TEST(FloorContacts, HandsOnTheFloorDoNotSlide) {
  const MotionScene source = built({}), target = built({1.15, 0.9, 1, 1, 1});
  const BoxBody a(source, 0.1), b(target, 0.1);
  PlayedClip clip(source, target);
  Directions d = planking(0);
  fit_trunk(source, a, kLeftFoot, &d);
  const Pose first = posed(source, d, {0, 0, 0});
  const double low = lowest(source, a, world_pose(source, first), -1);
  for (int f = 0; f < 20; ++f) {  // hips to and fro, hands and feet where they are
    const double swing = 0.03 * std::sin(0.4 * f);
    Directions moved = d;
    for (int side = 0; side < 2; ++side) {
      moved.arms[side] = moved.forearms[side] = -swing / 0.55;
      moved.thighs[side] = moved.calves[side] = d.thighs[side] - swing / 0.8 * std::cos(d.thighs[side]);
    }
    clip.add(posed(source, moved, {0, -low, swing}));
  }
  const auto slide = [&] {
    double most = 0;
    for (uint32_t f = 1; f < clip.frames; ++f)
      most = std::max(most, distance(clip.frame(f).positions[kRightHand], clip.frame(f - 1).positions[kRightHand]));
    return most;
  };
  EXPECT_GT(slide(), 0.001) << "copied";
  ASSERT_EQ(clip.contacts(&a, b), SINEW_OK);
  EXPECT_LT(slide(), 0.0005);
}

// A foot on every step, and the body over the lower one.
TEST(FloorContacts, FeetStandOnAnUnevenFloor) {
  const MotionScene scene = built({}), target = built({1, 1, 1.05, 1, 1});
  const BoxBody boxes(scene, 0.1), own(target, 0.1);
  const float steps[] = {0.2f, 0.3f, 0.2f, 0.3f};  // from right to left
  sinew_floor floor = {steps, 2, 2, {-0.1f, -1}, 0.2f, 0};
  sinew::ContactSettings settings;
  settings.floor = &floor;
  PlayedClip clip(scene, target);
  for (int f = 0; f < 5; ++f) clip.add(rest_pose(scene));
  const double hips = clip.frame(2).positions[kPelvis].y;
  ASSERT_EQ(clip.contacts(&boxes, own, settings), SINEW_OK);
  const WorldPose stands = clip.frame(2);
  EXPECT_NEAR(stands.positions[kLeftFoot].y, 0.1 + 0.3, 5e-3) << "where the floor is highest below it";
  EXPECT_NEAR(stands.positions[kRightFoot].y, 0.1 + 0.22, 5e-3);
  EXPECT_NEAR(stands.positions[kPelvis].y, hips + 0.2, 1e-6);

  const auto refused = [&](sinew_floor wrong) {
    settings.floor = &wrong;
    return clip.contacts(&boxes, own, settings);
  };
  const std::vector<float> before = clip.rotations;
  EXPECT_EQ(refused({nullptr, 2, 2, {0, 0}, 1, 0}), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused({steps, 0, 2, {0, 0}, 1, 0}), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused({steps, 2, 2, {0, 0}, 0, 0}), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(refused({steps, 2, SINEW_MAX_FLOOR_SIDE + 1, {0, 0}, 1, 0}), SINEW_ERROR_COUNT);
  const float hole[] = {0, 0, std::numeric_limits<float>::quiet_NaN(), 0};
  EXPECT_EQ(refused({hole, 2, 2, {0, 0}, 1, 0}), SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(clip.rotations, before);
}

}  // namespace
