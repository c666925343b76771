// SPDX-License-Identifier: MIT
// The sinew command on transfers: what it writes, what it says, and that wrong input is one line and leaves nothing behind.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli_fixture.hpp"

namespace sinew {
namespace {

class CliTransfer : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    fs::copy(kSnake, in("snake.obj"));
    good("bind " + kSnake + " --skeleton " + kSnakeRig + " -o snake.rig.txt");
  }
};

TEST_F(CliTransfer, TheSameMeshKeepsItsWeights) {
  const Outcome outcome = good("transfer snake.obj " + kSnake + " --skeleton " + kSnakeRig + " -o out.rig.txt");
  EXPECT_NE(outcome.out.find("mapped by equal names"), std::string::npos) << outcome.out;
  Character before = read_obj(in("snake.obj")), after = before;
  read_skeleton(in("snake.rig.txt"), true, &before);
  read_skeleton(in("out.rig.txt"), true, &after);
  expect_bound(after, 4);
  EXPECT_LT(mean_l1(before, after), 0.01);
}

TEST_F(CliTransfer, AMapSaysWhichJointIsWhich) {
  std::string map = "# target source\n";
  Character own = read_obj(kSnake);
  read_skeleton(kSnakeRig, false, &own);
  for (Joint& joint : own.joints) {
    map += "Other_" + joint.name + " " + joint.name + "\n";
    joint.name = "Other_" + joint.name;
  }
  write_rig(in("other.rig.txt"), own);
  put(in("map.txt"), map);
  const auto found =
      nlohmann::json::parse(good("transfer snake.obj " + kSnake + " --skeleton other.rig.txt --json -o out.glb").out);
  EXPECT_EQ(found["mapped_joints"], own.joints.size());
  EXPECT_EQ(found["mapped_by"], "anatomy and names");
  const auto json = nlohmann::json::parse(
      good("transfer snake.obj " + kSnake + " --skeleton other.rig.txt --map map.txt --json -o out.glb").out);
  EXPECT_EQ(json["mapped_joints"], own.joints.size());
  EXPECT_EQ(json["parts"].size(), 5u);  // the snake and what sticks to it
  good("map other.rig.txt --from " + kSnakeRig + " --set " + own.joints.back().name + "=- -o made.txt");
  const auto made = nlohmann::json::parse(
      good("transfer snake.obj " + kSnake + " --skeleton other.rig.txt --map made.txt --json -o out.glb").out);
  EXPECT_EQ(made["mapped_joints"], own.joints.size() - 1) << "the line of the joint that gets none";
  put(in("map.txt"), own.joints[0].name + " -\n");
  EXPECT_NE(bad(1, "transfer snake.obj " + kSnake + " --skeleton other.rig.txt --map map.txt -o new.glb")
                .error.find("maps no joint"),
            std::string::npos);
  put(in("map.txt"), own.joints[0].name + " " + own.joints[0].name.substr(6) + "\n" + own.joints[1].name + " " +
                         own.joints[0].name.substr(6) + "\n");
  EXPECT_NE(bad(1, "transfer snake.obj " + kSnake + " --skeleton other.rig.txt --map map.txt -o new.glb")
                .error.find("map.txt:2: expected each joint once"),
            std::string::npos);
  put(in("map.txt"), "Other_none x\n");
  EXPECT_NE(bad(1, "transfer snake.obj " + kSnake + " --skeleton other.rig.txt --map map.txt -o new.glb")
                .error.find("map.txt:1: expected"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(in("new.glb")));
}

TEST_F(CliTransfer, WrongUseIsOneLine) {
  const std::string call = "transfer snake.obj " + kSnake + " --skeleton " + kSnakeRig;
  bad(2, call + " --method other -o out.glb");
  bad(2, call + " --pair 1=2 -o out.glb");
  bad(2, call + " --method biharmonic --pair 1=99999999 -o out.glb");
  bad(2, call + " --garment -o out.glb");
  bad(2, call + " -o snake.rig.txt");
  bad(1, "transfer none.obj snake.obj -o out.glb");
  bad(1, "transfer " + kData + "/none.glb snake.obj -o out.glb");
  bad(2, "transfer snake.obj a.obj b.obj");
  EXPECT_FALSE(fs::exists(in("out.glb")));
}

TEST_F(CliTransfer, SeveralGarmentsGoToAFolder) {
  fs::create_directories(in("dressed"));
  fs::copy(kSnake, in("shirt.obj"));
  good("transfer snake.obj shirt.obj " + kSnake + " --garment --format rig.txt -o dressed");
  EXPECT_TRUE(fs::exists(in("dressed/shirt.rig.txt")));
  EXPECT_TRUE(fs::exists(in("dressed/snake__long.rig.txt")));
}

}  // namespace
}  // namespace sinew
