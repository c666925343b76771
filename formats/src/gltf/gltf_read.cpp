// SPDX-License-Identifier: MIT
// glTF 2.0 / GLB / VRM to Character: all mesh nodes of the scene in world space, in the pose that their weights are
// meant for.

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "gltf/gltf_from_scene.hpp"
#include "gltf/gltf_model.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "text/joint_names.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

using Row = std::vector<Influence>;

// Key by which two vertices of a mesh node are one: the same position in the file and the same influences. UVs,
// normals and colors may differ (seams); so may morph targets, which move both sides of a seam alike.
std::string weld_key(const float* position, const Row& row) {
  float xyz[3];
  for (size_t c = 0; c < 3; ++c) xyz[c] = position[c] + 0.0f;  // -0 becomes 0
  std::string key(reinterpret_cast<const char*>(xyz), sizeof xyz);
  for (const Influence& influence : row) {
    key.append(reinterpret_cast<const char*>(&influence.joint), sizeof influence.joint);
    key.append(reinterpret_cast<const char*>(&influence.weight), sizeof influence.weight);
  }
  return key;
}

// One line on the pictures that are files and were not found.
void note_missing_pictures(const tinygltf::Model& model, std::vector<std::string>* notes) {
  std::string names;
  size_t count = 0;
  for (const tinygltf::Image& image : model.images) {
    if (image.uri.empty() || !image.image.empty()) continue;
    if (++count <= 3) names += (count > 1 ? ", " : "") + in_quotes(image.uri);
  }
  if (count == 0) return;
  if (count > 3) names += " and " + std::to_string(count - 3) + " more";
  notes->push_back("warning: " + std::to_string(count) + (count == 1 ? " picture was" : " pictures were") +
                   " not found: " + names + "; the output refers to " + (count == 1 ? "it" : "them") +
                   " as the input does");
}

class GltfReader {
 public:
  GltfReader(std::string path, bool need_mesh) : path_(std::move(path)), need_mesh_(need_mesh) {}

  Character read() {
    source_ = std::make_shared<GltfSource>(is_scene_file(path_) ? gltf_from_scene(path_)
                                                                : load_gltf(path_, read_file(path_)));
    character_.notes = source_->notes;
    note_missing_pictures(source_->model, &character_.notes);
    nodes_ = gltf_nodes(path_, model());
    character_.name = stem_of(path_);
    for (size_t node = 0; node < model().nodes.size(); ++node) check_references(node);
    check_skins();
    source_->bind_pose = find_bind_pose(path_, model(), nodes_, skin_weights());
    read_joints();
    bool has_mesh = false;
    for (size_t node = 0; node < model().nodes.size(); ++node) {
      if (nodes_.in_scene[node] == 0 || model().nodes[node].mesh < 0) continue;
      read_mesh_node(node);
      has_mesh = true;
    }
    if (need_mesh_ && (!has_mesh || character_.vertices.empty()))
      throw Error(path_ + ": expected a scene with a mesh, found none in " + std::to_string(model().nodes.size()) +
                  " nodes");
    finish_names();
    source_->joints = character_.joints;
    source_->vertex_count = character_.vertices.size();
    character_.gltf = source_;
    return std::move(character_);
  }

 private:
  const tinygltf::Model& model() const { return source_->model; }

  void check_references(size_t node_index) const {
    const tinygltf::Node& node = model().nodes[node_index];
    const auto check = [&](int index, size_t count, const char* what) {
      if (index >= 0 && static_cast<size_t>(index) >= count)
        throw Error(path_ + ": node " + std::to_string(node_index) + " " + in_quotes(node.name) + ": expected a " +
                    what + " below " + std::to_string(count) + ", found " + std::to_string(index));
    };
    check(node.mesh, model().meshes.size(), "mesh");
    check(node.skin, model().skins.size(), "skin");
  }

  std::string skin_name(size_t skin) const {
    return path_ + ": skin " + std::to_string(skin) + " " + in_quotes(model().skins[skin].name);
  }

  void check_skins() const {
    for (size_t s = 0; s < model().skins.size(); ++s)
      for (const int node : model().skins[s].joints)
        if (node < 0 || static_cast<size_t>(node) >= model().nodes.size())
          throw Error(skin_name(s) + ": expected joints below " + std::to_string(model().nodes.size()) + ", found " +
                      std::to_string(node));
  }

  bool is_in_scene(size_t node) const { return nodes_.in_scene[node] != 0 && model().nodes[node].mesh >= 0; }

  SkinWeights skin_weights() const {
    SkinWeights weights;
    for (const tinygltf::Skin& skin : model().skins) weights.emplace_back(skin.joints.size(), 0.0);
    for (size_t n = 0; n < model().nodes.size(); ++n) {
      const tinygltf::Node& node = model().nodes[n];
      if (!is_in_scene(n) || node.skin < 0) continue;
      std::vector<double>& sums = weights[static_cast<size_t>(node.skin)];
      const std::vector<tinygltf::Primitive>& primitives = model().meshes[static_cast<size_t>(node.mesh)].primitives;
      for (size_t p = 0; p < primitives.size(); ++p) {
        const auto at = primitives[p].attributes.find("JOINTS_0");
        if (at == primitives[p].attributes.end() || at->second < 0 ||
            static_cast<size_t>(at->second) >= model().accessors.size())
          continue;
        const size_t count = model().accessors[static_cast<size_t>(at->second)].count;
        for (const Row& row :
             read_rows(primitive_name(static_cast<size_t>(node.mesh), p), primitives[p], count, sums.size()))
          for (const Influence& influence : row) sums[influence.joint] += static_cast<double>(influence.weight);
      }
    }
    return weights;
  }

  std::string primitive_name(size_t mesh, size_t primitive) const {
    return path_ + ": mesh " + std::to_string(mesh) + " " + in_quotes(model().meshes[mesh].name) + ", primitive " +
           std::to_string(primitive);
  }

  // The joints of all skins that meshes of the scene use (of all skins when none does), in the skins' order.
  void read_joints() {
    const size_t skin_count = model().skins.size();
    std::vector<char> used(skin_count, 0);
    for (size_t node = 0; node < model().nodes.size(); ++node)
      if (nodes_.in_scene[node] != 0 && model().nodes[node].mesh >= 0 && model().nodes[node].skin >= 0)
        used[static_cast<size_t>(model().nodes[node].skin)] = 1;
    if (std::find(used.begin(), used.end(), 1) == used.end()) std::fill(used.begin(), used.end(), char{1});
    joint_of_node_.assign(model().nodes.size(), -1);
    for (size_t s = 0; s < skin_count; ++s) {
      if (used[s] == 0) continue;
      for (const int node : model().skins[s].joints) {
        int& joint = joint_of_node_[static_cast<size_t>(node)];
        if (joint >= 0) continue;
        joint = static_cast<int>(character_.joints.size());
        const Affine& world = source_->bind_pose.worlds[static_cast<size_t>(node)];
        character_.joints.push_back(
            {model().nodes[static_cast<size_t>(node)].name,
             {static_cast<float>(world[3]), static_cast<float>(world[7]), static_cast<float>(world[11])},
             -1,
             deform_flag(model().nodes[static_cast<size_t>(node)])});
        source_->joint_nodes.push_back(node);
      }
    }
    for (size_t j = 0; j < character_.joints.size(); ++j)
      character_.joints[j].parent = joint_at_or_above(nodes_.parents[static_cast<size_t>(source_->joint_nodes[j])]);
    std::vector<std::string> names;
    for (const Joint& joint : character_.joints) names.push_back(joint.name);
    make_names_unique(&names);
    for (size_t j = 0; j < names.size(); ++j) character_.joints[j].name = std::move(names[j]);
  }

  // Blender keeps Bone.use_deform to itself; rigs that export it do so as a custom property of the bone.
  static std::optional<bool> deform_flag(const tinygltf::Node& node) {
    for (const char* key : {"use_deform", "deform"}) {
      if (!node.extras.IsObject() || !node.extras.Has(key)) continue;
      const tinygltf::Value& value = node.extras.Get(key);
      if (value.IsBool()) return value.Get<bool>();
      if (value.IsNumber()) return value.GetNumberAsDouble() != 0;
    }
    return std::nullopt;
  }

  int joint_at_or_above(int node) const {
    while (node >= 0 && joint_of_node_[static_cast<size_t>(node)] < 0) node = nodes_.parents[static_cast<size_t>(node)];
    return node < 0 ? -1 : joint_of_node_[static_cast<size_t>(node)];
  }

  // A skin may list a node twice: its weights are one joint's.
  static void add_influence(uint32_t joint, float weight, Row* row) {
    for (Influence& other : *row) {
      if (other.joint == joint) {
        other.weight += weight;
        return;
      }
    }
    row->push_back({joint, weight});
  }

  void read_mesh_node(size_t node_index) {
    const tinygltf::Node& node = model().nodes[node_index];
    const size_t mesh = static_cast<size_t>(node.mesh);
    std::unordered_map<std::string, uint32_t> welded;
    character_.group_names.push_back(!node.name.empty() ? node.name : model().meshes[mesh].name);
    const int carrier = node.skin >= 0 ? -1 : joint_at_or_above(static_cast<int>(node_index));
    character_.meshes.push_back({character_.group_names.back(), node.skin >= 0, carrier});
    // Skin matrices of the node's joints where its skin has no bind pose; a mesh without a skin moves with its node.
    std::vector<Affine> palette;
    if (node.skin >= 0 && !source_->bind_pose.agrees)
      palette = skin_palette(skin_name(static_cast<size_t>(node.skin)), model(), nodes_, node.skin);
    for (size_t p = 0; p < model().meshes[mesh].primitives.size(); ++p) {
      read_primitive(primitive_name(mesh, p), node_index, p, palette, &welded);
    }
  }

  // Influences by skin joint number (they index the palette), merged and sorted by joint; empty rows are unbound.
  std::vector<Row> read_rows(const std::string& where, const tinygltf::Primitive& primitive, size_t vertex_count,
                             size_t joint_count) const {
    std::vector<Row> rows(vertex_count);
    for (int set = 0;; ++set) {
      const auto joints_at = primitive.attributes.find("JOINTS_" + std::to_string(set));
      const auto weights_at = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
      if (joints_at == primitive.attributes.end() || weights_at == primitive.attributes.end()) break;
      const std::vector<uint32_t> joints =
          accessor_integers(where + ", " + joints_at->first, model(), joints_at->second, 4);
      const std::vector<float> weights =
          accessor_floats(where + ", " + weights_at->first, model(), weights_at->second, 4);
      if (joints.size() != vertex_count * 4 || weights.size() != vertex_count * 4)
        throw Error(where + ": expected joints and weights for " + std::to_string(vertex_count) + " vertices, found " +
                    std::to_string(joints.size() / 4) + " and " + std::to_string(weights.size() / 4));
      for (size_t i = 0; i < joints.size(); ++i) {
        const std::string vertex = where + ", vertex " + std::to_string(i / 4);
        if (weights[i] < 0)
          throw Error(vertex + ": expected weights of 0 or more, found " + std::to_string(weights[i]));
        if (weights[i] == 0) continue;
        if (joints[i] >= joint_count)
          throw Error(vertex + ": expected joints below " + std::to_string(joint_count) + ", found " +
                      std::to_string(joints[i]));
        Row& row = rows[i / 4];
        const auto same =
            std::find_if(row.begin(), row.end(), [&](const Influence& at) { return at.joint == joints[i]; });
        if (same != row.end())
          same->weight += weights[i];
        else
          row.push_back({joints[i], weights[i]});
      }
    }
    for (Row& row : rows)
      std::sort(row.begin(), row.end(), [](const Influence& a, const Influence& b) { return a.joint < b.joint; });
    return rows;
  }

  static Affine blend(const std::vector<Affine>& palette, const Row& row) {
    if (row.empty()) return palette.front();  // unbound: stays beside the rest of its mesh
    Affine sum{};
    double total = 0;
    for (const Influence& influence : row) {
      for (size_t i = 0; i < 12; ++i) sum[i] += static_cast<double>(influence.weight) * palette[influence.joint][i];
      total += static_cast<double>(influence.weight);
    }
    for (double& value : sum) value /= total;
    return sum;
  }

  void read_primitive(const std::string& where, size_t node_index, size_t primitive_index,
                      const std::vector<Affine>& palette, std::unordered_map<std::string, uint32_t>* welded) {
    const tinygltf::Node& node = model().nodes[node_index];
    const tinygltf::Primitive& primitive = model().meshes[static_cast<size_t>(node.mesh)].primitives[primitive_index];
    const auto position_at = primitive.attributes.find("POSITION");
    if (position_at == primitive.attributes.end()) return;  // the specification: nothing to draw
    if (primitive.mode == TINYGLTF_MODE_POINTS || primitive.mode == TINYGLTF_MODE_LINE ||
        primitive.mode == TINYGLTF_MODE_LINE_LOOP || primitive.mode == TINYGLTF_MODE_LINE_STRIP)
      throw Error(where + ": expected triangles, strips or fans, found points or lines (mode " +
                  std::to_string(primitive.mode) + "); remove them");

    const std::vector<float> positions = accessor_floats(where + ", POSITION", model(), position_at->second, 3);
    const size_t vertex_count = positions.size() / 3;
    const bool skinned = node.skin >= 0;
    const std::vector<Row> rows =
        skinned ? read_rows(where, primitive, vertex_count, model().skins[static_cast<size_t>(node.skin)].joints.size())
                : std::vector<Row>(vertex_count);
    const int carrier = character_.meshes.back().carrier;
    const Affine& frame = skinned ? source_->bind_pose.skin_frames[static_cast<size_t>(node.skin)]
                                  : source_->bind_pose.worlds[node_index];
    const std::vector<float> normals = optional_attribute(where, primitive, "NORMAL", 3, vertex_count);
    const std::vector<float> uvs = optional_attribute(where, primitive, "TEXCOORD_0", 2, vertex_count);

    GltfPart part{static_cast<int>(node_index), static_cast<int>(primitive_index), std::vector<uint32_t>(vertex_count)};
    std::vector<Vec3> world_normals(normals.empty() ? 0 : vertex_count);
    for (size_t v = 0; v < vertex_count; ++v) {
      const float* p = &positions[v * 3];
      const Affine matrix = palette.empty() ? frame : blend(palette, rows[v]);
      if (!normals.empty())
        world_normals[v] =
            unit(transform_normal(matrix, static_cast<double>(normals[v * 3]), static_cast<double>(normals[v * 3 + 1]),
                                  static_cast<double>(normals[v * 3 + 2])));
      const auto [at, is_new] =
          welded->emplace(weld_key(p, rows[v]), static_cast<uint32_t>(character_.vertices.size()));
      part.vertex_of[v] = at->second;
      if (!is_new) continue;
      const std::array<double, 3> world =
          transform_point(matrix, static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
      const Vec3 vertex{static_cast<float>(world[0]), static_cast<float>(world[1]), static_cast<float>(world[2])};
      if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y) || !std::isfinite(vertex.z))
        throw Error(where + ", vertex " + std::to_string(v) +
                    ": expected a finite position, found one beyond the range of floats");
      character_.vertices.push_back(vertex);
      character_.vertex_meshes.push_back(static_cast<uint32_t>(character_.meshes.size() - 1));
      if (character_.joints.empty()) continue;
      Row row;
      if (carrier >= 0) row.push_back({static_cast<uint32_t>(carrier), 1.0f});
      for (const Influence& influence : rows[v]) {
        const int joint_node = model().skins[static_cast<size_t>(node.skin)].joints[influence.joint];
        add_influence(static_cast<uint32_t>(joint_of_node_[static_cast<size_t>(joint_node)]), influence.weight, &row);
      }
      character_.influences.push_back(std::move(row));
    }
    read_faces(where, primitive, part, world_normals, uvs);
    source_->parts.push_back(std::move(part));
  }

  std::vector<float> optional_attribute(const std::string& where, const tinygltf::Primitive& primitive,
                                        const char* name, int components, size_t vertex_count) const {
    const auto at = primitive.attributes.find(name);
    if (at == primitive.attributes.end()) return {};
    std::vector<float> values = accessor_floats(where + ", " + name, model(), at->second, components);
    if (values.size() != vertex_count * static_cast<size_t>(components))
      throw Error(where + ": expected " + std::to_string(vertex_count) + " values of " + name + ", found " +
                  std::to_string(values.size() / static_cast<size_t>(components)));
    return values;
  }

  void read_faces(const std::string& where, const tinygltf::Primitive& primitive, const GltfPart& part,
                  const std::vector<Vec3>& normals, const std::vector<float>& uvs) {
    for (const std::array<uint32_t, 3>& corners :
         primitive_triangles(where, model(), primitive, part.vertex_of.size())) {
      for (const uint32_t corner : corners) {
        character_.face_vertices.push_back(part.vertex_of[corner]);
        has_normals_ |= !normals.empty();
        has_uvs_ |= !uvs.empty();
        character_.corner_normals.push_back(normals.empty() ? Vec3{} : normals[corner]);
        // OBJ convention in a Character: v runs up, in glTF down.
        character_.corner_uvs.push_back(uvs.empty() ? std::array<float, 2>{0, 0}
                                                    : std::array<float, 2>{uvs[corner * 2], 1 - uvs[corner * 2 + 1]});
      }
      character_.face_offsets.push_back(static_cast<uint32_t>(character_.face_vertices.size()));
      character_.face_groups.push_back(static_cast<int>(character_.group_names.size()) - 1);
      const bool has_material =
          primitive.material >= 0 && static_cast<size_t>(primitive.material) < model().materials.size();
      character_.face_materials.push_back(has_material ? primitive.material : -1);
    }
  }

  static Vec3 unit(const std::array<double, 3>& n) {
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(length > 0) || !std::isfinite(length)) return {};
    return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length), static_cast<float>(n[2] / length)};
  }

  void finish_names() {
    if (!has_normals_) character_.corner_normals.clear();
    if (!has_uvs_) character_.corner_uvs.clear();
    for (size_t m = 0; m < model().materials.size(); ++m)
      character_.material_names.push_back(model().materials[m].name.empty() ? "material_" + std::to_string(m)
                                                                            : model().materials[m].name);
    if (character_.material_names.empty()) character_.face_materials.clear();
    for (size_t g = 0; g < character_.group_names.size(); ++g)
      if (character_.group_names[g].empty()) character_.group_names[g] = std::string("mesh_").append(std::to_string(g));
  }

  std::string path_;
  bool need_mesh_;
  std::shared_ptr<GltfSource> source_;
  GltfNodes nodes_;
  Character character_;
  std::vector<int> joint_of_node_;  // [N], -1 = no joint
  bool has_normals_ = false, has_uvs_ = false;
};

}  // namespace

Character read_gltf_character(const std::string& path, bool need_mesh) { return GltfReader(path, need_mesh).read(); }

Character read_gltf(const std::string& path) { return read_gltf_character(path, true); }

}  // namespace sinew
