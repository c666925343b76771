// SPDX-License-Identifier: MIT
// Nodes: joints are limbs, carriers are nulls, meshes stand by themselves where a skin holds them.
#include <algorithm>
#include <cmath>
#include <set>

#include "fbx/fbx_write.hpp"
#include "gltf/control_points.hpp"
#include "gltf/node_parts.hpp"

namespace sinew {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;
class Models {
 public:
  Models(const std::string& whose, const tinygltf::Model& model, const GltfNodes& nodes,
         const std::vector<int64_t>& materials, FbxScene* scene)
      : whose_(whose), model_(model), nodes_(nodes), materials_(materials), scene_(*scene) {}

  FbxModels add() {
    out_.nodes.assign(model_.nodes.size(), 0);
    out_.meshes.assign(model_.nodes.size(), 0);
    out_.channels.resize(model_.nodes.size());
    joint_ = scene_joints(model_, nodes_);
    std::vector<size_t> order;
    for (size_t n = 0; n < model_.nodes.size(); ++n)
      if (nodes_.parents[n] < 0 && nodes_.in_scene[n] != 0) order.push_back(n);
    for (size_t next = 0; next < order.size(); ++next) {
      add_node(order[next]);
      for (const int child : model_.nodes[order[next]].children) order.push_back(static_cast<size_t>(child));
    }
    for (const size_t n : order)
      if (model_.nodes[n].mesh >= 0) add_mesh(n);
    return std::move(out_);
  }

 private:
  bool is_skinned(size_t n) const { return model_.nodes[n].skin >= 0 && model_.nodes[n].mesh >= 0; }

  // FBX files are read by name by many.
  std::string free_name(const std::string& wanted) {
    const std::string base = wanted.empty() ? "node" : wanted;
    std::string name = base;
    for (size_t number = 2; !names_.insert(name).second; ++number) name = base + "_" + std::to_string(number);
    return name;
  }

  int64_t add_model(const std::string& name, const char* type, const NodeParts& parts) {
    int64_t id = 0;
    FbxNode model = scene_.object("Model", name, "Model", type, &id);
    model.add("Version").integer(232);
    FbxNode properties("Properties70");
    properties.property_enum("InheritType", 1);  // as glTF: a parent's scale lies outside of the child's rotation
    const auto& t = parts.translation;
    properties.property_vector("Lcl Translation", "Lcl Translation", "", "A",
                               {kFbxUnits * t[0], kFbxUnits * t[1], kFbxUnits * t[2]});
    properties.property_vector("Lcl Rotation", "Lcl Rotation", "", "A", fbx_euler(parts.rotation));
    properties.property_vector("Lcl Scaling", "Lcl Scaling", "", "A", parts.scale);
    properties.property_integer("DefaultAttributeIndex", 0);
    model.add(std::move(properties));
    model.add("Shading").text("T");
    model.add("Culling").text("CullingOff");
    scene_.add("Model", std::move(model));
    return id;
  }

  void add_attribute(int64_t model, const std::string& name, const char* type, const char* flags) {
    int64_t id = 0;
    FbxNode attribute = scene_.object("NodeAttribute", name, "NodeAttribute", type, &id);
    attribute.add("TypeFlags").text(flags);
    scene_.add("NodeAttribute", std::move(attribute));
    scene_.connect(id, model);
  }

  int64_t parent_model(size_t n) const {
    const int parent = nodes_.parents[n];
    return parent < 0 ? 0 : out_.nodes[static_cast<size_t>(parent)];
  }

  void add_node(size_t n) {
    const tinygltf::Node& node = model_.nodes[n];
    const bool joint = joint_[n] != 0;
    if (!joint && node.mesh >= 0 && (!is_skinned(n) || node.children.empty())) {
      if (!is_skinned(n))
        out_.nodes[n] = out_.meshes[n] = connected(add_model(free_name(node.name), "Mesh", parts_of(node)), n);
      return;  // one that a skin holds comes later
    }
    const std::string name = free_name(node.name);
    out_.nodes[n] = connected(add_model(name, joint ? "LimbNode" : "Null", parts_of(node)), n);
    add_attribute(out_.nodes[n], name, joint ? "LimbNode" : "Null", joint ? "Skeleton" : "Null");
  }

  int64_t connected(int64_t model, size_t n) {
    scene_.connect(model, parent_model(n));
    return model;
  }

  static NodeParts parts_from(const Affine& m) { return sinew::parts_of(m, NodeParts()); }

  void add_mesh(size_t n) {
    const tinygltf::Node& node = model_.nodes[n];
    Affine frame = kIdentity;
    std::vector<int64_t> clusters;
    if (is_skinned(n)) {
      frame = skin_frame(whose_, model_, nodes_, static_cast<size_t>(node.skin));
      out_.meshes[n] = add_model(free_name(node.name), "Mesh", parts_from(frame));
      scene_.connect(out_.meshes[n], 0);
      for (const int joint : model_.skins[static_cast<size_t>(node.skin)].joints)
        clusters.push_back(out_.nodes[static_cast<size_t>(joint)]);
      out_.bound.emplace_back(out_.meshes[n], in_fbx_units(frame));
      add_bound(n, frame);
    } else if (out_.meshes[n] == 0) {  // on a joint
      out_.meshes[n] = add_model(free_name(node.name + "_mesh"), "Mesh", NodeParts());
      scene_.connect(out_.meshes[n], out_.nodes[n]);
    }
    std::vector<int> used;
    const int64_t geometry = add_fbx_geometry(whose_, model_, n, frame, clusters, &scene_, &used, &out_.channels[n]);
    if (geometry == 0) return;
    scene_.connect(geometry, out_.meshes[n]);
    for (const int material : used) {
      const bool known = material >= 0 && static_cast<size_t>(material) < materials_.size();
      if (known)
        scene_.connect(materials_[static_cast<size_t>(material)], out_.meshes[n]);
      else
        scene_.connect(materials_.back(), out_.meshes[n]);  // that of parts without one
    }
  }

  void add_bound(size_t n, const Affine& frame) {
    const tinygltf::Skin& skin = model_.skins[static_cast<size_t>(model_.nodes[n].skin)];
    const std::vector<Affine> binds = inverse_bind_matrices(whose_, model_, skin);
    for (size_t k = 0; k < skin.joints.size(); ++k) {
      const int64_t joint = out_.nodes[static_cast<size_t>(skin.joints[k])];
      const std::optional<Affine> back = inverse(binds[k]);
      if (joint != 0 && back && bound_.insert(joint).second)
        out_.bound.emplace_back(joint, in_fbx_units(multiply(frame, *back)));
    }
  }

  const std::string& whose_;
  const tinygltf::Model& model_;
  const GltfNodes& nodes_;
  const std::vector<int64_t>& materials_;
  FbxScene& scene_;
  FbxModels out_;
  std::vector<char> joint_;  // [N]
  std::set<std::string> names_;
  std::set<int64_t> bound_;
};

}  // namespace

std::array<double, 3> fbx_euler(const Quaternion& q) {
  const Rotation r = rotation_of(normalized(q));
  const double across = std::hypot(r[0], r[3]);
  if (across < 1e-9)  // y is a right angle: x and z are about one axis
    return {kDegrees * std::atan2(-r[5], r[4]), kDegrees * std::atan2(-r[6], across), 0};
  return {kDegrees * std::atan2(r[7], r[8]), kDegrees * std::atan2(-r[6], across), kDegrees * std::atan2(r[3], r[0])};
}

std::array<double, 3> fbx_euler(const Quaternion& q, const std::array<double, 3>& before) {
  const std::array<double, 3> first = fbx_euler(q), second = {first[0] + 180, 180 - first[1], first[2] + 180};
  std::array<double, 3> best{};
  double least = 1e300;
  for (std::array<double, 3> angles : {first, second}) {
    double apart = 0;
    for (size_t i = 0; i < 3; ++i) {
      angles[i] -= 360 * std::round((angles[i] - before[i]) / 360);
      apart += std::abs(angles[i] - before[i]);
    }
    if (apart < least) least = apart, best = angles;
  }
  return best;
}

Affine in_fbx_units(Affine m) {
  for (const size_t i : {size_t{3}, size_t{7}, size_t{11}}) m[i] *= kFbxUnits;
  return m;
}

FbxModels add_fbx_models(const std::string& whose, const tinygltf::Model& model, const GltfNodes& nodes,
                         const std::vector<int64_t>& materials, FbxScene* scene) {
  return Models(whose, model, nodes, materials, scene).add();
}

}  // namespace sinew
