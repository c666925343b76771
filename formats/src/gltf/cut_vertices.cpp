// SPDX-License-Identifier: MIT
// Accessors of primitives with the values of doubled vertices behind the others, and new indices.
#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "gltf/changed_document.hpp"
#include "gltf/gltf_model.hpp"
#include "gltf/gltf_source.hpp"

namespace sinew {
namespace {

class DocumentCutter {
 public:
  DocumentCutter(const std::string& name, const GltfSource& source, const std::vector<uint32_t>& face_vertices,
                 const std::vector<Vec3>& vertices)
      : name_(name),
        read_(source),
        face_vertices_(face_vertices),
        vertices_(vertices),
        cut_(source),
        mesh_nodes_(&cut_.document) {}

  // The document's JSON and bytes are cut, its model is as read.
  GltfSource run() {
    for_each_node(read_.parts, [&](size_t first, size_t last) {
      const int mesh = mesh_nodes_.own_mesh(read_.parts[first].node);
      for (size_t p = first; p < last; ++p) cut_part(static_cast<size_t>(mesh), p);
    });
    drop_unused_accessors(orphans_, &cut_);
    return std::move(cut_);
  }

 private:
  void cut_part(size_t mesh, size_t p) {
    GltfPart& part = cut_.parts[p];
    const size_t node = static_cast<size_t>(part.node), before = part.vertex_of.size();
    const tinygltf::Primitive& primitive = read_.model.meshes[static_cast<size_t>(read_.model.nodes[node].mesh)]
                                               .primitives[static_cast<size_t>(part.primitive)];
    const std::string where = name_ + ": mesh " + std::to_string(mesh);
    std::vector<uint32_t> indices, sources;  // of the doubled ones
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> doubled;
    for (const auto& corners : primitive_triangles(where, read_.model, primitive, before)) {
      for (const uint32_t corner : corners) {
        const uint32_t wanted = face_vertices_.at(next_corner_++);
        uint32_t index = corner;
        if (part.vertex_of[corner] != wanted) {
          const auto [at, is_new] = doubled.try_emplace({corner, wanted}, static_cast<uint32_t>(part.vertex_of.size()));
          index = at->second;
          if (is_new) {
            part.vertex_of.push_back(wanted);
            sources.push_back(corner);
          }
        }
        indices.push_back(index);
      }
    }
    if (sources.empty()) return;
    Json& json = cut_.document["meshes"][mesh]["primitives"][static_cast<size_t>(part.primitive)];
    for (const auto& [key, accessor] : primitive.attributes)
      json["attributes"][key] = extended(where + ", " + key, accessor, sources);
    place(part, before, sources, json["attributes"]["POSITION"].get<size_t>());
    for (size_t t = 0; t < primitive.targets.size(); ++t)
      for (const auto& [key, accessor] : primitive.targets[t])
        json["targets"][t][key] = extended(where + ", shape " + std::to_string(t), accessor, sources);
    if (primitive.indices >= 0) orphans_.push_back(primitive.indices);
    json["indices"] = add_accessor(&cut_, indices.data(), indices.size() * 4, "SCALAR",
                                   TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, indices.size(), false, false);
    cut_.document["bufferViews"].back()["target"] = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
    json["mode"] = TINYGLTF_MODE_TRIANGLES;
  }

  // A new accessor with the values of `accessor` and then those of `sources` again.
  int extended(const std::string& where, int accessor, const std::vector<uint32_t>& sources) {
    const auto key = std::make_pair(accessor, sources);
    if (const auto known = extended_.find(key); known != extended_.end()) return known->second;
    std::vector<uint32_t> vertices(read_.model.accessors.at(static_cast<size_t>(accessor)).count);
    std::iota(vertices.begin(), vertices.end(), 0u);
    vertices.insert(vertices.end(), sources.begin(), sources.end());
    const int number = pick_vertices(where, read_, accessor, vertices, true, &cut_);
    orphans_.push_back(accessor);
    extended_[key] = number;
    return number;
  }

  // Moves doubled vertices by what the Character's are away from those that they are of.
  void place(const GltfPart& part, size_t before, const std::vector<uint32_t>& sources, size_t accessor) {
    const Json& json = cut_.document["accessors"][accessor];
    const tinygltf::Node& node = read_.model.nodes[static_cast<size_t>(part.node)];
    const std::optional<Affine> back =
        inverse(node.skin >= 0 ? read_.bind_pose.skin_frames[static_cast<size_t>(node.skin)]
                               : read_.bind_pose.worlds[static_cast<size_t>(part.node)]);
    if (!back || json["componentType"] != TINYGLTF_COMPONENT_TYPE_FLOAT || !read_.bind_pose.agrees) return;
    const Json& view = cut_.document["bufferViews"][json["bufferView"].get<size_t>()];
    uint8_t* const bytes = cut_.bytes.data() + view["byteOffset"].get<size_t>();
    const auto local = [&](uint32_t vertex) {
      const Vec3& p = vertices_[vertex];
      return transform_point(*back, static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
    };
    for (size_t d = 0; d < sources.size(); ++d) {
      const auto now = local(part.vertex_of[before + d]), then = local(part.vertex_of[sources[d]]);
      std::array<float, 3> position;
      std::memcpy(position.data(), bytes + (before + d) * sizeof position, sizeof position);
      for (size_t c = 0; c < 3; ++c) position[c] += static_cast<float>(now[c] - then[c]);
      std::memcpy(bytes + (before + d) * sizeof position, position.data(), sizeof position);
    }
  }

  const std::string& name_;
  const GltfSource& read_;
  const std::vector<uint32_t>& face_vertices_;
  const std::vector<Vec3>& vertices_;
  GltfSource cut_;
  MeshNodes mesh_nodes_;
  size_t next_corner_ = 0;
  std::vector<int> orphans_;
  std::map<std::pair<int, std::vector<uint32_t>>, int> extended_;
};

}  // namespace

std::shared_ptr<const GltfSource> cut_document(const std::string& name, const GltfSource& source,
                                               const std::vector<uint32_t>& face_vertices,
                                               const std::vector<Vec3>& vertices) {
  std::shared_ptr<GltfSource> cut = read_again(name, DocumentCutter(name, source, face_vertices, vertices).run());
  cut->vertex_count = vertices.size();
  return cut;
}

}  // namespace sinew
