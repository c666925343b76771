// SPDX-License-Identifier: MIT
// Documents whose vertices, joints or whole are moved: attributes and nodes read, moved and written anew.
#include "gltf/changed_document.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "gltf/gltf_source.hpp"
#include "gltf/node_parts.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

void move_vertices(const std::string& where, const tinygltf::Primitive& primitive, const std::vector<Affine>& matrices,
                   PrimitiveAt at, GltfSource* source, std::vector<int>* orphans) {
  Json& document = source->document;
  Json& json = document["meshes"][at.mesh]["primitives"][at.primitive];
  const size_t count = matrices.size();
  std::vector<double> normal_lengths(count, 1), tangent_lengths(count, 1);
  // Moves one attribute; morph targets are differences, scaled as the normal or tangent they are added to was.
  const auto move = [&](Json* attributes, const char* name, const std::map<std::string, int>& from, bool difference) {
    const auto found = from.find(name);
    if (found == from.end()) return;
    const bool is_position = found->first == "POSITION", is_normal = found->first == "NORMAL";
    const size_t width = found->first == "TANGENT" && !difference ? 4 : 3;
    std::vector<float> values = accessor_floats(where, source->model, found->second, static_cast<int>(width));
    std::vector<double>& lengths = is_normal ? normal_lengths : tangent_lengths;
    std::array<float, 3> low{}, high{};
    for (size_t v = 0; v < count; ++v) {
      Affine m = matrices[v];
      if (!is_position || difference) m[3] = m[7] = m[11] = 0;
      const double x = static_cast<double>(values[v * width]), y = static_cast<double>(values[v * width + 1]),
                   z = static_cast<double>(values[v * width + 2]);
      std::array<double, 3> moved = is_normal ? transform_normal(m, x, y, z) : transform_point(m, x, y, z);
      if (!is_position) {
        const double length = std::sqrt(moved[0] * moved[0] + moved[1] * moved[1] + moved[2] * moved[2]);
        if (!difference) lengths[v] = length > 0 ? length : 1;
        for (double& value : moved) value /= lengths[v];
      }
      for (size_t c = 0; c < 3; ++c) {
        const float value = static_cast<float>(moved[c]);
        values[v * width + c] = value;
        low[c] = v == 0 ? value : std::min(low[c], value);
        high[c] = v == 0 ? value : std::max(high[c], value);
      }
    }
    const int accessor = add_accessor(source, values.data(), values.size() * 4, width == 4 ? "VEC4" : "VEC3",
                                      TINYGLTF_COMPONENT_TYPE_FLOAT, count, true, false);
    if (is_position) {
      document["accessors"][static_cast<size_t>(accessor)]["min"] = low;
      document["accessors"][static_cast<size_t>(accessor)]["max"] = high;
    }
    orphans->push_back(found->second);
    (*attributes)[name] = accessor;
  };
  for (const char* name : {"POSITION", "NORMAL", "TANGENT"})
    move(&json["attributes"], name, primitive.attributes, false);
  for (size_t t = 0; t < primitive.targets.size(); ++t)
    for (const char* name : {"POSITION", "NORMAL", "TANGENT"})
      move(&json["targets"][t], name, primitive.targets[t], true);
}

std::shared_ptr<const GltfSource> moved_document(const std::string& name, const GltfSource& source,
                                                 const std::vector<Affine>& matrices, bool with_joints) {
  if (!source.bind_pose.agrees)
    throw Error(
        name +
        ": cannot change the rest pose, its meshes share none; write it once with sinew bind and start from that file");
  auto moved = std::make_shared<GltfSource>(source);
  MeshNodes mesh_nodes(&moved->document);
  const GltfNodes nodes = gltf_nodes(name, source.model);
  const auto hangs_on_joint = [&](int node) {
    for (; node >= 0; node = nodes.parents[static_cast<size_t>(node)])
      if (std::find(source.joint_nodes.begin(), source.joint_nodes.end(), node) != source.joint_nodes.end())
        return true;
    return false;
  };
  std::vector<int> orphans;
  for_each_node(source.parts, [&](size_t first, size_t last) {
    const int node = source.parts[first].node;
    const tinygltf::Node& read = source.model.nodes[static_cast<size_t>(node)];
    if (with_joints && read.skin < 0 && hangs_on_joint(node)) return;
    const Affine& frame = read.skin >= 0 ? source.bind_pose.skin_frames[static_cast<size_t>(read.skin)]
                                         : source.bind_pose.worlds[static_cast<size_t>(node)];
    const std::optional<Affine> back = inverse(frame);
    if (!back) return;  // flat: there is nothing to see
    const size_t mesh = static_cast<size_t>(mesh_nodes.own_mesh(node));
    for (size_t p = first; p < last; ++p) {
      const GltfPart& part = source.parts[p];
      std::vector<Affine> local;
      for (const uint32_t v : part.vertex_of) local.push_back(multiply(*back, multiply(matrices[v], frame)));
      const tinygltf::Primitive& primitive =
          source.model.meshes[static_cast<size_t>(read.mesh)].primitives[static_cast<size_t>(part.primitive)];
      move_vertices(name + ": mesh " + std::to_string(mesh), primitive, local,
                    {mesh, static_cast<size_t>(part.primitive)}, moved.get(), &orphans);
    }
  });
  drop_unused_accessors(orphans, moved.get());
  return moved;
}

namespace {

class JointMover {
 public:
  JointMover(const std::string& name, const GltfSource& source, const std::vector<Affine>& palette)
      : name_(name), source_(source), nodes_(gltf_nodes(name, source.model)), joint_of_(nodes_.parents.size(), -1) {
    for (size_t j = 0; j < source.joint_nodes.size(); ++j) {
      joint_of_[static_cast<size_t>(source.joint_nodes[j])] = static_cast<int>(j);
      worlds_.push_back(multiply(palette[j], rest_world(source.joint_nodes[j])));
    }
  }

  void move_nodes(Json* document) const {
    for (size_t j = 0; j < worlds_.size(); ++j) {
      const size_t node = static_cast<size_t>(source_.joint_nodes[j]);
      const NodeParts parts =
          parts_of(multiply(back(world_of(nodes_.parents[node])), worlds_[j]), parts_of(source_.model.nodes[node]));
      Json& json = (*document)["nodes"][node];
      json.erase("matrix");
      json["translation"] = parts.translation;
      json["rotation"] = parts.rotation;
      json["scale"] = parts.scale;
    }
  }

  void move_skins(GltfSource* moved) const {
    for (size_t s = 0; s < source_.model.skins.size(); ++s) {
      const tinygltf::Skin& skin = source_.model.skins[s];
      std::vector<Affine> binds = inverse_bind_matrices(name_ + ": skin " + std::to_string(s), source_.model, skin);
      std::vector<float> values;
      for (size_t k = 0; k < binds.size(); ++k) {
        const int joint = joint_of_[static_cast<size_t>(skin.joints[k])];
        if (joint >= 0)
          binds[k] =
              multiply(back(worlds_[static_cast<size_t>(joint)]), multiply(rest_world(skin.joints[k]), binds[k]));
        for (size_t c = 0; c < 4; ++c)
          for (size_t r = 0; r < 4; ++r)
            values.push_back(r < 3 ? static_cast<float>(binds[k][r * 4 + c]) : (c == 3 ? 1.0f : 0.0f));
      }
      moved->document["skins"][s]["inverseBindMatrices"] = add_accessor(
          moved, values.data(), values.size() * 4, "MAT4", TINYGLTF_COMPONENT_TYPE_FLOAT, binds.size(), false, false);
    }
  }

 private:
  const Affine& rest_world(int node) const { return source_.bind_pose.worlds[static_cast<size_t>(node)]; }
  // Where a node stands once the joints above it have moved.
  Affine world_of(int node) const {
    for (int up = node; up >= 0; up = nodes_.parents[static_cast<size_t>(up)]) {
      const int joint = joint_of_[static_cast<size_t>(up)];
      if (joint >= 0)
        return multiply(worlds_[static_cast<size_t>(joint)], multiply(back(rest_world(up)), rest_world(node)));
    }
    return node < 0 ? kIdentity : nodes_.worlds[static_cast<size_t>(node)];
  }
  Affine back(const Affine& m) const {
    const std::optional<Affine> inverted = inverse(m);
    if (!inverted) throw Error(name_ + ": cannot change the rest pose, a joint has scale 0");
    return *inverted;
  }

  const std::string& name_;
  const GltfSource& source_;
  const GltfNodes nodes_;
  std::vector<int> joint_of_;   // [nodes] or -1
  std::vector<Affine> worlds_;  // [J] moved
};

}  // namespace

std::shared_ptr<const GltfSource> moved_joints(const std::string& name, const GltfSource& source,
                                               const std::vector<Affine>& palette, const std::vector<Joint>& joints) {
  GltfSource moved = source;
  const JointMover mover(name, source, palette);
  mover.move_nodes(&moved.document);
  std::vector<int> orphans;
  for (const tinygltf::Skin& skin : source.model.skins)
    if (skin.inverseBindMatrices >= 0) orphans.push_back(skin.inverseBindMatrices);
  mover.move_skins(&moved);
  drop_unused_accessors(orphans, &moved);
  moved.joints = joints;
  std::shared_ptr<GltfSource> fresh = read_again(name, std::move(moved));
  fresh->bind_pose.worlds = gltf_nodes(name, fresh->model).worlds;
  fresh->bind_pose.moved = false;
  return fresh;
}

std::shared_ptr<const GltfSource> transformed_document(const std::string& name, const GltfSource& source,
                                                       const Affine& transform, const std::vector<Joint>& joints) {
  if (source.model.scenes.size() > 1)
    throw Error(name + ": has " + std::to_string(source.model.scenes.size()) +
                " scenes; expected one to rotate or scale");
  const GltfNodes nodes = gltf_nodes(name, source.model);
  GltfSource transformed = source;
  Json node = Json::object();
  const NodeParts parts = parts_of(transform, NodeParts{});
  node["name"] = "Placed";
  node["translation"] = parts.translation;
  node["rotation"] = parts.rotation;
  node["scale"] = parts.scale;
  node["children"] = Json::array();
  for (size_t n = 0; n < nodes.parents.size(); ++n)
    if (nodes.parents[n] < 0 && nodes.in_scene[n] != 0) node["children"].push_back(n);
  Json& document = transformed.document;
  const size_t added = document["nodes"].size();
  document["nodes"].push_back(std::move(node));
  if (document.contains("scenes") && !document["scenes"].empty())
    document["scenes"][0]["nodes"] = Json::array({added});
  else
    document["scenes"] = Json::array({{{"nodes", Json::array({added})}}});
  for (Affine& world : transformed.bind_pose.worlds) world = multiply(transform, world);
  transformed.bind_pose.worlds.resize(added);
  transformed.bind_pose.worlds.push_back(transform);
  for (Affine& frame : transformed.bind_pose.skin_frames) frame = multiply(transform, frame);
  transformed.joints = joints;
  return read_again(name, std::move(transformed));
}

}  // namespace sinew
