// SPDX-License-Identifier: MIT
// Attributes of primitives read, moved and written as new accessors.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "gltf/changed_document.hpp"
#include "gltf/gltf_source.hpp"
#include "gltf/mesh_nodes.hpp"
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
    throw Error(name +
                ": its meshes know no common rest pose, so they are not put into another; write it once with "
                "sinew bind and start from that file");
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

}  // namespace sinew
