// SPDX-License-Identifier: MIT
// Clips that ship: they loop, feet stand where they stand, nothing goes through the floor, every part of a body lives; names.
#include "sinew_character/clips/builtin_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "expect_error.hpp"
#include "sinew_character/jobs/character_file.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

const std::vector<std::string> kKinds = {"person", "quadruped", "quadruped2", "insect",
                                         "spider", "bird",      "wings",      "fish"};
const std::vector<std::string> kManners = {"", ":lively", ":calm"};

Motion only(const std::string& path) {
  std::vector<Motion> motions = builtin_motions(path);
  EXPECT_EQ(motions.size(), 1u) << path;
  return motions[0];
}

size_t joint_of(const Motion& motion, const std::string& end) {
  for (size_t j = 0; j < motion.joints.size(); ++j) {
    const std::string& name = motion.joints[j].name;
    if (name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0) return j;
  }
  ADD_FAILURE() << "no " << end;
  return 0;
}

std::vector<WorldPose> poses_of(const Motion& motion) {
  std::vector<WorldPose> poses;
  for (const MotionFrame& frame : motion.clips.at(0).frames) poses.push_back(world_pose(motion, frame));
  return poses;
}

TEST(BuiltinMotion, EveryClipLoopsAtThirtyFrames) {
  for (size_t k = 0; k < kKinds.size() * kManners.size(); ++k) {
    const Motion motion = only("builtin:" + kKinds[k / kManners.size()] + kManners[k % kManners.size()]);
    ASSERT_FALSE(motion.clips.empty()) << k;
    for (const Clip& clip : motion.clips) {
      EXPECT_DOUBLE_EQ(clip.frame_time, 1.0 / 30);
      ASSERT_GT(clip.frames.size(), 10u) << clip.name;
      const MotionFrame &first = clip.frames.front(), &last = clip.frames.back();
      EXPECT_EQ(first.rotations, last.rotations) << clip.name;
      for (size_t j = 1; j < motion.joints.size(); ++j) EXPECT_EQ(first.translations[j], last.translations[j]);
      const Point3 travel = last.translations[0] - first.translations[0];
      EXPECT_NEAR(travel[0], 0, 1e-12);
      EXPECT_NEAR(travel[1], 0, 1e-12);
      for (size_t f = 1; f < clip.frames.size(); ++f)  // no frame jumps
        for (size_t j = 0; j < motion.joints.size(); ++j)
          EXPECT_GT(std::abs(dot(clip.frames[f].rotations[j], clip.frames[f - 1].rotations[j])), std::cos(0.5))
              << clip.name << " " << f << " " << motion.joints[j].name;
    }
  }
}

// A foot that is flat in two frames stood still in between; there are such frames; no point of a foot is below the floor.
void expect_planted(const std::string& path, const std::string& foot, const std::string& tip, size_t least) {
  const Motion motion = only(path);
  const size_t ankle = joint_of(motion, foot), toe = joint_of(motion, tip);
  const double floor = rest_joints(motion)[toe].position.y;
  const std::vector<WorldPose> poses = poses_of(motion);
  size_t flat = 0;
  for (size_t f = 1; f < poses.size(); ++f) {
    EXPECT_GT(poses[f].positions[toe][1], floor - 0.004) << path << " " << foot << " " << f;
    const auto is_flat = [&](const WorldPose& pose) {
      return std::abs(pose.rotations[ankle][3]) > 1 - 1e-9 && std::abs(pose.positions[toe][1] - floor) < 1e-6;
    };
    if (!is_flat(poses[f]) || !is_flat(poses[f - 1])) continue;
    ++flat;
    EXPECT_LT(length(poses[f].positions[ankle] - poses[f - 1].positions[ankle]), 1e-6)
        << path << " " << foot << " " << f;
  }
  EXPECT_GE(flat, least) << path << " " << foot;
}

TEST(BuiltinMotion, FeetStandWhereTheyStand) {
  for (const std::string& manner : kManners)
    for (const char* side : {"Left", "Right"}) {
      const std::string foot = side + std::string("Foot"), toe = side + std::string("ToeBase");
      expect_planted("builtin:person/walk" + manner, foot, toe, 6);
      expect_planted("builtin:run" + manner, foot, toe, 1);
      expect_planted("builtin:jump" + manner, foot, toe, 15);
    }
  for (const char* side : {"Left", "Right"}) {
    const std::string foot = side + std::string("Foot"), toe = side + std::string("ToeBase");
    expect_planted("builtin:person/idle", foot, toe, 120);
    expect_planted("builtin:wave", foot, toe, 75);
    expect_planted("builtin:sit", foot, toe, 135);
    expect_planted("builtin:squat", foot, toe, 90);
    expect_planted("builtin:reach", foot, toe, 90);
  }
  for (const char* side : {".L", ".R"}) {
    for (const char* clip : {"builtin:bird/strut", "builtin:perch"})
      expect_planted(clip, "Toe" + std::string(side), "Toe" + std::string(side) + "_end", 5);
    for (const char* foot : {"FrontFoot", "BackToe"}) {
      expect_planted("builtin:quadruped/gallop", foot + std::string(side), foot + std::string(side) + "_end", 1);
      expect_planted("builtin:quadruped/walk", foot + std::string(side), foot + std::string(side) + "_end", 8);
      expect_planted("builtin:quadruped/trot", foot + std::string(side), foot + std::string(side) + "_end", 2);
      expect_planted("builtin:quadruped/idle", foot + std::string(side), foot + std::string(side) + "_end", 90);
    }
    for (const char* clip : {"walk", "trot"})
      for (const char* foot : {"FrontFoot", "BackToe"})
        expect_planted("builtin:quadruped2/" + std::string(clip), foot + std::string(side),
                       foot + std::string(side) + "_end", 2);
    for (const char* leg : {"1", "2", "3", "4"}) {
      const std::string foot = "Foot" + std::string(leg) + side;
      expect_planted("builtin:spider/crawl", foot, foot + "_end", 8);
      if (leg != std::string("2")) expect_planted("builtin:insect/crawl", foot, foot + "_end", 8);
    }
  }
}

TEST(BuiltinMotion, AWalkSwingsItsArmsAgainstItsLegs) {
  for (const char* name : {"builtin:person/walk", "builtin:run"}) {
    const Motion motion = only(name);
    const size_t hips = joint_of(motion, "Hips"), hand = joint_of(motion, "LeftHand"),
                 foot = joint_of(motion, "LeftFoot");
    double together = 0, lowest = 1e9, highest = -1e9;
    for (const WorldPose& pose : poses_of(motion)) {
      const Point3 arm = pose.positions[hand] - pose.positions[hips], leg = pose.positions[foot] - pose.positions[hips];
      together += (arm[2] - 0.1) * (leg[2] + 0.05);
      lowest = std::min(lowest, pose.positions[hips][1]);
      highest = std::max(highest, pose.positions[hips][1]);
    }
    EXPECT_LT(together, -0.1) << name;
    EXPECT_GT(highest - lowest, 0.02) << name;
    EXPECT_GT(motion.clips[0].frames.back().translations[0][2], 1.0) << name;
  }
}

TEST(BuiltinMotion, WingsFlapAndFishBend) {
  const Motion flap = only("builtin:bird/flap"), swim = only("builtin:swim");
  const size_t wing = joint_of(flap, "Wing4.L_end"), other = joint_of(flap, "Wing4.R_end"),
               tail = joint_of(swim, "Spine6_end");
  double low = 1e9, high = -1e9, left = -1e9, right = 1e9;
  for (const WorldPose& pose : poses_of(flap)) {
    low = std::min(low, pose.positions[wing][1]);
    high = std::max(high, pose.positions[wing][1]);
    EXPECT_NEAR(pose.positions[wing][1], pose.positions[other][1], 0.05) << "nearly mirror images";
  }
  for (const WorldPose& pose : poses_of(swim)) {
    left = std::max(left, pose.positions[tail][0]);
    right = std::min(right, pose.positions[tail][0]);
  }
  EXPECT_GT(high - low, 0.6);
  EXPECT_GT(left - right, 0.2);
}

// The largest angle in degrees between two frames of a rotation.
double range_of(const std::vector<Quaternion>& rotations) {
  double least = 1;
  for (size_t a = 0; a < rotations.size(); a += 3)
    for (size_t b = 0; b < a; b += 3) least = std::min(least, std::abs(dot(rotations[a], rotations[b])));
  return std::acos(least) * 360 / std::numbers::pi;
}

double range_between(const Motion& motion, const std::string& from, const std::string& to) {
  std::vector<Quaternion> rotations;
  const size_t a = joint_of(motion, from), b = joint_of(motion, to);
  for (const WorldPose& pose : poses_of(motion))
    rotations.push_back(multiply(conjugate(pose.rotations[a]), pose.rotations[b]));
  return range_of(rotations);
}

TEST(BuiltinMotion, AllOfAPersonMoves) {
  for (const char* name : {"walk", "run", "idle", "wave", "jump", "sit", "squat", "reach"}) {
    const Motion motion = only("builtin:person/" + std::string(name));
    for (const char* side : {"Left", "Right"}) {
      const std::string of = side;
      EXPECT_GT(range_between(motion, of + "ForeArm", of + "Hand"), 5) << name;
      EXPECT_LT(range_between(motion, of + "ForeArm", of + "Hand"), 60) << name;
      for (const char* finger : {"Index", "Middle", "Ring", "Pinky"})
        EXPECT_GT(range_between(motion, of + "Hand", of + "Hand" + finger + "1"), 3) << name << finger;
    }
    EXPECT_GT(range_between(motion, "Hips", "Spine2"), 6) << name;
    EXPECT_GT(range_between(motion, "Spine2", ":Head"), 6) << name;
    // No two frames are mirror images: the sides do not do the same at the same time.
    double apart = 0;
    for (const WorldPose& pose : poses_of(motion))
      apart = std::max(apart, std::abs(pose.positions[joint_of(motion, "LeftHand")][2] -
                                       pose.positions[joint_of(motion, "RightHand")][2]));
    EXPECT_GT(apart, 0.02) << name;
  }
}

TEST(BuiltinMotion, KneesAndElbowsBendOneWay) {
  for (const std::string& manner : kManners) {
    const Motion motion = only("builtin:person" + manner);
    for (const Clip& clip : motion.clips)
      for (const MotionFrame& frame : clip.frames) {
        const WorldPose pose = world_pose(motion, frame);
        for (const std::string side : {"Left", "Right"}) {
          const auto at = [&](const char* joint) { return pose.positions[joint_of(motion, side + joint)]; };
          const Point3 thigh = at("Leg") - at("UpLeg"), shin = at("Foot") - at("Leg");
          EXPECT_GE(cross(thigh, shin)[0], -1e-3) << clip.name;
          EXPECT_GT(dot(unit(thigh), unit(shin)), std::cos(150 * std::numbers::pi / 180)) << clip.name;
          const Quaternion& elbow = frame.rotations[joint_of(motion, side + "ForeArm")];
          EXPECT_LE((side == "Left" ? 1 : -1) * elbow[1] * elbow[3], 1e-3) << clip.name;
        }
      }
  }
}

TEST(BuiltinMotion, AVariantIsAnotherMannerOfEveryClip) {
  for (const std::string& kind : kKinds) {
    const Motion usual = only("builtin:" + kind), lively = only("builtin:" + kind + ":lively"),
                 calm = only("builtin:" + kind + ":calm");
    ASSERT_EQ(usual.clips.size(), lively.clips.size());
    for (size_t c = 0; c < usual.clips.size(); ++c) {
      EXPECT_EQ(lively.clips[c].name, usual.clips[c].name + "_lively");
      EXPECT_LT(lively.clips[c].frames.size(), usual.clips[c].frames.size());
      EXPECT_GT(calm.clips[c].frames.size(), usual.clips[c].frames.size());
      EXPECT_GE(lively.clips[c].frames.back().translations[0][2], usual.clips[c].frames.back().translations[0][2]);
    }
  }
  // A calm person waves with the other hand.
  const Motion wave = only("builtin:wave:calm");
  const WorldPose middle = world_pose(wave, wave.clips[0].frames[wave.clips[0].frames.size() / 2]);
  EXPECT_GT(middle.positions[joint_of(wave, "LeftHand")][1], middle.positions[joint_of(wave, "RightHand")][1] + 0.4);
}

TEST(BuiltinMotion, ASquatBringsTheHipsToTheKneesAndAReachTheHandsAboveTheHead) {
  const Motion squat = only("builtin:squat"), reach = only("builtin:reach");
  const WorldPose down = world_pose(squat, squat.clips[0].frames[45]),
                  up = world_pose(reach, reach.clips[0].frames[45]);
  for (const char* side : {"Left", "Right"}) {
    const std::string of = side;
    const Point3 hip = down.positions[joint_of(squat, of + "UpLeg")],
                 knee = down.positions[joint_of(squat, of + "Leg")];
    EXPECT_NEAR(hip[1], knee[1], 0.08) << side;
    EXPECT_GT(down.positions[joint_of(squat, of + "Hand")][2], hip[2] + 0.5) << side;
    EXPECT_GT(up.positions[joint_of(reach, of + "Hand")][1], up.positions[joint_of(reach, ":Head")][1] + 0.3) << side;
  }
}

TEST(BuiltinMotion, NamesAreClipsKindsOrBoth) {
  EXPECT_TRUE(is_builtin_motion("builtin:walk"));
  EXPECT_FALSE(is_builtin_motion("walk.bvh"));
  EXPECT_EQ(builtin_motions("builtin:walk").size(), 3u) << "a person's, a quadruped's, and without hocks";
  EXPECT_EQ(only("builtin:person").clips.size(), 8u);
  EXPECT_EQ(only("builtin:quadruped/walk").joints[0].name, "Hips");
  EXPECT_EQ(only("builtin:wave").clips[0].name, "wave");
  for (const char* wrong : {"builtin:", "builtin:dance", "builtin:bird/walk", "builtin:/", "builtin:cat/walk",
                            "builtin:walk:", "builtin:walk:mad"})
    EXPECT_ERROR(builtin_motions(wrong), wrong, "expected builtin:NAME", "person: walk, run", "spider: crawl");
}

TEST(BuiltinMotion, OpensAsASkeletonWhereFilesDo) {
  EXPECT_EQ(open_character("builtin:flap").character.joints.size(), only("builtin:bird/flap").joints.size());
  EXPECT_EQ(read_map_rig("builtin:crawl").joints.size(), only("builtin:spider/crawl").joints.size());
}

}  // namespace
}  // namespace sinew
