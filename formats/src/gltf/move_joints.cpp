// SPDX-License-Identifier: MIT
#include <utility>

#include "gltf/changed_document.hpp"
#include "gltf/gltf_source.hpp"
#include "gltf/node_parts.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
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
    if (!inverted) throw Error(name_ + ": a joint is scaled to nothing, so it is not put into another pose");
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

}  // namespace sinew
