// SPDX-License-Identifier: MIT
// Character to a skinned GLB, VRM, .gltf with .bin or FBX: the input's own document or a new one, with the skin put in.
#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "fbx/fbx_write.hpp"
#include "gltf/gltf_container.hpp"
#include "gltf/gltf_source.hpp"
#include "gltf/springs.hpp"
#include "gltf/vrm.hpp"
#include "sinew_formats/document_form.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"
#include "sinew_formats/morphs.hpp"
#include "text/text_lines.hpp"
#include "usd/usd_write.hpp"

namespace fs = std::filesystem;

namespace sinew {
namespace {

// The name, seen from the folder of `path`, of a file that a document at `from` names by `uri`.
std::string moved_uri(const std::string& uri, const std::string& from, const std::string& path) {
  std::error_code first, second;
  const fs::path file = fs::weakly_canonical(fs::absolute(from).parent_path() / percent_decoded(uri), first),
                 folder = fs::weakly_canonical(fs::absolute(path).parent_path(), second);
  const fs::path relative = first || second ? fs::path() : file.lexically_relative(folder);
  std::string moved;
  for (const fs::path& part : relative) moved += (moved.empty() ? "" : "/") + percent_encoded(part.generic_string());
  return moved.empty() ? uri : moved;
}

bool same_folder(const std::string& a, const std::string& b) {
  std::error_code first, second;
  const fs::path x = fs::weakly_canonical(fs::absolute(a).parent_path(), first),
                 y = fs::weakly_canonical(fs::absolute(b).parent_path(), second);
  return !first && !second && x == y;
}

// Where the skin of the document as it was read has its joints.
GltfJoints own_joints(const GltfSource& source) {
  GltfJoints joints = {source.joint_nodes, {}};
  for (const int node : joints.nodes) joints.worlds.push_back(source.bind_pose.worlds[static_cast<size_t>(node)]);
  return joints;
}

// Controls (formats/spec/controls.md) of another skeleton or form say nothing of this one.
void drop_old_controls(const std::vector<Joint>& joints, bool formed, Json* document) {
  const Json::json_pointer at("/extras/sinew_controls");
  if (!document->contains(at)) return;
  bool stays = !formed && (*document)[at].is_object();
  const Json listed = stays ? (*document)[at].value("joints", Json::array()) : Json::array();
  for (const Json& one : listed) {
    const std::string name = one.is_object() && one.contains("name") && one["name"].is_string() ? one["name"] : "";
    stays = stays && std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) { return joint.name == name; });
  }
  if (!stays) (*document)["extras"].erase("sinew_controls");
}

void add_extras(const std::string& extras, Json* document) {
  if (extras.empty()) return;
  Json& all = (*document)["extras"];
  if (!all.is_object()) all = Json::object();
  const Json added = Json::parse(extras);
  for (const auto& [key, value] : added.items()) all[key] = value;
}

constexpr Rotation kZToY = {1, 0, 0, 0, 0, 1, 0, -1, 0};

// Springs of the character's own file for the joints that it still has; broken ones go with the skeleton.
std::optional<Springs> springs_left(const std::string& path, const Character& character) {
  try {
    return read_springs(path, character);
  } catch (const Error&) {
    return std::nullopt;
  }
}

// A glTF has y up: the roots of every scene become children of a node that rotates z to y.
void raise_z(GltfJoints* joints, Json* document) {
  constexpr double kHalf = 0.70710678118654752440;
  std::map<size_t, size_t> raised;  // roots that several scenes show
  for (Json& scene : (*document)["scenes"]) {
    std::set<size_t> tops;
    Json children = Json::array();
    for (const Json& root : scene.value("nodes", Json::array())) {
      const auto [entry, fresh] = raised.emplace(root.get<size_t>(), (*document)["nodes"].size());
      if (fresh) children.push_back(root);
      tops.insert(entry->second);
    }
    if (!children.empty())
      (*document)["nodes"].push_back({{"name", "z_up"}, {"rotation", {-kHalf, 0, 0, kHalf}}, {"children", children}});
    if (!tops.empty()) scene["nodes"] = tops;
  }
  for (Affine& world : joints->worlds) world = multiply({1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0}, world);
}

// The document with the character's skin, motion and shapes; pictures are not yet in it.
//   form  or null
//   notes  gets what the form says; with a form
GltfSource skinned_document(const std::string& path, const Character& character, const GlbOptions& options,
                            const Morphs* morphs, const DocumentForm* form, std::vector<std::string>* notes) {
  const bool has_document = character.gltf && character.gltf->vertex_count == character.vertices.size();
  GltfSource source = has_document ? *character.gltf : gltf_from_mesh(path, character);
  GltfJoints joints;
  bool replaced = false;               // the file's own skeleton
  std::optional<Springs> own_springs;  // the file's, for what is left of its joints
  if (options.keep_skin && has_document && !source.joint_nodes.empty()) {
    joints = own_joints(source);
  } else if (!character.influences.empty() && !character.joints.empty()) {
    if (character.influences.size() != character.vertices.size())
      throw Error(path + ": cannot write, expected influences for " + std::to_string(character.vertices.size()) +
                  " vertices, found " + std::to_string(character.influences.size()));
    joints = write_gltf_skin(path, character, options.unorm8, &source);
    replaced = has_document && !source.joint_nodes.empty() &&
               (joints.nodes.size() < source.joint_nodes.size() ||
                !std::equal(source.joint_nodes.begin(), source.joint_nodes.end(), joints.nodes.begin()));
    if (replaced) {
      if (options.springs == nullptr) own_springs = springs_left(path, character);
      drop_old_skeleton(&joints, &source);
    }
  } else if (!has_document) {
    joints.nodes = add_joint_nodes(path, character.joints, &source.document);
    for (const Joint& joint : character.joints)
      joints.worlds.push_back({1, 0, 0, static_cast<double>(joint.position.x), 0, 1, 0,
                               static_cast<double>(joint.position.y), 0, 0, 1, static_cast<double>(joint.position.z)});
  }
  if (options.drop_animations) source.document.erase("animations");
  if (options.motion != nullptr && !options.motion->clips.empty()) {
    if (joints.nodes.size() != character.joints.size() || joints.nodes.size() != options.motion->joints.size())
      throw Error(path + ": cannot write, expected a motion of the character's " +
                  std::to_string(character.joints.size()) + " joints, found one of " +
                  std::to_string(options.motion->joints.size()));
    write_gltf_motion(path, *options.motion, joints, &source);
  }
  if (morphs != nullptr && !morphs->shapes.empty())
    add_gltf_morphs(path, character, *morphs, joints, options.motion != nullptr ? options.motion->clips.size() : 0,
                    &source);
  const auto say = [&](std::vector<std::string> more) { notes->insert(notes->end(), more.begin(), more.end()); };
  if (form != nullptr && form->vrm != nullptr && !form->vrm->zero) say(turn_vrm_zero_into_one(&source.document));
  if (options.springs != nullptr || own_springs) {
    if (joints.nodes.size() != character.joints.size())
      throw Error(path + ": cannot write springs, the character has no joints in the document");
    const Rotation turn = form != nullptr ? form->turn : character.up == Axis::kZ ? kZToY : kNoRotation;
    write_springs(options.springs != nullptr ? *options.springs : *own_springs, joints, turn, &source.document);
  }
  if (character.up == Axis::kZ && form == nullptr) raise_z(&joints, &source.document);  // forms stand by themselves
  if (form != nullptr) {
    say(put_into_form(path, *form, joints, &source));
    if (form->vrm != nullptr) say(add_vrm(path, *form->vrm, joints.nodes, &source));
  }
  if (replaced) drop_boneless_vrm(&source.document);
  drop_old_controls(character.joints, form != nullptr, &source.document);
  add_extras(options.extras, &source.document);
  Json& asset = source.document["asset"];
  if (!asset.contains("generator")) asset["generator"] = "sinew";
  return source;
}

void write_text_form(const std::string& path, GltfSource* source) {
  const fs::path target = path;
  const fs::path binary = target.parent_path() / (stem_of(path) + ".bin");
  std::vector<NamedBytes> files;
  if (!source->bytes.empty()) {
    source->document["buffers"][0]["byteLength"] = source->bytes.size();
    source->document["buffers"][0]["uri"] = percent_encoded(binary.filename().string());
    files.push_back({binary.string(), std::move(source->bytes)});
  }
  const std::string text = source->document.dump(2) + "\n";
  files.push_back({path, {text.begin(), text.end()}});
  write_files(files);
}

bool is_vrm(const Json& document) {
  if (!document.contains("extensions")) return false;
  const Json& extensions = document["extensions"];
  return extensions.contains("VRM") || extensions.contains("VRMC_vrm");
}

void write_document(const std::string& path, const Character& character, const GlbOptions& options,
                    const Morphs* morphs, const DocumentForm* form = nullptr,
                    std::vector<std::string>* notes = nullptr) {
  const bool as_text = has_extension(path, ".gltf");
  GltfSource source = skinned_document(path, character, options, morphs, form, notes);
  if (options.springs != nullptr && has_extension(path, ".vrm") && is_vrm(source.document) &&
      !source.document["extensions"].contains("VRMC_vrm"))
    throw Error(path + ": cannot write springs into a VRM 0.x, sinew writes those of VRM 1.0; add --for vrm");
  if (has_extension(path, ".vrm") && !is_vrm(source.document))
    throw Error(path + ": cannot write a VRM, " + character.name +
                " has no VRM data (extension VRM or VRMC_vrm); add --for vrm, or write a .glb");
  try {
    const bool in_memory = source.in_memory || memory_outputs() != nullptr;  // no folder to share
    embed_images(path, !as_text || source.path.empty() || in_memory || !same_folder(path, source.path), &source);
    if (as_text) return write_text_form(path, &source);
    if (has_extension(path, ".fbx"))
      return write_file(path,
                        fbx_of(path, load_gltf(path, pack_glb(path, &source.document, std::move(source.bytes))).model));
    if (has_extension(path, ".usda") || has_extension(path, ".usdz"))
      return write_files(
          usd_of(path, load_gltf(path, pack_glb(path, &source.document, std::move(source.bytes))).model));
    write_file(path, pack_glb(path, &source.document, std::move(source.bytes)));
  } catch (const nlohmann::json::exception& error) {
    throw Error(path + ": cannot write, a name is not UTF-8 text: " + one_line(error.what()));
  }
}

}  // namespace

void embed_images(const std::string& path, bool files_too, GltfSource* source) {
  Json& document = source->document;
  for (size_t i = 0; i < source->model.images.size(); ++i) {
    Json& image = document["images"][i];
    const std::vector<unsigned char>& bytes = source->model.images[i].image;
    const char* type = image_type(bytes);
    if (!image.contains("uri") || bytes.empty()) continue;
    const std::string uri = image["uri"].get<std::string>();
    const bool is_file = !tinygltf::IsDataURI(uri);
    if (is_file && !files_too) continue;
    if (type == nullptr) {
      if (is_file) image["uri"] = moved_uri(uri, source->path, path);
      continue;
    }
    source->bytes.resize((source->bytes.size() + 3) / 4 * 4);
    document["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", source->bytes.size()}, {"byteLength", bytes.size()}});
    source->bytes.insert(source->bytes.end(), bytes.begin(), bytes.end());
    image.erase("uri");
    image["bufferView"] = document["bufferViews"].size() - 1;
    image["mimeType"] = type;
    if (!document.contains("buffers")) document["buffers"] = Json::array({Json::object()});
  }
}

bool has_vrm_data(const Character& character) { return character.gltf && is_vrm(character.gltf->document); }

void write_gltf(const std::string& path, const Character& character, const GlbOptions& options) {
  write_document(path, character, options, nullptr);
}

void write_gltf_morphs(const std::string& path, const Character& character, const GlbOptions& options,
                       const Morphs& morphs) {
  write_document(path, character, options, &morphs);
}

std::vector<std::string> write_gltf_form(const std::string& path, const Character& character, const GlbOptions& options,
                                         const Morphs& morphs, const DocumentForm& form) {
  std::vector<std::string> notes;
  write_document(path, character, options, &morphs, &form, &notes);
  return notes;
}

}  // namespace sinew
