// SPDX-License-Identifier: MIT
// sinew_retarget_stream_*(): as whole clips where nothing touches the floor, and on it where something does.
#include "motion/retarget_stream.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "floor_motions.hpp"

namespace {

using namespace sinew_test;
using sinew::RetargetStream;
using sinew::StreamSettings;

struct Live {
  MotionScene source, target;
  RetargetStream stream;

  Live(const MotionScene& from, const MotionScene& to, const sinew_motion_body* body,
       const StreamSettings& settings = {})
      : source(from), target(to) {
    EXPECT_EQ(stream.make(source.view(), target.view(), one_to_one(target.count()).data(), target.classes.data(), {},
                          body, settings),
              SINEW_OK);
  }
  Pose next(const Pose& pose) {
    Pose out(target.count());
    EXPECT_EQ(
        stream.frame(pose.rotations.data(), pose.translations.data(), out.rotations.data(), out.translations.data()),
        SINEW_OK);
    return out;
  }
};

TEST(RetargetStream, InTheAirItIsTheRetargetOfAFrame) {
  const MotionScene source = built({}), target = built({0.9, 1.1, 0.9, 1, 0.7});
  const BoxBody boxes(target, 0.07, 0.7);
  sinew_motion_body body = boxes.view();
  body.triangle_count = 0;  // so hands know nothing of it
  StreamSettings settings;
  settings.without |= SINEW_WITHOUT_RANGE;
  Live live(source, target, &body, settings), bare(source, target, nullptr, settings);
  PlayedClip clip(source, target);
  for (uint32_t f = 0; f < 20; ++f) {
    const Pose pose = random_pose(source, f, 1.2, {0.1 * f, 3, 0});
    clip.add(pose);
    for (Live* one : {&live, &bare}) {
      const Pose out = one->next(pose);
      EXPECT_TRUE(std::equal(out.rotations.begin(), out.rotations.end(), clip.rotations.end() - 4 * target.count()))
          << f;
      EXPECT_TRUE(
          std::equal(out.translations.begin(), out.translations.end(), clip.translations.end() - 3 * target.count()))
          << f;
    }
  }
}

TEST(RetargetStream, KeepsTheRangeThatClipsKeep) {
  const MotionScene source = body(20, 1.2), target = body(20);
  const BoxBody boxes(target, 0.1);
  const sinew_motion_body own = boxes.view();
  StreamSettings settings;
  settings.without |= SINEW_WITHOUT_CONTACTS;
  Live live(source, target, &own, settings);
  PlayedClip clip(source, target);
  std::vector<float> rotations;
  for (int f = 0; f < 30; ++f) {
    Pose pose = rest_pose(source);
    const double angle = 0.15 * (f - 10);
    pose.set(kLeftCalf, {std::sin(angle / 2), 0, 0, std::cos(angle / 2)}, vec(&pose.translations[3 * kLeftCalf]));
    clip.add(pose);
    const Pose out = live.next(pose);
    rotations.insert(rotations.end(), out.rotations.begin(), out.rotations.end());
  }
  const std::vector<float> copied = clip.rotations;
  ASSERT_EQ(clip.keep_range(boxes), SINEW_OK);
  EXPECT_NE(copied, clip.rotations);
  EXPECT_EQ(rotations, clip.rotations);
}

struct StreamFigures {
  double off = 0, below = 0, slide = 0;  // shares of the height
  int contacts = 0;
};

// What the source has on its floor, hands that do not move there, and how far the two are off.
StreamFigures play(const Proportions& p, const Motion& motion, int stands_with) {
  const MotionScene source = built({}), target = built(p);
  const BoxBody a(source, 0.1), b(target, 0.1 * p.size, p.size);
  const sinew_motion_body body = b.view();
  Live live(source, target, &body);
  StreamFigures out;
  WorldPose before, from;
  const double height = 1.58 * p.size;
  for (int f = 0; f < 30; ++f) {
    Directions d = motion(f / 30.0);
    if (stands_with >= 0) fit_trunk(source, a, static_cast<uint32_t>(stands_with), &d);
    const double low = lowest(source, a, world_pose(source, posed(source, d, {0, 0, 0})), -1);
    const Pose pose = posed(source, d, {0, -low, 0});
    const WorldPose own = world_pose(source, pose), now = world_pose(target, live.next(pose));
    out.below = std::max(out.below, -lowest(target, b, now, -1) / height);
    for (const uint32_t j : {kLeftHand, kRightHand, kLeftCalf, kRightCalf, kLeftThigh, kRightThigh}) {
      if (lowest(source, a, own, static_cast<int>(j)) > 0.012) continue;
      ++out.contacts;
      double now_low = lowest(target, b, now, static_cast<int>(j));
      if (j == kLeftHand) now_low = std::min(now_low, lowest(target, b, now, kLeftFinger));
      out.off = std::max(out.off, std::abs(now_low) / height);
      if (f > 0 && distance(own.positions[j], from.positions[j]) < 0.002)
        out.slide = std::max(out.slide, std::hypot(now.positions[j].x - before.positions[j].x,
                                                   now.positions[j].z - before.positions[j].z) /
                                            height);
    }
    before = now;
    from = own;
  }
  return out;
}

TEST(RetargetStream, TheBodyIsOnTheFloorFromTheFirstFrameOn) {
  for (const Proportions& p : builds()) {
    for (const auto& [motion, with] : {std::pair<Motion, int>{crawling, kLeftCalf},
                                       {planking, kLeftFoot},
                                       {pushing, kLeftFoot},
                                       {kneeling, -1},
                                       {sitting, -1}}) {
      const StreamFigures found = play(p, motion, with);
      EXPECT_GE(found.contacts, 30) << "one of them in all frames";
      EXPECT_LT(found.slide, 0.005) << p.arms << " " << p.trunk << " " << p.thighs;
      EXPECT_LT(found.off, 0.01) << p.arms << " " << p.trunk << " " << p.thighs;
      EXPECT_LT(found.below, 0.005) << p.arms << " " << p.trunk << " " << p.thighs;
    }
  }
}

// Hips sway over feet that stand; longer shins would slide. `sunk`: how far the rest pose lies below where the motion plays.
void sway_over_feet(float sunk) {
  MotionScene source = built({});
  for (size_t j = 0; j < source.count(); ++j) source.positions[3 * j + 1] -= sunk;
  const MotionScene target = built({1, 1, 1, 1.3, 1});
  Live live(source, target, nullptr);
  WorldPose before;
  double slide = 0, jump = 0;
  for (int f = 0; f < 60; ++f) {
    Directions d;
    d.trunk = 3.14159265358979;
    const double bend = 0.3 + 0.2 * std::sin(0.3 * f), lift = f < 40 ? 0 : 0.02 * (f - 40);
    for (int side = 0; side < 2; ++side) {
      d.thighs[side] = bend;
      d.calves[side] = -bend;
    }
    const WorldPose free = world_pose(source, posed(source, d, {0, 0, 0}));
    const Vec3d back = source.at(kLeftFoot) - free.positions[kLeftFoot];
    const Vec3d root = {0, back.y + lift + static_cast<double>(sunk), back.z};
    const WorldPose now = world_pose(target, live.next(posed(source, d, root)));
    if (f > 0) {
      const Vec3d way = now.positions[kLeftFoot] - before.positions[kLeftFoot];
      if (f < 40) slide = std::max(slide, std::hypot(way.x, way.z));
      jump = std::max(jump, std::sqrt(sinew::dot(way, way)));
    }
    before = now;
  }
  EXPECT_LT(slide, 1e-5) << sunk;
  EXPECT_LT(jump, 0.05) << "and leave the floor without a jump, " << sunk;
}

TEST(RetargetStream, FeetThatStandStayAndThenGo) { sway_over_feet(0); }

// Captures have their hips at the origin at rest, which stand on no floor.
TEST(RetargetStream, TheFloorIsWhereFeetRestedWhereTheRestPoseStandsOnNone) { sway_over_feet(0.9f); }

// A first frame below the floor, as a rest pose is, does not say where that is for good.
TEST(RetargetStream, AHigherFloorIsBelievedAfterASecond) {
  MotionScene source = built({});
  for (size_t j = 0; j < source.count(); ++j) source.positions[3 * j + 1] -= 0.9f;
  const MotionScene target = built({});
  Live live(source, target, nullptr);
  (void)live.next(rest_pose(source));
  double low = 0;
  for (int f = 0; f < 60; ++f) {
    const WorldPose now = world_pose(target, live.next(posed(source, {}, {0, 0.9, 0})));
    low = now.positions[kLeftFoot].y - target.at(kLeftFoot).y;
    if (f == 20) {
      EXPECT_GT(low, 0.5) << "it may be a jump";
    }
  }
  EXPECT_NEAR(low, 0, 0.01);
}

// A hand that lies on one belly comes to lie on a thinner or thicker one, as in a whole clip.
TEST(RetargetStream, AHandThatTouchesTouches) {
  const MotionScene scene = body(20);
  const Pose pose = reaching_pose(scene, {0.1, -0.8, 0.35});
  const BoxBody moving(scene, 0.12);
  const sinew_motion_body source = moving.view();
  StreamSettings settings;
  settings.source = &source;
  for (const double belly : {0.06, 0.10, 0.15}) {
    const BoxBody boxes(scene, belly);
    const sinew_motion_body target = boxes.view();
    Live live(scene, scene, &target, settings);
    const double copied = world_pose(scene, pose).positions[kLeftHand].z;
    WorldPose now, before;
    for (int f = 0; f < 20; ++f) {
      before = now;
      now = world_pose(scene, live.next(pose));
      EXPECT_NEAR(now.positions[kLeftHand].z - copied, belly - 0.12, 0.015) << belly;
      if (f > 0) {
        EXPECT_LT(distance(now.positions[kLeftHand], before.positions[kLeftHand]), 5e-3) << "and lies there";
      }
    }
    // Where it does not touch, it goes by and by.
    now = world_pose(scene, live.next(rest_pose(scene)));
    for (int f = 0; f < 20; ++f) {
      before = now;
      now = world_pose(scene, live.next(rest_pose(scene)));
      EXPECT_LT(distance(now.positions[kLeftHand], before.positions[kLeftHand]), 0.03) << "without a jump";
    }
    EXPECT_LT(distance(now.positions[kLeftHand], scene.at(kLeftHand)), 1e-4);
    EXPECT_LT(distance(now.positions[kRightHand], scene.at(kRightHand)), 1e-5) << "the other hand stays";
  }
}

// In the first frame and all that follow; a hand that left the body goes back without a jump.
TEST(RetargetStream, AnArmInTheBodyComesOutAtOnce) {
  const MotionScene scene = body(20), longer = body(20, 1.2);
  const BoxBody boxes(scene, 0.36);
  const sinew_motion_body thick = boxes.view();
  sinew_motion_body bare = thick;
  bare.triangle_count = 0;
  Live live(longer, scene, &thick), knows_nothing(longer, scene, &bare);
  const Pose inside = reaching_pose(longer, {0.05, -0.3, 0.95}), outside = rest_pose(longer);
  ASSERT_LT(world_pose(scene, knows_nothing.next(inside)).positions[kLeftHand].z, 0.33) << "the test needs that";
  WorldPose before;
  for (int f = 0; f < 12; ++f) {
    const WorldPose now = world_pose(scene, live.next(inside));
    EXPECT_GT(now.positions[kLeftHand].z, 0.358) << f;
    EXPECT_LT(now.positions[kLeftHand].z, 0.46) << "and no farther";
    EXPECT_LT(distance(now.positions[kRightHand], world_pose(scene, knows_nothing.next(inside)).positions[kRightHand]),
              1e-6)
        << "the other hand stays";
    if (f > 0) {
      EXPECT_LT(distance(now.positions[kLeftHand], before.positions[kLeftHand]), f == 1 ? 0.015 : 1e-5) << "no jitter";
    }
    before = now;
  }
  const Vec3d rest = world_pose(scene, knows_nothing.next(outside)).positions[kLeftHand];
  double far = 1;
  for (int f = 0; f < 60; ++f) {
    const double own = distance(world_pose(scene, live.next(outside)).positions[kLeftHand], rest);
    EXPECT_LE(own, f == 0 ? 0.2 : 0.95 * far + 1e-6) << f;
    far = own;
  }
  EXPECT_LT(far, 1e-3);
}

// As deep as at rest is no fault of the motion, and a motion of this very body is left alone.
TEST(RetargetStream, ArmsMayBeAsDeepAsTheyAreMeantToBe) {
  const MotionScene scene = body(80), longer = body(80, 1.2);
  const BoxBody boxes(scene, 0.45);  // over the hands of hanging arms
  const sinew_motion_body thick = boxes.view();
  Live live(longer, scene, &thick);
  for (int f = 0; f < 6; ++f) {
    if (f == 4) {
      EXPECT_EQ(live.stream.restart(), SINEW_OK);
    }
    EXPECT_LT(distance(world_pose(scene, live.next(rest_pose(longer))).positions[kLeftHand], scene.at(kLeftHand)), 1e-4)
        << f;
  }
  StreamSettings settings;
  settings.source = &thick;
  Live same(scene, scene, &thick, settings);
  settings.without |= SINEW_WITHOUT_CONTACTS;
  Live copied(scene, scene, &thick, settings);
  const Pose touching = reaching_pose(scene, {0.1, -0.8, 0.35});
  EXPECT_EQ(same.next(touching).rotations, copied.next(touching).rotations);
  for (int f = 0; f < 4; ++f) {  // feet that slide do
    const Pose drifting = posed(scene, {}, {0.002 * f, 0, 0});
    EXPECT_EQ(same.next(drifting).rotations, copied.next(drifting).rotations) << f;
  }
}

TEST(RetargetStream, SameFramesAgainGiveTheSameBytesAfterARestart) {
  const MotionScene source = built({}), target = built({0.9, 1.1, 0.9, 1.2, 0.7});
  const BoxBody boxes(target, 0.07, 0.7);
  const sinew_motion_body body = boxes.view();
  const auto swaying = [&](int f, double aside) {  // hips over feet that stand
    Directions d;
    d.trunk = kPi;
    const double bend = 0.3 + 0.2 * std::sin(0.3 * f);
    d.thighs[0] = d.thighs[1] = bend;
    d.calves[0] = d.calves[1] = -bend;
    const Vec3d back = source.at(kLeftFoot) - world_pose(source, posed(source, d, {0, 0, 0})).positions[kLeftFoot];
    return posed(source, d, {aside, back.y, back.z});
  };
  Live live(source, target, &body), other(source, target, &body);
  std::vector<float> rounds[3];
  for (int round = 0; round < 3; ++round) {
    for (int f = 0; f < 20; ++f) {
      const Pose pose = f < 15 ? swaying(f, 0) : reaching_pose(source, {0.05, -0.9, 0.3});
      const Pose out = (round == 2 ? other : live).next(pose);
      rounds[round].insert(rounds[round].end(), out.rotations.begin(), out.rotations.end());
      rounds[round].insert(rounds[round].end(), out.translations.begin(), out.translations.end());
    }
    for (int f = 0; f < 5; ++f) (void)live.next(swaying(f + 7, 0.3));
    for (int f = 0; f < 3; ++f) (void)live.next(reaching_pose(source, {0.05, -0.3, 0.95}));
    EXPECT_EQ(live.stream.restart(), SINEW_OK);
  }
  EXPECT_EQ(rounds[0], rounds[1]);
  EXPECT_EQ(rounds[0], rounds[2]);
}

TEST(RetargetStream, MisuseIsAStatus) {
  const MotionScene scene = body(20);
  const BoxBody boxes(scene, 0.1);
  sinew_motion_body own = boxes.view();
  const std::vector<int32_t> map = one_to_one(scene.count());
  const auto make = [&](const StreamSettings& settings, const sinew_motion_body* on) {
    return RetargetStream().make(scene.view(), scene.view(), map.data(), scene.classes.data(), {}, on, settings);
  };
  EXPECT_EQ(make({}, &own), SINEW_OK);
  StreamSettings wrong;
  wrong.fps = 0.5f;
  EXPECT_EQ(make(wrong, &own), SINEW_ERROR_ARGUMENT);
  wrong = {};
  wrong.without = SINEW_WITHOUT_TOES;
  EXPECT_EQ(make(wrong, &own), SINEW_ERROR_ARGUMENT);
  wrong = {};
  wrong.ground = std::numeric_limits<float>::infinity();
  EXPECT_EQ(make(wrong, &own), SINEW_ERROR_NOT_FINITE);
  wrong = {};
  wrong.struct_size = 4;
  EXPECT_EQ(make(wrong, &own), SINEW_ERROR_ARGUMENT);
  sinew_motion_body moving = own;
  wrong = {};
  wrong.source = &moving;
  EXPECT_EQ(make(wrong, &own), SINEW_OK);
  EXPECT_EQ(make(wrong, nullptr), SINEW_ERROR_ARGUMENT) << "nothing to touch";
  --moving.vertex_count;
  EXPECT_EQ(make(wrong, &own), SINEW_ERROR_ARGUMENT) << "other vertices";
  ++moving.vertex_count;
  moving.positions = nullptr;
  EXPECT_EQ(make(wrong, &own), SINEW_ERROR_ARGUMENT);
  own.vertex_count = 0;
  EXPECT_EQ(make({}, &own), SINEW_ERROR_COUNT);

  size_t bytes = 7;
  EXPECT_EQ(sinew_retarget_stream_workspace_size(0, 17, 0, 0, &bytes), SINEW_ERROR_COUNT);
  EXPECT_EQ(bytes, 0u);
  EXPECT_EQ(sinew_retarget_stream_workspace_size(17, 17, SINEW_MAX_VERTICES + 1, 0, &bytes), SINEW_ERROR_COUNT);
  EXPECT_EQ(sinew_retarget_stream_workspace_size(17, 17, 8, 8 * SINEW_MAX_VERTICES + 1, &bytes), SINEW_ERROR_COUNT);
  EXPECT_EQ(sinew_retarget_stream_workspace_size(17, 17, 0, 0, nullptr), SINEW_ERROR_ARGUMENT);
  ASSERT_EQ(sinew_retarget_stream_workspace_size(17, 17, 0, 0, &bytes), SINEW_OK);
  const sinew::Workspace memory(bytes);
  const sinew_skeleton rig = scene.view();
  sinew_retarget_stream* stream = nullptr;
  EXPECT_EQ(sinew_retarget_stream_create(&rig, &rig, map.data(), nullptr, nullptr, nullptr, nullptr, memory.data(),
                                         bytes - 64, &stream),
            SINEW_ERROR_WORKSPACE);
  EXPECT_EQ(stream, nullptr);
  RetargetStream empty;
  Pose pose = rest_pose(scene), out(scene.count());
  const auto frame = [&](RetargetStream& of) {
    return of.frame(pose.rotations.data(), pose.translations.data(), out.rotations.data(), out.translations.data());
  };
  EXPECT_EQ(frame(empty), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(empty.restart(), SINEW_ERROR_ARGUMENT);
  RetargetStream good;
  ASSERT_EQ(good.make(rig, rig, map.data(), nullptr, {}, nullptr), SINEW_OK);
  pose.translations[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(frame(good), SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(out.rotations[0], 77) << "untouched";
  pose = rest_pose(scene);
  EXPECT_EQ(frame(good), SINEW_OK);
}

}  // namespace
