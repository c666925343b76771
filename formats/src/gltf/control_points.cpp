// SPDX-License-Identifier: MIT
#include "gltf/control_points.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "gltf/gltf_model.hpp"
#include "gltf/node_parts.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr size_t kMostFrames = 64;  // joints of a skin that are asked where its mesh stands

struct Frame {
  Affine at;
  size_t agree = 0;
};

bool is_near(const Affine& a, const Affine& b) {
  double size = 1e-9, apart = 0;
  for (size_t i = 0; i < 12; ++i) size = std::max(size, std::abs(a[i])), apart = std::max(apart, std::abs(a[i] - b[i]));
  return apart <= 1e-5 * size;
}

class PointFinder {
 public:
  PointFinder(const std::string& whose, const tinygltf::Model& model, size_t node)
      : model_(model), node_(model.nodes[node]), mesh_(model.meshes[static_cast<size_t>(node_.mesh)]) {
    out_.where = whose + ": mesh " + in_quotes(mesh_.name);
    for (const tinygltf::Primitive& primitive : mesh_.primitives) {
      out_.has_normals = out_.has_normals && primitive.attributes.count("NORMAL") != 0;
      out_.has_uvs = out_.has_uvs && primitive.attributes.count("TEXCOORD_0") != 0;
      out_.has_colors = out_.has_colors && primitive.attributes.count("COLOR_0") != 0;
      out_.shapes.resize(std::max(out_.shapes.size(), primitive.targets.size()));
    }
    for (const tinygltf::Primitive& primitive : mesh_.primitives) read(primitive);
    out_.name = mesh_.name.empty() ? node_.name : mesh_.name;
    for (size_t t = 0; t < out_.shapes.size(); ++t) {
      const std::vector<double>& resting = node_.weights.empty() ? mesh_.weights : node_.weights;
      out_.shapes[t].name = shape_name(t);
      out_.shapes[t].weight = t < resting.size() ? resting[t] : 0;
    }
  }

  ControlPoints find() { return std::move(out_); }

 private:
  std::vector<float> floats(const tinygltf::Primitive& primitive, const char* attribute, int width) const {
    return accessor_floats(out_.where + ", " + attribute, model_, primitive.attributes.at(attribute), width);
  }

  std::vector<std::vector<float>> target_floats(const tinygltf::Primitive& primitive, const char* attribute) const {
    std::vector<std::vector<float>> all;
    for (const auto& target : primitive.targets)
      all.push_back(target.count(attribute) == 0
                        ? std::vector<float>()
                        : accessor_floats(out_.where + ", " + attribute, model_, target.at(attribute), 3));
    return all;
  }

  // [vertices] joint of the skin and weight.
  std::vector<std::vector<Influence>> rows_of(const tinygltf::Primitive& primitive, size_t count) const {
    std::vector<std::vector<Influence>> rows(count);
    for (size_t set = 0; node_.skin >= 0; ++set) {
      const std::string joints = "JOINTS_" + std::to_string(set), weights = "WEIGHTS_" + std::to_string(set);
      if (primitive.attributes.count(joints) == 0 || primitive.attributes.count(weights) == 0) break;
      const std::vector<uint32_t> numbers =
          accessor_integers(out_.where + ", " + joints, model_, primitive.attributes.at(joints), 4);
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
    const std::vector<std::vector<float>> moves = target_floats(primitive, "POSITION"),
                                          turns = target_floats(primitive, "NORMAL");
    std::vector<float> normals, uvs;
    if (out_.has_normals) normals = floats(primitive, "NORMAL", 3);
    if (out_.has_uvs) uvs = floats(primitive, "TEXCOORD_0", 2);
    const std::vector<float> colors = out_.has_colors ? read_colors(primitive) : std::vector<float>();
    const auto known = std::find(out_.materials.begin(), out_.materials.end(), primitive.material);
    const int32_t material = static_cast<int32_t>(known - out_.materials.begin());
    if (known == out_.materials.end()) out_.materials.push_back(primitive.material);
    std::vector<int32_t> point_of(count, -1);
    for (const std::array<uint32_t, 3>& triangle : primitive_triangles(out_.where, model_, primitive, count)) {
      for (size_t c = 0; c < 3; ++c) {
        const size_t v = triangle[c];
        if (point_of[v] < 0) point_of[v] = point(v, positions, rows[v], moves, turns);
        out_.corners.push_back(point_of[v]);
        append(normals, v, 3, &out_.normals);
        if (out_.has_uvs)
          out_.uvs.push_back(static_cast<double>(uvs[2 * v])),
              out_.uvs.push_back(1 - static_cast<double>(uvs[2 * v + 1]));
        append(colors, v, 4, &out_.colors);
      }
      out_.polygon_materials.push_back(material);
    }
  }

  static void append(const std::vector<float>& from, size_t v, size_t width, std::vector<double>* to) {
    for (size_t i = 0; i < width && !from.empty(); ++i) to->push_back(static_cast<double>(from[width * v + i]));
  }

  std::vector<float> read_colors(const tinygltf::Primitive& primitive) const {
    const int accessor = primitive.attributes.at("COLOR_0");
    if (model_.accessors[static_cast<size_t>(accessor)].type == TINYGLTF_TYPE_VEC4)
      return floats(primitive, "COLOR_0", 4);
    std::vector<float> out;
    const std::vector<float> colors = floats(primitive, "COLOR_0", 3);
    for (size_t i = 0; i < colors.size(); ++i) {
      out.push_back(colors[i]);
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
    const auto [at, is_new] = points_.emplace(std::move(key), static_cast<int32_t>(out_.rows.size()));
    if (!is_new) return at->second;
    append(positions, v, 3, &out_.positions);
    out_.rows.push_back(row);
    for (size_t t = 0; t < moves.size(); ++t) {
      const std::vector<float>& move = moves[t];
      if (move.empty() || (move[3 * v] == 0 && move[3 * v + 1] == 0 && move[3 * v + 2] == 0)) continue;
      out_.shapes[t].points.push_back(at->second);
      append(move, v, 3, &out_.shapes[t].moves);
      if (turns[t].empty())
        out_.shapes[t].normals.insert(out_.shapes[t].normals.end(), 3, 0.0);
      else
        append(turns[t], v, 3, &out_.shapes[t].normals);
    }
    return at->second;
  }

  std::string shape_name(size_t t) const {
    if (mesh_.extras.IsObject() && mesh_.extras.Has("targetNames")) {
      const tinygltf::Value& names = mesh_.extras.Get("targetNames");
      if (names.IsArray() && t < names.ArrayLen() && names.Get(static_cast<int>(t)).IsString())
        return names.Get(static_cast<int>(t)).Get<std::string>();
    }
    return "shape_" + std::to_string(t);
  }

  const tinygltf::Model& model_;
  const tinygltf::Node& node_;
  const tinygltf::Mesh& mesh_;
  std::unordered_map<std::string, int32_t> points_;  // by what they are
  ControlPoints out_;
};

}  // namespace

ControlPoints control_points(const std::string& whose, const tinygltf::Model& model, size_t node) {
  return PointFinder(whose, model, node).find();
}

std::vector<char> scene_joints(const tinygltf::Model& model, const GltfNodes& nodes) {
  std::vector<char> joint(model.nodes.size(), 0);
  std::vector<char> mesh_below(model.nodes.size(), 0);
  for (size_t n = 0; n < model.nodes.size(); ++n)
    for (int up = static_cast<int>(n); up >= 0 && model.nodes[n].mesh >= 0; up = nodes.parents[static_cast<size_t>(up)])
      mesh_below[static_cast<size_t>(up)] = 1;
  for (const tinygltf::Skin& skin : model.skins)
    for (const int node : skin.joints) joint[static_cast<size_t>(node)] = 1;
  for (size_t n = 0; n < model.nodes.size(); ++n) {
    if (mesh_below[n] != 0 || model.nodes[n].camera >= 0) continue;
    bool below_joint = model.skins.empty();
    for (int up = nodes.parents[n]; up >= 0 && !below_joint; up = nodes.parents[static_cast<size_t>(up)])
      below_joint = joint[static_cast<size_t>(up)] != 0;
    if (below_joint) joint[n] = 1;
  }
  return joint;
}

Affine skin_frame(const std::string& whose, const tinygltf::Model& model, const GltfNodes& nodes, size_t skin) {
  const tinygltf::Skin& from = model.skins[skin];
  const std::vector<Affine> binds = inverse_bind_matrices(whose, model, from);
  std::vector<Frame> frames;
  for (size_t k = 0; k < std::min(binds.size(), kMostFrames); ++k) {
    const Affine at = multiply(nodes.worlds[static_cast<size_t>(from.joints[k])], binds[k]);
    const auto same =
        std::find_if(frames.begin(), frames.end(), [&](const Frame& frame) { return is_near(frame.at, at); });
    if (same == frames.end())
      frames.push_back({at, 1});
    else
      ++same->agree;
  }
  const auto most =
      std::max_element(frames.begin(), frames.end(), [](const Frame& a, const Frame& b) { return a.agree < b.agree; });
  if (most == frames.end()) return kIdentity;
  // Translation, rotation and scale cannot express shear: then the mesh stands at the origin.
  return is_near(parts_of(most->at, NodeParts()).affine(), most->at) ? most->at : kIdentity;
}

}  // namespace sinew
