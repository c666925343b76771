// SPDX-License-Identifier: MIT
// Puts a Character's skin into a glTF document: joints, inverse bind matrices, weights. Everything else of the document
// stays.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "gltf/changed_document.hpp"
#include "gltf/fixed_weights.hpp"
#include "gltf/gltf_model.hpp"
#include "gltf/gltf_source.hpp"
#include "gltf/node_parts.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/base/joint_tree.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

class SkinWriter {
 public:
  SkinWriter(const std::string& path, const Character& character, bool unorm8, GltfSource* source)
      : path_(path),
        character_(character),
        unorm8_(unorm8),
        source_(*source),
        document_(source->document),
        mesh_nodes_(&source->document),
        nodes_(gltf_nodes(path, source->model)) {}

  GltfJoints write() {
    const size_t own = source_.joint_nodes.size();
    keeps_joints_ = own > 0 && has_joints(character_.joints, source_.joints);
    joint_nodes_ = keeps_joints_ ? source_.joint_nodes : add_joint_nodes(path_, character_.joints, &document_);
    for (size_t j = 0; j < character_.joints.size(); ++j) {
      const Vec3& p = character_.joints[j].position;
      const bool kept = keeps_joints_ && j < own;
      joint_worlds_.push_back(kept ? source_.bind_pose.worlds[static_cast<size_t>(joint_nodes_[j])]
                                   : Affine{1, 0, 0, static_cast<double>(p.x), 0, 1, 0, static_cast<double>(p.y), 0, 0,
                                            1, static_cast<double>(p.z)});
      if (character_.joints[j].parent < 0 && fallback_joint_ == SIZE_MAX) fallback_joint_ = j;
      if (keeps_joints_ && !kept) joint_nodes_.push_back(hang_joint(character_.joints[j]));
    }
    fix_weights();
    measure_box();
    for_each_node(source_.parts, [&](size_t first, size_t last) { write_node(first, last); });
    for (auto& [skin, joints] : skin_joints_) write_skin(skin, joints);
    drop_unused_skins();
    join_skeletons();
    drop_unused_accessors(orphans_, &source_);
    return {std::move(joint_nodes_), std::move(joint_worlds_)};
  }

 private:
  void fix_weights() {
    const uint32_t one = unorm8_ ? 255 : 65535;
    for (size_t v = 0; v < character_.influences.size(); ++v) {
      for (const Influence& influence : character_.influences[v]) {
        if (influence.joint >= character_.joints.size())
          throw Error(path_ + ": cannot write, vertex " + std::to_string(v) + " names joint " +
                      std::to_string(influence.joint) + " of " + std::to_string(character_.joints.size()));
        if (!std::isfinite(influence.weight) || influence.weight < 0)
          throw Error(path_ + ": cannot write, vertex " + std::to_string(v) +
                      " has a weight that is negative or not finite");
      }
      rows_.push_back(to_fixed(character_.influences[v], one));
    }
  }

  int joint_at_or_above(int node) const {
    for (; node >= 0; node = nodes_.parents[static_cast<size_t>(node)]) {
      const auto at = std::find(joint_nodes_.begin(), joint_nodes_.end(), node);
      if (at != joint_nodes_.end()) return static_cast<int>(at - joint_nodes_.begin());
    }
    return -1;
  }

  // A node below those that are there already for a joint that the file did not have.
  int hang_joint(const Joint& joint) {
    const size_t parent = joint_index(joint.parent);
    const std::optional<Affine> back = inverse(joint_worlds_[parent]);
    if (!back)
      throw Error(path_ + ": cannot write joint " + in_quotes(joint.name) + ", " +
                  in_quotes(character_.joints[parent].name) + " above it has scale 0");
    const NodeParts parts = parts_of(multiply(*back, joint_worlds_.back()), NodeParts{});
    Json& nodes = document_["nodes"];
    const int number = static_cast<int>(nodes.size());
    nodes.push_back({{"name", joint.name},
                     {"translation", parts.translation},
                     {"rotation", parts.rotation},
                     {"scale", parts.scale}});
    nodes[static_cast<size_t>(joint_nodes_[parent])]["children"].push_back(number);
    return number;
  }

  // A rigid part that is a child of its joint needs no skin; neither does what nothing is bound to.
  bool stays(size_t first, size_t last, int node) const {
    const bool skinned = source_.model.nodes[static_cast<size_t>(node)].skin >= 0;
    const int carrier = skinned || !keeps_joints_ ? -1 : joint_at_or_above(node);
    bool unbound = true, rigid = carrier >= 0;
    for (size_t p = first; p < last; ++p)
      for (const uint32_t vertex : source_.parts[p].vertex_of) {
        const FixedRow& row = rows_[vertex];
        unbound = unbound && row.empty();
        rigid = rigid && row.size() == 1 && static_cast<int>(row[0].joint) == carrier;
      }
    return unbound || rigid;
  }

  void write_node(size_t first, size_t last) {
    const int node = source_.parts[first].node;
    if (stays(first, last, node)) return;
    const tinygltf::Node& old = source_.model.nodes[static_cast<size_t>(node)];
    Json& json = document_["nodes"][static_cast<size_t>(node)];

    const int mesh = mesh_nodes_.own_mesh(node);
    int skin = old.skin;
    const GltfBindPose& pose = source_.bind_pose;
    if (skin < 0) {
      skin = skin_for(pose.worlds[static_cast<size_t>(node)]);
      move_to_scene(node);
    } else if (!pose.agrees) {
      for (size_t p = first; p < last; ++p) bake_pose(source_.parts[p], mesh);
      skin = skin_for(kIdentity);
    } else if (!keeps_joints_) {
      skin = skin_for(pose.skin_frames[static_cast<size_t>(skin)]);
    }
    json["skin"] = skin;
    write_weights(first, last, mesh, skin);
  }

  // The number of `joint` in a skin, which is extended when it is new there. Skins of the document keep the joints they
  // have.
  uint32_t joint_in_skin(int skin, uint32_t joint) {
    auto [at, is_new] = skin_joints_.try_emplace(skin);
    std::vector<int>& joints = at->second;
    if (is_new && static_cast<size_t>(skin) < source_.model.skins.size())
      joints = source_.model.skins[static_cast<size_t>(skin)].joints;
    const auto found = std::find(joints.begin(), joints.end(), joint_nodes_[joint]);
    if (found != joints.end()) return static_cast<uint32_t>(found - joints.begin());
    joints.push_back(joint_nodes_[joint]);
    return static_cast<uint32_t>(joints.size() - 1);
  }

  void write_weights(size_t first, size_t last, int mesh, int skin) {
    std::map<uint32_t, uint32_t> number_in_skin;
    size_t longest = 1;
    const FixedRow fallback = {{static_cast<uint32_t>(fallback_joint_), unorm8_ ? 255u : 65535u}};
    const auto row_of = [&](uint32_t vertex) -> const FixedRow& {
      return rows_[vertex].empty() ? fallback : rows_[vertex];
    };
    for (size_t p = first; p < last; ++p)
      for (const uint32_t vertex : source_.parts[p].vertex_of) {
        longest = std::max(longest, row_of(vertex).size());
        for (const FixedInfluence& influence : row_of(vertex))
          if (number_in_skin.count(influence.joint) == 0) {
            number_in_skin[influence.joint] = joint_in_skin(skin, influence.joint);
            weighted_[skin].insert(joint_nodes_[influence.joint]);
          }
      }
    const bool wide =
        std::any_of(number_in_skin.begin(), number_in_skin.end(), [](const auto& at) { return at.second > 255; });
    const size_t set_count = (longest + 3) / 4;

    std::map<std::vector<uint32_t>, std::vector<std::array<int, 2>>> written;  // primitives often share their vertices
    for (size_t p = first; p < last; ++p) {
      const GltfPart& part = source_.parts[p];
      Json& attributes = document_["meshes"][static_cast<size_t>(mesh)]["primitives"]
                                  [static_cast<size_t>(part.primitive)]["attributes"];
      for (auto at = attributes.begin(); at != attributes.end();) {
        const bool old =
            at.key().rfind("JOINTS_", 0) == 0 || at.key().rfind("WEIGHTS_", 0) == 0 || at.key() == "_CONFIDENCE";
        if (old) orphans_.push_back(at.value().get<int>());
        if (old)
          at = attributes.erase(at);
        else
          ++at;
      }
      std::vector<std::array<int, 2>>& sets = written[part.vertex_of];
      for (size_t set = sets.size(); set < set_count; ++set) {
        const size_t count = part.vertex_of.size();
        std::vector<uint16_t> joints(count * 4, 0), weights(count * 4, 0);
        for (size_t v = 0; v < count; ++v) {
          const FixedRow& row = row_of(part.vertex_of[v]);
          for (size_t k = 0; k < 4 && set * 4 + k < row.size(); ++k) {
            joints[v * 4 + k] = static_cast<uint16_t>(number_in_skin[row[set * 4 + k].joint]);
            weights[v * 4 + k] = static_cast<uint16_t>(row[set * 4 + k].weight);
          }
        }
        sets.push_back({add_small(joints, wide, false), add_small(weights, !unorm8_, true)});
      }
      if (!character_.confidence.empty()) attributes["_CONFIDENCE"] = confidence_accessor(part.vertex_of);
      for (size_t set = 0; set < set_count; ++set) {
        attributes["JOINTS_" + std::to_string(set)] = sets[set][0];
        attributes["WEIGHTS_" + std::to_string(set)] = sets[set][1];
      }
    }
  }

  // Custom attributes of any form are legal; floats 0..1 are what viewers and node editors take.
  int confidence_accessor(const std::vector<uint32_t>& vertex_of) {
    const auto [at, is_new] = confidences_.try_emplace(vertex_of, -1);
    if (!is_new) return at->second;
    std::vector<float> values;
    for (const uint32_t v : vertex_of) values.push_back(static_cast<float>(character_.confidence[v]) / 255.0f);
    at->second = add_accessor(&source_, values.data(), values.size() * 4, "SCALAR", TINYGLTF_COMPONENT_TYPE_FLOAT,
                              values.size(), true, false);
    return at->second;
  }

  int add_small(const std::vector<uint16_t>& values, bool wide, bool normalized) {
    if (wide)
      return add_accessor(&source_, values.data(), values.size() * 2, "VEC4", TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                          values.size() / 4, true, normalized);
    const std::vector<uint8_t> bytes(values.begin(), values.end());
    return add_accessor(&source_, bytes.data(), bytes.size(), "VEC4", TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                        bytes.size() / 4, true, normalized);
  }

  // The new skin whose meshes stand at `mesh_world` times their vertices; inverse bind matrices follow in write_skin.
  int skin_for(const Affine& mesh_world) {
    for (const auto& [skin, world] : mesh_worlds_)
      if (world == mesh_world) return skin;
    document_["skins"].push_back({{"joints", Json::array()}});
    const int skin = static_cast<int>(document_["skins"].size()) - 1;
    mesh_worlds_[skin] = mesh_world;
    skin_joints_[skin] = joint_nodes_;
    return skin;
  }

  // A mesh that its old joints hold in another pose than it was bound in: the vertices are moved to where they stand,
  // because the new joints know that pose only.
  void bake_pose(const GltfPart& part, int mesh) {
    const std::string where =
        path_ + ": mesh " + std::to_string(mesh) + ", primitive " + std::to_string(part.primitive);
    const tinygltf::Node& node = source_.model.nodes[static_cast<size_t>(part.node)];
    const tinygltf::Primitive& primitive =
        source_.model.meshes[static_cast<size_t>(node.mesh)].primitives[static_cast<size_t>(part.primitive)];
    const std::vector<Affine> palette = skin_palette(where, source_.model, nodes_, node.skin);
    const size_t count = part.vertex_of.size();
    std::vector<Affine> matrices(count, Affine{});
    std::vector<double> totals(count, 0);
    for (int set = 0; primitive.attributes.count("JOINTS_" + std::to_string(set)) != 0 &&
                      primitive.attributes.count("WEIGHTS_" + std::to_string(set)) != 0;
         ++set) {
      const std::vector<uint32_t> joints =
          accessor_integers(where, source_.model, primitive.attributes.at("JOINTS_" + std::to_string(set)), 4);
      const std::vector<float> weights =
          accessor_floats(where, source_.model, primitive.attributes.at("WEIGHTS_" + std::to_string(set)), 4);
      for (size_t i = 0; i < count * 4; ++i) {
        if (!(weights[i] > 0)) continue;
        for (size_t m = 0; m < 12; ++m) matrices[i / 4][m] += static_cast<double>(weights[i]) * palette[joints[i]][m];
        totals[i / 4] += static_cast<double>(weights[i]);
      }
    }
    for (size_t v = 0; v < count; ++v) {
      if (totals[v] == 0)
        matrices[v] = palette[0];
      else
        for (double& value : matrices[v]) value /= totals[v];
    }

    move_vertices(where, primitive, matrices, {static_cast<size_t>(mesh), static_cast<size_t>(part.primitive)},
                  &source_, &orphans_);
  }

  // Joints and inverse bind matrices of a skin: joint's bind transform x inverse bind = where the mesh stands. Matrices
  // that do so already stay.
  void write_skin(int skin, const std::vector<int>& joints) {
    const bool is_old = static_cast<size_t>(skin) < source_.model.skins.size();
    Json& json = document_["skins"][static_cast<size_t>(skin)];
    std::vector<Affine> binds;
    if (is_old)
      binds = inverse_bind_matrices(path_ + ": skin " + std::to_string(skin), source_.model,
                                    source_.model.skins[static_cast<size_t>(skin)]);
    const size_t old_count = binds.size();
    const Affine& frame = is_old ? source_.bind_pose.skin_frames[static_cast<size_t>(skin)] : mesh_worlds_.at(skin);
    bool changed = joints.size() != old_count || !is_old;
    for (size_t j = 0; j < joints.size(); ++j) {
      if (j < old_count && weighted_[skin].count(joints[j]) == 0) continue;
      const auto at = std::find(joint_nodes_.begin(), joint_nodes_.end(), joints[j]);
      if (at == joint_nodes_.end()) continue;
      const size_t joint = static_cast<size_t>(at - joint_nodes_.begin());
      if (j < old_count && same_pose(multiply(joint_worlds_[joint], binds[j]), frame)) continue;
      const std::optional<Affine> back = inverse(joint_worlds_[joint]);
      if (!back)
        throw Error(path_ + ": cannot write a skin, joint " + in_quotes(character_.joints[joint].name) +
                    " has scale 0 and no inverse bind matrix");
      binds.resize(std::max(binds.size(), j + 1), kIdentity);
      binds[j] = multiply(*back, frame);
      changed = true;
    }
    if (!changed) return;
    if (is_old) {
      const int old = source_.model.skins[static_cast<size_t>(skin)].inverseBindMatrices;
      if (old >= 0) orphans_.push_back(old);
      if (joints.size() != old_count) json.erase("skeleton");  // need not be above the new joints
    }
    std::vector<float> values;
    for (const Affine& bind : binds)
      for (size_t c = 0; c < 4; ++c)
        for (size_t r = 0; r < 4; ++r)
          values.push_back(r < 3 ? static_cast<float>(bind[r * 4 + c]) : (c == 3 ? 1.0f : 0.0f));
    json["joints"] = joints;
    json["inverseBindMatrices"] = add_accessor(&source_, values.data(), values.size() * 4, "MAT4",
                                               TINYGLTF_COMPONENT_TYPE_FLOAT, binds.size(), false, false);
  }

  void measure_box() {
    const Box box = box_of(character_.vertices);
    box_corners_ = box.corners();
    box_size_ = static_cast<double>(box.diagonal());
  }

  // Whether a joint's and a skin's transform agree over the character's box (see gltf_model.hpp).
  bool same_pose(const Affine& a, const Affine& b) const {
    const std::optional<Affine> back = inverse(b);
    if (!back) return false;
    const Affine moved = multiply(a, *back);
    return sinew::same_pose(moved, kIdentity, box_corners_, box_size_);
  }

  // The transforms above a skinned mesh have no effect, and validators warn about them: a node without other duties
  // goes to the top of its scenes.
  void move_to_scene(int node) {
    const size_t index = static_cast<size_t>(node);
    Json& json = document_["nodes"][index];
    if (!source_.model.nodes[index].children.empty() ||
        std::find(joint_nodes_.begin(), joint_nodes_.end(), node) != joint_nodes_.end())
      return;
    for (const tinygltf::Animation& animation : source_.model.animations)
      for (const tinygltf::AnimationChannel& channel : animation.channels)
        if (channel.target_node == node && channel.target_path != "weights") return;
    for (const char* key : {"matrix", "translation", "rotation", "scale"}) json.erase(key);
    const int parent = nodes_.parents[index];
    if (parent < 0) return;
    int top = parent;
    while (nodes_.parents[static_cast<size_t>(top)] >= 0) top = nodes_.parents[static_cast<size_t>(top)];
    Json& siblings = document_["nodes"][static_cast<size_t>(parent)]["children"];
    siblings.erase(std::find(siblings.begin(), siblings.end(), node));
    if (siblings.empty()) document_["nodes"][static_cast<size_t>(parent)].erase("children");
    if (!document_.contains("scenes")) return;
    for (Json& scene : document_["scenes"])
      if (scene.contains("nodes") &&
          std::find(scene["nodes"].begin(), scene["nodes"].end(), top) != scene["nodes"].end())
        scene["nodes"].push_back(node);
  }

  void drop_unused_skins() {
    Json& skins = document_["skins"];
    std::vector<char> used(skins.size(), 0);
    for (const Json& node : document_["nodes"])
      if (node.contains("skin")) used[node["skin"].get<size_t>()] = 1;
    for (size_t s = 0; s < source_.model.skins.size(); ++s) {
      bool was_used = !keeps_joints_;  // else a skin that was unused is not the character's
      for (const tinygltf::Node& node : source_.model.nodes) was_used = was_used || node.skin == static_cast<int>(s);
      if (!was_used) used[s] = 1;
      if (used[s] == 0 && source_.model.skins[s].inverseBindMatrices >= 0)
        orphans_.push_back(source_.model.skins[s].inverseBindMatrices);
    }
    std::vector<int> new_number(used.size(), -1);
    Json kept = Json::array();
    for (size_t s = 0; s < used.size(); ++s)
      if (used[s] != 0) {
        new_number[s] = static_cast<int>(kept.size());
        kept.push_back(std::move(skins[s]));
      }
    for (Json& node : document_["nodes"])
      if (node.contains("skin")) node["skin"] = new_number[node["skin"].get<size_t>()];
    skins = std::move(kept);
    if (skins.empty()) document_.erase("skins");
  }

  // glTF wants the joints of a skin below one node. Trees that a skin has come to join get a common parent.
  void join_skeletons() {
    if (!document_.contains("skins")) return;
    std::vector<int> parents(document_["nodes"].size(), -1);
    for (size_t i = 0; i < parents.size(); ++i)
      if (document_["nodes"][i].contains("children"))
        for (const Json& child : document_["nodes"][i]["children"]) parents[child.get<size_t>()] = static_cast<int>(i);
    std::set<int> apart;
    for (const Json& skin : document_["skins"]) {
      std::set<int> tops;
      for (const Json& joint : skin["joints"]) {
        int top = joint.get<int>();
        while (parents[static_cast<size_t>(top)] >= 0) top = parents[static_cast<size_t>(top)];
        tops.insert(top);
      }
      if (tops.size() > 1) apart.insert(tops.begin(), tops.end());
    }
    if (apart.empty()) return;
    const size_t common = document_["nodes"].size();
    document_["nodes"].push_back({{"name", "skeleton"}, {"children", apart}});
    if (!document_.contains("scenes")) return;
    for (Json& scene : document_["scenes"]) {
      if (!scene.contains("nodes")) continue;
      Json kept = Json::array();
      for (const Json& node : scene["nodes"])
        if (apart.count(node.get<int>()) == 0) kept.push_back(node);
      if (kept.size() == scene["nodes"].size()) continue;
      kept.push_back(common);
      scene["nodes"] = std::move(kept);
    }
  }

  const std::string& path_;
  const Character& character_;
  const bool unorm8_;
  GltfSource& source_;
  Json& document_;
  MeshNodes mesh_nodes_;
  const GltfNodes nodes_;
  bool keeps_joints_ = false;
  std::vector<int> joint_nodes_;                 // [J]
  std::vector<Affine> joint_worlds_;             // [J]
  size_t fallback_joint_ = SIZE_MAX;             // takes the vertices of a skinned mesh that have no influence
  std::vector<FixedRow> rows_;                   // [V]
  std::map<int, std::vector<int>> skin_joints_;  // skins that meshes use now -> their joints' nodes
  std::map<int, Affine> mesh_worlds_;            // new skins
  std::vector<Vec3> box_corners_;                // of the character
  double box_size_ = 0;
  std::map<int, std::set<int>> weighted_;  // skins -> nodes of the joints that have weight now
  std::map<std::vector<uint32_t>, int> confidences_;
  std::vector<int> orphans_;  // accessors that lost a user
};

}  // namespace

GltfJoints write_gltf_skin(const std::string& path, const Character& character, bool unorm8, GltfSource* source) {
  try {
    return SkinWriter(path, character, unorm8, source).write();
  } catch (const nlohmann::json::exception& error) {
    throw Error(path + ": cannot write, the input document has an unexpected form: " + one_line(error.what()));
  }
}

}  // namespace sinew
