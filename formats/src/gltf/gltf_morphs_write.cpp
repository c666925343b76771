// SPDX-License-Identifier: MIT
// Puts corrective shapes into a glTF document: morph targets behind those that a mesh has, and what drives them in the extras of
// their meshes (formats/spec/correctives.md). Everything else of the document stays.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "gltf/changed_document.hpp"
#include "gltf/gltf_container.hpp"
#include "gltf/gltf_source.hpp"
#include "gltf/morph_animations.hpp"
#include "gltf/node_parts.hpp"
#include "gltf/surface_normals.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/morphs.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr double kLeastTurn = 0.05;  // of a normal, three degrees: less is hardly seen

class MorphWriter {
 public:
  MorphWriter(const std::string& path, const Character& character, const Morphs& morphs, const GltfJoints& joints,
              size_t new_animations, GltfSource* source)
      : path_(path),
        character_(character),
        morphs_(morphs),
        joints_(joints),
        source_(*source),
        document_(source->document),
        mesh_nodes_(&source->document),
        normals_(character),
        animations_(path, morphs, new_animations, model_, source) {}

  void write() {
    model_ = load_gltf(path_, pack_glb(path_, &document_, source_.bytes)).model;
    nodes_ = gltf_nodes(path_, model_);
    joint_of_node_.assign(model_.nodes.size(), -1);
    for (size_t j = 0; j < joints_.nodes.size(); ++j)
      joint_of_node_.at(static_cast<size_t>(joints_.nodes[j])) = static_cast<int>(j);
    for_each_node(source_.parts, [&](size_t first, size_t last) { write_node(first, last); });
    write_views();
    drop_unused_accessors(animations_.orphans(), &source_);
  }

 private:
  // Shape numbers that move a vertex of these parts.
  std::vector<size_t> shapes_of(size_t first, size_t last) const {
    std::vector<char> own(character_.vertices.size(), 0);
    for (size_t p = first; p < last; ++p)
      for (const uint32_t v : source_.parts[p].vertex_of) own[v] = 1;
    std::vector<size_t> found;
    for (size_t s = 0; s < morphs_.shapes.size(); ++s)
      if (std::any_of(morphs_.shapes[s].vertices.begin(), morphs_.shapes[s].vertices.end(),
                      [&](uint32_t v) { return own.at(v) != 0; }))
        found.push_back(s);
    return found;
  }

  void write_node(size_t first, size_t last) {
    const std::vector<size_t> shapes = shapes_of(first, last);
    if (shapes.empty()) return;
    const size_t node = static_cast<size_t>(source_.parts[first].node);
    Json& json = document_["meshes"][static_cast<size_t>(mesh_nodes_.own_mesh(source_.parts[first].node))];
    const size_t before = model_.meshes[static_cast<size_t>(model_.nodes[node].mesh)].primitives.at(0).targets.size();
    for (size_t p = first; p < last; ++p) write_targets(source_.parts[p], shapes, &json);
    // Names and weights that belong to targets grow with them.
    Json weights = json.value("weights", Json::array());
    weights.get_ref<Json::array_t&>().resize(before + shapes.size(), 0.0);
    json["weights"] = std::move(weights);
    if (document_["nodes"][node].contains("weights"))
      document_["nodes"][node]["weights"].get_ref<Json::array_t&>().resize(before + shapes.size(), 0.0);
    write_extras(shapes, before, &json);
    animations_.write(node, shapes, before);
  }

  void write_targets(const GltfPart& part, const std::vector<size_t>& shapes, Json* mesh) {
    const std::string where = path_ + ": node " + std::to_string(part.node);
    const tinygltf::Primitive& primitive =
        model_.meshes[static_cast<size_t>(model_.nodes[static_cast<size_t>(part.node)].mesh)]
            .primitives[static_cast<size_t>(part.primitive)];
    const std::vector<Affine> frames = vertex_frames(where, part, primitive);
    std::vector<float> normals;
    if (const auto at = primitive.attributes.find("NORMAL"); at != primitive.attributes.end())
      normals = accessor_floats(where + ", NORMAL", model_, at->second, 3);
    std::multimap<uint32_t, uint32_t> copies;  // the file's vertices of one of the character's
    for (size_t i = 0; i < part.vertex_of.size(); ++i) copies.emplace(part.vertex_of[i], static_cast<uint32_t>(i));
    Json& targets = (*mesh)["primitives"][static_cast<size_t>(part.primitive)]["targets"];
    for (const size_t s : shapes) {
      const MorphShape& shape = morphs_.shapes[s];
      std::map<uint32_t, std::array<float, 3>> moves, turns;
      for (size_t i = 0; i < shape.vertices.size(); ++i) {
        const auto [begin, end] = copies.equal_range(shape.vertices[i]);
        for (auto at = begin; at != end; ++at) {
          const std::optional<Affine> back = inverse(frames[at->second]);
          if (!back) continue;  // flattened: nothing moves it
          const Point3 move = to_direction(shape.moves[i]);
          std::array<float, 3>& to = moves[at->second];
          for (size_t r = 0; r < 3; ++r)
            to[r] = static_cast<float>((*back)[4 * r] * move[0] + (*back)[4 * r + 1] * move[1] +
                                       (*back)[4 * r + 2] * move[2]);
        }
      }
      Json target = {{"POSITION", add_moves(part.vertex_of.size(), moves, true)}};
      if (!normals.empty()) {
        for (const auto& [vertex, posed] : normals_.under(shape)) {
          const auto [begin, end] = copies.equal_range(vertex);
          for (auto at = begin; at != end; ++at) {
            const auto turn = turn_of(vertex, posed, frames[at->second], &normals[3 * at->second]);
            if (turn) turns[at->second] = *turn;
          }
        }
        target["NORMAL"] = add_moves(part.vertex_of.size(), turns, false);
      }
      targets.push_back(std::move(target));
    }
  }

  // The displacement of a normal of the file, in the mesh's space.
  std::optional<std::array<float, 3>> turn_of(uint32_t vertex, const Point3& posed, const Affine& frame,
                                              const float* normal) const {
    const Point3& rest = normals_.rest(vertex);
    double apart = 0;
    for (size_t c = 0; c < 3; ++c) apart = std::max(apart, std::abs(posed[c] - rest[c]));
    if (apart < kLeastTurn) return std::nullopt;
    const Point3 own = {static_cast<double>(normal[0]), static_cast<double>(normal[1]), static_cast<double>(normal[2])};
    Point3 world = transform_normal(frame, own[0], own[1], own[2]);
    const double length = std::hypot(world[0], world[1], world[2]);
    if (!(length > 0)) return std::nullopt;
    for (double& x : world) x /= length;
    world = turned(world, rest, posed);
    Point3 back{};  // normals go by the inverse transposed, so back by the transposed
    for (size_t c = 0; c < 3; ++c) back[c] = frame[c] * world[0] + frame[4 + c] * world[1] + frame[8 + c] * world[2];
    const double back_length = std::hypot(back[0], back[1], back[2]);
    if (!(back_length > 0)) return std::nullopt;
    std::array<float, 3> out{};
    for (size_t c = 0; c < 3; ++c) out[c] = static_cast<float>(back[c] / back_length - own[c]);
    return out;
  }

  // Where skinning (or the node) puts the mesh's own space in the pose that weights are meant for. [vertices of the part]
  std::vector<Affine> vertex_frames(const std::string& where, const GltfPart& part,
                                    const tinygltf::Primitive& primitive) const {
    const size_t count = part.vertex_of.size();
    const int skin = model_.nodes[static_cast<size_t>(part.node)].skin;
    if (skin < 0) return std::vector<Affine>(count, source_.bind_pose.worlds.at(static_cast<size_t>(part.node)));
    const std::vector<int>& skin_joints = model_.skins[static_cast<size_t>(skin)].joints;
    std::vector<Affine> palette = inverse_bind_matrices(where, model_, model_.skins[static_cast<size_t>(skin)]);
    for (size_t k = 0; k < palette.size(); ++k) {
      const int joint = joint_of_node_.at(static_cast<size_t>(skin_joints[k]));
      palette[k] = multiply(
          joint >= 0 ? joints_.worlds[static_cast<size_t>(joint)] : nodes_.worlds[static_cast<size_t>(skin_joints[k])],
          palette[k]);
    }
    std::vector<std::vector<Influence>> rows(count);
    for (int set = 0;; ++set) {
      const auto at = primitive.attributes.find("JOINTS_" + std::to_string(set)),
                 with = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
      if (at == primitive.attributes.end() || with == primitive.attributes.end()) break;
      const std::vector<uint32_t> numbers = accessor_integers(where, model_, at->second, 4);
      const std::vector<float> weights = accessor_floats(where, model_, with->second, 4);
      for (size_t i = 0; i < 4 * count; ++i)
        if (weights.at(i) > 0) rows[i / 4].push_back({numbers.at(i), weights[i]});
    }
    std::vector<Affine> frames;
    for (const std::vector<Influence>& row : rows) frames.push_back(blended_matrix(row, palette));
    return frames;
  }

  // Values behind those of other accessors, in a view that write_views() makes. Returns where.
  template <class T>
  static Json add_to(std::vector<uint8_t>* bytes, const std::vector<T>& values) {
    bytes->resize((bytes->size() + 3) / 4 * 4);
    const size_t offset = bytes->size();
    const auto* from = reinterpret_cast<const uint8_t*>(values.data());
    bytes->insert(bytes->end(), from, from + values.size() * sizeof(T));
    return {{"byteOffset", offset}};
  }

  // An accessor of vectors that are 0 but for some: sparse where that is smaller, and one of its length for all that move nothing.
  size_t add_moves(size_t count, const std::map<uint32_t, std::array<float, 3>>& moves, bool with_bounds) {
    if (const auto still = still_.find(count); moves.empty() && still != still_.end()) return still->second;
    std::array<float, 3> low{}, high{};
    if (moves.size() == count && count != 0) low = high = moves.begin()->second;
    for (const auto& [vertex, move] : moves)
      for (size_t c = 0; c < 3; ++c) {
        low[c] = std::min(low[c], move[c]);
        high[c] = std::max(high[c], move[c]);
      }
    const bool wide = count > 65535;
    const size_t sparse_bytes = moves.size() * ((wide ? 4 : 2) + 12);
    size_t number = 0;
    if (sparse_bytes < count * 12) {
      std::vector<uint16_t> small;
      std::vector<uint32_t> large;
      std::vector<std::array<float, 3>> values;
      for (const auto& [vertex, move] : moves) {
        if (wide)
          large.push_back(vertex);
        else
          small.push_back(static_cast<uint16_t>(vertex));
        values.push_back(move);
      }
      Json accessor = {{"componentType", TINYGLTF_COMPONENT_TYPE_FLOAT}, {"count", count}, {"type", "VEC3"}};
      if (!values.empty()) {  // without: all are 0
        Json indices = wide ? add_to(&sparse_indices_, large) : add_to(&sparse_indices_, small);
        indices["componentType"] = wide ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
        accessor["sparse"] = {
            {"count", values.size()}, {"indices", std::move(indices)}, {"values", add_to(&sparse_values_, values)}};
        sparse_.push_back(document_["accessors"].size());
      }
      document_["accessors"].push_back(std::move(accessor));
      number = document_["accessors"].size() - 1;
    } else {
      std::vector<std::array<float, 3>> values(count, std::array<float, 3>{});
      for (const auto& [vertex, move] : moves) values[vertex] = move;
      number = static_cast<size_t>(add_accessor(&source_, values.data(), values.size() * 12, "VEC3",
                                                TINYGLTF_COMPONENT_TYPE_FLOAT, count, true, false));
    }
    if (with_bounds || moves.empty()) {
      document_["accessors"][number]["min"] = low;
      document_["accessors"][number]["max"] = high;
    }
    if (moves.empty()) still_[count] = number;
    return number;
  }

  // The views of all sparse accessors.
  void write_views() {
    const auto add_view = [&](const std::vector<uint8_t>& bytes) {
      source_.bytes.resize((source_.bytes.size() + 3) / 4 * 4);
      document_["bufferViews"].push_back(
          {{"buffer", 0}, {"byteOffset", source_.bytes.size()}, {"byteLength", bytes.size()}});
      source_.bytes.insert(source_.bytes.end(), bytes.begin(), bytes.end());
      return document_["bufferViews"].size() - 1;
    };
    if (sparse_.empty()) return;
    const size_t indices = add_view(sparse_indices_), values = add_view(sparse_values_);
    for (const size_t accessor : sparse_) {
      document_["accessors"][accessor]["sparse"]["indices"]["bufferView"] = indices;
      document_["accessors"][accessor]["sparse"]["values"]["bufferView"] = values;
    }
  }

  // Input of a joint's rotation: its node, the node's rotation at rest, and the axes of its parent.
  Json turning_node(size_t joint) const {
    const size_t node = static_cast<size_t>(joints_.nodes[joint]);
    Affine above = kIdentity;
    if (const int parent = nodes_.parents[node]; parent >= 0) {
      const int parent_joint = joint_of_node_[static_cast<size_t>(parent)];
      above = parent_joint >= 0 ? joints_.worlds[static_cast<size_t>(parent_joint)]
                                : nodes_.worlds[static_cast<size_t>(parent)];
    }
    const Affine own = multiply(inverse(above).value_or(kIdentity), joints_.worlds[joint]);
    const NodeParts parts = parts_of(own, parts_of(model_.nodes[node]));
    const Affine& m = above;
    const double volume =
        m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
    if (volume < 0)  // a rotation is the same in axes that all point in opposite directions
      for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 3; ++c) above[4 * r + c] = -above[4 * r + c];
    return {{"joint", character_.joints[joint].name},
            {"node", node},
            {"rest", parts.rotation},
            {"axes", quaternion_of(rotation_part(above))}};
  }

  // A driver of those of its shapes that the mesh has.
  Json drive(const MorphDriver& driver, const std::vector<size_t>& shapes, size_t before,
             std::vector<size_t>* turning) const {
    const auto number_of = [&](size_t joint) {
      const auto at = std::find(turning->begin(), turning->end(), joint);
      if (at != turning->end()) return static_cast<size_t>(at - turning->begin());
      turning->push_back(joint);
      return turning->size() - 1;
    };
    Json bend = {{"joint", character_.joints[driver.joint].name}, {"targets", Json::array()}};
    std::vector<size_t> sums;  // that these shapes have
    for (const MorphWeight& weight : driver.weights) {
      const auto at = std::find(shapes.begin(), shapes.end(), weight.shape);
      if (at == shapes.end()) continue;
      const auto sum = std::find(sums.begin(), sums.end(), weight.sum);
      bend["targets"].push_back(before + static_cast<size_t>(at - shapes.begin()));
      bend["sums"].push_back(sum - sums.begin());
      bend["scales"].push_back(weight.scale);
      if (sum == sums.end()) sums.push_back(weight.sum);
    }
    for (const MorphTerm& term : driver.terms) {
      if (sums.empty()) break;
      Json turns = {number_of(term.joint)}, factors = Json::array();
      if (term.with != term.joint) turns.push_back(number_of(term.with));
      for (const size_t sum : sums) factors.push_back(term.factors[sum]);
      bend["terms"].push_back({{"turns", std::move(turns)}, {"factors", std::move(factors)}});
    }
    return bend;
  }

  void write_extras(const std::vector<size_t>& shapes, size_t before, Json* mesh) {
    Json extras = mesh->value("extras", Json::object());
    if (!extras.is_object()) return;  // someone's own: it stays
    Json names = extras.value("targetNames", Json::array());
    if (!names.is_array()) names = Json::array();
    while (names.size() > before) names.erase(names.size() - 1);
    while (names.size() < before) names.push_back("target_" + std::to_string(names.size()));
    for (const size_t s : shapes) names.push_back(morphs_.shapes[s].name);
    extras["targetNames"] = std::move(names);
    Json bends = Json::array();
    std::vector<size_t> turning;  // joints that the terms are about
    for (const MorphDriver& driver : morphs_.drivers) {
      Json bend = drive(driver, shapes, before, &turning);
      if (!bend["targets"].empty()) bends.push_back(std::move(bend));
    }
    if (!bends.empty()) {
      Json joints = Json::array();
      for (const size_t joint : turning) joints.push_back(turning_node(joint));
      extras["sinew_correctives"] = {{"joints", std::move(joints)}, {"bends", std::move(bends)}};
    }
    (*mesh)["extras"] = std::move(extras);
  }

  const std::string& path_;
  const Character& character_;
  const Morphs& morphs_;
  const GltfJoints& joints_;
  GltfSource& source_;
  Json& document_;
  MeshNodes mesh_nodes_;
  tinygltf::Model model_;  // of the document as it was given
  GltfNodes nodes_;
  std::vector<int> joint_of_node_;  // [N], -1 = no joint
  SurfaceNormals normals_;
  MorphAnimations animations_;
  std::vector<uint8_t> sparse_indices_, sparse_values_;  // of all shapes: a view each
  std::vector<size_t> sparse_;                           // accessors that lie in these
  std::map<size_t, size_t> still_;  // accessors of shapes that move nothing of a primitive, by its number of vertices
};

}  // namespace

void add_gltf_morphs(const std::string& path, const Character& character, const Morphs& morphs,
                     const GltfJoints& joints, size_t new_animations, GltfSource* source) {
  try {
    MorphWriter(path, character, morphs, joints, new_animations, source).write();
  } catch (const nlohmann::json::exception& error) {
    throw Error(path + ": cannot write, the input document has an unexpected form: " + one_line(error.what()));
  }
}

}  // namespace sinew
