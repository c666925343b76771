// SPDX-License-Identifier: MIT
// sinew rig on skeletons that the user has a say in: edits, a skeleton of their own, templates.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

class CliRigEdit : public Cli {
 protected:
  // A skeleton takes the place of the model's answer, so that no model is needed.
  void SetUp() override {
    Cli::SetUp();
    rig_ = "rig " + kRobed + " --prediction " + kRobedRig + " --no-bind -o out.rig.txt ";
  }
  std::map<std::string, Joint> out() const {
    Character c;
    read_skeleton(in("out.rig.txt"), false, &c);
    std::map<std::string, Joint> joints;
    for (const Joint& joint : c.joints) {
      joints.emplace(joint.name, joint);
      parents_[joint.name] = joint.parent < 0 ? "" : c.joints[static_cast<size_t>(joint.parent)].name;
    }
    return joints;
  }
  std::string rig_;
  mutable std::map<std::string, std::string> parents_;
};

TEST_F(CliRigEdit, EditsApplyInTheOrderOfTheCommandLine) {
  good(rig_);
  const auto before = out();
  ASSERT_EQ(before.count("hand.L"), 1u) << slurp(kRobedRig).substr(0, 500);
  const Outcome outcome = good(rig_ +
                               "--move hand.L=0.5,1,0.25 --add extra.L=hand.L:0.6,1,0.25 --move=extra.L=0.7,1,0.25 "
                               "--rename extra.L=thumb.L --parent thumb.L=forearm.L");
  EXPECT_NE(outcome.out.find("symmetric"), std::string::npos) << outcome.out;
  const auto after = out();
  EXPECT_EQ(after.size(), before.size() + 2);
  EXPECT_FLOAT_EQ(after.at("hand.L").position.x, 0.5f);
  EXPECT_FLOAT_EQ(after.at("hand.R").position.x, -0.5f);
  EXPECT_FLOAT_EQ(after.at("thumb.R").position.x, -0.7f);
  EXPECT_EQ(parents_["thumb.R"], "forearm.R");
  good(rig_ + "--no-mirror --remove hand.L");
  const auto one_side = out();
  EXPECT_EQ(one_side.count("hand.L"), 0u);
  EXPECT_EQ(one_side.count("hand.R"), 1u);
}

TEST_F(CliRigEdit, AMeshIsTurnedScaledAndPutOnTheFloor) {
  good("rig " + kRobed + " --method shape --turn x --turn=-x --height 0.5 --floor -o placed.glb");
  const Character placed = read_mesh(in("placed.glb"));
  float low = placed.vertices[0].y, high = low;
  for (const Vec3& p : placed.vertices) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  EXPECT_NEAR(low, 0, 1e-6f);
  EXPECT_NEAR(high, 0.5f, 1e-5f);
  EXPECT_NE(bad(2, rig_ + "--floor").error.find("--prediction uses the coordinates of the mesh"), std::string::npos);
  bad(2, "rig " + kRobed + " --turn w");
  EXPECT_NE(bad(2, "rig " + kRobed + " --height 0").error.find("--height: Value 0, expected a number above 0"),
            std::string::npos);
}

TEST_F(CliRigEdit, ArmsOfATPoseLieOnALine) {
  good("rig " + kRobed + " --prediction " + kRobedRig + " --to-pose t -o out.rig.txt");
  const auto posed = out();
  for (const std::string side : {".L", ".R"})
    for (const std::string joint : {"forearm", "hand"})
      EXPECT_NEAR(posed.at(joint + side).position.y, posed.at("upper_arm" + side).position.y, 1e-3f) << joint << side;
  EXPECT_NE(bad(2, rig_ + "--to-pose t").error.find("--no-bind"), std::string::npos);
  EXPECT_NE(bad(1, "rig " + kRobed + " --to-pose nowhere.rig.txt -o out.glb").error.find("nowhere"), std::string::npos);
  EXPECT_NE(
      bad(1, "rig " + kData + "/snake__long.obj --method shape --to-pose t -o out.glb").error.find("left from right"),
      std::string::npos);
}

TEST_F(CliRigEdit, AGateEndsWithThreeAndWritesAllTheSame) {
  const std::string sure = "rig " + kRobed + " --prediction " + kRobedRig + " -o sure.glb --gate";
  EXPECT_EQ(good(sure).error, "");
  const auto figures = nlohmann::json::parse(good(sure + " --json").out)["gate"];
  EXPECT_EQ(figures["fails"].size(), 0u);
  EXPECT_EQ(figures["unweighted"], 0);
  put(in("cube.obj"),
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 "
      "7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  EXPECT_NE(bad(3, "rig cube.obj -o cube.glb --gate").error.find("gate"), std::string::npos);
  EXPECT_TRUE(fs::exists(in("cube.glb")));
}

TEST_F(CliRigEdit, WrongEditsAreOneLine) {
  EXPECT_NE(bad(1, rig_ + "--move hnd.L=0,0,0").error.find("near it: hand.L"), std::string::npos);
  EXPECT_NE(bad(2, rig_ + "--move hand.L=0,x,0").error.find("three numbers"), std::string::npos);
  EXPECT_NE(bad(2, rig_ + "--add tail").error.find("NAME=PARENT:X,Y,Z"), std::string::npos);
  EXPECT_NE(bad(1, rig_ + "--parent forearm.L=hand.L").error.find("cycle"), std::string::npos);
  EXPECT_NE(bad(2, rig_ + "--keep-lengths").error.find("--skeleton"), std::string::npos);
  EXPECT_NE(bad(2, rig_ + "--model x.sinew").error.find("--prediction"), std::string::npos);
  EXPECT_NE(bad(2, rig_ + "--skeleton template:biped").error.find("mixamo"), std::string::npos);
  EXPECT_NE(bad(2, rig_ + "--skeleton " + kRobed).error.find("holds no skeleton"), std::string::npos);
  EXPECT_NE(bad(1, rig_ + "--skeleton nowhere.rig.txt").error.find("nowhere"), std::string::npos);
  EXPECT_NE(bad(2, "rig " + kData + " -o out --prediction " + kRobedRig).error.find("one mesh"), std::string::npos);
  EXPECT_FALSE(fs::exists(in("out.rig.txt")));
}

TEST_F(CliRigEdit, AnOwnSkeletonKeepsNamesHierarchyAndOrder) {
  good(rig_ + "--skeleton " + kRobedRig);
  Character own, fitted;
  read_skeleton(kRobedRig, false, &own);
  read_skeleton(in("out.rig.txt"), false, &fitted);
  ASSERT_EQ(own.joints.size(), fitted.joints.size());
  for (size_t j = 0; j < own.joints.size(); ++j) {
    EXPECT_EQ(own.joints[j].name, fitted.joints[j].name);
    EXPECT_EQ(own.joints[j].parent, fitted.joints[j].parent);
    EXPECT_NEAR(own.joints[j].position.x, fitted.joints[j].position.x, 1e-3f) << own.joints[j].name;
    EXPECT_NEAR(own.joints[j].position.y, fitted.joints[j].position.y, 1e-3f) << own.joints[j].name;
    EXPECT_NEAR(own.joints[j].position.z, fitted.joints[j].position.z, 1e-3f) << own.joints[j].name;
  }
}

TEST_F(CliRigEdit, TemplatesAreListedFittedAndEdited) {
  const std::string list = good("rig --list-templates").out;
  for (const char* name : {"mixamo", "unreal", "vrm", "rigify", "quadruped", "bird", "fish", "spider", "hand"})
    EXPECT_NE(list.find(std::string("template:") + name), std::string::npos) << list;
  const auto json =
      nlohmann::json::parse(good(rig_ + "--skeleton template:mixamo --remove mixamorig:LeftHandPinky4 --json").out);
  EXPECT_GE(json["matched"], 17);
  EXPECT_EQ(json["joints"].size(), 63u);
  EXPECT_EQ(json["symmetric"], true);
  EXPECT_NE(good(rig_ + "--skeleton template:spider").out.find("match nothing in this mesh"), std::string::npos);
  good(rig_);
  const auto body = out();
  good(rig_ + "--skeleton template:mixamo --keep-lengths");
  const auto mixamo = out();
  EXPECT_NEAR(mixamo.at("mixamorig:LeftUpLeg").position.y, body.at("thigh.L").position.y, 0.1f);
  EXPECT_EQ(parents_["mixamorig:LeftHandThumb1"], "mixamorig:LeftHand");
}

TEST_F(CliRigEdit, WeightsGoToTheFittedSkeleton) {
  good("rig " + kRobed + " --prediction " + kRobedRig + " --skeleton template:unreal -o out.glb");
  const Character bound = read_character(in("out.glb"));
  expect_bound(bound, 4);
  for (const auto& row : bound.influences)
    for (const Influence& i : row) {
      EXPECT_NE(bound.joints[i.joint].name, "root");
      EXPECT_NE(bound.joints[i.joint].name, "ik_foot_l");
    }
}

}  // namespace
}  // namespace sinew
