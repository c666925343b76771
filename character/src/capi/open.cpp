// SPDX-License-Identifier: MIT
// Characters from files, memory and arrays; errors.
#include <cmath>
#include <filesystem>
#include <set>

#include "conversions.hpp"
#include "handle.hpp"
#include "sinew_formats/file_kinds.hpp"

namespace sinew {
namespace {

thread_local std::string last_error;

// One line of printable text, whatever bytes a file's name has.
std::string one_line_of(const char* text) {
  std::string line = text;
  for (char& c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 32 || byte == 127) c = c == '\n' || c == '\r' || c == '\t' ? ' ' : '?';
  }
  return line;
}

Character mesh_of(const sinew_mesh& mesh) {
  need(mesh.positions != nullptr, "mesh.positions");
  if (mesh.vertex_count == 0 || mesh.vertex_count > SINEW_MAX_VERTICES)
    throw Failure(SINEW_ERROR_COUNT, "mesh: expected 1 to " + std::to_string(SINEW_MAX_VERTICES) + " vertices, found " +
                                         std::to_string(mesh.vertex_count));
  Character character;
  character.vertices.resize(mesh.vertex_count);
  for (size_t v = 0; v < mesh.vertex_count; ++v) {
    const float* p = mesh.positions + 3 * v;
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      throw Failure(SINEW_ERROR_NOT_FINITE, "mesh: vertex " + std::to_string(v) + " is not finite");
    character.vertices[v] = {p[0], p[1], p[2]};
  }
  if (mesh.face_count == 0) return character;
  need(mesh.face_vertices != nullptr, "mesh.face_vertices");
  character.face_offsets.resize(size_t{mesh.face_count} + 1);
  for (size_t f = 0; f <= mesh.face_count; ++f)
    character.face_offsets[f] = mesh.face_offsets != nullptr ? mesh.face_offsets[f] : static_cast<uint32_t>(3 * f);
  bool rises = character.face_offsets[0] == 0 && character.face_offsets.back() == mesh.corner_count;
  for (size_t f = 0; f < mesh.face_count; ++f)
    rises = rises && character.face_offsets[f] + 3 <= character.face_offsets[f + 1];
  if (!rises)
    throw Failure(SINEW_ERROR_INDEX, "mesh: expected faces of at least three corners, offsets from 0 to corner_count");
  character.face_vertices.assign(mesh.face_vertices, mesh.face_vertices + mesh.corner_count);
  for (size_t c = 0; c < mesh.corner_count; ++c)
    if (mesh.face_vertices[c] >= mesh.vertex_count)
      throw Failure(SINEW_ERROR_INDEX, "mesh: corner " + std::to_string(c) + " names vertex " +
                                           std::to_string(mesh.face_vertices[c]) + " of " +
                                           std::to_string(mesh.vertex_count));
  return character;
}

}  // namespace

void open_into(sinew_character* opened) {
  if (is_picture(opened->path)) return open_picture_into({}, opened);
  CharacterFile file = open_character(opened->path);
  opened->character = std::move(file.character);
  opened->own_skeleton = file.own_skeleton;
}

std::shared_ptr<FileBytes> bytes_of(const sinew_file* files, uint32_t file_count) {
  need(files != nullptr && file_count > 0, "files");
  auto bytes = std::make_shared<FileBytes>();
  for (uint32_t i = 0; i < file_count; ++i) {
    need(files[i].name != nullptr, "files: name");
    need(files[i].bytes != nullptr || files[i].size_bytes == 0, "files: bytes");
    const auto* first = static_cast<const uint8_t*>(files[i].bytes);
    const std::string name = std::filesystem::path(files[i].name).lexically_normal().generic_string();
    (*bytes)[name] =
        first == nullptr ? std::vector<uint8_t>() : std::vector<uint8_t>(first, first + files[i].size_bytes);
  }
  return bytes;
}

std::vector<Joint> joints_of(const sinew_skeleton* given) {
  const sinew_skeleton skeleton = options_of(given);
  const char* const* names = skeleton.names;
  need(skeleton.positions != nullptr && skeleton.parents != nullptr, "skeleton.positions, skeleton.parents");
  const uint32_t count = skeleton.joint_count;
  if (count == 0 || count > SINEW_MAX_JOINTS)
    throw Failure(SINEW_ERROR_COUNT, "skeleton: expected 1 to " + std::to_string(SINEW_MAX_JOINTS) + " joints, found " +
                                         std::to_string(count));
  std::vector<Joint> joints(count);
  std::set<std::string> taken;
  for (uint32_t j = 0; j < count; ++j) {
    const float* p = skeleton.positions + 3 * size_t{j};
    const std::string name = names != nullptr && names[j] != nullptr ? names[j] : "joint" + std::to_string(j);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      throw Failure(SINEW_ERROR_NOT_FINITE, "skeleton: joint " + name + " is not finite");
    if (skeleton.parents[j] < -1 || skeleton.parents[j] >= static_cast<int32_t>(count))
      throw Failure(SINEW_ERROR_INDEX, "skeleton: the parent of joint " + name + " does not exist");
    if (name.empty() || !taken.insert(name).second)
      throw Error("skeleton: expected a unique name for joint " + std::to_string(j) + ", found '" + name + "'");
    joints[j].name = name;
    joints[j].position = {p[0], p[1], p[2]};
    joints[j].parent = skeleton.parents[j];
    if (skeleton.flags == nullptr) continue;
    if ((skeleton.flags[j] & SINEW_JOINT_NEVER) != 0) joints[j].deforms = false;
    if ((skeleton.flags[j] & SINEW_JOINT_DEFORMS) != 0) joints[j].deforms = true;
  }
  for (uint32_t j = 0; j < count; ++j) {
    uint32_t steps = 0;
    for (int at = joints[j].parent; at >= 0; at = joints[static_cast<size_t>(at)].parent)
      if (++steps > count)
        throw Failure(SINEW_ERROR_HIERARCHY, "skeleton: the parents of joint " + joints[j].name + " form a cycle");
  }
  return joints;
}

sinew_status fail(const sinew_character* character, sinew_status status, const char* line) noexcept {
  try {
    last_error = one_line_of(line);
    if (character != nullptr) character->error = last_error;
  } catch (...) {  // no memory for the line: the status says it
  }
  return status;
}

void changed(sinew_character* character) {
  character->same_skin = false;
  character->viewed = false;
  character->clip_views.clear();
  character->springs.reset();  // they are of the joints that were there
  character->spring_player.reset();
}

void check_nothing_added(const sinew_character& character) {
  if (!character.clips.empty() || !character.morphs.shapes.empty())
    throw Error(character.character.name +
                ": has clips or morph targets that are not saved yet; save it and open that file");
}

}  // namespace sinew

using namespace sinew;

extern "C" {

const char* sinew_character_error(const sinew_character* character) {
  return character == nullptr ? last_error.c_str() : character->error.c_str();
}

const char* sinew_character_extensions(uint32_t uses) {
  static_assert(uint32_t{SINEW_READ_MESH} == uint32_t{kReadsMesh} &&
                uint32_t{SINEW_READ_SKELETON} == uint32_t{kReadsSkeleton});
  static_assert(uint32_t{SINEW_READ_MOTION} == uint32_t{kReadsMotion} &&
                uint32_t{SINEW_READ_WHOLE} == uint32_t{kReadsWhole});
  static_assert(uint32_t{SINEW_WRITE_CHARACTER} == uint32_t{kWritesCharacter} &&
                uint32_t{SINEW_WRITE_MOTION} == uint32_t{kWritesMotion});
  static_assert(uint32_t{SINEW_WRITE_MESH} == uint32_t{kWritesMesh} &&
                uint32_t{SINEW_READ_PICTURE} == uint32_t{kReadsPicture});
  constexpr uint32_t kAll = 511 & ~uint32_t{kOffered};
  static const std::vector<std::string> texts = [] {
    std::vector<std::string> all;
    for (uint32_t use = 0; use <= kAll; ++use) all.push_back(extensions_text(use, " "));
    return all;
  }();
  return (uses & ~kAll) == 0 ? texts[uses].c_str() : "";
}

sinew_status sinew_character_open(const char* path, sinew_character** character) {
  return guarded(nullptr, [&] {
    need(path != nullptr, "path");
    need(character != nullptr, "character");
    auto opened = std::make_unique<sinew_character>();
    opened->path = path;
    open_into(opened.get());
    *character = opened.release();
  });
}

sinew_status sinew_character_open_files(const sinew_file* files, uint32_t file_count, sinew_character** character) {
  return guarded(nullptr, [&] {
    need(character != nullptr, "character");
    auto opened = std::make_unique<sinew_character>();
    opened->files = bytes_of(files, file_count);
    opened->path = files[0].name;
    const FilesOf scope(*opened);
    open_into(opened.get());
    *character = opened.release();
  });
}

sinew_status sinew_character_create(const sinew_mesh* mesh, const sinew_skeleton* skeleton,
                                    sinew_character** character) {
  return guarded(nullptr, [&] {
    need(mesh != nullptr || skeleton != nullptr, "mesh, skeleton");
    need(character != nullptr, "character");
    auto made = std::make_unique<sinew_character>();
    if (mesh != nullptr) made->character = mesh_of(*mesh);
    if (skeleton != nullptr) made->character.joints = joints_of(skeleton);
    made->character.name = "character";
    made->same_skin = false;
    *character = made.release();
  });
}

sinew_status sinew_character_copy(const sinew_character* from, sinew_character** character) {
  return guarded(from, [&] {
    need(from != nullptr, "from");
    need(character != nullptr, "character");
    auto copy = std::make_unique<sinew_character>();
    copy->character = from->character;
    copy->path = from->path;
    copy->files = from->files;
    copy->picture = from->picture;
    copy->own_skeleton = from->own_skeleton;
    copy->same_skin = from->same_skin;
    copy->drop_animations = from->drop_animations;
    copy->keep_confidence = from->keep_confidence;
    copy->profile = from->profile;
    copy->profile_options = from->profile_options;
    copy->own_motion = from->own_motion;
    copy->clips = from->clips;
    copy->keypoints = from->keypoints;
    copy->morphs = from->morphs;
    *character = copy.release();
  });
}

void sinew_character_close(sinew_character* character) { delete character; }

}  // extern "C"
