// SPDX-License-Identifier: MIT
// sinew_retarget_contacts(): limbs reach, feet stand, hands touch and stay outside, and what is wrong is refused.
#include "motion/contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/arena.hpp"
#include "motion/retarget.hpp"
#include "motion_scene.hpp"

namespace {

using namespace sinew_test;
using sinew::ContactSettings;
using sinew::Limb;
using sinew::RetargetPlan;

// A body of boxes, one around each joint of body(), rigid; `belly` is how thick the one at the spine is, and that one has a
// grid on each side. The same vertices and triangles whatever the sizes are.
struct BoxBody {
  std::vector<float> positions;
  std::vector<uint16_t> joints, weights;
  std::vector<uint32_t> triangles;

  BoxBody(const MotionScene& scene, double belly, double size = 1) {
    for (uint32_t j = 0; j < scene.count(); ++j) {
      const double half = size * (j == kSpine ? belly : 0.04);
      const uint32_t cells = j == kSpine ? 6 : 1;
      for (int axis = 0; axis < 3; ++axis) {
        add_side(scene, j, axis, half, cells);
        add_side(scene, j, axis, -half, cells);
      }
    }
  }
  void add_side(const MotionScene& scene, uint32_t j, int axis, double half, uint32_t cells) {
    const uint32_t first = static_cast<uint32_t>(positions.size() / 3), row = cells + 1;
    const double size = std::abs(half);
    for (uint32_t u = 0; u <= cells; ++u) {
      for (uint32_t v = 0; v <= cells; ++v) {
        double p[3];
        p[axis] = half;
        p[(axis + 1) % 3] = size * (2.0 * u / cells - 1);
        p[(axis + 2) % 3] = size * (2.0 * v / cells - 1);
        const Vec3d place = scene.at(j) + Vec3d{p[0], p[1], p[2]};
        for (const double x : {place.x, place.y, place.z}) positions.push_back(static_cast<float>(x));
        joints.push_back(static_cast<uint16_t>(j));
        weights.push_back(65535);
      }
    }
    for (uint32_t u = 0; u < cells; ++u) {
      for (uint32_t v = 0; v < cells; ++v) {
        const uint32_t c = first + u * row + v;
        const uint32_t out[6] = {c, c + row, c + row + 1, c, c + row + 1, c + 1};
        for (int i = 0; i < 6; ++i) triangles.push_back(half > 0 ? out[i] : out[5 - i]);
      }
    }
  }
  sinew_motion_body view() const {
    return {positions.data(),
            joints.data(),
            weights.data(),
            triangles.data(),
            static_cast<uint32_t>(positions.size() / 3),
            1,
            static_cast<uint32_t>(triangles.size() / 3)};
  }
};

// A source's clip, played on a target.
struct PlayedClip {
  MotionScene source, target;
  std::vector<float> from_rotations, from_translations, rotations, translations;
  uint32_t frames = 0;
  float ground = 0;
  RetargetPlan plan;

  PlayedClip(const MotionScene& s, const MotionScene& t) : source(s), target(t) {
    EXPECT_EQ(plan.make(s.view(), t.view(), one_to_one(t.count()).data(), t.classes.data()), SINEW_OK);
    EXPECT_EQ(plan.ground(nullptr, 0, &ground), SINEW_OK);
  }
  void add(const Pose& pose) {
    Pose out(target.count());
    EXPECT_EQ(plan.frame(pose.rotations.data(), pose.translations.data(), ground, out.rotations.data(),
                         out.translations.data()),
              SINEW_OK);
    from_rotations.insert(from_rotations.end(), pose.rotations.begin(), pose.rotations.end());
    from_translations.insert(from_translations.end(), pose.translations.begin(), pose.translations.end());
    rotations.insert(rotations.end(), out.rotations.begin(), out.rotations.end());
    translations.insert(translations.end(), out.translations.begin(), out.translations.end());
    ++frames;
  }
  sinew_motion_clip view() {
    return {from_rotations.data(), from_translations.data(), rotations.data(), translations.data(), frames, ground};
  }
  sinew_status contacts(const BoxBody* source_body, const BoxBody& target_body, const ContactSettings& settings = {}) {
    sinew::Workspace workspace;
    const sinew_motion_body own = target_body.view();
    sinew_motion_body other = {};
    if (source_body != nullptr) other = source_body->view();
    return plan.contacts(source_body == nullptr ? nullptr : &other, own, view(), settings, &workspace);
  }
  Placed frame(uint32_t f) const {
    Pose pose(target.count());
    std::copy_n(rotations.begin() + 4 * target.count() * f, pose.rotations.size(), pose.rotations.begin());
    std::copy_n(translations.begin() + 3 * target.count() * f, pose.translations.size(), pose.translations.begin());
    return placed(target, pose);
  }
};

TEST(MoveLimb, ReachesItsGoalWithBonesOfTheirLengthAndTheElbowOnItsSide) {
  const MotionScene scene = body(20);
  size_t bytes = 0;
  ASSERT_EQ(sinew_retarget_size(17, 17, &bytes), SINEW_OK);
  const sinew::Workspace block(bytes);
  sinew_retarget* plan = nullptr;
  const sinew_motion_rig rig = scene.view();
  ASSERT_EQ(sinew_retarget_create(&rig, &rig, one_to_one(17).data(), scene.classes.data(), nullptr, block.data(), bytes,
                                  &plan),
            SINEW_OK);
  const sinew::LimbList limbs = sinew::find_limbs(*plan);
  ASSERT_EQ(limbs.count, 4u);
  EXPECT_FALSE(limbs.limbs[0].leg);
  EXPECT_TRUE(limbs.limbs[3].leg);
  const Limb arm = limbs.limbs[0];
  EXPECT_EQ(arm.first, kLeftUpperArm);
  EXPECT_EQ(arm.last, kLeftHand);
  const Pose rest = rest_pose(scene);
  for (const Vec3d way :
       {Vec3d{-0.1, 0.1, 0.2}, {0.05, -0.2, 0.1}, {-0.3, 0, 0.05}, {0, 0, 0}, {9, 9, 9}, {-0.5, 0.15, 0}}) {
    sinew::load_target(plan, rest.rotations.data(), rest.translations.data());
    const Vec3d shoulder = plan->target_places[arm.first], goal = plan->target_places[arm.last] + way;
    const sinew::Quat hand = plan->target_turns[arm.last];
    const double upper = distance(scene.at(arm.first), scene.at(arm.middle)),
                 lower = distance(scene.at(arm.middle), scene.at(arm.last));
    sinew::move_limb(arm, goal, plan);
    const Vec3d elbow = plan->target_places[arm.middle], wrist = plan->target_places[arm.last];
    EXPECT_NEAR(distance(elbow, shoulder), upper, 1e-9);
    EXPECT_NEAR(distance(wrist, elbow), lower, 1e-9);
    const double reach = distance(goal, shoulder), most = 0.9995 * (upper + lower), least = 1.001 * (upper - lower);
    const double wanted = reach > most ? most : reach < least ? least : reach;
    EXPECT_NEAR(distance(wrist, shoulder), wanted, 1e-6) << "as near as it comes";
    EXPECT_LT(distance(wrist, shoulder + wanted * sinew::unit(goal - shoulder)), 1e-6);
    EXPECT_EQ(plan->target_turns[arm.last].x, hand.x) << "the hand keeps its turn";
    EXPECT_LT(distance(plan->target_places[kLeftFinger] - wrist, scene.at(kLeftFinger) - scene.at(kLeftHand)), 1e-9);
    EXPECT_LT(distance(plan->target_places[kRightHand], scene.at(kRightHand)), 1e-7);
  }
}

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
      const Quat knee = sinew::normalised({std::sin(bend), 0, 0, std::cos(bend)});
      const Quat hip = sinew::normalised({-std::sin(bend / 4), 0, 0, std::cos(bend / 4)});
      for (const uint32_t thigh : {kLeftThigh, kRightThigh}) {
        pose.set(thigh, hip, vec(&pose.translations[3 * thigh]));
        pose.set(thigh + 1, knee, vec(&pose.translations[3 * (thigh + 1)]));
        pose.set(thigh + 2, conjugate(hip * knee), vec(&pose.translations[3 * (thigh + 2)]));
      }
      const Vec3d foot = placed(clip.source, pose).places[kLeftFoot];
      const Vec3d back = clip.source.at(kLeftFoot) - foot;
      pose.set(0, sinew::kNoTurn, clip.source.at(0) + Vec3d{0, back.y, back.z});
      ASSERT_LT(distance(placed(clip.source, pose).places[kLeftFoot], clip.source.at(kLeftFoot)), 1e-6);
      clip.add(pose);
    }
    const auto slide = [&] {
      double most = 0;
      for (uint32_t f = 1; f < clip.frames; ++f)
        for (const uint32_t foot : {kLeftFoot, kRightFoot})
          most = std::max(most, std::hypot(clip.frame(f).places[foot].x - clip.frame(f - 1).places[foot].x,
                                           clip.frame(f).places[foot].z - clip.frame(f - 1).places[foot].z));
      return most;
    };
    EXPECT_GT(slide(), 0.01) << "copied";
    double lowest = 1, highest = 0;
    for (uint32_t f = 0; f < clip.frames; ++f) {
      lowest = std::min(lowest, clip.frame(f).places[kLeftFoot].y);
      highest = std::max(highest, clip.frame(f).places[kLeftFoot].y);
    }
    EXPECT_GT(highest - lowest, 0.01) << "copied";
    const BoxBody a(clip.source, 0.1), b(clip.target, 0.1);
    ASSERT_EQ(clip.contacts(with_source ? &a : nullptr, b), SINEW_OK);
    EXPECT_LT(slide(), 1e-4);
    for (uint32_t f = 0; f < clip.frames; ++f) {
      const Placed pose = clip.frame(f);
      EXPECT_NEAR(pose.places[kLeftFoot].y, 0.1, 2e-3) << "on the floor";
      EXPECT_NEAR(distance(pose.places[kLeftThigh], pose.places[kLeftCalf]),
                  distance(longer.at(kLeftThigh), longer.at(kLeftCalf)), 1e-5);
    }
  }
}

// The left hand in front of the belly, as far as the upper arm points forward, in every frame.
void reach_forward(PlayedClip* clip, Vec3d upper_arm) {
  const MotionScene& scene = clip->source;
  for (int f = 0; f < 12; ++f) {
    Pose pose = rest_pose(scene);
    const Quat upper = sinew::shortest_arc(scene.at(kLeftForearm) - scene.at(kLeftUpperArm), upper_arm);
    const Quat lower =
        sinew::shortest_arc(rotate(upper, scene.at(kLeftHand) - scene.at(kLeftForearm)), {-0.9, 0.05, 0.1});
    pose.set(kLeftUpperArm, upper, vec(&pose.translations[3 * kLeftUpperArm]));
    pose.set(kLeftForearm, conjugate(upper) * lower * upper, vec(&pose.translations[3 * kLeftForearm]));
    clip->add(pose);
  }
}

// A hand that lies on one belly lies on a thinner or thicker one.
TEST(Contacts, AHandThatTouchesTouches) {
  const MotionScene scene = body(20);
  const Vec3d forward = {0.1, -0.8, 0.35};
  for (const double belly : {0.06, 0.10, 0.15}) {
    PlayedClip clip(scene, scene);
    reach_forward(&clip, forward);
    const BoxBody source(scene, 0.12), target(scene, belly);
    const double before = clip.frame(6).places[kLeftHand].z;
    ASSERT_EQ(clip.contacts(&source, target), SINEW_OK);
    const Placed after = clip.frame(6);
    EXPECT_NEAR(after.places[kLeftHand].z - before, belly - 0.12, 0.015) << belly;
    EXPECT_LT(distance(after.places[kRightHand], scene.at(kRightHand)), 1e-5) << "the other hand stays";
    for (uint32_t f = 1; f < clip.frames; ++f)
      EXPECT_LT(distance(clip.frame(f).places[kLeftHand], clip.frame(f - 1).places[kLeftHand]), 1e-3) << "no jitter";
  }
}

// One that is far from its own body does not touch, but comes out of another.
TEST(Contacts, AHandInsideOfTheBodyComesOut) {
  const MotionScene scene = body(20);
  PlayedClip clip(scene, scene);
  reach_forward(&clip, {0.05, -0.3, 0.95});
  const BoxBody thin(scene, 0.05), thick(scene, 0.36);
  ASSERT_LT(clip.frame(6).places[kLeftHand].z, 0.33) << "inside of it: the test needs that";
  ASSERT_EQ(clip.contacts(&thin, thick), SINEW_OK);
  EXPECT_GT(clip.frame(6).places[kLeftHand].z, 0.36);
  EXPECT_LT(clip.frame(6).places[kLeftHand].z, 0.45) << "and no farther";
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
  EXPECT_EQ(sinew_retarget_contacts_size(none, &own, 4, &bytes), SINEW_ERROR_ARGUMENT);
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
