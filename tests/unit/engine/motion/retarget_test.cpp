// SPDX-License-Identifier: MIT
// sinew_retarget_*: the same rig gives the same motion, another rest pose, world, unit or body the motion it should, and
// what is wrong is refused before anything is written.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "floor_motions.hpp"

namespace {

using namespace sinew_test;
using sinew::RetargetPlan;
using sinew::RetargetSettings;

constexpr double kHeight = 1.7;  // of body()

Pose play(const MotionScene& source, const MotionScene& target, const std::vector<int32_t>& map, const Pose& pose,
          const RetargetSettings& settings = {}, bool with_classes = true) {
  RetargetPlan plan;
  EXPECT_EQ(
      plan.make(source.view(), target.view(), map.data(), with_classes ? target.classes.data() : nullptr, settings),
      SINEW_OK);
  float ground = 0;
  EXPECT_EQ(plan.ground(nullptr, 0, &ground), SINEW_OK);
  Pose out(target.count());
  EXPECT_EQ(plan.frame(pose.rotations.data(), pose.translations.data(), ground, out.rotations.data(),
                       out.translations.data()),
            SINEW_OK);
  return out;
}

double farthest(const WorldPose& a, const WorldPose& b) {
  double most = 0;
  for (size_t j = 0; j < a.positions.size(); ++j) most = std::max(most, distance(a.positions[j], b.positions[j]));
  return most;
}

TEST(Retarget, TheSameRigMovesAsItself) {
  MotionScene turned = body(40);
  for (uint32_t j = 0; j < turned.count(); ++j) {  // joints with axes of their own, as editors give them
    const Quat q = sinew::motion::normalized({0.3 * j, 0.5, -0.2 * j, 1});
    for (const double x : {q.x, q.y, q.z, q.w}) turned.rotations.push_back(static_cast<float>(x));
  }
  for (const MotionScene& scene : {body(40), turned}) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
      const Pose pose = random_pose(scene, seed, 1.5, {0.3 * seed, 0.1, -2});
      const Pose out = play(scene, scene, one_to_one(scene.count()), pose);
      EXPECT_LT(farthest(world_pose(scene, out), world_pose(scene, pose)), 1e-6 * kHeight);
    }
  }
}

// Bones that stretch, feet that hang on the root: positions go with the turns, by the ratio of the legs.
TEST(Retarget, JointsThatLeaveTheirPlacesDoSo) {
  const MotionScene scene = body(10), half = body(10, 0.5);
  for (uint32_t seed = 0; seed < 10; ++seed) {
    Pose pose = random_pose(scene, seed, 1.0, {0.5, 0, 1});
    for (size_t i = 3; i < pose.translations.size(); ++i)
      pose.translations[i] += 0.1f * std::sin(static_cast<float>(i) + static_cast<float>(seed));
    const WorldPose wanted = world_pose(scene, pose);
    EXPECT_LT(farthest(world_pose(scene, play(scene, scene, one_to_one(17), pose)), wanted), 1e-6 * kHeight);
    RetargetSettings stretch;
    stretch.translations = 1;
    const WorldPose small = world_pose(half, play(scene, half, one_to_one(17), pose, stretch));
    for (uint32_t j = 0; j < 17; ++j)
      EXPECT_LT(distance(small.positions[j], 0.5 * wanted.positions[j]), 1e-6 * kHeight);
  }
}

// Between other rigs a source that moves its spine, as some programs write it, does not pull the target's torso.
TEST(Retarget, BonesOfTheBodyKeepTheirLengthsUnlessAsked) {
  const MotionScene scene = body(10), half = body(10, 0.5);
  Pose pose = rest_pose(scene);
  for (size_t i = 3; i < pose.translations.size(); ++i) pose.translations[i] += 0.4f;
  const WorldPose found = world_pose(half, play(scene, half, one_to_one(17), pose));
  for (uint32_t j = 0; j < 17; ++j) {
    const int32_t parent = half.parents[j];
    if (parent < 0 || half.classes[j] == SINEW_CLASS_INDEX) continue;
    const uint32_t p = static_cast<uint32_t>(parent);
    EXPECT_NEAR(distance(found.positions[j], found.positions[p]), distance(half.at(j), half.at(p)), 1e-6) << j;
  }
}

// As published: between bodies of one build it is the motion itself; between others a joint lies at the offset that it has at rest.
TEST(Retarget, NodeOffsetsTurnWithTheirSources) {
  const MotionScene source = body(0), target = body(40), half = body(0, 0.5);
  RetargetSettings settings;
  settings.method = SINEW_RETARGET_NODE_OFFSETS;
  for (uint32_t seed = 0; seed < 10; ++seed) {
    const Pose pose = random_pose(source, seed, 1.0, {0.5, 0, 1});
    const WorldPose wanted = world_pose(source, pose);
    EXPECT_LT(farthest(world_pose(source, play(source, source, one_to_one(17), pose, settings)), wanted),
              1e-6 * kHeight);
    const WorldPose small = world_pose(half, play(source, half, one_to_one(17), pose, settings));
    const WorldPose lower = world_pose(target, play(source, target, one_to_one(17), pose, settings));
    for (uint32_t j = 0; j < 17; ++j) {
      EXPECT_LT(distance(small.positions[j], 0.5 * wanted.positions[j]), 1e-6 * kHeight);
      EXPECT_NEAR(distance(lower.positions[j], wanted.positions[j]), distance(target.at(j), source.at(j)), 1e-5) << j;
    }
  }
}

// Arms that hang 40 degrees at rest point to where those of a T pose do.
TEST(Retarget, ArmsOfAnAPosePointToWhereThoseOfATPoseDo) {
  const MotionScene source = body(0), target = body(40);
  for (uint32_t seed = 0; seed < 20; ++seed) {
    const Pose pose = random_pose(source, seed, 1.0);
    const WorldPose wanted = world_pose(source, pose),
                    found = world_pose(target, play(source, target, one_to_one(17), pose));
    for (const auto& [from, to] : {std::pair{kLeftUpperArm, kLeftForearm},
                                   {kLeftForearm, kLeftHand},
                                   {kRightForearm, kRightHand},
                                   {kLeftThigh, kLeftCalf},
                                   {kRightCalf, kRightFoot}}) {
      const Vec3d a = sinew::unit(wanted.positions[to] - wanted.positions[from]);
      const Vec3d b = sinew::unit(found.positions[to] - found.positions[from]);
      EXPECT_LT(distance(a, b), 1e-5) << from;
    }
  }
  // Without classes nothing is aligned.
  const Pose rest = rest_pose(source);
  const WorldPose loose = world_pose(target, play(source, target, one_to_one(17), rest, {}, false));
  EXPECT_GT(distance(loose.positions[kLeftHand], source.at(kLeftHand)), 0.2);
  const WorldPose aligned = world_pose(target, play(source, target, one_to_one(17), rest));
  EXPECT_LT(distance(aligned.positions[kLeftHand], source.at(kLeftHand)), 0.01);
  EXPECT_LT(distance(aligned.positions[kLeftFinger], source.at(kLeftFinger)), 0.02) << "below a hand all turns with it";
}

TEST(Retarget, AnotherAxisUpAndCentimetersGiveTheSameMotion) {
  const MotionScene target = body(10);
  MotionScene source = body(10, 100);  // z up, facing -y: (x, y, z) is (x, -z, y)
  for (uint32_t j = 0; j < source.count(); ++j) {
    const float y = source.positions[3 * j + 1], z = source.positions[3 * j + 2];
    source.positions[3 * j + 1] = -z;
    source.positions[3 * j + 2] = y;
  }
  const Quat raise = sinew::motion::shortest_arc({0, 1, 0}, {0, 0, 1});
  for (uint32_t seed = 0; seed < 10; ++seed) {
    const Pose wanted = random_pose(target, seed, 1.2, {1, 0.2, 0.5});
    const WorldPose world = world_pose(target, wanted);
    Pose pose(source.count());
    for (uint32_t j = 0; j < source.count(); ++j) {
      const Quat turn = raise * world.rotations[j] * conjugate(raise);
      const int32_t parent = source.parents[j];
      if (parent < 0) {
        pose.set(j, turn, 100.0 * rotate(raise, world.positions[j]));
      } else {
        const size_t p = static_cast<size_t>(parent);
        const Quat above = raise * world.rotations[p] * conjugate(raise);
        pose.set(j, conjugate(above) * turn, source.at(j) - source.at(p));
      }
    }
    EXPECT_LT(farthest(world_pose(target, play(source, target, one_to_one(17), pose)), world), 2e-6 * kHeight);
  }
}

TEST(Retarget, AMotionThatFacesAnotherWayIsTurned) {
  const MotionScene target = body(0);
  for (const double angle : {0.25, 0.5, 0.38, 1.0, -0.7}) {  // of half a turn
    MotionScene source = target;
    const double half = angle * std::acos(0.0);
    const Quat turn = {0, std::sin(half), 0, std::cos(half)};
    for (uint32_t j = 0; j < source.count(); ++j) {
      const Vec3d p = rotate(turn, source.at(j));
      source.positions[3 * j] = static_cast<float>(p.x);
      source.positions[3 * j + 2] = static_cast<float>(p.z);
    }
    Pose pose = rest_pose(source);
    const Vec3d front = rotate(turn, {0, 0, 1});
    pose.translations[0] += static_cast<float>(front.x);  // it walks ahead
    pose.translations[2] += static_cast<float>(front.z);
    const WorldPose found = world_pose(target, play(source, target, one_to_one(17), pose));
    EXPECT_NEAR(found.positions[kPelvis].z, 1, 1e-5) << angle;
    EXPECT_NEAR(found.positions[kPelvis].x, 0, 1e-5) << angle;
    EXPECT_LT(
        distance(found.positions[kLeftHand] - found.positions[kPelvis], target.at(kLeftHand) - target.at(kPelvis)),
        1e-5)
        << angle;
  }
}

bool is_arm(uint32_t j) { return (j >= kLeftUpperArm && j <= kRightHand) || j == kLeftFinger; }

RetargetSettings spread_by(double degrees) {
  RetargetSettings settings;
  settings.arm_spread = static_cast<float>(degrees);
  return settings;
}

// Degrees from the trunk's down axis to an upper arm, outwards.
double angle_of_arm(const WorldPose& pose, uint32_t shoulder) {
  const Vec3d bone = rotate(conjugate(pose.rotations[kSpine]), pose.positions[shoulder + 1] - pose.positions[shoulder]);
  return std::atan2(shoulder == kLeftUpperArm ? bone.x : -bone.x, -bone.y) * 180 / kPi;
}

TEST(Retarget, ArmSpreadLiftsHangingArmsByItsAngle) {
  const MotionScene source = body(90);
  for (const double rest : {90.0, 40.0, 0.0}) {
    const MotionScene target = body(rest, 0.8);
    for (uint32_t seed = 0; seed < 5; ++seed) {
      Pose pose = rest_pose(source);
      const Pose turned = random_pose(source, seed, 1.5);
      for (const uint32_t j : {kPelvis, kSpine}) pose.set(j, quat(&turned.rotations[4 * j]), source.at(j));
      const Pose copied = play(source, target, one_to_one(17), pose);
      for (const double degrees : {-20.0, 15.0, 45.0, 90.0}) {
        const Pose spread = play(source, target, one_to_one(17), pose, spread_by(degrees));
        const WorldPose found = world_pose(target, spread);
        for (const uint32_t shoulder : {kLeftUpperArm, kRightUpperArm})
          EXPECT_NEAR(angle_of_arm(found, shoulder), degrees, 1e-3) << shoulder;
        for (uint32_t j = 0; j < 17; ++j) {
          for (uint32_t i = 0; i < 4; ++i) {
            const float now = spread.rotations[4 * j + i], before = copied.rotations[4 * j + i];
            if (j == kLeftUpperArm || j == kRightUpperArm) continue;
            EXPECT_NEAR(now, before, is_arm(j) ? 1e-6 : 0) << j;
          }
          for (uint32_t i = 0; i < 3; ++i)
            EXPECT_NEAR(spread.translations[3 * j + i], copied.translations[3 * j + i], is_arm(j) ? 1e-6 : 0) << j;
        }
      }
    }
  }
}

// A constant rotation would bring raised arms together.
TEST(Retarget, ArmSpreadOpensRaisedArmsAndLeavesThoseThatPointSideways) {
  const MotionScene target = body(40), raised = body(-90), level = body(0);
  const auto angle = [&](const MotionScene& source, double degrees) {
    return angle_of_arm(world_pose(target, play(source, target, one_to_one(17), rest_pose(source), spread_by(degrees))),
                        kRightUpperArm);
  };
  EXPECT_NEAR(std::abs(angle(raised, 0)), 180, 1e-3);
  EXPECT_NEAR(angle(raised, 30), 150, 1e-3);
  EXPECT_NEAR(angle(level, 0), 90, 1e-3);
  EXPECT_NEAR(angle(level, 30), 90, 1e-3);
}

TEST(Retarget, ArmSpreadTakesHandsBesideTheirArmsAlong) {
  const MotionScene source = body(90);
  MotionScene target = source;
  target.parents[kLeftHand] = kPelvis;  // as for inverse kinematics
  for (const uint32_t method : {SINEW_RETARGET_COPY, SINEW_RETARGET_NODE_OFFSETS}) {
    RetargetSettings settings = spread_by(30);
    settings.method = method;
    const Pose pose = rest_pose(source);
    const WorldPose one = world_pose(source, play(source, source, one_to_one(17), pose, settings));
    const WorldPose other = world_pose(target, play(source, target, one_to_one(17), pose, settings));
    EXPECT_LT(farthest(one, other), 1e-6);
    EXPECT_GT(one.positions[kLeftFinger].x, 0.4);
  }
}

TEST(Retarget, ArmSpreadNeedsArms) {
  const MotionScene scene = body(40);
  const Pose pose = random_pose(scene, 1, 1.0);
  MotionScene armless = scene;
  for (uint32_t j = 0; j < 17; ++j)
    if (is_arm(j)) armless.classes[j] = SINEW_CLASS_OTHER;
  for (const bool with_classes : {true, false}) {
    const Pose copied = play(scene, armless, one_to_one(17), pose, {}, with_classes);
    const Pose spread = play(scene, armless, one_to_one(17), pose, spread_by(30), with_classes);
    EXPECT_EQ(copied.rotations, spread.rotations);
    EXPECT_EQ(copied.translations, spread.translations);
  }
  // One arm is lifted away from the hips.
  std::vector<int32_t> map = one_to_one(17);
  for (const uint32_t j : {kRightUpperArm, kRightForearm, kRightHand}) map[j] = -1;
  const MotionScene hanging = body(90);
  const WorldPose found = world_pose(scene, play(hanging, scene, map, rest_pose(hanging), spread_by(30)));
  EXPECT_NEAR(angle_of_arm(found, kLeftUpperArm), 30, 1e-3);
}

TEST(Retarget, HipsGoByTheLengthOfTheLegsAndFeetStayOnTheFloor) {
  const MotionScene source = body(20), target = body(20, 0.5);
  Pose pose = rest_pose(source);
  pose.translations[1] += 0.3f;
  pose.translations[2] += 4;
  WorldPose found = world_pose(target, play(source, target, one_to_one(17), pose));
  EXPECT_NEAR(found.positions[kPelvis].z, 2, 1e-6);
  EXPECT_NEAR(found.positions[kLeftFoot].y, 0.05 + 0.15, 1e-6);
  RetargetSettings in_place;
  in_place.in_place = 1;
  found = world_pose(target, play(source, target, one_to_one(17), pose, in_place));
  EXPECT_NEAR(found.positions[kPelvis].z, 0, 1e-6);
  EXPECT_NEAR(found.positions[kLeftFoot].y, 0.2, 1e-6);
  RetargetSettings scaled;
  scaled.scale = 2;
  found = world_pose(target, play(source, target, one_to_one(17), pose, scaled));
  EXPECT_NEAR(found.positions[kPelvis].z, 8, 1e-5);
}

// Legs half as long under the same trunk: steps are half as long, but a somersault needs room for the trunk.
TEST(Retarget, ShortLegsFlyByTheWholeBody) {
  const MotionScene source = built({}), target = built({1, 1, 0.5, 0.5, 1});
  const auto rise = [&](float lift, float scale) {
    Pose pose = rest_pose(source);
    pose.translations[1] += lift;
    RetargetSettings settings;
    settings.scale = scale;
    const WorldPose found = world_pose(target, play(source, target, one_to_one(source.count()), pose, settings));
    return found.positions[kLeftFoot].y - target.at(kLeftFoot).y;
  };
  EXPECT_NEAR(rise(0.05f, 0), 0.025, 1e-6) << "on tiptoe";
  EXPECT_GT(rise(1, 0), 0.6);
  EXPECT_LT(rise(1, 0), 0.8);
  EXPECT_NEAR(rise(1, 0.5f), 0.5, 0.02) << "a scale that is given counts";
}

// A tail that nothing moves hangs on a joint above the one that carries the legs, some way behind it: it goes with the body.
TEST(Retarget, WhatHangsAboveTheLegsGoesWithThem) {
  const auto with_base = [](bool tail) {
    MotionScene scene;
    scene.add({0, 1, -0.35}, -1, SINEW_CLASS_OTHER);
    const MotionScene person = body(0);
    for (uint32_t j = 0; j < person.count(); ++j) scene.add(person.at(j), person.parents[j] + 1, person.classes[j]);
    if (tail) scene.add({0, 1, -0.8}, 0, SINEW_CLASS_OTHER);
    return scene;
  };
  MotionScene source = with_base(false);
  const MotionScene target = with_base(true);
  const uint32_t pelvis = kPelvis + 1, tail = target.count() - 1;
  std::vector<int32_t> map = one_to_one(source.count());
  map.push_back(-1);
  for (uint32_t j = 0; j < source.count(); ++j) source.positions[3 * j + 1] -= 1;  // as a BVH at rest
  Pose pose = rest_pose(source);
  pose.translations[1] += 1;
  pose.translations[2] += 2;
  const WorldPose found = world_pose(target, play(source, target, map, pose));
  EXPECT_NEAR(found.positions[pelvis].z, target.at(pelvis).z + 2, 1e-5);
  EXPECT_LT(distance(found.positions[tail] - found.positions[pelvis], target.at(tail) - target.at(pelvis)), 1e-5);
}

// A BVH's root stands at 0 at rest: the clip says where the floor is.
TEST(Retarget, TheFloorIsWhereTheFeetOfAClipStand) {
  const MotionScene target = body(0);
  MotionScene source = target;
  for (uint32_t j = 0; j < source.count(); ++j) source.positions[3 * j + 1] -= 1;
  RetargetPlan plan;
  ASSERT_EQ(plan.make(source.view(), target.view(), one_to_one(17).data(), target.classes.data()), SINEW_OK);
  std::vector<float> heights;
  Pose pose = rest_pose(source);
  for (int frame = 0; frame < 101; ++frame) {
    pose.translations[1] = 1.05f + 0.01f * static_cast<float>(frame);
    heights.push_back(0);
    ASSERT_EQ(plan.height(pose.rotations.data(), pose.translations.data(), &heights.back()), SINEW_OK);
    EXPECT_NEAR(heights.back(), 0.15 + 0.01 * frame, 1e-6);
  }
  std::swap(heights[3], heights[90]);
  float ground = 0;
  ASSERT_EQ(plan.ground(heights.data(), heights.size(), &ground), SINEW_OK);
  EXPECT_NEAR(ground, 0.20, 1e-6) << "5th percentile";
  Pose out(target.count());
  pose.translations[1] = 1.1f;
  ASSERT_EQ(plan.frame(pose.rotations.data(), pose.translations.data(), ground, out.rotations.data(),
                       out.translations.data()),
            SINEW_OK);
  EXPECT_NEAR(world_pose(target, out).positions[kLeftFoot].y, 0.1, 1e-6);

  // A source that stands on the floor at rest keeps its own height, however high the clip jumps.
  ASSERT_EQ(plan.make(target.view(), target.view(), one_to_one(17).data(), target.classes.data()), SINEW_OK);
  ASSERT_EQ(plan.ground(heights.data(), heights.size(), &ground), SINEW_OK);
  EXPECT_NEAR(ground, 0.1, 1e-6);
}

TEST(Retarget, JointsWithoutASourceFollowTheirParents) {
  const MotionScene scene = body(0);
  std::vector<int32_t> map = one_to_one(17);
  map[kNeck] = map[kLeftForearm] = map[kLeftHand] = -1;
  const Pose pose = random_pose(scene, 3, 1.0);
  const Pose out = play(scene, scene, map, pose);
  for (const uint32_t j : {kNeck, kLeftForearm, kLeftHand}) {
    EXPECT_FLOAT_EQ(out.rotations[4 * j + 3], 1) << j;
    for (size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(out.translations[3 * j + i], rest_pose(scene).translations[3 * j + i], 1e-6);
  }
  const WorldPose found = world_pose(scene, out), wanted = world_pose(scene, pose);
  EXPECT_LT(distance(found.positions[kRightHand] - found.positions[kPelvis],
                     wanted.positions[kRightHand] - wanted.positions[kPelvis]),
            1e-6);
}

// A floor joint above the hips, as games have it, stays where it is; one that moves in the source moves.
TEST(Retarget, ARootOnTheFloorStaysThere) {
  MotionScene target = body(0);
  for (int32_t& parent : target.parents) ++parent;
  target.parents.insert(target.parents.begin(), -1);
  target.classes.insert(target.classes.begin(), SINEW_CLASS_OTHER);
  target.positions.insert(target.positions.begin(), {0, 0, 0});
  const MotionScene source = body(0);
  std::vector<int32_t> map = one_to_one(17);
  map.insert(map.begin(), -1);
  Pose pose = rest_pose(source);
  pose.translations[2] += 1;
  WorldPose found = world_pose(target, play(source, target, map, pose));
  EXPECT_LT(distance(found.positions[0], {0, 0, 0}), 1e-9);
  EXPECT_NEAR(found.positions[1].z, 1, 1e-6);

  Pose rooted = rest_pose(target);
  rooted.translations[2] = 3;
  found = world_pose(target, play(target, target, one_to_one(18), rooted));
  EXPECT_NEAR(found.positions[0].z, 3, 1e-6);
  EXPECT_NEAR(found.positions[1].z, 3, 1e-6);
}

TEST(Retarget, RootsBesideTheBodyMoveByThemselves) {
  MotionScene scene;
  for (int j = 0; j < 4; ++j) scene.add({0, 0.3 * j, 0}, j - 1, SINEW_CLASS_OTHER);
  scene.add({0.5, 0.6, 0}, 2, SINEW_CLASS_OTHER);
  scene.add({1, 1, 0}, -1, SINEW_CLASS_OTHER);  // a socket
  Pose pose = random_pose(scene, 4, 0.7, {0.2, 0, 1});
  pose.translations[15] = 3;
  EXPECT_LT(farthest(world_pose(scene, play(scene, scene, one_to_one(6), pose)), world_pose(scene, pose)), 1e-6);
}

// The trunk is a root of its own: it goes where the pelvis goes, as in the source; so does a root that nothing moves.
TEST(Retarget, RootsOfOneBodyMoveTogether) {
  const MotionScene source = body(30);
  MotionScene target = source;
  target.parents[kSpine] = -1;
  target.add({0, 1.62, 0.05}, -1, SINEW_CLASS_OTHER);  // a hat on the head
  std::vector<int32_t> map = one_to_one(17);
  map.push_back(-1);
  for (uint32_t seed = 0; seed < 5; ++seed) {
    const Pose pose = random_pose(source, seed, 0.7, {0.5, 0, 2});
    const WorldPose wanted = world_pose(source, pose), found = world_pose(target, play(source, target, map, pose));
    for (uint32_t j = 0; j < 17; ++j) EXPECT_LT(distance(found.positions[j], wanted.positions[j]), 1e-5) << j;
    EXPECT_NEAR(distance(found.positions[17], found.positions[kHead]), distance(target.at(17), target.at(kHead)), 1e-5);
  }
  const Pose own = random_pose(target, 3, 0.7, {0.5, 0, 2});  // and as its own source every root by itself
  EXPECT_LT(farthest(world_pose(target, play(target, target, one_to_one(18), own)), world_pose(target, own)), 1e-5);
}

TEST(Retarget, ChainsAndSingleJointsMove) {
  MotionScene chain;
  for (int j = 0; j < 6; ++j) chain.add({0, 0.1, 0.2 * j}, j - 1, SINEW_CLASS_OTHER);
  const Pose pose = random_pose(chain, 5, 0.8, {1, 0, 2});
  EXPECT_LT(farthest(world_pose(chain, play(chain, chain, one_to_one(6), pose)), world_pose(chain, pose)), 1e-6);
  MotionScene one;
  one.add({1, 2, 3}, -1, SINEW_CLASS_OTHER);
  const Pose alone = random_pose(one, 1, 0.5, {1, 1, 1});
  EXPECT_LT(farthest(world_pose(one, play(one, one, {0}, alone)), world_pose(one, alone)), 1e-6);
  // Joints in any order: children first.
  MotionScene backwards;
  backwards.positions = {0, 1, 0, 0, 0, 0};
  backwards.parents = {1, -1};
  backwards.classes = {SINEW_CLASS_OTHER, SINEW_CLASS_OTHER};
  Pose turned(2);
  turned.set(0, {0, 0, 0.6, 0.8}, {0, 1, 0});
  turned.set(1, {0.6, 0, 0, 0.8}, {0, 0, 0});
  const Pose out = play(backwards, backwards, {0, 1}, turned);
  for (size_t i = 0; i < 8; ++i) EXPECT_NEAR(out.rotations[i], turned.rotations[i], 1e-6);
}

TEST(Retarget, WhatIsWrongIsRefusedAndNothingIsWritten) {
  const MotionScene scene = body(0);
  const std::vector<int32_t> map = one_to_one(17);
  size_t bytes = 0;
  ASSERT_EQ(sinew_retarget_create_workspace_size(17, 17, &bytes), SINEW_OK);
  EXPECT_EQ(sinew_retarget_create_workspace_size(0, 17, &bytes), SINEW_ERROR_COUNT);
  EXPECT_EQ(bytes, 0u);
  EXPECT_EQ(sinew_retarget_create_workspace_size(17, SINEW_MAX_JOINTS + 1, &bytes), SINEW_ERROR_COUNT);
  EXPECT_EQ(sinew_retarget_create_workspace_size(17, 17, nullptr), SINEW_ERROR_ARGUMENT);
  ASSERT_EQ(sinew_retarget_create_workspace_size(17, 17, &bytes), SINEW_OK);
  const sinew::Workspace block(bytes);
  sinew_retarget* plan = nullptr;
  const auto create = [&](const MotionScene& source, const MotionScene& target, const std::vector<int32_t>& m,
                          const sinew_retarget_options* options, size_t missing = 0) {
    plan = nullptr;
    const sinew_skeleton a = source.view(), b = target.view();
    const sinew_status status =
        sinew_retarget_create(&a, &b, m.data(), target.classes.data(), options, block.data(), bytes - missing, &plan);
    EXPECT_EQ(plan != nullptr, status == SINEW_OK);
    return status;
  };
  EXPECT_EQ(create(scene, scene, map, nullptr), SINEW_OK);
  EXPECT_EQ(create(scene, scene, map, nullptr, 1), SINEW_ERROR_WORKSPACE);
  std::vector<int32_t> wrong = map;
  wrong[3] = 17;
  EXPECT_EQ(create(scene, scene, wrong, nullptr), SINEW_ERROR_INDEX);
  wrong[3] = -2;
  EXPECT_EQ(create(scene, scene, wrong, nullptr), SINEW_ERROR_INDEX);
  EXPECT_EQ(create(scene, scene, std::vector<int32_t>(17, -1), nullptr), SINEW_ERROR_NO_JOINT);
  MotionScene broken = scene;
  broken.parents[kPelvis] = kHead;
  EXPECT_EQ(create(broken, scene, map, nullptr), SINEW_ERROR_HIERARCHY);
  broken.parents[kPelvis] = 17;
  EXPECT_EQ(create(scene, broken, map, nullptr), SINEW_ERROR_INDEX);
  broken = scene;
  broken.positions[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(create(scene, broken, map, nullptr), SINEW_ERROR_NOT_FINITE);
  broken = scene;
  broken.rotations.assign(68, std::numeric_limits<float>::infinity());
  EXPECT_EQ(create(broken, scene, map, nullptr), SINEW_ERROR_NOT_FINITE);
  sinew_retarget_options options = SINEW_INIT(sinew_retarget_options);
  for (uint32_t* const member : {&options.method, &options.in_place}) {
    *member = 9;
    EXPECT_EQ(create(scene, scene, map, &options), SINEW_ERROR_ARGUMENT);
    *member = 0;
  }
  options.scale = -1;
  EXPECT_EQ(create(scene, scene, map, &options), SINEW_ERROR_ARGUMENT);
  options.scale = 0;
  for (const float degrees : {-91.0f, 90.5f, std::numeric_limits<float>::quiet_NaN()}) {
    options.arm_spread = degrees;
    EXPECT_EQ(create(scene, scene, map, &options), SINEW_ERROR_ARGUMENT) << degrees;
  }
  options.arm_spread = 0;
  options.struct_size = 4;
  EXPECT_EQ(create(scene, scene, map, &options), SINEW_ERROR_ARGUMENT);
  const sinew_skeleton view = scene.view();
  for (uint32_t sinew_skeleton::*const member : {&sinew_skeleton::up, &sinew_skeleton::struct_size}) {
    sinew_skeleton other = view;
    other.*member = 9;
    EXPECT_EQ(sinew_retarget_create(&other, &view, map.data(), nullptr, nullptr, block.data(), bytes, &plan),
              SINEW_ERROR_ARGUMENT);
    EXPECT_EQ(sinew_retarget_create(&view, &other, map.data(), nullptr, nullptr, block.data(), bytes, &plan),
              SINEW_ERROR_ARGUMENT);
  }
  EXPECT_EQ(sinew_retarget_create(nullptr, &view, map.data(), nullptr, nullptr, block.data(), bytes, &plan),
            SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_retarget_create(&view, &view, map.data(), nullptr, nullptr, static_cast<char*>(block.data()) + 8,
                                  bytes, &plan),
            SINEW_ERROR_WORKSPACE);

  ASSERT_EQ(create(scene, scene, map, nullptr), SINEW_OK);
  Pose pose = rest_pose(scene), out(17);
  pose.rotations[20] = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> before = out.rotations;
  float height = 7;
  EXPECT_EQ(sinew_retarget_height(plan, pose.rotations.data(), pose.translations.data(), &height),
            SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(height, 7);
  EXPECT_EQ(sinew_retarget_frame(plan, pose.rotations.data(), pose.translations.data(), 0, out.rotations.data(),
                                 out.translations.data()),
            SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(sinew_retarget_ground(plan, &pose.rotations[20], 1, &height), SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(out.rotations, before);
  pose = rest_pose(scene);
  for (size_t i = 0; i < 4; ++i) pose.rotations[i] = 0;  // no turn
  EXPECT_EQ(sinew_retarget_frame(plan, pose.rotations.data(), pose.translations.data(), 0.1f, out.rotations.data(),
                                 out.translations.data()),
            SINEW_OK);
  EXPECT_FLOAT_EQ(out.rotations[3], 1);
}

TEST(Quaternion, ReciprocalRootsAndArcs) {
  for (const double x : {1e-70, 3.7e-9, 0.5, 1.0, 2.0, 12345.678, 1e60})
    EXPECT_NEAR(sinew::reciprocal_root(x) * std::sqrt(x), 1, 4e-16) << x;
  const Vec3d a = sinew::unit({1, 2, 3});
  for (const Vec3d b : {a, sinew::unit({-3, 1, 2}), -1.0 * a, Vec3d{0, 1, 0}, Vec3d{0, -1, 0}})
    EXPECT_LT(distance(rotate(sinew::motion::shortest_arc(a, b), a), b), 1e-12);
  EXPECT_EQ(sinew::motion::shortest_arc(a, {0, 0, 0}).w, 1);
  EXPECT_NEAR(sinew::motion::shortest_arc(a, a).w, 1, 1e-15);
  EXPECT_EQ(sinew::motion::shortest_arc(a, a).x, 0);
}

// Feet that inverse kinematics drive hang under the root: they go with the shin, toes with them.
TEST(Retarget, FeetUnderTheRootGoWithTheShin) {
  const MotionScene source = body(10);
  MotionScene plain = body(10, 0.5), driven = plain;
  for (MotionScene* scene : {&plain, &driven})
    scene->add(scene->at(kLeftFoot) + Vec3d{0, -0.03, 0.06}, kLeftFoot, SINEW_CLASS_TOE);
  driven.parents[kLeftFoot] = driven.parents[kRightFoot] = 0;
  std::vector<int32_t> map = one_to_one(17);
  map.push_back(-1);
  for (uint32_t seed = 0; seed < 10; ++seed) {
    const Pose pose = random_pose(source, seed, 1.0, {0.4, 0.1, 1});
    const WorldPose wanted = world_pose(plain, play(source, plain, map, pose));
    const WorldPose found = world_pose(driven, play(source, driven, map, pose));
    for (uint32_t j = 0; j < 18; ++j) EXPECT_LT(distance(found.positions[j], wanted.positions[j]), 1e-6) << j;
  }
}

}  // namespace
