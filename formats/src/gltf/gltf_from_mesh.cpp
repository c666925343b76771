// SPDX-License-Identifier: MIT
// A glTF document for a mesh that has none (an OBJ): a node per object, vertices split where UVs or normals differ, one
// primitive per material.
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <unordered_map>

#include "files/picture_files.hpp"
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

// COLOR_0 in 16 bits: linear light has its steps where eyes see them least.
int add_colors(tinygltf::Model* model, const Character& character, const SplitPrimitive& split) {
  std::vector<uint16_t> values;
  for (const SplitVertex& v : split.vertices) {
    for (const float channel : character.vertex_colors[v.vertex])
      values.push_back(static_cast<uint16_t>(std::lround(channel * 65535.0f)));
    values.push_back(65535);
  }
  tinygltf::Accessor accessor;
  accessor.bufferView = add_view(model, values.data(), values.size() * 2, TINYGLTF_TARGET_ARRAY_BUFFER);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  accessor.normalized = true;
  accessor.type = TINYGLTF_TYPE_VEC4;
  accessor.count = split.vertices.size();
  model->accessors.push_back(std::move(accessor));
  return static_cast<int>(model->accessors.size()) - 1;
}

// Materials of a document being made, each picture in it once.
class Materials {
 public:
  Materials(const Character& character, tinygltf::Model* model) : character_(character), model_(*model) {}

  int number_of(int material) {
    if (material < 0 || static_cast<size_t>(material) >= character_.material_names.size()) return -1;
    const auto [at, is_new] = numbers_.try_emplace(material, static_cast<int>(model_.materials.size()));
    if (!is_new) return at->second;
    tinygltf::Material made;
    made.name = character_.material_names[static_cast<size_t>(material)];
    made.pbrMetallicRoughness.metallicFactor = 0;
    made.pbrMetallicRoughness.roughnessFactor = 0.9;
    if (character_.materials.size() == character_.material_names.size())
      describe(character_.materials[static_cast<size_t>(material)], &made);
    model_.materials.push_back(std::move(made));
    return at->second;
  }

 private:
  void describe(const Material& material, tinygltf::Material* made) {
    made->pbrMetallicRoughness.baseColorFactor.assign(material.base_color.begin(), material.base_color.end());
    made->emissiveFactor.assign(material.emissive.begin(), material.emissive.end());
    if (material.base_color[3] < 1) made->alphaMode = "BLEND";
    if (material.cut_out) made->alphaMode = "MASK";  // at alphaCutoff's 0.5
    if (material.unlit) {
      made->extensions["KHR_materials_unlit"] = tinygltf::Value(tinygltf::Value::Object());
      if (model_.extensionsUsed.empty()) model_.extensionsUsed.push_back("KHR_materials_unlit");
    }
    made->pbrMetallicRoughness.baseColorTexture.index = texture_of(material.base_color_texture);
    made->normalTexture.index = texture_of(material.normal_texture);
  }

  int texture_of(const Picture& picture) {
    if (!picture) return -1;
    const auto [at, is_new] = textures_.try_emplace(picture.get(), static_cast<int>(model_.textures.size()));
    if (!is_new) return at->second;
    tinygltf::Image image;
    image.mimeType = png_or_jpeg(picture->data(), picture->size());
    image.bufferView = add_view(&model_, picture->data(), picture->size(), 0);
    tinygltf::Texture texture;
    texture.source = static_cast<int>(model_.images.size());
    model_.images.push_back(std::move(image));
    model_.textures.push_back(std::move(texture));
    return at->second;
  }

  const Character& character_;
  tinygltf::Model& model_;
  std::map<int, int> numbers_;
  std::map<const void*, int> textures_;
};

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
  if (character.vertex_colors.size() == character.vertices.size())
    primitive.attributes["COLOR_0"] = add_colors(model, character, split);

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

  std::map<int, std::map<int, SplitPrimitive>> objects;  // by object and material; -1 = none
  const auto number_at = [face_count](const std::vector<int>& of, size_t f) {
    return of.size() == face_count ? of[f] : -1;
  };
  for (size_t f = 0; f < face_count; ++f) {
    SplitPrimitive& split = objects[number_at(character.face_objects, f)][number_at(character.face_materials, f)];
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
  tinygltf::Scene scene;
  GltfSource parts;
  Materials materials(character, &model);
  for (const auto& [object, primitives] : objects) {
    tinygltf::Mesh mesh;
    const bool named = object >= 0 && static_cast<size_t>(object) < character.object_names.size();
    mesh.name = named ? character.object_names[static_cast<size_t>(object)] : character.name;
    const int node_number = static_cast<int>(model.nodes.size());
    for (const auto& [material, split] : primitives) {
      GltfPart part{node_number, static_cast<int>(mesh.primitives.size()), {}};
      for (const SplitVertex& v : split.vertices) part.vertex_of.push_back(v.vertex);
      parts.parts.push_back(std::move(part));
      mesh.primitives.push_back(add_primitive(&model, character, split, has_uvs, materials.number_of(material)));
    }
    tinygltf::Node node;
    node.name = mesh.name;
    node.mesh = static_cast<int>(model.meshes.size());
    model.meshes.push_back(std::move(mesh));
    model.nodes.push_back(std::move(node));
    scene.nodes.push_back(node_number);
  }
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
