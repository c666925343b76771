// SPDX-License-Identifier: MIT
// --for PROFILE and .fbx of the commands: files in, files out, wrong calls.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "cli_fixture.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {
namespace {

class CliProfiles : public Cli {};

bool has_joint(const Character& character, const std::string& name) {
  return std::any_of(character.joints.begin(), character.joints.end(),
                     [&](const Joint& joint) { return joint.name == name; });
}

TEST_F(CliProfiles, CommandsWriteWhatAProgramWants) {
  good("bind " + kRobed + " --skeleton " + kRobedRig + " --for mixamo -o a.glb");
  EXPECT_TRUE(has_joint(read_gltf(in("a.glb")), "mixamorig:LeftForeArm"));
  good("bind " + kRobed + " --skeleton " + kRobedRig + " --for mixamo --keep-axes --to-pose none -o kept.glb");
  EXPECT_FALSE(has_joint(read_gltf(in("kept.glb")), "mixamorig:LeftForeArm"));
  good("animate a.glb --motion builtin:walk --for unreal -o b.glb");
  EXPECT_TRUE(has_joint(read_gltf(in("b.glb")), "root"));
  good("simplify b.glb --level low --for godot -o c.glb");
  EXPECT_TRUE(has_joint(read_gltf(in("c.glb")), "LeftLowerArm"));
  good("transfer a.glb " + kRobed + " --skeleton " + kRobedRig + " --for blender -o d.glb");
  EXPECT_TRUE(has_joint(read_gltf(in("d.glb")), "forearm.L"));
  good("bind " + kRobed + " --skeleton " + kRobedRig + " --for vrm0 --author Ann --to-pose none");
  EXPECT_TRUE(fs::exists(in("biped__robed.bound.vrm")));

  EXPECT_NE(
      bad(2, "bind " + kRobed + " --skeleton " + kRobedRig + " --for softimage -o x.glb").error.find("mixamo, unreal"),
      std::string::npos);
  EXPECT_NE(bad(2, "bind " + kRobed + " --skeleton " + kRobedRig + " --for vrm -o x.vrm").error.find("--author"),
            std::string::npos);
  EXPECT_NE(
      bad(2, "bind " + kRobed + " --skeleton " + kRobedRig + " --for mixamo --author Ann -o x.glb").error.find("vrm"),
      std::string::npos);
  EXPECT_NE(bad(2, "bind " + kRobed + " --skeleton " + kRobedRig + " --keep-axes -o x.glb").error.find("--for"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(in("x.glb")));
}

TEST_F(CliProfiles, UsdComesBack) {
  good("bind " + kRobed + " --skeleton " + kRobedRig + " -o a.usda");
  good("bind " + kRobed + " --skeleton " + kRobedRig + " -o a.glb");
  const Character usd = read_gltf(in("a.usda")), glb = read_gltf(in("a.glb"));
  EXPECT_EQ(usd.joints.size(), glb.joints.size());
  EXPECT_EQ(usd.vertices.size(), glb.vertices.size());
  good("animate a.usda --motion builtin:walk --for mixamo -o b.usdz");
  EXPECT_EQ(read_gltf_motion(in("b.usdz")).clips.at(0).name, "walk");
  EXPECT_TRUE(has_joint(read_gltf(in("b.usdz")), "mixamorig:LeftForeArm"));
  put(in("broken.usda"), "#usda 1.0\ndef Mesh \"A\" { point3f[] points = }\n");
  EXPECT_NE(bad(1, "bind broken.usda -o x.glb").error.find("broken.usda:2: expected a value"), std::string::npos);
}

#ifdef SINEW_HAS_ASSIMP
TEST_F(CliProfiles, FbxComesBack) {
  good("bind " + kRobed + " --skeleton " + kRobedRig + " -o a.fbx");
  good("bind " + kRobed + " --skeleton " + kRobedRig + " -o a.glb");
  const Character fbx = read_gltf(in("a.fbx")), glb = read_gltf(in("a.glb"));
  EXPECT_EQ(fbx.joints.size(), glb.joints.size());
  EXPECT_EQ(fbx.vertices.size(), glb.vertices.size());
  good("animate a.fbx --motion builtin:walk --for mixamo -o b.fbx");
  EXPECT_EQ(read_gltf_motion(in("b.fbx")).clips.at(0).name, "walk");
  EXPECT_TRUE(has_joint(read_gltf(in("b.fbx")), "mixamorig:LeftForeArm"));
}
#endif

}  // namespace
}  // namespace sinew
