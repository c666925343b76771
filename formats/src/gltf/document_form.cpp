// SPDX-License-Identifier: MIT
// Each joint's world transform W(t) becomes G W(t) C: G rotates the whole, C gives the joint its axes. So a node's
// own transform L becomes A L C, where A is G for a node without a parent and the parent's C^-1 else; an inverse bind
// matrix B becomes C^-1 B, and skinning gives G W C C^-1 B = G W B. A rotation key q becomes A q C, which is linear
// in q: tangents of cubic keys transform alike.

#include "sinew_formats/document_form.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "gltf/gltf_container.hpp"
#include "gltf/gltf_source.hpp"
#include "gltf/node_parts.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/base/point.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr double kEvenScale = 1e-3;  // scales of a node along its axes that differ by less are one

Rotation transposed(const Rotation& r) { return {r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]}; }

Affine affine(const Rotation& r) { return {r[0], r[1], r[2], 0, r[3], r[4], r[5], 0, r[6], r[7], r[8], 0}; }

Point3 rotated(const Rotation& r, const Point3& p) {
  return {r[0] * p[0] + r[1] * p[1] + r[2] * p[2], r[3] * p[0] + r[4] * p[1] + r[5] * p[2],
          r[6] * p[0] + r[7] * p[1] + r[8] * p[2]};
}

bool is_even(double x, double y, double z) {
  const double size = std::max({std::abs(x), std::abs(y), std::abs(z)});
  return std::abs(x - y) <= kEvenScale * size && std::abs(x - z) <= kEvenScale * size && x > 0;
}

class FormApplier {
 public:
  FormApplier(const std::string& path, const DocumentForm& form, const GltfJoints& joints, GltfSource* source)
      : path_(path), form_(form), joints_(joints), source_(*source), document_(source->document) {}

  std::vector<std::string> apply() {
    model_ = load_gltf(path_, pack_glb(path_, &document_, source_.bytes)).model;
    nodes_ = gltf_nodes(path_, model_);
    after_.assign(model_.nodes.size(), kNoRotation);
    if (!form_.axes.empty()) find_axes();
    if (moves()) {
      for (size_t n = 0; n < model_.nodes.size(); ++n) write_node(n);
      for (size_t s = 0; s < model_.skins.size(); ++s) write_skin(s);
      for (size_t a = 0; a < model_.animations.size(); ++a) write_animation(a);
      write_offsets();
      drop_unused_accessors(orphans_, &source_);
    }
    write_correctives();
    for (size_t j = 0; j < form_.names.size(); ++j)
      node_json(static_cast<size_t>(joints_.nodes[j]))["name"] = form_.names[j];
    if (!form_.root.empty()) add_root();
    return std::move(notes_);
  }

 private:
  Json& node_json(size_t node) { return document_["nodes"][node]; }

  bool moves() const { return form_.turn != kNoRotation || !form_.axes.empty(); }

  bool uses(const char* extension) const {
    return std::find(model_.extensionsUsed.begin(), model_.extensionsUsed.end(), extension) !=
           model_.extensionsUsed.end();
  }

  // [nodes] 1: scaled unevenly, at rest or by an animation, or mirrored.
  std::vector<char> uneven_nodes() const {
    std::vector<char> uneven(model_.nodes.size(), 0);
    for (size_t n = 0; n < uneven.size(); ++n) {
      const Point3 scale = parts_of(model_.nodes[n]).scale;
      uneven[n] = is_even(scale[0], scale[1], scale[2]) ? 0 : 1;
    }
    for (const tinygltf::Animation& animation : model_.animations)
      for (const tinygltf::AnimationChannel& channel : animation.channels) {
        if (channel.target_path != "scale" || channel.target_node < 0) continue;
        const std::vector<float> scales =
            accessor_floats(path_, model_, animation.samplers[static_cast<size_t>(channel.sampler)].output, 3);
        for (size_t i = 0; i + 2 < scales.size(); i += 3)
          if (!is_even(static_cast<double>(scales[i]), static_cast<double>(scales[i + 1]),
                       static_cast<double>(scales[i + 2])))
            uneven[static_cast<size_t>(channel.target_node)] = 1;
      }
    return uneven;
  }

  void find_axes() {
    if (uses("VRMC_node_constraint")) {
      notes_.emplace_back("joints keep their axes: constraints of the file (VRMC_node_constraint) are bound to them");
      return;
    }
    const std::vector<char> uneven = uneven_nodes();
    const Rotation back = transposed(form_.turn);
    size_t kept = 0;
    for (size_t j = 0; j < joints_.nodes.size(); ++j) {
      const size_t node = static_cast<size_t>(joints_.nodes[j]);
      kept += uneven[node] != 0 ? 1 : 0;
      if (uneven[node] == 0)
        after_[node] = multiply(transposed(rotation_part(joints_.worlds[j])), multiply(back, form_.axes[j]));
    }
    if (kept > 0)
      notes_.push_back(std::to_string(kept) + (kept == 1 ? " joint keeps its" : " joints keep their") +
                       " axes: nonuniform scale or mirrored");
  }

  // The factor before a node's own transform: A.
  Rotation before(size_t node) const {
    const int parent = nodes_.parents[node];
    return parent < 0 ? form_.turn : transposed(after_[static_cast<size_t>(parent)]);
  }

  bool is_still(size_t node) const { return before(node) == kNoRotation && after_[node] == kNoRotation; }

  // The transform above a skinned mesh has no effect.
  bool has_effect(size_t node) const {
    const tinygltf::Node& from = model_.nodes[node];
    return from.skin < 0 || from.mesh < 0 || !from.children.empty() ||
           std::find(joints_.nodes.begin(), joints_.nodes.end(), static_cast<int>(node)) != joints_.nodes.end();
  }

  void write_node(size_t node) {
    if (is_still(node) || !has_effect(node)) return;
    const tinygltf::Node& from = model_.nodes[node];
    Json& json = node_json(node);
    if (from.matrix.size() == 16) {
      Affine local{};
      for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 4; ++c) local[r * 4 + c] = from.matrix[c * 4 + r];
      local = multiply(multiply(affine(before(node)), local), affine(after_[node]));
      for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 4; ++c) json["matrix"][c * 4 + r] = local[r * 4 + c];
      return;
    }
    const NodeParts parts = parts_of(from);
    write_rotation(
        normalized(multiply(multiply(quaternion_of(before(node)), parts.rotation), quaternion_of(after_[node]))),
        &json);
    if (from.translation.size() == 3) json["translation"] = rotated(before(node), parts.translation);
  }

  static void write_rotation(const Quaternion& rotation, Json* node) {
    const double side = rotation[3] < 0 ? -1 : 1;
    Quaternion tidy{};
    for (size_t i = 0; i < 4; ++i) tidy[i] = std::abs(rotation[i]) < 1e-12 ? 0.0 : side * rotation[i];
    if (tidy == kNoRotation4)
      node->erase("rotation");
    else
      (*node)["rotation"] = tidy;
  }

  int add_floats(const std::vector<float>& values, const char* type, size_t width) {
    return add_accessor(&source_, values.data(), values.size() * sizeof(float), type, TINYGLTF_COMPONENT_TYPE_FLOAT,
                        values.size() / width, false, false);
  }

  void write_skin(size_t s) {
    const tinygltf::Skin& skin = model_.skins[s];
    std::vector<Affine> binds = inverse_bind_matrices(path_ + ": skin " + std::to_string(s), model_, skin);
    bool changed = false;
    std::vector<float> values;
    for (size_t k = 0; k < binds.size(); ++k) {
      const Rotation& after = after_[static_cast<size_t>(skin.joints[k])];
      if (after != kNoRotation) {
        binds[k] = multiply(affine(transposed(after)), binds[k]);
        changed = true;
      }
      append_columns(binds[k], &values);
    }
    if (!changed) return;
    if (skin.inverseBindMatrices >= 0) orphans_.push_back(skin.inverseBindMatrices);
    document_["skins"][s]["inverseBindMatrices"] = add_floats(values, "MAT4", 16);
  }

  void write_animation(size_t a) {
    const tinygltf::Animation& animation = model_.animations[a];
    Json& json = document_["animations"][a];
    std::map<int, size_t> users;
    for (const tinygltf::AnimationChannel& channel : animation.channels) ++users[channel.sampler];
    for (size_t c = 0; c < animation.channels.size(); ++c) {
      const tinygltf::AnimationChannel& channel = animation.channels[c];
      const bool rotates = channel.target_path == "rotation";
      if (channel.target_node < 0 || (!rotates && channel.target_path != "translation")) continue;
      const size_t node = static_cast<size_t>(channel.target_node);
      if (is_still(node) || !has_effect(node) || (!rotates && before(node) == kNoRotation)) continue;
      const int output = animation.samplers[static_cast<size_t>(channel.sampler)].output;
      orphans_.push_back(output);
      const int written = rotates ? turned_rotations(node, output) : turned_translations(node, output);
      Json sampler = json["samplers"][static_cast<size_t>(channel.sampler)];
      sampler["output"] = written;
      if (users[channel.sampler] == 1) {
        json["samplers"][static_cast<size_t>(channel.sampler)] = std::move(sampler);
      } else {
        --users[channel.sampler];
        json["channels"][c]["sampler"] = json["samplers"].size();
        json["samplers"].push_back(std::move(sampler));
      }
    }
  }

  int turned_rotations(size_t node, int accessor) {
    std::vector<float> values = accessor_floats(path_, model_, accessor, 4);
    const Quaternion first = quaternion_of(before(node)), last = quaternion_of(after_[node]);
    for (size_t i = 0; i + 3 < values.size(); i += 4) {
      Quaternion key{};
      for (size_t k = 0; k < 4; ++k) key[k] = static_cast<double>(values[i + k]);
      key = multiply(multiply(first, key), last);
      for (size_t k = 0; k < 4; ++k) values[i + k] = static_cast<float>(key[k]);
    }
    return add_floats(values, "VEC4", 4);
  }

  int turned_translations(size_t node, int accessor) {
    std::vector<float> values = accessor_floats(path_, model_, accessor, 3);
    for (size_t i = 0; i + 2 < values.size(); i += 3) {
      const Point3 p = rotated(before(node), {static_cast<double>(values[i]), static_cast<double>(values[i + 1]),
                                              static_cast<double>(values[i + 2])});
      for (size_t k = 0; k < 3; ++k) values[i + k] = static_cast<float>(p[k]);
    }
    return add_floats(values, "VEC3", 3);
  }

  // Vectors of extensions that are given in a node's axes.
  void turn_offset(size_t node, const char* key, Json* of) {
    if (!of->is_object() || !of->contains(key)) return;
    const Json& old = (*of)[key];
    if (!old.is_array() || old.size() != 3 || node >= after_.size() || after_[node] == kNoRotation) return;
    const Point3 p = {old[0].get<double>(), old[1].get<double>(), old[2].get<double>()};
    (*of)[key] = rotated(transposed(after_[node]), p);
  }

  void write_offsets() {
    if (!document_.contains("extensions")) return;
    Json& extensions = document_["extensions"];
    if (extensions.contains("VRMC_springBone") && extensions["VRMC_springBone"].contains("colliders"))
      for (Json& collider : extensions["VRMC_springBone"]["colliders"])
        for (const char* at : {"/shape", "/extensions/VRMC_springBone_extended_collider/shape"})
          if (const Json::json_pointer shapes(at); collider.contains("node") && collider.contains(shapes))
            for (const char* shape : {"sphere", "capsule", "plane"})
              for (const char* key : {"offset", "tail", "normal"})
                if (collider[shapes].contains(shape))
                  turn_offset(collider["node"].get<size_t>(), key, &collider[shapes][shape]);
    if (!extensions.contains("VRMC_vrm")) return;
    Json& vrm = extensions["VRMC_vrm"];
    const Json::json_pointer head("/humanoid/humanBones/head/node");
    if (vrm.contains("lookAt") && vrm.contains(head))
      turn_offset(vrm[head].get<size_t>(), "offsetFromHeadBone", &vrm["lookAt"]);
  }

  // A rotation is axes q rest^-1 axes^-1 (spec/correctives.md): with q and rest both A q C it stays where axes become
  // axes A^-1.
  void write_correctives() {
    if (!document_.contains("meshes")) return;
    for (Json& mesh : document_["meshes"]) {
      const Json::json_pointer at("/extras/sinew_correctives");
      if (!mesh.contains(at)) continue;
      Json& drivers = mesh[at];
      std::map<std::string, std::string> renamed;
      for (Json& joint : drivers["joints"]) {
        const size_t node = joint.at("node").get<size_t>();
        const Quaternion first = quaternion_of(before(node));
        joint["rest"] = multiply(multiply(first, joint.at("rest").get<Quaternion>()), quaternion_of(after_.at(node)));
        joint["axes"] = multiply(joint.at("axes").get<Quaternion>(), conjugate(first));
        const auto found = std::find(joints_.nodes.begin(), joints_.nodes.end(), static_cast<int>(node));
        if (form_.names.empty() || found == joints_.nodes.end()) continue;
        const std::string& name = form_.names[static_cast<size_t>(found - joints_.nodes.begin())];
        renamed[joint.at("joint").get<std::string>()] = name;
        joint["joint"] = name;
      }
      for (Json& bend : drivers["bends"]) {
        const auto found = renamed.find(bend.value("joint", std::string()));
        if (found != renamed.end()) bend["joint"] = found->second;
      }
    }
  }

  // A joint above those without one above them; skins get it, so that readers of skins alone know it.
  void add_root() {
    std::vector<size_t> tops;
    for (const int node : joints_.nodes) {
      int up = nodes_.parents[static_cast<size_t>(node)];
      while (up >= 0 && std::find(joints_.nodes.begin(), joints_.nodes.end(), up) == joints_.nodes.end())
        up = nodes_.parents[static_cast<size_t>(up)];
      if (up < 0) tops.push_back(static_cast<size_t>(node));
    }
    if (tops.empty()) return;
    const int above = nodes_.parents[tops[0]];
    if (std::any_of(tops.begin(), tops.end(), [&](size_t top) { return nodes_.parents[top] != above; })) {
      notes_.push_back("no joint " + in_quotes(form_.root) +
                       " was added: the skeleton's roots have different parent nodes");
      return;
    }
    const size_t root = document_["nodes"].size();
    document_["nodes"].push_back({{"name", form_.root}, {"children", tops}});
    const auto replace = [&](Json* list) {
      Json kept = Json::array();
      for (const Json& node : *list)
        if (std::find(tops.begin(), tops.end(), node.get<size_t>()) == tops.end()) kept.push_back(node);
      if (kept.size() == list->size()) return;
      kept.push_back(root);
      *list = std::move(kept);
    };
    if (above >= 0)
      replace(&node_json(static_cast<size_t>(above))["children"]);
    else if (document_.contains("scenes"))
      for (Json& scene : document_["scenes"])
        if (scene.contains("nodes")) replace(&scene["nodes"]);
    add_to_skins(root, above);
  }

  void add_to_skins(size_t root, int above) {
    if (!document_.contains("skins")) return;
    const GltfSource whole = load_gltf(path_, pack_glb(path_, &document_, source_.bytes));
    const Affine world =
        multiply(affine(form_.turn), above < 0 ? kIdentity : nodes_.worlds[static_cast<size_t>(above)]);
    std::vector<int> orphans;
    for (size_t s = 0; s < whole.model.skins.size(); ++s) {
      const tinygltf::Skin& skin = whole.model.skins[s];
      std::vector<Affine> binds = inverse_bind_matrices(path_, whole.model, skin);
      const auto first = std::find_if(skin.joints.begin(), skin.joints.end(), [&](int node) {
        return std::find(joints_.nodes.begin(), joints_.nodes.end(), node) != joints_.nodes.end();
      });
      const std::optional<Affine> back = inverse(world);
      if (first == skin.joints.end() || !back) continue;
      const size_t k = static_cast<size_t>(first - skin.joints.begin());
      const size_t joint =
          static_cast<size_t>(std::find(joints_.nodes.begin(), joints_.nodes.end(), *first) - joints_.nodes.begin());
      const Affine bound =
          multiply(affine(form_.turn), multiply(joints_.worlds[joint], affine(after_[static_cast<size_t>(*first)])));
      binds.push_back(multiply(*back, multiply(bound, binds[k])));
      std::vector<float> values;
      for (const Affine& bind : binds) append_columns(bind, &values);
      if (skin.inverseBindMatrices >= 0) orphans.push_back(skin.inverseBindMatrices);
      document_["skins"][s]["joints"].push_back(root);
      document_["skins"][s]["inverseBindMatrices"] = add_floats(values, "MAT4", 16);
      document_["skins"][s].erase("skeleton");
    }
    drop_unused_accessors(orphans, &source_);
  }

  const std::string& path_;
  const DocumentForm& form_;
  const GltfJoints& joints_;
  GltfSource& source_;
  Json& document_;
  tinygltf::Model model_;  // of the document as it was given
  GltfNodes nodes_;
  std::vector<Rotation> after_;  // [N] C of each node
  std::vector<int> orphans_;
  std::vector<std::string> notes_;
};

}  // namespace

std::vector<std::string> put_into_form(const std::string& path, const DocumentForm& form, const GltfJoints& joints,
                                       GltfSource* source) {
  try {
    return FormApplier(path, form, joints, source).apply();
  } catch (const nlohmann::json::exception& error) {
    throw Error(path + ": cannot write, the input document has an unexpected form: " + one_line(error.what()));
  }
}

}  // namespace sinew
