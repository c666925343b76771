// SPDX-License-Identifier: MIT
// Damages of glTF files' nodes and matrices, and of clips.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>

#include "gltf/gltf_container.hpp"
#include "score/rig_damage.hpp"
#include "sinew_character/jobs/animate_job.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/motion/motion_file.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"

namespace sinew {
namespace {

using nlohmann::json;

constexpr const char* kName = "damaged.glb";

// The skin's joints by node, those with most vertices first: that damage shows on.
std::vector<size_t> heavy_joints(const Character& character) {
  const auto vertices = vertices_by_joint(character);
  std::vector<size_t> order;
  for (size_t j = 0; j < vertices.size(); ++j)
    if (vertices[j].size() >= 8 && character.joints[j].parent >= 0) order.push_back(j);
  return order;
}

json* node_named(const std::string& name, json* document) {
  for (json& node : (*document)["nodes"])
    if (node.value("name", "") == name) return &node;
  return nullptr;
}

void move_matrix(const Character& c, size_t joint, json* document, std::vector<uint8_t>* bytes) {
  const json& skin = (*document)["skins"][0];
  const json& accessor = (*document)["accessors"][skin["inverseBindMatrices"].get<size_t>()];
  const json& view = (*document)["bufferViews"][accessor["bufferView"].get<size_t>()];
  const size_t offset = view.value("byteOffset", size_t{0}) + accessor.value("byteOffset", size_t{0});
  for (size_t k = 0; k < skin["joints"].size(); ++k) {
    if ((*document)["nodes"][skin["joints"][k].get<size_t>()].value("name", "") != c.joints[joint].name) continue;
    float x = 0;
    uint8_t* const at = bytes->data() + offset + k * 64 + 12 * 4;
    std::memcpy(&x, at, 4);
    x += 0.2F * longest_side(c);
    std::memcpy(at, &x, 4);
  }
}

bool damage_document(const std::string& kind, Draws* draws, const Character& c, json* document,
                     std::vector<uint8_t>* bytes) {
  const std::vector<size_t> heavy = heavy_joints(c);
  if (heavy.empty()) return false;
  if (kind == "bind-matrix") {
    move_matrix(c, draws->of(heavy), document, bytes);
    return true;
  }
  if (kind == "uneven-scale") {
    json* const node = node_named(c.joints[draws->of(heavy)].name, document);
    if (node == nullptr) return false;
    (*node)["scale"] = {1.5, 1.0, 1.0};
    return true;
  }
  if (kind == "exploded-rest") {
    for (const size_t j : heavy)
      if (json* const node = node_named(c.joints[j].name, document); node != nullptr && node->contains("translation"))
        for (json& value : (*node)["translation"]) value = 4 * value.get<double>();
    return true;
  }
  // mirrored-scale: roots of the scene under a node of its own.
  json& scene = (*document)["scenes"][document->value("scene", size_t{0})];
  json wrapper = {{"name", "mirrored"}, {"scale", {-1.0, 1.0, 1.0}}, {"children", scene["nodes"]}};
  (*document)["nodes"].push_back(wrapper);
  scene["nodes"] = json::array({(*document)["nodes"].size() - 1});
  return true;
}

}  // namespace

bool is_file_damage(const std::string& kind) {
  return kind == "bind-matrix" || kind == "mirrored-scale" || kind == "exploded-rest" || kind == "uneven-scale";
}

bool is_clip_damage(const std::string& kind) { return kind.rfind("foot-", 0) == 0 || kind.rfind("clip-", 0) == 0; }

std::optional<Character> damage_file(const std::string& kind, Draws* draws, const Character& character) {
  Character plain = character;
  plain.gltf.reset();
  std::vector<NamedBytes> written;
  {
    const MemoryFiles scope(nullptr, &written);
    write_glb(kName, plain);
  }
  FileBytes files;
  std::vector<uint8_t>& file = files[kName];
  file = written.at(0).bytes;
  if (!kind.empty()) {
    json document = json::parse(gltf_text(file));
    std::vector<uint8_t> bytes = load_buffers(kName, file, document).at(0);
    if (!damage_document(kind, draws, plain, &document, &bytes)) return std::nullopt;
    file = pack_glb(kName, &document, std::move(bytes));
  }
  const MemoryFiles scope(&files, nullptr);
  Character read = read_gltf(kName);
  read.name = character.name;
  return read;
}

std::optional<Motion> walk_of(const Character& character) {
  const JointVerdicts verdicts = joint_verdicts(character.joints);
  size_t feet = 0;
  for (size_t j = 0; j < character.joints.size(); ++j)
    feet += verdicts.classes[j] == SINEW_CLASS_FOOT && verdicts.sides[j] != 0 ? 1 : 0;
  if (feet < 2) return std::nullopt;
  try {
    AnimatedCharacter out = animated_character(character, character.name);
    MotionRequest request;
    request.path = "builtin:walk";
    const MotionFile file = read_motion_for(request, map_rig_of(character));
    AnimateOptions options;
    options.character = character.name;
    MotionInput input;
    input.file = request.path;
    input.motion = &file.motion;
    add_motion(
        options, input, [](size_t) { return [] { return true; }; }, &out);
    return out.motion;
  } catch (const OutOfMemory&) {
    throw;
  } catch (const Error&) {  // it does not fit
    return std::nullopt;
  }
}

bool damage_clip(const std::string& kind, Draws* draws, const Character& character, Motion* motion) {
  std::vector<MotionFrame>& frames = motion->clips[0].frames;
  std::vector<size_t> roots;
  for (size_t j = 0; j < character.joints.size(); ++j)
    if (character.joints[j].parent < 0) roots.push_back(j);
  Vec3 low = character.vertices[0], high = low;
  for (const Vec3& p : character.vertices) low.y = std::min(low.y, p.y), high.y = std::max(high.y, p.y);
  const double height = static_cast<double>(high.y - low.y);
  const size_t at = frames.size() / 3 + draws->below(std::max<size_t>(1, frames.size() / 3));
  if (kind == "clip-flip") {
    std::vector<size_t> joints = heavy_joints(character);
    if (joints.empty()) return false;
    const size_t joint = draws->of(joints);
    const Quaternion q = frames[at].rotations[joint];
    frames[at].rotations[joint] = {q[3], q[2], -q[1], -q[0]};  // 180 degrees about x
    return true;
  }
  // A walk over the frames: what is pulled along goes to and fro by 15 % of the height.
  for (size_t f = 0; f < frames.size(); ++f)
    for (const size_t root : roots) {
      Point3& p = frames[f].translations[root];
      const double part = static_cast<double>(f % 16) / 16;
      if (kind == "foot-slide") p[0] += height * 0.15 * (part < 0.5 ? part : 1 - part);
      if (kind == "foot-float") p[1] += 0.1 * height;
      if (kind == "foot-sink") p[1] -= 0.06 * height;
      if (kind == "clip-jump" && f >= at) p[2] += 0.25 * height;
    }
  return true;
}

}  // namespace sinew
