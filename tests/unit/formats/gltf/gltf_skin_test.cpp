// SPDX-License-Identifier: MIT
// Skins that the writer puts into a document: weights, joints, parts and poses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glb_round.hpp"

namespace sinew {
namespace {

using nlohmann::json;

TEST(GltfSkin, RigidPartsAndStrangersStayAsTheyAre) {
  const Character c = read(with_parts());
  const json out = json_of_glb(written(c));
  EXPECT_EQ(out["nodes"][3], with_parts().document["nodes"][3]);
  EXPECT_EQ(out["nodes"][4], with_parts().document["nodes"][4]);
  EXPECT_EQ(out["nodes"][2]["skin"], 0);
}

TEST(GltfSkin, ARigidPartThatGetsOtherWeightsGetsASkinAndStaysInPlace) {
  Character c = read(with_parts());
  c.influences[11] = {{0, 0.5f}, {1, 0.5f}};
  const std::string glb = written(c);
  const json out = json_of_glb(glb);
  EXPECT_TRUE(out["nodes"][3].contains("skin"));
  EXPECT_FALSE(out["nodes"][4].contains("skin"));  // the stone shares the mesh of the lamp and must not
  EXPECT_NE(out["nodes"][3]["mesh"], out["nodes"][4]["mesh"]);
  EXPECT_FALSE(out["nodes"][1].contains("children"));
  const Character again = reread(glb);
  ASSERT_EQ(again.vertices.size(), c.vertices.size());
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    float nearest = 1e9f;
    for (size_t w = 0; w < again.vertices.size(); ++w) {
      const float d = std::fabs(again.vertices[w].x - c.vertices[v].x) +
                      std::fabs(again.vertices[w].y - c.vertices[v].y) +
                      std::fabs(again.vertices[w].z - c.vertices[v].z);
      nearest = std::min(nearest, d);
    }
    EXPECT_LT(nearest, 1e-5f) << v;
  }
}

TEST(GltfSkin, OldWeightsThatAnotherMeshUsesStay) {
  GlbBuilder builder = two_joint_strip();
  builder.add("meshes", builder.document["meshes"][0]);
  builder.root({{"name", "statue"}, {"mesh", 1}, {"translation", {50, 0, 0}}});  // same accessors, no skin
  const std::string glb = written(read(builder));
  const json out = json_of_glb(glb);
  const json& statue = out["meshes"][1]["primitives"][0]["attributes"];
  EXPECT_NE(statue["WEIGHTS_0"], out["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"]);
  EXPECT_EQ(values_of<float>(glb, out, statue["WEIGHTS_0"], 4)[13], 0.25f);
}

TEST(GltfSkin, WeightsSumExactlyAreSortedAndUnique) {
  Character c = read(two_joint_strip());
  for (int j = 0; j < 9; ++j) c.joints.push_back({"extra" + std::to_string(j), {static_cast<float>(j), 1, 2}, 0});
  c.influences[0] = {{3, 0.1f}, {4, 0.1f}, {3, 0.1f}, {5, 0.2f}, {6, 1e-9f}, {7, 0.3f}, {2, 0.2f}};
  c.influences[1] = {};                                             // unbound in a bound mesh
  c.influences[2] = {{0, 1.0f / 3}, {1, 1.0f / 3}, {2, 1.0f / 3}};  // does not divide
  c.influences[3] = {{1, 7}, {0, 7}};                               // any scale
  for (const bool unorm8 : {false, true}) {
    const std::string glb = written(c, {unorm8});
    const json out = json_of_glb(glb);
    const json& at = out["meshes"][0]["primitives"][0]["attributes"];
    ASSERT_TRUE(at.contains("WEIGHTS_1"));
    ASSERT_FALSE(at.contains("WEIGHTS_2"));
    std::vector<std::vector<uint32_t>> weights(10), joints(10);
    for (int set = 0; set < 2; ++set) {
      const int w = at["WEIGHTS_" + std::to_string(set)], j = at["JOINTS_" + std::to_string(set)];
      EXPECT_EQ(out["accessors"][static_cast<size_t>(w)]["normalized"], true);
      const auto js = values_of<uint8_t>(glb, out, j, 4);
      if (unorm8) {
        const auto ws = values_of<uint8_t>(glb, out, w, 4);
        for (size_t i = 0; i < 40; ++i) weights[i / 4].push_back(ws[i]);
      } else {
        const auto ws = values_of<uint16_t>(glb, out, w, 4);
        for (size_t i = 0; i < 40; ++i) weights[i / 4].push_back(ws[i]);
      }
      for (size_t i = 0; i < 40; ++i) joints[i / 4].push_back(js[i]);
    }
    for (size_t v = 0; v < 10; ++v) {
      uint32_t sum = 0;
      std::map<uint32_t, int> seen;
      for (size_t k = 0; k < 8; ++k) {
        sum += weights[v][k];
        EXPECT_LE(weights[v][k], weights[v][k > 0 ? k - 1 : 0]);
        if (weights[v][k] == 0) {
          EXPECT_EQ(joints[v][k], 0u);
        } else {
          EXPECT_EQ(seen[joints[v][k]]++, 0);
        }
      }
      EXPECT_EQ(sum, unorm8 ? 255u : 65535u) << v;
    }
    EXPECT_EQ(weights[0][5], 0u);  // 1e-9 is no influence
    EXPECT_EQ(joints[1][0], 0u);   // the root takes unbound vertices
    EXPECT_EQ(weights[2][0] - weights[2][1], 0u);
  }
}

TEST(GltfSkin, UnormWeightsSurviveAnyNumberOfRounds) {
  Character c = read(two_joint_strip());
  c.influences[0] = {{0, 0.123456f}, {1, 0.876544f}};
  const std::string once = written(c), twice = written(reread(once));
  EXPECT_EQ(once, twice);
}

// Joints that nobody followed often have matrices that were never set.
TEST(GltfSkin, AMatrixThatNeverMatteredIsMendedWhenItDoes) {
  GlbBuilder builder = two_joint_strip();
  const int control = builder.add("nodes", {{"name", "control"}, {"translation", {0, 1, 5}}});
  builder.document["nodes"][0]["children"].push_back(control);
  builder.document["skins"][0]["joints"].push_back(control);
  std::vector<float> binds = {1, 0, 0, 0, 0, 1,  0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0,   1, 0, 0,
                              0, 0, 1, 0, 0, -2, 0, 1, 0, 7, 0, 0, 7, 0, 0, 0, 0, 0, 7, 0, 300, 0, 0, 1};
  builder.document["skins"][0]["inverseBindMatrices"] = builder.accessor(binds, "MAT4");
  Character c = read(builder);
  ASSERT_EQ(c.joints.size(), 3u);
  for (auto& row : c.influences) row = {{0, 0.5f}, {2, 0.5f}};
  const std::string glb = written(c);
  const json out = json_of_glb(glb);
  const auto matrices = values_of<float>(glb, out, out["skins"][0]["inverseBindMatrices"].get<int>(), 16);
  EXPECT_EQ(std::vector<float>(matrices.begin(), matrices.begin() + 32),
            std::vector<float>(binds.begin(), binds.begin() + 32));
  EXPECT_EQ(matrices[32], 1);
  EXPECT_EQ(matrices[45], -1);
  EXPECT_EQ(matrices[46], -5);
  const Character again = reread(glb);
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    EXPECT_NEAR(again.vertices[v].x, c.vertices[v].x, 1e-5);
    EXPECT_NEAR(again.vertices[v].y, c.vertices[v].y, 1e-5);
  }
}

TEST(GltfSkin, AnotherSkeletonBecomesNodesAndASkin) {
  const TempFolder folder;
  Character c = read(two_joint_strip());
  read_skeleton(
      folder.write("new.rig.txt", "joints a 10 0 0\njoints b 10.5 3 0\njoints prop 0 0 0\nroot a\nhier a b\n"), false,
      &c);
  c.influences.assign(c.vertices.size(), {{1, 0.5f}, {0, 0.5f}});
  c.influences[0] = {{2, 1.0f}};
  const std::string glb = written(c);
  const json out = json_of_glb(glb);
  EXPECT_EQ(out["skins"].size(), 1u);
  const Character again = reread(glb);
  ASSERT_EQ(again.joints.size(), 3u);
  EXPECT_EQ(again.joints[1].name, "b");
  EXPECT_EQ(again.joints[1].parent, 0);
  EXPECT_EQ(again.joints[2].parent, -1);
  EXPECT_NEAR(again.joints[1].position.y, 3, 1e-6);
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    EXPECT_NEAR(again.vertices[v].x, c.vertices[v].x, 1e-5);
    EXPECT_NEAR(again.vertices[v].y, c.vertices[v].y, 1e-5);
  }
}

TEST(GltfSkin, AnotherSkeletonOnAPosedMeshKeepsThePose) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][1]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};
  Character c = read(builder);
  read_skeleton(folder.write("new.rig.txt", "joints a 10 0 0\nroot a\n"), false, &c);
  c.influences.assign(c.vertices.size(), {{0, 1.0f}});
  const Character again = reread(written(c));
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    EXPECT_NEAR(again.vertices[v].x, c.vertices[v].x, 1e-5);
    EXPECT_NEAR(again.vertices[v].y, c.vertices[v].y, 1e-5);
    EXPECT_NEAR(again.corner_normals[v].x * again.corner_normals[v].x +
                    again.corner_normals[v].y * again.corner_normals[v].y +
                    again.corner_normals[v].z * again.corner_normals[v].z,
                1, 1e-5);
  }
}

}  // namespace
}  // namespace sinew
