// SPDX-License-Identifier: MIT
// Meshes: control points are vertices that agree in place, weights and shapes; normals, texture coordinates and colours are their corners'.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "fbx/fbx_scene.hpp"
#include "gltf/primitive_triangles.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

class Geometry {
 public:
  Geometry(const std::string& whose, const tinygltf::Model& model, size_t node)
      : model_(model), node_(model.nodes[node]), mesh_(model.meshes[static_cast<size_t>(node_.mesh)]) {
    where_ = whose + ": mesh " + in_quotes(mesh_.name);
    for (const tinygltf::Primitive& primitive : mesh_.primitives) {
      has_normals_ = has_normals_ && primitive.attributes.count("NORMAL") != 0;
      has_uvs_ = has_uvs_ && primitive.attributes.count("TEXCOORD_0") != 0;
      has_colours_ = has_colours_ && primitive.attributes.count("COLOR_0") != 0;
      shapes_.resize(std::max(shapes_.size(), primitive.targets.size()));
    }
    for (const tinygltf::Primitive& primitive : mesh_.primitives) read(primitive);
  }

  int64_t write(const Affine& frame, const std::vector<int64_t>& clusters, FbxScene* scene, std::vector<int>* materials,
                std::vector<int64_t>* channels) {
    if (corners_.empty()) return 0;
    *materials = materials_;
    int64_t id = 0;
    FbxNode geometry = scene->object("Geometry", name(), "Geometry", "Mesh", &id);
    geometry.add("Properties70");
    geometry.add("GeometryVersion").integer(124);
    geometry.add("Vertices").numbers(scaled(positions_));
    geometry.add("PolygonVertexIndex").integers(corners_);
    add_layers(&geometry);
    scene->add("Geometry", std::move(geometry));
    if (!clusters.empty()) write_skin(id, frame, clusters, scene);
    if (!shapes_.empty()) write_shapes(id, scene, channels);
    return id;
  }

 private:
  struct Shape {
    std::vector<int32_t> points;
    std::vector<double> moves, normals;
  };

  std::string name() const { return mesh_.name.empty() ? node_.name : mesh_.name; }

  static std::vector<double> scaled(const std::vector<double>& values) {
    std::vector<double> out;
    for (const double value : values) out.push_back(kFbxUnits * value);
    return out;
  }

  std::vector<float> floats(const tinygltf::Primitive& primitive, const char* attribute, int width) const {
    return accessor_floats(where_ + ", " + attribute, model_, primitive.attributes.at(attribute), width);
  }

  std::vector<std::vector<float>> target_floats(const tinygltf::Primitive& primitive, const char* attribute) const {
    std::vector<std::vector<float>> all;
    for (const auto& target : primitive.targets)
      all.push_back(target.count(attribute) == 0 ? std::vector<float>()
                                                 : accessor_floats(where_ + ", " + attribute, model_, target.at(attribute), 3));
    return all;
  }

  // [vertices] joint of the skin and weight.
  std::vector<std::vector<Influence>> rows_of(const tinygltf::Primitive& primitive, size_t count) const {
    std::vector<std::vector<Influence>> rows(count);
    for (size_t set = 0; node_.skin >= 0; ++set) {
      const std::string joints = "JOINTS_" + std::to_string(set), weights = "WEIGHTS_" + std::to_string(set);
      if (primitive.attributes.count(joints) == 0 || primitive.attributes.count(weights) == 0) break;
      const std::vector<uint32_t> numbers = accessor_integers(where_ + ", " + joints, model_, primitive.attributes.at(joints), 4);
      const std::vector<float> values = floats(primitive, weights.c_str(), 4);
      for (size_t i = 0; i < std::min(values.size(), 4 * count); ++i)
        if (values[i] > 0) rows[i / 4].push_back({numbers[i], values[i]});
    }
    return rows;
  }

  void read(const tinygltf::Primitive& primitive) {
    if (primitive.attributes.count("POSITION") == 0) return;
    if (primitive.mode >= 0 && primitive.mode < TINYGLTF_MODE_TRIANGLES) return;  // points and lines
    const std::vector<float> positions = floats(primitive, "POSITION", 3);
    const size_t count = positions.size() / 3;
    const std::vector<std::vector<Influence>> rows = rows_of(primitive, count);
    const std::vector<std::vector<float>> moves = target_floats(primitive, "POSITION"), turns = target_floats(primitive, "NORMAL");
    std::vector<float> normals, uvs;
    if (has_normals_) normals = floats(primitive, "NORMAL", 3);
    if (has_uvs_) uvs = floats(primitive, "TEXCOORD_0", 2);
    const std::vector<float> colours = has_colours_ ? read_colours(primitive) : std::vector<float>();
    const auto known = std::find(materials_.begin(), materials_.end(), primitive.material);
    const int32_t material = static_cast<int32_t>(known - materials_.begin());
    if (known == materials_.end()) materials_.push_back(primitive.material);
    std::vector<int32_t> point_of(count, -1);
    for (const std::array<uint32_t, 3>& triangle : primitive_triangles(where_, model_, primitive, count)) {
      for (size_t c = 0; c < 3; ++c) {
        const size_t v = triangle[c];
        if (point_of[v] < 0) point_of[v] = point(v, positions, rows[v], moves, turns);
        corners_.push_back(c < 2 ? point_of[v] : ~point_of[v]);
        append(normals, v, 3, &normals_);
        if (has_uvs_) uvs_.push_back(static_cast<double>(uvs[2 * v])), uvs_.push_back(1 - static_cast<double>(uvs[2 * v + 1]));
        append(colours, v, 4, &colours_);
      }
      polygon_materials_.push_back(material);
    }
  }

  static void append(const std::vector<float>& from, size_t v, size_t width, std::vector<double>* to) {
    for (size_t i = 0; i < width && !from.empty(); ++i) to->push_back(static_cast<double>(from[width * v + i]));
  }

  std::vector<float> read_colours(const tinygltf::Primitive& primitive) const {
    const int accessor = primitive.attributes.at("COLOR_0");
    if (model_.accessors[static_cast<size_t>(accessor)].type == TINYGLTF_TYPE_VEC4) return floats(primitive, "COLOR_0", 4);
    std::vector<float> out;
    const std::vector<float> colours = floats(primitive, "COLOR_0", 3);
    for (size_t i = 0; i < colours.size(); ++i) {
      out.push_back(colours[i]);
      if (i % 3 == 2) out.push_back(1);
    }
    return out;
  }

  // The control point of a vertex.
  int32_t point(size_t v, const std::vector<float>& positions, const std::vector<Influence>& row,
                const std::vector<std::vector<float>>& moves, const std::vector<std::vector<float>>& turns) {
    std::string key;
    const auto add = [&key](const auto& value) { key.append(reinterpret_cast<const char*>(&value), sizeof value); };
    for (size_t i = 0; i < 3; ++i) add(positions[3 * v + i]);
    for (const Influence& one : row) add(one.joint), add(one.weight);
    for (const std::vector<float>& move : moves)
      for (size_t i = 0; i < 3 && !move.empty(); ++i) add(move[3 * v + i]);
    const auto [at, is_new] = points_.emplace(std::move(key), static_cast<int32_t>(rows_.size()));
    if (!is_new) return at->second;
    append(positions, v, 3, &positions_);
    rows_.push_back(row);
    for (size_t t = 0; t < moves.size(); ++t) {
      const std::vector<float>& move = moves[t];
      if (move.empty() || (move[3 * v] == 0 && move[3 * v + 1] == 0 && move[3 * v + 2] == 0)) continue;
      shapes_[t].points.push_back(at->second);
      append(move, v, 3, &shapes_[t].moves);
      if (turns[t].empty())
        shapes_[t].normals.insert(shapes_[t].normals.end(), 3, 0.0);
      else
        append(turns[t], v, 3, &shapes_[t].normals);
    }
    return at->second;
  }

  static FbxNode layer(const char* kind, const char* name, const char* mapping, const char* reference) {
    FbxNode element(kind);
    element.integer(0);
    element.add("Version").integer(101);
    element.add("Name").text(name);
    element.add("MappingInformationType").text(mapping);
    element.add("ReferenceInformationType").text(reference);
    return element;
  }

  void add_layers(FbxNode* geometry) const {
    FbxNode all("Layer");
    all.integer(0);
    all.add("Version").integer(100);
    const auto take = [&](const char* kind, FbxNode element) {
      geometry->add(std::move(element));
      FbxNode entry("LayerElement");
      entry.add("Type").text(kind);
      entry.add("TypedIndex").integer(0);
      all.add(std::move(entry));
    };
    if (has_normals_) {
      FbxNode element = layer("LayerElementNormal", "", "ByPolygonVertex", "Direct");
      element.add("Normals").numbers(normals_);
      take("LayerElementNormal", std::move(element));
    }
    const auto indexed = [&](const char* kind, const char* name, const char* values_name, const char* index_name,
                             const std::vector<double>& values, size_t width) {
      FbxNode element = layer(kind, name, "ByPolygonVertex", "IndexToDirect");
      std::vector<int32_t> indices(values.size() / width);
      for (size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<int32_t>(i);
      element.add(values_name).numbers(values);
      element.add(index_name).integers(indices);
      take(kind, std::move(element));
    };
    if (has_colours_) indexed("LayerElementColor", "Col", "Colors", "ColorIndex", colours_, 4);
    if (has_uvs_) indexed("LayerElementUV", "UVMap", "UV", "UVIndex", uvs_, 2);
    const bool one = materials_.size() < 2;
    FbxNode element = layer("LayerElementMaterial", "", one ? "AllSame" : "ByPolygon", "IndexToDirect");
    element.add("Materials").integers(one ? std::vector<int32_t>{0} : polygon_materials_);
    take("LayerElementMaterial", std::move(element));
    geometry->add(std::move(all));
  }

  // A cluster for each joint, also of those that hold nothing: they tell where it was bound.
  void write_skin(int64_t geometry, const Affine& frame, const std::vector<int64_t>& clusters, FbxScene* scene) const {
    const tinygltf::Skin& skin = model_.skins[static_cast<size_t>(node_.skin)];
    const std::vector<Affine> binds = inverse_bind_matrices(where_, model_, skin);
    std::vector<std::vector<int32_t>> points(clusters.size());
    std::vector<std::vector<double>> weights(clusters.size());
    for (size_t p = 0; p < rows_.size(); ++p)
      for (const Influence& one : rows_[p]) {
        if (one.joint >= clusters.size()) continue;
        points[one.joint].push_back(static_cast<int32_t>(p));
        weights[one.joint].push_back(static_cast<double>(one.weight));
      }
    int64_t id = 0;
    FbxNode deformer = scene->object("Deformer", name(), "Deformer", "Skin", &id);
    deformer.add("Version").integer(101);
    deformer.add("Link_DeformAcuracy").number(50);
    deformer.add("SkinningType").text("Linear");
    scene->add("Deformer", std::move(deformer));
    scene->connect(id, geometry);
    for (size_t k = 0; k < clusters.size(); ++k) {
      const std::optional<Affine> back = inverse(binds[k]);
      if (clusters[k] == 0 || !back) continue;
      int64_t cluster = 0;
      FbxNode link = scene->object("Deformer", model_.nodes[static_cast<size_t>(skin.joints[k])].name, "SubDeformer", "Cluster", &cluster);
      link.add("Version").integer(100);
      link.add("UserData").text("").text("");
      if (!points[k].empty()) {
        link.add("Indexes").integers(points[k]);
        link.add("Weights").numbers(weights[k]);
      }
      link.add("Transform").matrix(in_fbx_units(binds[k]));
      link.add("TransformLink").matrix(in_fbx_units(multiply(frame, *back)));
      scene->add("Deformer", std::move(link));
      scene->connect(cluster, id);
      scene->connect(clusters[k], cluster);
    }
  }

  std::string shape_name(size_t t) const {
    if (mesh_.extras.IsObject() && mesh_.extras.Has("targetNames")) {
      const tinygltf::Value& names = mesh_.extras.Get("targetNames");
      if (names.IsArray() && t < names.ArrayLen() && names.Get(static_cast<int>(t)).IsString())
        return names.Get(static_cast<int>(t)).Get<std::string>();
    }
    return "shape_" + std::to_string(t);
  }

  void write_shapes(int64_t geometry, FbxScene* scene, std::vector<int64_t>* channels) const {
    int64_t id = 0;
    FbxNode deformer = scene->object("Deformer", name(), "Deformer", "BlendShape", &id);
    deformer.add("Version").integer(100);
    scene->add("Deformer", std::move(deformer));
    scene->connect(id, geometry);
    for (size_t t = 0; t < shapes_.size(); ++t) {
      const std::vector<double>& resting = node_.weights.empty() ? mesh_.weights : node_.weights;
      const double percent = t < resting.size() ? 100 * resting[t] : 0;
      int64_t channel = 0, shape = 0;
      FbxNode sub = scene->object("Deformer", shape_name(t), "SubDeformer", "BlendShapeChannel", &channel);
      sub.add("Version").integer(100);
      sub.add("DeformPercent").number(percent);
      sub.add("FullWeights").numbers({100});
      FbxNode properties("Properties70");
      properties.property("DeformPercent", "Number", "", "A").number(percent);
      sub.add(std::move(properties));
      scene->add("Deformer", std::move(sub));
      FbxNode moved = scene->object("Geometry", shape_name(t), "Geometry", "Shape", &shape);
      moved.add("Properties70");
      moved.add("Version").integer(100);
      moved.add("Indexes").integers(shapes_[t].points);
      moved.add("Vertices").numbers(scaled(shapes_[t].moves));
      moved.add("Normals").numbers(shapes_[t].normals);
      scene->add("Geometry", std::move(moved));
      scene->connect(channel, id);
      scene->connect(shape, channel);
      channels->push_back(channel);
    }
  }

  const tinygltf::Model& model_;
  const tinygltf::Node& node_;
  const tinygltf::Mesh& mesh_;
  std::string where_;
  bool has_normals_ = true, has_uvs_ = true, has_colours_ = true;
  std::unordered_map<std::string, int32_t> points_;  // control points by what they are
  std::vector<double> positions_;                    // [points x 3]
  std::vector<std::vector<Influence>> rows_;         // [points]
  std::vector<int32_t> corners_;                     // of triangles, the last of each complemented
  std::vector<double> normals_, uvs_, colours_;      // [corners]
  std::vector<int> materials_;                       // glTF's, in the order of their use
  std::vector<int32_t> polygon_materials_;           // numbers in materials_
  std::vector<Shape> shapes_;
};

}  // namespace

int64_t add_fbx_geometry(const std::string& whose, const tinygltf::Model& model, size_t node, const Affine& frame,
                         const std::vector<int64_t>& clusters, FbxScene* scene, std::vector<int>* materials,
                         std::vector<int64_t>* channels) {
  return Geometry(whose, model, node).write(frame, clusters, scene, materials, channels);
}

}  // namespace sinew
