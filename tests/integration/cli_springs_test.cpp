// SPDX-License-Identifier: MIT
// sinew springs and animate --springs: files in, files out, wrong calls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "sinew_formats/springs.hpp"

namespace sinew {
namespace {

class CliSprings : public Cli {};

TEST_F(CliSprings, ATailIsFoundAndWritten) {
  const auto json = nlohmann::json::parse(good("springs " + kRobed + " --json -o swings.glb").out);
  ASSERT_EQ(json["chains"].size(), 1u);
  EXPECT_EQ(json["chains"][0]["kind"], "tail");
  EXPECT_EQ(json["chains"][0]["kept"], true);
  EXPECT_EQ(json["chains"][0]["joints"].size(), 3u);
  EXPECT_LE(json["colliders"].size(), 16u);
  const Character written = read_gltf(in("swings.glb"));
  const std::optional<Springs> springs = read_springs("swings.glb", written);
  ASSERT_TRUE(springs);
  EXPECT_EQ(springs->chains.size(), 1u);
  EXPECT_EQ(springs->colliders.size(), json["colliders"].size());
  // The file's own come back as they are.
  const auto again = nlohmann::json::parse(good("springs swings.glb --json").out);
  EXPECT_EQ(again["chains"][0]["own"], true);
  EXPECT_EQ(again["chains"][0]["joints"][0]["stiffness"], json["chains"][0]["joints"][0]["stiffness"]);
  EXPECT_EQ(files(), 1u);
  EXPECT_NE(good("springs swings.glb").out.find("kept 1 of 1 chains"), std::string::npos);
}

TEST_F(CliSprings, OwnSpringsSurviveOtherCommands) {
  good("springs " + kRobed + " -o swings.glb");
  const Springs before = *read_springs("", read_gltf(in("swings.glb")));
  for (const std::string command :
       {"bind swings.glb -o bound.glb", "simplify swings.glb --level 20 --keep tail_1 -o bound.glb",
        "bind swings.glb --for vrm -o bound.vrm", "animate swings.glb --motion builtin:walk -o bound.glb"}) {
    good(command);
    const std::string file = in(command.find(".vrm") != std::string::npos ? "bound.vrm" : "bound.glb");
    const Character after = read_gltf(file);
    const std::optional<Springs> springs = read_springs(file, after);
    ASSERT_TRUE(springs) << command;
    ASSERT_EQ(springs->chains.size(), 1u) << command;
    EXPECT_GE(springs->chains[0].turning_joints(), 1u) << command;
    EXPECT_EQ(springs->colliders.size(), before.colliders.size()) << command;
    EXPECT_EQ(springs->chains[0].groups.size(), before.chains[0].groups.size()) << command;
  }
}

// Joints that are added hang below the file's own, which stay with their clips.
TEST_F(CliSprings, ARobeGetsChainsInItsOwnFile) {
  good("animate " + kRobed + " --motion builtin:walk -o walks.glb");
  const auto json = nlohmann::json::parse(good("springs walks.glb --make --json -o made.glb").out);
  size_t laid = 0;
  for (const auto& chain : json["chains"])
    if (chain["name"].get<std::string>().find("Skirt") != std::string::npos) {
      ++laid;
      EXPECT_EQ(chain["kept"], true);
    }
  EXPECT_GE(laid, 6u);
  const Character before = read_gltf(in("walks.glb")), after = read_gltf(in("made.glb"));
  ASSERT_EQ(after.joints.size(), before.joints.size() + 3 * laid);
  for (size_t j = 0; j < before.joints.size(); ++j) EXPECT_EQ(after.joints[j].name, before.joints[j].name);
  const Motion motion = read_motion(in("made.glb"));
  ASSERT_EQ(motion.clips.size(), 1u);
  EXPECT_EQ(motion.clips[0].frames.size(), read_motion(in("walks.glb")).clips[0].frames.size());
  EXPECT_EQ(read_springs("made.glb", after)->chains.size(), json["chains"].size());
  const auto again = nlohmann::json::parse(good("springs made.glb --make --json").out);
  EXPECT_EQ(again["chains"].size(), json["chains"].size());  // nothing is laid twice
}

TEST_F(CliSprings, ABareMeshIsRiggedWithThem) {
  good("rig " + kCaped + " --detail full -o rigged.glb");
  const Character rigged = read_gltf(in("rigged.glb"));
  const auto is_skirt = [](const Joint& joint) { return joint.name.find("Skirt") != std::string::npos; };
  const auto laid = std::count_if(rigged.joints.begin(), rigged.joints.end(), is_skirt);
  EXPECT_GE(laid, 18);
  EXPECT_EQ(laid % 3, 0);
  EXPECT_NE(good("springs rigged.glb").out.find("SkirtBack_1: skirt"), std::string::npos);
}

TEST_F(CliSprings, ClipsSwing) {
  good("animate " + kRobed + " --motion builtin:run -o stiff.glb");
  const auto json =
      nlohmann::json::parse(good("animate " + kRobed + " --motion builtin:run --springs --json -o swinging.glb").out);
  EXPECT_EQ(json["clips"][0]["springs"]["joints"], 3);
  EXPECT_EQ(json["clips"][0]["springs"]["loops"], true);
  EXPECT_LT(json["clips"][0]["springs"]["gap"].get<double>(), 0.1);
  const Motion stiff = read_gltf_motion(in("stiff.glb"), 30), swinging = read_gltf_motion(in("swinging.glb"), 30);
  ASSERT_EQ(stiff.clips[0].frames.size(), swinging.clips[0].frames.size());
  size_t moved = 0;
  for (size_t j = 0; j < stiff.joints.size(); ++j) {
    double most = 0;
    for (size_t f = 0; f < stiff.clips[0].frames.size(); ++f)
      for (size_t i = 0; i < 4; ++i)
        most = std::max(
            most, std::abs(stiff.clips[0].frames[f].rotations[j][i] - swinging.clips[0].frames[f].rotations[j][i]));
    const bool tail =
        stiff.joints[j].name.rfind("tail_", 0) == 0 && stiff.joints[j].name.find("end") == std::string::npos;
    EXPECT_EQ(most > 0.01, tail) << stiff.joints[j].name << " " << most;
    moved += most > 0.01 ? 1 : 0;
  }
  EXPECT_EQ(moved, 3u);
}

TEST_F(CliSprings, ChainsThatGoWithTheirJointsAreTold) {
  good("springs " + kRobed + " --make -o made.glb");
  EXPECT_NE(good("simplify made.glb --level low -o low.glb").out.find("11 of 13 chains that swing are left out"),
            std::string::npos);
  EXPECT_EQ(good("simplify made.glb --level 200 -o same.glb").out.find("left out"), std::string::npos);
  const auto json = nlohmann::json::parse(good("simplify made.glb --level low --json -o low.glb").out);
  EXPECT_EQ(json.at("notes").size(), 1u);
}

TEST_F(CliSprings, WrongCallsSayWhatIsWrong) {
  EXPECT_NE(bad(1, "springs " + kRobed + " --drop Nose").error.find("tail_1"), std::string::npos);
  EXPECT_NE(bad(1, "springs " + kRobed + " --preset tail_1=wing").error.find("long-hair"), std::string::npos);
  EXPECT_NE(bad(1, "springs " + kRobed + " --value tail_1:drag=7").error.find("0 to 1"), std::string::npos);
  bad(2, "springs " + kRobed + " -o swings.fbx");
  bad(1, "springs " + kRobed + " -o swings.vrm");
  bad(1, "springs missing.glb");
  const std::string snake = kData + "/snake__long.obj";
  EXPECT_NE(
      bad(1, "animate " + snake + " --motion builtin:swim --force --springs -o o.glb").error.find("no chain swings"),
      std::string::npos);
  EXPECT_EQ(files(), 0u);
}

}  // namespace
}  // namespace sinew
