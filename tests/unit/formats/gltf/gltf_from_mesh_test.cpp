// SPDX-License-Identifier: MIT
// Documents for meshes that came without one.
#include <gtest/gtest.h>

#include <array>

#include "glb_round.hpp"

namespace sinew {
namespace {

using nlohmann::json;

TEST(GltfFromMesh, ObjWithMaterialsUvsAndNormals) {
  const TempFolder folder;
  Character c = read_obj(folder.write("box.obj",
                                      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 2 0\nvt 0 0\nvt 1 0.25\nvn 0 0 0\n"
                                      "usemtl red\nf 1/1/1 2/2/1 3/1/1 4/2/1\nusemtl blue\nf 4/1 3/2 5/1\n"));
  c.joints = {{"root", {0, 0, 0}, -1}, {"tip", {0, 1, 0}, 0}};
  c.influences.assign(5, {{0, 0.25f}, {1, 0.75f}});
  const std::string glb = written(c);
  const json out = json_of_glb(glb);
  EXPECT_EQ(out["asset"]["generator"], "sinew");
  ASSERT_EQ(out["meshes"][0]["primitives"].size(), 2u);
  EXPECT_EQ(out["materials"][0]["name"], "red");
  const Character again = reread(glb);
  EXPECT_EQ(again.vertices.size(), 5u);
  EXPECT_EQ(again.face_vertices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3, 3, 2, 4}));
  EXPECT_EQ(again.corner_uvs[1], (std::array<float, 2>{1, 0.25f}));
  EXPECT_EQ(again.material_names, c.material_names);
  EXPECT_NEAR(again.corner_normals[0].z, 1, 1e-6);
  EXPECT_EQ(again.joints[1].parent, 0);
  EXPECT_NEAR(row(again, 2)[1], 0.75f, 2e-5);
}

TEST(GltfFromMesh, JointsWithoutWeightsAreStillNodes) {
  const TempFolder folder;
  Character c = read_obj(folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  c.joints = {{"a", {0, 0, 0}, -1}};
  const json out = json_of_glb(written(c));
  EXPECT_EQ(out["nodes"][1]["name"], "a");
  EXPECT_FALSE(out.contains("skins"));
}

}  // namespace
}  // namespace sinew
