// SPDX-License-Identifier: MIT
// Materials, pictures, colors and objects of an OBJ, up to the glTF that is made of them.
#include "text/mtl.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "glb_round.hpp"

namespace sinew {
namespace {

using nlohmann::json;

std::string png(char color_type) {
  return std::string("\x89PNG\r\n\x1a\n", 8) + std::string(17, '\0') + color_type + "picture";
}

const char kTwo[] =
    "mtllib my colors.mtl\nv 0 0 0 1 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0\nv 0 0 1 0 0 0\n"
    "o left boot\nusemtl leather\nf 1 2 3\no right boot\nusemtl glass\nf 1 3 4\nusemtl leather\nf 2 3 4\n";

TEST(Mtl, ColorsPicturesAndObjectsReachTheGlb) {
  const TempFolder folder;
  folder.write(
      "my colors.mtl",
      "newmtl leather\nKd 0 0 0\nmap_Kd -s 1 1 1 -o 0 0 tex\\brown skin.png\nmap_Bump -bm 0.5 bumps.png\n"
      "newmtl glass\nKd 0.25 0.5 1\nKe 0 0 0.5\nd 0.5\nnorm -clamp on normals.png\nnewmtl unused\nmap_Kd no.png\n");
  folder.write("brown skin.png", png(2));
  folder.write("bumps.png", png(0));
  folder.write("normals.png", png(6));
  const Character c = read_obj(folder.write("boots.obj", kTwo));
  ASSERT_EQ(c.materials.size(), 2u);
  EXPECT_EQ(c.notes.size(), 1u);
  EXPECT_NE(c.notes.at(0).find("'bumps.png' is a height map"), std::string::npos) << c.notes[0];
  ASSERT_EQ(c.vertex_colors.size(), 4u);
  EXPECT_NEAR(c.vertex_colors[1][1], 0.2140, 1e-4);  // half of what a screen shows is a fifth of the light
  EXPECT_EQ(c.vertex_colors[2], (std::array<float, 3>{1, 1, 1}));

  const std::string glb = written(c);
  const json out = json_of_glb(glb);
  ASSERT_EQ(out["nodes"].size(), 2u);
  EXPECT_EQ(out["nodes"][0]["name"], "left boot");
  EXPECT_EQ(out["nodes"][1]["name"], "right boot");
  EXPECT_EQ(out["meshes"][1]["primitives"].size(), 2u);
  ASSERT_EQ(out["materials"].size(), 2u);
  const json& leather = out["materials"][0];
  EXPECT_EQ(leather["name"], "leather");
  EXPECT_FALSE(leather["pbrMetallicRoughness"].contains("baseColorFactor"));  // white
  EXPECT_EQ(leather["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
  const json& glass = out["materials"][1];
  EXPECT_EQ(glass["alphaMode"], "BLEND");
  EXPECT_EQ(glass["pbrMetallicRoughness"]["baseColorFactor"], json({0.25, 0.5, 1, 0.5}));
  EXPECT_EQ(glass["emissiveFactor"], json({0, 0, 0.5}));
  EXPECT_TRUE(glass.contains("normalTexture"));
  EXPECT_EQ(out["images"].size(), 2u);
  EXPECT_NE(glb.find(png(2)), std::string::npos);
  const json& attributes = out["meshes"][0]["primitives"][0]["attributes"];
  EXPECT_EQ(values_of<uint16_t>(glb, out, attributes["COLOR_0"], 4)[5], 14027);  // 0.2140 of 65535
}

TEST(Mtl, WhatIsMissingIsANote) {
  const TempFolder folder;
  Character c = read_obj(folder.write("boots.obj", kTwo));
  ASSERT_EQ(c.notes.size(), 1u);
  EXPECT_NE(c.notes[0].find("'my colors.mtl' were not found"), std::string::npos) << c.notes[0];
  folder.write("my colors.mtl", "Kd 1 1 1\nnewmtl leather\nmap_Kd gone.png\nKd red\nd\nnewmtl glass\nmap_Kd a.tga\n");
  folder.write("a.tga", "targa");
  c = read_obj(folder.file("boots.obj"));
  ASSERT_EQ(c.notes.size(), 4u);
  EXPECT_NE(c.notes[0].find("'gone.png' was not found"), std::string::npos) << c.notes[0];
  EXPECT_NE(c.notes[1].find("my colors.mtl:4: expected three numbers"), std::string::npos) << c.notes[1];
  EXPECT_NE(c.notes[2].find("my colors.mtl:5: expected a number"), std::string::npos) << c.notes[2];
  EXPECT_NE(c.notes[3].find("'a.tga' is not a PNG or JPEG"), std::string::npos) << c.notes[3];
}

TEST(Mtl, GroupsPartAMeshWithoutObjects) {
  const TempFolder folder;
  const Character c = read_obj(folder.write("g.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2 3\ng b\nf 3 2 1\n"));
  const json out = json_of_glb(written(c));
  ASSERT_EQ(out["nodes"].size(), 2u);
  EXPECT_EQ(out["nodes"][1]["name"], "b");
}

}  // namespace
}  // namespace sinew
