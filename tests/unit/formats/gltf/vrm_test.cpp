// SPDX-License-Identifier: MIT
// VRM animations: joints by the humanoid's map, expressions left out, broken maps in one line.
#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.hpp"
#include "make_glb.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

// Nodes: 0 root, 1 J_Hip, 2 J_Leg, 3 J_Knee, 4 happy; the hip and the knee turn, the face smiles.
GlbBuilder dance() {
  GlbBuilder builder;
  builder.root({{"name", "root"}, {"children", {1, 4}}});
  builder.add("nodes", {{"name", "J_Hip"}, {"translation", {0, 1, 0}}, {"children", {2}}});
  builder.add("nodes", {{"name", "J_Leg"}, {"translation", {0.1, 0, 0}}, {"children", {3}}});
  builder.add("nodes", {{"name", "J_Knee"}, {"translation", {0, -0.5, 0}}});
  builder.add("nodes", {{"name", "happy"}});
  const int times = builder.accessor(std::vector<float>{0, 1}, "SCALAR");
  const int turn = builder.accessor(std::vector<float>{0, 0, 0, 1, 1, 0, 0, 0}, "VEC4");
  const int smile = builder.accessor(std::vector<float>{0, 0, 0, 1, 0, 0}, "VEC3");
  const auto channel = [](int sampler, int node, const char* path) {
    return nlohmann::json{{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}};
  };
  builder.add("animations",
              {{"name", "dance"},
               {"channels", {channel(0, 1, "rotation"), channel(0, 3, "rotation"), channel(1, 4, "translation")}},
               {"samplers", {{{"input", times}, {"output", turn}}, {{"input", times}, {"output", smile}}}}});
  builder.document["extensionsUsed"] = {"VRMC_vrm_animation"};
  builder.document["extensions"]["VRMC_vrm_animation"] = {
      {"specVersion", "1.0"},
      {"humanoid",
       {{"humanBones", {{"hips", {{"node", 1}}}, {"leftUpperLeg", {{"node", 2}}}, {"leftLowerLeg", {{"node", 3}}}}}}},
      {"expressions", {{"preset", {{"happy", {{"node", 4}}}}}}}};
  return builder;
}
Motion read_dance(const GlbBuilder& builder, const std::string& name = "dance.vrma") {
  const TempFolder folder;
  return read_motion(folder.write(name, builder.glb()));
}

TEST(VrmAnimation, JointsAreTheHumanoids) {
  for (const char* name : {"dance.vrma", "dance.glb"}) {
    const Motion motion = read_dance(dance(), name);
    ASSERT_EQ(motion.joints.size(), 3u);
    EXPECT_EQ(motion.joints[0].name, "hips");
    EXPECT_EQ(motion.joints[1].name, "leftUpperLeg");
    EXPECT_EQ(motion.joints[2].name, "leftLowerLeg");
    EXPECT_EQ(motion.joints[2].parent, 1);
    ASSERT_EQ(motion.clips.size(), 1u);
    EXPECT_NEAR(std::abs(dot(motion.clips[0].frames.back().rotations[2], axis_rotation(0, 2 * std::acos(0.0)))), 1,
                1e-6);
    ASSERT_EQ(motion.notes.size(), 1u);
    EXPECT_EQ(motion.notes[0], "expressions and eye directions were left out");
  }
  const TempFolder folder;
  Character skeleton;
  read_skeleton(folder.write("dance.vrma", dance().glb()), false, &skeleton);
  EXPECT_EQ(skeleton.joints.size(), 3u);
}

TEST(VrmAnimation, BrokenMapsAreOneLine) {
  const auto fails = [](const auto& change, const std::string& expected) {
    GlbBuilder builder = dance();
    change(&builder.document["extensions"]["VRMC_vrm_animation"]);
    EXPECT_ERROR(read_dance(builder), "dance.vrma", expected);
  };
  using Json = nlohmann::json;
  fails([](Json* e) { (*e)["humanoid"]["humanBones"]["hips"]["node"] = 5; },
        "expected a node below 5 in 'humanBones.hips', found another");
  fails([](Json* e) { (*e)["humanoid"]["humanBones"]["hips"] = 1; }, "in 'humanBones.hips', found none");
  fails([](Json* e) { (*e)["humanoid"]["humanBones"]["hips"]["node"] = -1; }, "found another");
  fails([](Json* e) { (*e)["humanoid"]["humanBones"]["head"]["node"] = 1; }, "a separate node for each bone");
  fails([](Json* e) { (*e)["humanoid"] = 3; }, "expected humanoid.humanBones, found none");
  fails([](Json* e) { (*e)["expressions"]["preset"]["happy"]["node"] = "4"; }, "'expressions.preset.happy'");
  fails([](Json* e) { (*e)["lookAt"] = {{"node", 77}}; }, "'lookAt'");
  GlbBuilder plain = dance();
  plain.document.erase("extensions");
  EXPECT_ERROR(read_dance(plain), "dance.vrma", "expected a VRM animation (extension VRMC_vrm_animation)");
}

}  // namespace
}  // namespace sinew
