// SPDX-License-Identifier: MIT
// A glTF document for a mesh that has none (an OBJ): vertices split where UVs or normals differ, one primitive per
// material.
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <unordered_map>

#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

std::array<double, 3> face_normal_x2(const Character& character, size_t face) {
  std::array<double, 3> sum{};  // Newell: works for polygons that are not flat
  const size_t first = character.face_offsets[face], last = character.face_offsets[face + 1];
  for (size_t c = first; c < last; ++c) {
    const Vec3& a = character.vertices[character.face_vertices[c]];
    const Vec3& b = character.vertices[character.face_vertices[c + 1 < last ? c + 1 : first]];
    const double ax = static_cast<double>(a.x), ay = static_cast<double>(a.y), az = static_cast<double>(a.z);
    const double bx = static_cast<double>(b.x), by = static_cast<double>(b.y), bz = static_cast<double>(b.z);
    sum[0] += (ay - by) * (az + bz);
    sum[1] += (az - bz) * (ax + bx);
    sum[2] += (ax - bx) * (ay + by);
  }
  return sum;
}

// nullopt-free: a direction without length becomes +Y, because glTF demands unit normals.
Vec3 unit_or_up(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  if (!(length > 1e-30) || !std::isfinite(length)) return {0, 1, 0};
  return {static_cast<float>(x / length), static_cast<float>(y / length), static_cast<float>(z / length)};
}

// Area-weighted; the fallback for corners without a normal.
std::vector<Vec3> smooth_normals(const Character& character) {
  std::vector<std::array<double, 3>> sums(character.vertices.size(), std::array<double, 3>{});
  for (size_t f = 0; f < character.face_count(); ++f) {
    const std::array<double, 3> normal = face_normal_x2(character, f);
    for (size_t c = character.face_offsets[f]; c < character.face_offsets[f + 1]; ++c)
      for (size_t axis = 0; axis < 3; ++axis) sums[character.face_vertices[c]][axis] += normal[axis];
  }
  std::vector<Vec3> normals;
  for (const auto& sum : sums) normals.push_back(unit_or_up(sum[0], sum[1], sum[2]));
  return normals;
}

struct SplitVertex {
  uint32_t vertex;
  std::array<float, 5> uv_normal;
  bool operator==(const SplitVertex& other) const { return vertex == other.vertex && uv_normal == other.uv_normal; }
};
struct HashSplitVertex {
  size_t operator()(const SplitVertex& v) const {
    uint64_t hash = v.vertex * 0x9e3779b97f4a7c15ull;
    for (const float value : v.uv_normal) hash = (hash ^ std::hash<float>()(value)) * 0x100000001b3ull;
    return static_cast<size_t>(hash);
  }
};

struct SplitPrimitive {
  std::unordered_map<SplitVertex, uint32_t, HashSplitVertex> numbers;
  std::vector<SplitVertex> vertices;
  std::vector<uint32_t> indices;
};

int add_view(tinygltf::Model* model, const void* bytes, size_t size, int target) {
  std::vector<unsigned char>& data = model->buffers[0].data;
  data.resize((data.size() + 3) / 4 * 4);
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = size;
  view.target = target;
  const unsigned char* first = static_cast<const unsigned char*>(bytes);
  data.insert(data.end(), first, first + size);
  model->bufferViews.push_back(std::move(view));
  return static_cast<int>(model->bufferViews.size()) - 1;
}

int add_floats(tinygltf::Model* model, const std::vector<float>& values, int components, bool with_bounds) {
  tinygltf::Accessor accessor;
  accessor.bufferView = add_view(model, values.data(), values.size() * sizeof(float), TINYGLTF_TARGET_ARRAY_BUFFER);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  accessor.type = components == 3 ? TINYGLTF_TYPE_VEC3 : TINYGLTF_TYPE_VEC2;
  const size_t width = static_cast<size_t>(components);
  accessor.count = values.size() / width;
  if (with_bounds) {
    accessor.minValues.assign(values.begin(), values.begin() + components);
    accessor.maxValues = accessor.minValues;
    for (size_t i = 0; i < values.size(); ++i) {
      accessor.minValues[i % width] = std::min(accessor.minValues[i % width], static_cast<double>(values[i]));
      accessor.maxValues[i % width] = std::max(accessor.maxValues[i % width], static_cast<double>(values[i]));
    }
  }
  model->accessors.push_back(std::move(accessor));
  return static_cast<int>(model->accessors.size()) - 1;
}

tinygltf::Primitive add_primitive(tinygltf::Model* model, const Character& character, const SplitPrimitive& split,
                                  bool has_uvs, int material) {
  std::vector<float> positions, normals, uvs;
  for (const SplitVertex& v : split.vertices) {
    const Vec3& p = character.vertices[v.vertex];
    positions.insert(positions.end(), {p.x, p.y, p.z});
    uvs.insert(uvs.end(), {v.uv_normal[0], 1 - v.uv_normal[1]});  // glTF's v runs down
    normals.insert(normals.end(), {v.uv_normal[2], v.uv_normal[3], v.uv_normal[4]});
  }
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = material;
  primitive.attributes["POSITION"] = add_floats(model, positions, 3, true);
  primitive.attributes["NORMAL"] = add_floats(model, normals, 3, false);
  if (has_uvs) primitive.attributes["TEXCOORD_0"] = add_floats(model, uvs, 2, false);

  tinygltf::Accessor accessor;
  if (split.vertices.size() < 65535) {
    const std::vector<uint16_t> small(split.indices.begin(), split.indices.end());
    accessor.bufferView = add_view(model, small.data(), small.size() * 2, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  } else {
    accessor.bufferView =
        add_view(model, split.indices.data(), split.indices.size() * 4, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  }
  accessor.type = TINYGLTF_TYPE_SCALAR;
  accessor.count = split.indices.size();
  model->accessors.push_back(std::move(accessor));
  primitive.indices = static_cast<int>(model->accessors.size()) - 1;
  return primitive;
}

}  // namespace

GltfSource gltf_from_mesh(const std::string& path, const Character& character) {
  const size_t face_count = character.face_count(), corner_count = character.face_vertices.size();
  if (face_count == 0) throw Error(path + ": cannot write a GLB of a mesh without faces");
  const bool has_uvs = character.corner_uvs.size() == corner_count,
             has_normals = character.corner_normals.size() == corner_count;
  const std::vector<Vec3> smooth = smooth_normals(character);

  std::map<int, SplitPrimitive> primitives;  // by material; -1 = none
  for (size_t f = 0; f < face_count; ++f) {
    SplitPrimitive& split =
        primitives[character.face_materials.size() == face_count ? character.face_materials[f] : -1];
    std::vector<uint32_t> corners;
    for (size_t c = character.face_offsets[f]; c < character.face_offsets[f + 1]; ++c) {
      SplitVertex v{character.face_vertices[c], {}};
      if (has_uvs) v.uv_normal[0] = character.corner_uvs[c][0], v.uv_normal[1] = character.corner_uvs[c][1];
      Vec3 normal = smooth[v.vertex];
      if (has_normals) {
        const Vec3& given = character.corner_normals[c];
        if (given.x != 0 || given.y != 0 || given.z != 0)
          normal = unit_or_up(static_cast<double>(given.x), static_cast<double>(given.y), static_cast<double>(given.z));
      }
      v.uv_normal[2] = normal.x, v.uv_normal[3] = normal.y, v.uv_normal[4] = normal.z;
      const auto [at, is_new] = split.numbers.emplace(v, static_cast<uint32_t>(split.vertices.size()));
      if (is_new) split.vertices.push_back(v);
      corners.push_back(at->second);
    }
    for (size_t c = 2; c < corners.size(); ++c)
      split.indices.insert(split.indices.end(), {corners[0], corners[c - 1], corners[c]});
  }

  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "sinew";
  model.buffers.emplace_back();
  tinygltf::Mesh mesh;
  mesh.name = character.name;
  GltfSource parts;
  for (const auto& [material, split] : primitives) {
    int number = -1;
    if (material >= 0 && static_cast<size_t>(material) < character.material_names.size()) {
      tinygltf::Material made;
      made.name = character.material_names[static_cast<size_t>(material)];
      made.pbrMetallicRoughness.metallicFactor = 0;
      made.pbrMetallicRoughness.roughnessFactor = 0.9;
      number = static_cast<int>(model.materials.size());
      model.materials.push_back(std::move(made));
    }
    GltfPart part{0, static_cast<int>(mesh.primitives.size()), {}};
    for (const SplitVertex& v : split.vertices) part.vertex_of.push_back(v.vertex);
    parts.parts.push_back(std::move(part));
    mesh.primitives.push_back(add_primitive(&model, character, split, has_uvs, number));
  }
  model.meshes.push_back(std::move(mesh));
  tinygltf::Node node;
  node.name = character.name;
  node.mesh = 0;
  model.nodes.push_back(std::move(node));
  tinygltf::Scene scene;
  scene.nodes = {0};
  model.scenes.push_back(std::move(scene));
  model.defaultScene = 0;

  std::ostringstream stream;
  tinygltf::TinyGLTF writer;
  try {
    if (!writer.WriteGltfSceneToStream(&model, stream, false, true)) throw Error("no reason given");
  } catch (const std::exception& error) {  // names that are not UTF-8
    throw Error(path + ": cannot write a GLB: " + one_line(error.what()));
  }
  const std::string glb = stream.str();
  GltfSource source = load_gltf(path, {glb.begin(), glb.end()});
  source.parts = std::move(parts.parts);
  source.bind_pose.worlds = gltf_nodes(path, source.model).worlds;
  source.vertex_count = character.vertices.size();
  return source;
}

}  // namespace sinew
