// SPDX-License-Identifier: MIT
// Compressed documents: the same character as from the plain file, written back plain; broken data is refused.
#include "gltf/gltf_decompress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "expect_error.hpp"
#include "glb_round.hpp"
#ifdef SINEW_HAS_MESHOPT
#include "meshopt_glb.hpp"
#endif
#ifdef SINEW_HAS_DRACO
#include "draco_glb.hpp"
#endif

namespace sinew {
namespace {

using nlohmann::json;

// Corners of a face may be turned in a ring: encoders do that.
std::vector<std::array<uint32_t, 3>> turned_faces(const Character& c) {
  std::vector<std::array<uint32_t, 3>> faces;
  for (size_t f = 0; f < c.face_count(); ++f) {
    std::array<uint32_t, 3> face = {c.face_vertices[f * 3], c.face_vertices[f * 3 + 1], c.face_vertices[f * 3 + 2]};
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back(face);
  }
  return faces;
}

void expect_same(const Character& a, const Character& b, double tolerance = 0) {
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (size_t v = 0; v < a.vertices.size(); ++v) {
    EXPECT_NEAR(a.vertices[v].x, b.vertices[v].x, tolerance);
    EXPECT_NEAR(a.vertices[v].y, b.vertices[v].y, tolerance);
    EXPECT_NEAR(a.vertices[v].z, b.vertices[v].z, tolerance);
    for (const auto& [joint, weight] : row(b, v)) EXPECT_NEAR(row(a, v)[joint], weight, 2e-5) << v;
  }
  EXPECT_EQ(turned_faces(a), turned_faces(b));
}

// The reader's promise to the writer: nothing of the extension is left.
void expect_written_plain(const Character& c, const char* extension, size_t view_count) {
  const std::string glb = written(c);
  const json out = json_of_glb(glb);
  EXPECT_EQ(out.dump().find(extension), std::string::npos);
  EXPECT_FALSE(out.contains("extensionsRequired"));
  EXPECT_EQ(out["buffers"].size(), 1u);
  EXPECT_EQ(out["bufferViews"].size(), view_count);
  expect_same(reread(glb), c, 1e-6);
}

TEST(GltfDecompress, APlainFileThatOnlySpeaksOfCompressionIsPlain) {
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][0]["name"] = "KHR_draco_mesh_compression";
  EXPECT_TRUE(read(builder).notes.empty());
}

TEST(GltfDecompress, ValuesBesideDracoAreTaken) {
  GlbBuilder builder = two_joint_strip();
  builder.document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  builder.document["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", builder.view(std::vector<char>(16, 'x'))}, {"attributes", {{"POSITION", 0}}}};
  expect_same(read(builder), read(two_joint_strip()));
}

#ifdef SINEW_HAS_MESHOPT

TEST(GltfDecompress, MeshoptIsReadAndWrittenPlain) {
  const GlbBuilder plain = two_joint_strip(true);
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    const Character c = read(meshopt_packed(plain, name));
    expect_same(c, read(plain));
    ASSERT_EQ(c.notes.size(), 1u);
    EXPECT_NE(c.notes[0].find(std::string(name) + ": decompressed"), std::string::npos) << c.notes[0];
    expect_written_plain(c, "meshopt", plain.document["bufferViews"].size());
  }
}

TEST(GltfDecompress, MeshoptFiltersAndIndexSequences) {
  GlbBuilder plain = two_joint_strip();
  GlbBuilder packed = meshopt_packed(plain);
  const auto repack = [&](size_t accessor, std::vector<unsigned char> bytes, json fields) {
    json& view = packed.document["bufferViews"][packed.document["accessors"][accessor]["bufferView"].get<size_t>()];
    json& extension = view["extensions"]["EXT_meshopt_compression"];
    packed.bytes.resize((packed.bytes.size() + 3) / 4 * 4);
    extension["byteOffset"] = packed.bytes.size();
    extension["byteLength"] = bytes.size();
    extension.update(fields);
    packed.bytes.append(bytes.begin(), bytes.end());
  };
  const json primitive = plain.document["meshes"][0]["primitives"][0];
  // Positions as exponents, normals as octahedra in 8 bits, indices as a sequence.
  std::vector<float> positions(30), normals(40, 0);
  std::memcpy(positions.data(), plain.bytes.data(), 120);
  for (size_t v = 0; v < 10; ++v) normals[v * 4] = 1;  // other than in the plain file: along x
  std::vector<unsigned char> exponents(120), octahedra(40);
  meshopt_encodeFilterExp(exponents.data(), 10, 12, 15, positions.data());
  meshopt_encodeFilterOct(octahedra.data(), 10, 4, 8, normals.data());
  std::vector<unsigned char> out(meshopt_encodeVertexBufferBound(10, 12));
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), exponents.data(), 10, 12));
  repack(primitive["attributes"]["POSITION"], out, {{"filter", "EXPONENTIAL"}});
  out.resize(meshopt_encodeVertexBufferBound(10, 4));
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), octahedra.data(), 10, 4));
  const size_t normal = primitive["attributes"]["NORMAL"];
  repack(normal, out, {{"filter", "OCTAHEDRAL"}, {"byteStride", 4}});
  packed.document["accessors"][normal]["componentType"] = 5120;
  packed.document["accessors"][normal]["normalized"] = true;
  packed.document["bufferViews"][packed.document["accessors"][normal]["bufferView"].get<size_t>()]["byteStride"] = 4;
  const size_t indices = primitive["indices"];
  const json& view = plain.document["bufferViews"][plain.document["accessors"][indices]["bufferView"].get<size_t>()];
  std::vector<uint16_t> corners(24);
  std::memcpy(corners.data(), plain.bytes.data() + view["byteOffset"].get<size_t>(), 48);
  const std::vector<unsigned int> wide(corners.begin(), corners.end());
  out.resize(meshopt_encodeIndexSequenceBound(24, 10));
  out.resize(meshopt_encodeIndexSequence(out.data(), out.size(), wide.data(), 24));
  repack(indices, out, {{"mode", "INDICES"}});
  const Character c = read(packed);
  expect_same(c, read(plain), 1e-3);
  EXPECT_NEAR(c.corner_normals[0].x, 1, 0.02);
}

TEST(GltfDecompress, BrokenMeshoptIsOneLine) {
  const GlbBuilder whole = meshopt_packed(two_joint_strip());
  const auto with = [&](const char* field, const json& value) {
    GlbBuilder builder = whole;
    builder.document["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][field] = value;
    return builder;
  };
  EXPECT_ERROR(read(with("byteStride", 6)), "cat.glb: buffer view 0", "byteStride of 4, 8", "found 6");
  EXPECT_ERROR(read(with("byteStride", 0)), "found 0");
  EXPECT_ERROR(read(with("count", 0)), "count of elements");
  EXPECT_ERROR(read(with("count", 4000000000u)), "count of elements", "found 4000000000");
  EXPECT_ERROR(read(with("count", -1)), "count of elements");
  EXPECT_ERROR(read(with("count", 100)), "broken data");
  EXPECT_ERROR(read(with("mode", "LINES")), "ATTRIBUTES, TRIANGLES or INDICES", "'LINES'");
  EXPECT_ERROR(read(with("filter", "BLUR")), "OCTAHEDRAL", "'BLUR'");
  EXPECT_ERROR(read(with("filter", "OCTAHEDRAL")), "4 or 8", "found 12");
  EXPECT_ERROR(read(with("filter", "QUATERNION")), "byteStride of 8");
  EXPECT_ERROR(read(with("byteLength", 1 << 20)), "inside of buffer 0");
  EXPECT_ERROR(read(with("buffer", 7)), "buffer below 2", "found 7");
  EXPECT_ERROR(read(with("mode", 3)), "fields of compressed glTF");
  EXPECT_ERROR(read(with("mode", "TRIANGLES")), "byteStride of 2 or 4");
  GlbBuilder other = whole;
  other.bytes[0] = static_cast<char>(0xaf);  // a version to come
  EXPECT_ERROR(read(other), "version");
  other = whole;
  other.document["bufferViews"][0].erase("extensions");  // the fallback has no bytes
  EXPECT_ERROR(read(other), "buffer view 0", "inside of buffer 1 of 0 bytes");
  other = whole;
  other.document["buffers"][0].erase("extensions");
  EXPECT_ERROR(read(other), "buffer 1", "expected a uri");
}

#else

TEST(GltfDecompress, WithoutMeshoptimizerTheLineSaysWhatToInstall) {
  GlbBuilder builder = two_joint_strip();
  builder.document["extensionsUsed"] = {"EXT_meshopt_compression"};
  json& view = builder.document["bufferViews"][0];
  view["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
  EXPECT_TRUE(read(builder).gltf != nullptr);  // the plain bytes are there
  view["buffer"] = 1;
  builder.document["buffers"] = {
      {{"byteLength", 120}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  EXPECT_ERROR(read(builder), "EXT_meshopt_compression", "libmeshoptimizer-dev");
}

#endif
#ifdef SINEW_HAS_DRACO

TEST(GltfDecompress, DracoIsReadAndWrittenPlain) {
  const GlbBuilder plain = two_joint_strip(true);
  const Character c = read(draco_packed(plain));
  expect_same(c, read(plain));
  EXPECT_EQ(c.corner_uvs, read(plain).corner_uvs);
  ASSERT_EQ(c.notes.size(), 1u);
  EXPECT_NE(c.notes[0].find("KHR_draco_mesh_compression: decompressed"), std::string::npos) << c.notes[0];
  expect_written_plain(c, "draco", plain.document["bufferViews"].size());
}

TEST(GltfDecompress, DracoInAnotherOrderAndRounded) {
  GlbBuilder plain = two_joint_strip(true);
  plain.document["meshes"][0]["primitives"].push_back(plain.document["meshes"][0]["primitives"][0]);  // shared vertices
  GlbBuilder packed = draco_packed(two_joint_strip(true), false);
  json& primitives = packed.document["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  const Character c = read(packed), expected = read(plain);
  ASSERT_EQ(c.vertices.size(), expected.vertices.size());
  EXPECT_EQ(c.face_count(), expected.face_count());
  const auto heights = [](const Character& of) {
    std::vector<float> all;
    for (const Vec3& p : of.vertices) all.push_back(p.y);
    std::sort(all.begin(), all.end());
    return all;
  };
  for (size_t v = 0; v < c.vertices.size(); ++v) EXPECT_NEAR(heights(c)[v], heights(expected)[v], 1e-3);
}

TEST(GltfDecompress, BrokenDracoIsOneLine) {
  const GlbBuilder whole = draco_packed(two_joint_strip());
  const auto extension = [](GlbBuilder* of) -> json& {
    return of->document["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
  };
  GlbBuilder other = whole;
  extension(&other)["bufferView"] = 90;
  EXPECT_ERROR(read(other), "mesh 0, primitive 0", "buffer view below", "found 90");
  other = whole;
  extension(&other)["attributes"]["NORMAL"] = 77;
  EXPECT_ERROR(read(other), "attribute 77 for NORMAL");
  other = whole;
  extension(&other).erase("attributes");
  EXPECT_ERROR(read(other), "fields of compressed glTF");
  other = whole;
  other.document["accessors"][0]["count"] = 9;
  EXPECT_ERROR(read(other), "9 values of POSITION", "found 10");
  other = whole;
  const json& view = other.document["bufferViews"][extension(&other)["bufferView"].get<size_t>()];
  const size_t first = view["byteOffset"].get<size_t>(), length = view["byteLength"].get<size_t>();
  for (size_t cut = 0; cut < length; cut += 7) {
    GlbBuilder shorter = whole;
    shorter.document["bufferViews"][extension(&shorter)["bufferView"].get<size_t>()]["byteLength"] = cut;
    EXPECT_ERROR(read(shorter), "KHR_draco_mesh_compression");
  }
  for (size_t at = 0; at < length; ++at) {  // an error or a character, never more
    other = whole;
    other.bytes[first + at] = static_cast<char>(other.bytes[first + at] ^ (1 << at % 8));
    try {
      (void)read(other);
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

#else

TEST(GltfDecompress, WithoutDracoTheLineSaysWhatToInstall) {
  GlbBuilder builder = two_joint_strip();
  builder.document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  builder.document["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", builder.view(std::vector<char>(16, 'x'))}, {"attributes", {{"POSITION", 0}}}};
  builder.document["accessors"][0].erase("bufferView");
  EXPECT_ERROR(read(builder), "KHR_draco_mesh_compression", "libdraco-dev");
}

#endif

// Positions in steps of 1/1000 as int16, normals and UVs in normalized integers. `node` or the bind matrices scale back.
GlbBuilder quantized(bool skinned) {
  GlbBuilder builder = two_joint_strip();
  json& attributes = builder.document["meshes"][0]["primitives"][0]["attributes"];
  std::vector<int16_t> positions;
  std::vector<int8_t> normals;
  std::vector<uint16_t> uvs;
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 2; ++x) {
      for (const int value : {x * 1000, y * 1000, 0, 0}) positions.push_back(static_cast<int16_t>(value));
      for (const int value : {0, 0, 127, 0}) normals.push_back(static_cast<int8_t>(value));
      for (const double value : {x * 1.0, y / 4.0}) uvs.push_back(static_cast<uint16_t>(std::lround(value * 65535)));
    }
  const auto strided = [&](int accessor, int stride) {
    json& made = builder.document["accessors"][static_cast<size_t>(accessor)];
    builder.document["bufferViews"][made["bufferView"].get<size_t>()]["byteStride"] = stride;
    made["type"] = "VEC3";
    return accessor;
  };
  const int position = strided(builder.accessor(positions, "VEC4"), 8);
  builder.document["accessors"][static_cast<size_t>(position)]["min"] = {0, 0, 0};
  builder.document["accessors"][static_cast<size_t>(position)]["max"] = {1000, 4000, 0};
  attributes["POSITION"] = position;
  attributes["NORMAL"] = strided(builder.accessor(normals, "VEC4", true), 4);
  attributes["TEXCOORD_0"] = builder.accessor(uvs, "VEC2", true);
  builder.document["extensionsUsed"] = builder.document["extensionsRequired"] = {"KHR_mesh_quantization"};
  if (skinned) {
    std::vector<float> binds(32, 0);
    for (size_t j = 0; j < 2; ++j)
      for (size_t d = 0; d < 4; ++d) binds[j * 16 + d * 5] = d < 3 ? 0.001f : 1;
    binds[16 + 13] = -2;
    builder.document["skins"][0]["inverseBindMatrices"] = builder.accessor(binds, "MAT4");
  } else {
    builder.document["nodes"][2] = {{"mesh", 0}, {"scale", {0.001, 0.001, 0.001}}, {"translation", {10, 0, 0}}};
    attributes.erase("JOINTS_0");
    attributes.erase("WEIGHTS_0");
  }
  return builder;
}

TEST(GltfRead, QuantizedAttributesReadAsTheirFloatsAndStayQuantized) {
  const Character plain = read(two_joint_strip());
  for (const bool skinned : {true, false}) {
    Character c = read(quantized(skinned));
    ASSERT_EQ(c.vertices.size(), plain.vertices.size());
    for (size_t v = 0; v < c.vertices.size(); ++v) {
      EXPECT_NEAR(c.vertices[v].x, plain.vertices[v].x, 1e-6);
      EXPECT_NEAR(c.vertices[v].y, plain.vertices[v].y, 1e-6);
    }
    for (size_t i = 0; i < c.corner_uvs.size(); ++i) EXPECT_NEAR(c.corner_uvs[i][1], plain.corner_uvs[i][1], 1e-4);
    EXPECT_NEAR(c.corner_normals[0].z, 1, 1e-6);
    c.influences.assign(c.vertices.size(), {{0, 0.75f}, {1, 0.25f}});
    const std::string glb = written(c);
    const json out = json_of_glb(glb);
    EXPECT_EQ(out["extensionsRequired"], json::array({"KHR_mesh_quantization"}));
    const json& position = out["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
    EXPECT_EQ(out["accessors"][position.get<size_t>()]["componentType"], 5122);
    const Character again = reread(glb);
    for (size_t v = 0; v < c.vertices.size(); ++v) {
      EXPECT_NEAR(again.vertices[v].x, plain.vertices[v].x, 1e-5);
      EXPECT_NEAR(again.vertices[v].y, plain.vertices[v].y, 1e-5);
    }
  }
}

}  // namespace
}  // namespace sinew
