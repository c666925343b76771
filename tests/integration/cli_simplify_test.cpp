// SPDX-License-Identifier: MIT
// sinew simplify: files in, files out, wrong calls.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {
namespace {

class CliSimplify : public Cli {};

TEST_F(CliSimplify, WeightsFollowTheirJoints) {
  const Outcome outcome = good("simplify " + kRobed + " --level 9 --json -o few.glb");
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["joints"], 9);
  const Character before = read_character(kRobed), after = read_character(in("few.glb"));
  ASSERT_EQ(after.joints.size(), 9u);
  ASSERT_EQ(json["into"].size() + 9, before.joints.size());
  EXPECT_FALSE(after.influences.empty());
  for (const auto& row : after.influences) {
    float sum = 0;
    for (const Influence& influence : row) sum += influence.weight;
    if (!row.empty()) {
      EXPECT_NEAR(sum, 1, 1e-3);
    }
  }
}

TEST_F(CliSimplify, ASkeletonAloneBecomesASkeleton) {
  fs::copy_file(kRobedRig, in("alone.rig.txt"));
  good("simplify alone.rig.txt --level 12 -o less.rig.txt");
  good("simplify alone.rig.txt --level low --mesh " + kRobed + " -o less.glb");
  Character all, less;
  read_skeleton(kRobedRig, false, &all);
  read_skeleton(in("less.rig.txt"), false, &less);
  EXPECT_LT(less.joints.size(), all.joints.size());
  EXPECT_GT(less.joints.size(), 5u);
}

TEST_F(CliSimplify, KeptJointsStay) {
  const Character before = read_character(kRobed);
  const std::string last = before.joints.back().name;
  good("simplify " + kRobed + " --level 3 --keep " + last + " -o few.rig.txt");
  Character after;
  read_skeleton(in("few.rig.txt"), false, &after);
  ASSERT_EQ(after.joints.size(), 3u);
  EXPECT_TRUE(std::any_of(after.joints.begin(), after.joints.end(), [&](const Joint& j) { return j.name == last; }));
}

TEST_F(CliSimplify, AnimationsStayOnTheJointsThatAreLeft) {
  good("bind " + kRobed + " --skeleton " + kRobedRig + " -o hero.glb");
  const Character hero = read_gltf(in("hero.glb"));
  Motion motion = motion_of(hero.joints);
  Clip clip = {"lean", 0.1, {}};
  for (int f = 0; f < 5; ++f) {
    clip.frames.push_back({std::vector<Quaternion>(hero.joints.size(), kNoRotation4), {}});
    for (const MotionJoint& joint : motion.joints) clip.frames.back().translations.push_back(joint.offset);
    clip.frames.back().rotations[0] = {0, 0, std::sin(0.1 * f), std::cos(0.1 * f)};
    clip.frames.back().translations[0][2] += 0.1 * f;
  }
  write_bvh(in("lean.bvh"), motion, clip);
  good("animate hero.glb --motion lean.bvh -o leaning.glb");
  good("simplify leaning.glb --level 8 -o few.glb");
  const Motion before = read_gltf_motion(in("leaning.glb"), 10), after = read_gltf_motion(in("few.glb"), 10);
  ASSERT_EQ(after.clips.size(), 1u);
  EXPECT_EQ(after.clips[0].name, "lean");
  ASSERT_EQ(after.clips[0].frames.size(), before.clips[0].frames.size());
  const WorldPose was = world_pose(before, before.clips[0].frames[4]), is = world_pose(after, after.clips[0].frames[4]);
  size_t compared = 0;
  for (size_t j = 0; j < after.joints.size(); ++j) {
    for (size_t k = 0; k < before.joints.size(); ++k) {
      if (before.joints[k].name != after.joints[j].name) continue;
      ++compared;
      for (size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(is.positions[j][axis], was.positions[k][axis], 1e-4);
    }
  }
  EXPECT_GE(compared, 8u);
}

TEST_F(CliSimplify, RigMakesASkeletonOfTheShapeAlone) {
  for (const std::string method : {"shape", "regions"}) {
    const Outcome outcome = good("rig " + kRobed + " --method " + method + " --json -o " + method + ".glb");
    const auto json = nlohmann::json::parse(outcome.out);
    const Character bound = read_character(in(method + ".glb"));
    EXPECT_EQ(json["joints"].size(), bound.joints.size());
    EXPECT_EQ(json["symmetric"], method == "shape");
    EXPECT_GT(bound.joints.size(), 8u);
    expect_bound(bound, 4);
  }
  bad(1, "rig missing.obj --method shape -o o.glb");
  EXPECT_EQ(files(), 2u);
}

TEST_F(CliSimplify, WrongCallsSayWhatIsWrong) {
  EXPECT_NE(bad(2, "simplify " + kRobed + " --level few -o o.glb").error.find("high, low or a number"),
            std::string::npos);
  bad(2, "simplify " + kRobed + " --level 0 -o o.glb");
  bad(2, "simplify " + kRobed + " -o o.png");
  bad(1, "simplify " + kRobed + " --keep nobody -o o.glb");
  bad(1, "simplify missing.glb -o o.glb");
  bad(2, "simplify " + kRobed + " --mesh " + kRobed + " -o o.glb");
  fs::copy_file(kRobedRig, in("alone.rig.txt"));
  EXPECT_NE(bad(2, "simplify alone.rig.txt -o o.glb").error.find("no mesh"), std::string::npos);
  EXPECT_FALSE(fs::exists(in("o.glb")));
}

}  // namespace
}  // namespace sinew
