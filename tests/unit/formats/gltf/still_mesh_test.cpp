// SPDX-License-Identifier: MIT
// Meshes without their skeletons: which vertices they have, and what of a document stays.
#include "sinew_formats/still_mesh.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "gltf/gltf_source.hpp"
#include "make_glb.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

using Texels = std::vector<std::array<float, 2>>;

Texels numbered(size_t count) {
  Texels texels;
  for (size_t i = 0; i < count; ++i) texels.push_back({static_cast<float>(i) + 0.25f, static_cast<float>(i) + 0.5f});
  return texels;
}

std::vector<Vec3> rest_positions(const StillMesh& mesh, const Character& character) {
  std::vector<Vec3> positions;
  for (const uint32_t v : mesh.vertices()) positions.push_back(character.vertices[v]);
  return positions;
}

// A strip with a seam in two primitives, which a second node shows too, turned by a quarter about y and without the skin.
GlbBuilder shown_twice() {
  GlbBuilder builder = two_joint_strip(true);
  nlohmann::json& primitives = builder.document["meshes"][0]["primitives"];
  std::vector<float> second(24, 0.125f);
  const int set = builder.accessor(second, "VEC2");
  primitives[0]["attributes"]["TEXCOORD_1"] = set;
  primitives[0]["attributes"]["TANGENT"] = builder.accessor(std::vector<float>(48, 1.0f), "VEC4");
  builder.document["textures"] = {{{"source", 0}}};
  builder.document["images"] = {{{"uri", "data:image/png;base64,iVBORw0KGgo="}}};
  primitives[0]["material"] = builder.add(
      "materials",
      {{"occlusionTexture", {{"index", 0}, {"texCoord", 1}}},
       {"emissiveTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"texCoord", 1}}}}}}}});
  builder.document["extensionsUsed"] = {"KHR_texture_transform", "KHR_lights_punctual"};
  builder.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  primitives.push_back(primitives[0]);
  primitives[1].erase("material");
  builder.root({{"name", "turned"}, {"mesh", 0}, {"rotation", {0, 0.70710678, 0, 0.70710678}}});
  return builder;
}

TEST(StillMesh, EveryPrimitiveOfEveryNodeHasVerticesOfItsOwnInWorldAxes) {
  const TempFolder folder;
  const Character character = read_gltf(folder.write("in.glb", shown_twice().glb()));
  const StillMesh mesh("in.glb", character);
  ASSERT_EQ(mesh.vertices().size(), 4u * 12);
  for (size_t i = 0; i < 24; ++i) EXPECT_NEAR(mesh.normals()[i].z, 1, 1e-6);
  for (size_t i = 24; i < 48; ++i) EXPECT_NEAR(mesh.normals()[i].x, 1, 1e-6);  // of the turned node

  const std::vector<uint8_t> glb =
      mesh.glb(rest_positions(mesh, character), mesh.normals(), numbered(mesh.vertices().size()));
  const Character still = read_gltf(folder.write("still.glb", std::string(glb.begin(), glb.end())));
  EXPECT_TRUE(still.joints.empty());
  ASSERT_EQ(still.gltf->parts.size(), 4u);
  size_t vertex = 0;
  for (const GltfPart& part : still.gltf->parts) {
    const tinygltf::Node& node = still.gltf->model.nodes[static_cast<size_t>(part.node)];
    EXPECT_TRUE(node.rotation.empty() && node.translation.empty() && node.matrix.empty());
    const tinygltf::Primitive& primitive =
        still.gltf->model.meshes[static_cast<size_t>(node.mesh)].primitives[static_cast<size_t>(part.primitive)];
    const std::vector<float> texels = accessor_floats("", still.gltf->model, primitive.attributes.at("TEXCOORD_1"), 2);
    for (size_t v = 0; v < part.vertex_of.size(); ++v, ++vertex) {
      EXPECT_EQ(texels[2 * v], numbered(48)[vertex][0]);
      EXPECT_EQ(texels[2 * v + 1], numbered(48)[vertex][1]);
      const Vec3 &a = still.vertices[part.vertex_of[v]], &b = character.vertices[mesh.vertices()[vertex]];
      EXPECT_EQ(a.x, b.x);
      EXPECT_EQ(a.y, b.y);
      EXPECT_EQ(a.z, b.z);
    }
  }
  EXPECT_EQ(still.face_count(), character.face_count());
}

TEST(StillMesh, MaterialsKeepTheirTexturesAndNothingElseIsLeft) {
  const TempFolder folder;
  const Character character = read_gltf(folder.write("in.glb", shown_twice().glb()));
  const StillMesh mesh("in.glb", character);
  const std::vector<uint8_t> glb = mesh.glb(rest_positions(mesh, character), mesh.normals(), numbered(48));
  const nlohmann::json document = json_of_glb(std::string(glb.begin(), glb.end()));
  for (const char* gone : {"skins", "animations", "extensions"}) EXPECT_FALSE(document.contains(gone)) << gone;
  EXPECT_EQ(document["extensionsUsed"], nlohmann::json::array({"KHR_texture_transform"}));
  const nlohmann::json& attributes = document["meshes"][0]["primitives"][0]["attributes"];
  EXPECT_TRUE(attributes.contains("TEXCOORD_0"));
  EXPECT_TRUE(attributes.contains("TEXCOORD_2"));  // was 1
  for (const char* gone : {"JOINTS_0", "WEIGHTS_0", "TANGENT"}) EXPECT_FALSE(attributes.contains(gone)) << gone;
  const nlohmann::json& material = document["materials"][0];
  EXPECT_EQ(material["occlusionTexture"]["texCoord"], 2);
  EXPECT_FALSE(material["emissiveTexture"].contains("texCoord"));
  EXPECT_EQ(material["emissiveTexture"]["extensions"]["KHR_texture_transform"]["texCoord"], 2);
  // Nothing is left of joints and weights: TEXCOORD_0, _2, indices, and three new accessors of each of four primitives.
  EXPECT_EQ(document["accessors"].size(), 3u + 4 * 3);
}

TEST(StillMesh, AMeshFromTextHasTheVerticesThatItsGlbHas) {
  const TempFolder folder;
  const Character character = read_obj(folder.write(
      "in.obj",
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nusemtl red\nf 1/1 2/2 3/1\nusemtl green\nf 1/1 3/2 4/2\n"));
  const StillMesh mesh("in.obj", character);
  EXPECT_EQ(mesh.vertices(), (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
  for (const Vec3& normal : mesh.normals()) EXPECT_EQ(normal.z, 1);
  const std::vector<uint8_t> glb = mesh.glb(rest_positions(mesh, character), mesh.normals(), numbered(6));
  const Character still = read_gltf(folder.write("still.glb", std::string(glb.begin(), glb.end())));
  const tinygltf::Primitive& primitive = still.gltf->model.meshes[0].primitives[0];
  EXPECT_NE(primitive.attributes.at("TEXCOORD_0"), primitive.attributes.at("TEXCOORD_1"));
  EXPECT_EQ(still.material_names, (std::vector<std::string>{"red", "green"}));
  EXPECT_EQ(still.face_count(), 2u);
}

TEST(StillMesh, AMeshWithoutTextureCoordinatesHasNoGapBeforeTheTexels) {
  const TempFolder folder;
  const Character character = read_obj(folder.write("in.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"));
  const StillMesh mesh("in.obj", character);
  const std::vector<uint8_t> glb = mesh.glb(rest_positions(mesh, character), mesh.normals(), numbered(3));
  const nlohmann::json document = json_of_glb(std::string(glb.begin(), glb.end()));
  const nlohmann::json& attributes = document["meshes"][0]["primitives"][0]["attributes"];
  EXPECT_EQ(attributes["TEXCOORD_0"], attributes["TEXCOORD_1"]);
}

TEST(StillMesh, AMeshWithoutFacesIsRefused) {
  Character character;
  character.vertices = {{0, 0, 0}};
  EXPECT_ERROR(StillMesh("in.obj", character), "in.obj", "without faces");
}

}  // namespace
}  // namespace sinew
