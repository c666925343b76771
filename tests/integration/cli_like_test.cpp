// SPDX-License-Identifier: MIT
// sinew bind --like: style by example.
#include <gtest/gtest.h>

#include <cmath>

#include "cli_fixture.hpp"

namespace sinew {
namespace {

using CliLike = Cli;

TEST_F(CliLike, TheExampleComesBackOnItsOwnMesh) {
  // An example that no bind would give: every vertex follows its strongest joint alone.
  const std::string mesh = kData + "/biped__robed.obj", rig = kData + "/biped__robed.rig.txt";
  Character example = read_character(mesh);
  for (auto& row : example.influences) row = {{row.front().joint, 1.0f}};
  write_obj(in("hard.obj"), example);
  write_rig(in("hard.rig.txt"), example);
  const std::string said = good("bind " + mesh + " --skeleton " + rig + " --like hard.obj -o like.rig.txt").out;
  EXPECT_NE(said.find("like hard: "), std::string::npos) << said;
  good("bind " + mesh + " --skeleton " + rig + " -o plain.rig.txt");
  Character like = read_obj(mesh), plain = like;
  read_skeleton(in("like.rig.txt"), true, &like);
  read_skeleton(in("plain.rig.txt"), true, &plain);
  expect_bound(like, 4);
  EXPECT_GT(mean_l1(plain, example), 0.1);
  EXPECT_LT(mean_l1(like, example), 0.3 * mean_l1(plain, example));
}

TEST_F(CliLike, WrongUseIsOneLine) {
  const std::string call = "bind " + kSnake + " --skeleton " + kSnakeRig;
  put(in("bare.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  put(in("bare.rig.txt"), "joints a 0 0 0\njoints b 0 1 0\nroot a\nhier a b\n");
  EXPECT_NE(bad(1, call + " --like bare.obj -o out.glb").error.find("no skin weights"), std::string::npos);
  bad(1, call + " --like none.glb -o out.glb");
  EXPECT_FALSE(fs::exists(in("out.glb")));
}

}  // namespace
}  // namespace sinew
