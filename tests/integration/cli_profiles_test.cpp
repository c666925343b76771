// SPDX-License-Identifier: MIT
// --for PROFILE and .fbx of the commands: files in, files out, wrong calls.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
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
  EXPECT_NE(good("bind " + kRobed + " --skeleton " + kRobedRig + " --for vrm --to-pose none -o nobody.vrm")
                .out.find("--author"),
            std::string::npos);
  EXPECT_NE(
      bad(2, "bind " + kRobed + " --skeleton " + kRobedRig + " --for mixamo --author Ann -o x.glb").error.find("vrm"),
      std::string::npos);
  EXPECT_NE(bad(2, "bind " + kRobed + " --skeleton " + kRobedRig + " --keep-axes -o x.glb").error.find("--for"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(in("x.glb")));
}

// A dog has no T pose: what a program prefers is left undone with a word, what the user asks for is an error.
TEST_F(CliProfiles, ABodyWithoutThePreferredPoseKeepsItsOwn) {
  const std::string dog = kData + "/quadruped__tailed.obj", rig = kData + "/quadruped__tailed.rig.txt";
  const auto note = [](const std::string& out) { return out.find("the rest pose is unchanged: the pose t needs "); };
  EXPECT_NE(note(good("rig " + dog + " --for unity -o dog.fbx").out), std::string::npos);
  EXPECT_NE(note(good("bind " + dog + " --skeleton " + rig + " --for godot -o dog.glb").out), std::string::npos);
  EXPECT_EQ(note(good("rig " + dog + " --for unity --to-pose none -o none.fbx").out), std::string::npos);
  EXPECT_NE(bad(1, "rig " + dog + " --for unity --to-pose t -o t.fbx").error.find("the pose t needs "),
            std::string::npos);
  EXPECT_FALSE(fs::exists(in("t.fbx")));
}

TEST_F(CliProfiles, ControlsAreAFileAndExtras) {
  good("bind " + kRobed + " --skeleton " + kRobedRig + " -o a.glb --controls a.controls.json");
  const auto own = nlohmann::json::parse(slurp(in("a.controls.json")));
  EXPECT_EQ(own["limbs"].size(), 4u);
  const auto extras = [&](const std::string& file) {
    const std::string text = slurp(in(file));
    return nlohmann::json::parse(text).value("extras", nlohmann::json::object());
  };
  good("bind a.glb -o a.gltf --controls a.controls.json");
  EXPECT_EQ(extras("a.gltf")["sinew_controls"], nlohmann::json::parse(slurp(in("a.controls.json"))));
  // By the names that are written.
  good("animate a.glb --motion builtin:walk --for mixamo -o b.gltf --controls b.controls.json");
  const auto mixamo = nlohmann::json::parse(slurp(in("b.controls.json")));
  EXPECT_EQ(extras("b.gltf")["sinew_controls"], mixamo);
  EXPECT_EQ(mixamo["limbs"][0]["name"], "leg.left");
  EXPECT_EQ(mixamo["limbs"][0]["joints"][0], "mixamorig:LeftUpLeg");
  // Kept with the same joints, gone with others.
  good("bind a.gltf -o c.gltf");
  EXPECT_TRUE(extras("c.gltf").contains("sinew_controls"));
  good("bind a.gltf -o d.gltf --for mixamo --to-pose none");
  EXPECT_FALSE(extras("d.gltf").contains("sinew_controls"));
  // What is not there is said in a line.
  EXPECT_NE(good("bind " + kSnake + " --skeleton " + kSnakeRig + " -o e.glb --controls e.controls.json")
                .out.find("controls: no legs and no arms"),
            std::string::npos);
  EXPECT_NE(bad(2, "bind a.glb -o f.glb --controls f.txt").error.find(".json"), std::string::npos);
  EXPECT_NE(bad(2, "animate a.glb --motion builtin:walk -o f.bvh --controls f.json").error.find("--controls"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(in("f.glb")));
}

TEST_F(CliProfiles, BindPlacesTheMeshWithItsJoints) {
  good("bind " + kRobed + " --skeleton " + kRobedRig + " -o a.glb");
  good("bind " + kRobed + " --skeleton " + kRobedRig + " -o b.glb --turn y --height 3.5 --floor");
  const Character a = read_gltf(in("a.glb")), b = read_gltf(in("b.glb"));
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  float low = b.vertices[0].y, high = low, own_low = a.vertices[0].y, own_high = own_low;
  for (const Vec3& p : b.vertices) low = std::min(low, p.y), high = std::max(high, p.y);
  for (const Vec3& p : a.vertices) own_low = std::min(own_low, p.y), own_high = std::max(own_high, p.y);
  EXPECT_NEAR(low, 0, 1e-5);
  EXPECT_NEAR(high, 3.5, 1e-5);
  const float scale = 3.5f / (own_high - own_low);
  for (size_t j = 0; j < a.joints.size(); ++j) {
    EXPECT_NEAR(b.joints[j].position.x, scale * a.joints[j].position.z, 1e-4);
    EXPECT_NEAR(b.joints[j].position.y, scale * (a.joints[j].position.y - own_low), 1e-4);
    EXPECT_NEAR(b.joints[j].position.z, -scale * a.joints[j].position.x, 1e-4);
  }
}

TEST_F(CliProfiles, UsdIsWrittenAndNotRead) {
  good("bind " + kRobed + " --skeleton " + kRobedRig + " -o a.usda");
  good("bind " + kRobed + " --skeleton " + kRobedRig + " -o a.glb");
  good("animate a.glb --motion builtin:walk --for mixamo -o b.usdz");
  EXPECT_NE(read_text_file(in("a.usda")).find("def SkelRoot"), std::string::npos);
  const std::string package = read_text_file(in("b.usdz"));  // stored, so its layer is plain text in it
  EXPECT_NE(package.find("def SkelAnimation \"walk\""), std::string::npos);
  EXPECT_NE(package.find("mixamorig:LeftForeArm"), std::string::npos);
  const std::string remedy = "sinew writes USD but does not read it: export glTF or FBX";
  for (const char* words : {"bind a.usda -o x.glb", "rig a.usda -o x.glb",
                            "animate a.usda --motion builtin:walk -o x.glb", "animate a.glb --motion b.usdz -o x.glb",
                            "bind a.glb --skeleton a.usda -o x.glb", "map a.usda --from a.glb", "inspect b.usdz"}) {
    const std::string error = bad(1, words).error;
    EXPECT_NE(error.find(remedy), std::string::npos) << words << ": " << error;
    EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << words << ": " << error;
  }
  EXPECT_NE(run("check b.usdz").error.find(remedy), std::string::npos) << "and a line about all files";
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
