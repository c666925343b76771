// SPDX-License-Identifier: MIT
// The sinew command on hands: rig --detail hands, its skeletons, what it refuses, and eval hands.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "cli_fixture.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

class CliHands : public Cli {
 protected:
  // A forearm, a hand and three fingers of two joints along x, a pyramid at every joint.
  void write_hand() {
    std::string mesh, faces, joints, tree, skin;
    int count = 0;
    const auto add = [&](const std::string& name, double x, double z, const std::string& parent) {
      const std::string at = std::to_string(x) + " 0 " + std::to_string(z);
      joints += "joints " + name + " " + at + "\n";
      tree += parent.empty() ? "root " + name + "\n" : "hier " + parent + " " + name + "\n";
      for (const char* corner : {" 0.1 0", " -0.1 0.1", " -0.1 -0.1"}) mesh += "v " + std::to_string(x) + corner + "\n";
      mesh += "v " + std::to_string(x + 0.8) + " 0 " + std::to_string(z) + "\n";
      const auto v = [&](int i) { return " " + std::to_string(4 * count + i); };
      faces += "f" + v(1) + v(2) + v(4) + "\nf" + v(2) + v(3) + v(4) + "\nf" + v(3) + v(1) + v(4) + "\n";
      for (int i = 0; i < 4; ++i) skin += "skin " + std::to_string(4 * count + i) + " " + name + " 1\n";
      ++count;
    };
    add("LeftForeArm", -4, 0, "");
    add("LeftHand", 0, 0, "LeftForeArm");
    for (const char* finger : {"Thumb", "Index", "Middle"}) {
      const std::string name = std::string("LeftHand") + finger;
      add(name + "1", 2, 0.3 * count, "LeftHand");
      add(name + "2", 3, 0.3 * count, name + "1");
    }
    put(in("hand.obj"), mesh + faces);
    put(in("hand.rig.txt"), joints + tree + skin);
  }
};

TEST_F(CliHands, WithoutFingersTheSkeletonIsThatOfTheBody) {
  const std::string mesh = kData + "/biped__robed.obj";  // its arms end in stubs
  good("rig " + mesh + " --no-bind -o body.rig.txt");
  const Outcome made = good("rig " + mesh + " --no-bind --detail hands -o hands.rig.txt");
  EXPECT_NE(made.out.find("no hand with separate fingers"), std::string::npos) << made.out;
  EXPECT_EQ(slurp(in("hands.rig.txt")), slurp(in("body.rig.txt")));
}

TEST_F(CliHands, AGivenSkeletonKeepsItsJoints) {
  const std::string mesh = kData + "/biped__robed.obj";
  good("rig " + mesh + " --no-bind -o body.rig.txt");
  good("rig " + mesh + " --prediction body.rig.txt --no-bind --detail hands -o hands.rig.txt");
  Character body, hands;
  read_skeleton(in("body.rig.txt"), false, &body);
  read_skeleton(in("hands.rig.txt"), false, &hands);
  EXPECT_EQ(hands.joints.size(), body.joints.size());
}

TEST_F(CliHands, FullDetailAddsEyesAndAJawWhereThereAreEyes) {
  put(in("box.obj"),
      "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 1 2 0\nv 0 0 1\nv 1 0 1\nv 0 2 1\nv 1 2 1\n"
      "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
  const Outcome none = good("rig box.obj --no-bind --detail full -o none.rig.txt");
  EXPECT_NE(none.out.find("no head with separate eyes"), std::string::npos) << none.out;
  good("rig box.obj --no-bind -o body.rig.txt");
  EXPECT_EQ(slurp(in("none.rig.txt")), slurp(in("body.rig.txt")));

  good("rig " + kData + "/biped__robed.obj --detail full -o face.rig.txt");  // its eyes are loose balls
  const std::string made = slurp(in("face.rig.txt"));
  for (const char* line :
       {"joints LeftEye 0.08", "joints RightEye -0.08", "hier Head LeftEye", "hier Head Jaw", "hier Jaw Jaw_end"})
    EXPECT_NE(made.find(line), std::string::npos) << line;
  EXPECT_NE(made.find(" LeftEye 1.000000"), std::string::npos) << "a ball moves with its eye";
  EXPECT_NE(made.find("hier LeftHand LeftHandProp"), std::string::npos) << "it holds a stick";
  EXPECT_NE(made.find(" LeftHandProp 1.000000"), std::string::npos);
}

TEST_F(CliHands, ModelsAreToldApart) {
  const std::string mesh = kData + "/biped__robed.obj";
  const Outcome body = bad(1, "rig " + mesh + " --no-bind --model " + kData + "/sinew_hands.sinew -o out.rig.txt");
  EXPECT_NE(body.error.find("sinew_hands.sinew: "), std::string::npos) << body.error;
  const Outcome hands =
      bad(1, "rig " + mesh + " --no-bind --detail hands --hands-model " + kData + "/sinew_rig.sinew -o out.rig.txt");
  EXPECT_NE(hands.error.find("sinew_rig.sinew: "), std::string::npos) << hands.error;
  const Outcome unused = bad(2, "rig " + mesh + " --hands-model " + kData + "/sinew_hands.sinew -o out.rig.txt");
  EXPECT_NE(unused.error.find("--detail hands"), std::string::npos) << unused.error;
  EXPECT_FALSE(fs::exists(in("out.rig.txt")));
}

TEST_F(CliHands, EvalCountsHandsThatHaveNone) {
  fs::create_directories(in("set"));
  for (const char* end : {".obj", ".rig.txt"}) fs::copy(kData + "/biped__robed" + std::string(end), in("set"));
  const auto figures = nlohmann::json::parse(good("eval hands set --json").out);
  EXPECT_EQ(figures["all"]["hands"], 0);
  EXPECT_EQ(figures["all"]["bare_wrong"], 0);
  const Outcome wrong = bad(2, "eval hands set --predictions set");
  EXPECT_NE(wrong.error.find("--predictions"), std::string::npos) << wrong.error;
}

TEST_F(CliHands, TargetsMayHaveFingers) {
  write_hand();
  good("dataset target hand.obj -o body");
  good("dataset target hand.obj -o hands --detail hands");
  Character body, hands;
  read_skeleton(in("body/hand.rig.txt"), false, &body);
  read_skeleton(in("hands/hand.rig.txt"), false, &hands);
  EXPECT_GT(hands.joints.size(), body.joints.size());
}

}  // namespace
}  // namespace sinew
