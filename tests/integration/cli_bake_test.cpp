// SPDX-License-Identifier: MIT
// The sinew command on corrective shapes: what it writes, what it says, and that wrong input is one line and leaves nothing behind.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli_fixture.hpp"
#include "gltf_validator.hpp"
#include "make_glb.hpp"
#include "nodding_motion.hpp"

namespace sinew {
namespace {

using CliBake = Cli;

TEST_F(CliBake, HalvesTheErrorOfHeldOutPoses) {
  const auto json = nlohmann::json::parse(good("bake " + kRobed + " --poses 150 --limit 50 --json -o baked.glb").out);
  EXPECT_GT(json["shapes"], 8);
  EXPECT_EQ(json["held_out_poses"], 10);
  EXPECT_GT(json["held_out_error"]["linear"], 1e-4);
  EXPECT_LT(json["held_out_error"]["baked"].get<double>(), 0.5 * json["held_out_error"]["linear"].get<double>());
  const auto document = json_of_glb(slurp(in("baked.glb")));
  EXPECT_FALSE(document["meshes"][0]["extras"]["sinew_correctives"]["bends"].empty());
  SINEW_EXPECT_VALID_GLTF({in("baked.glb")});
}

TEST_F(CliBake, LearnsFromAnAnimationAndPlaysInIt) {
  put(in("nod.bvh"), nodding_bvh());
  put(in("map.txt"), nodding_map(read_character(kRobed)));
  good("animate " + kRobed + " --motion nod.bvh --map map.txt --method copy -o nodding.glb");
  const auto json = nlohmann::json::parse(good("bake nodding.glb --animation 0 --shapes 2 --json -o baked.glb").out);
  EXPECT_EQ(json["animations"], 1);
  EXPECT_EQ(json["held_out_poses"], 10);
  EXPECT_EQ(json["poses"], 81);  // 3 seconds at 30 frames a second
  EXPECT_LT(json["held_out_error"]["baked"].get<double>(), 0.5 * json["held_out_error"]["linear"].get<double>());
  const auto document = json_of_glb(slurp(in("baked.glb")));
  size_t weights = 0;
  for (const auto& channel : document["animations"][0]["channels"]) weights += channel["target"]["path"] == "weights";
  EXPECT_GT(weights, 0u);
  SINEW_EXPECT_VALID_GLTF({in("baked.glb")});
}

TEST_F(CliBake, WrongUseIsOneLine) {
  bad(2, "bake " + kRobed + "");
  bad(2, "bake " + kRobed + " -o out.obj");
  bad(2, "bake " + kRobed + " --deform linear -o out.glb");
  bad(2, "bake " + kRobed + " --shapes 0 -o out.glb");
  EXPECT_NE(bad(1, "bake " + kRobed + " --animation walk -o out.glb").error.find("no animation"), std::string::npos);
  put(in("bare.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  put(in("bare.rig.txt"), "joints a 0 0 0\njoints b 0 1 0\nroot a\nhier a b\n");
  EXPECT_NE(bad(1, "bake bare.obj -o out.glb").error.find("bind it first"), std::string::npos);
  bad(1, "bake none.glb -o out.glb");
  EXPECT_FALSE(fs::exists(in("out.glb")));
}

}  // namespace
}  // namespace sinew
