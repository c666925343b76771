// SPDX-License-Identifier: MIT
// Chooses the reader by file name, and finds which skeleton belongs to which mesh.
#include <filesystem>

#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {
namespace {

// Read as glTF, or converted to it.
bool is_scene(const std::string& path) { return has_use(path, kReadsWhole); }

}  // namespace

Character read_mesh(const std::string& path) {
  if (path == "-" || has_extension(path, ".obj")) return read_obj(path);
  if (is_scene(path)) return read_gltf(path);
  throw Error(path + ": expected a mesh (" + extensions_text(kReadsMesh) +
              ", or - for an OBJ on standard input), found another extension" + remedy(path));
}

void read_skeleton(const std::string& path, bool with_skin, Character* character) {
  character->meshes.clear();  // they were bound to another skeleton
  character->vertex_meshes.clear();
  if (has_extension(path, ".txt")) return read_rig(path, with_skin, character);
  if (is_motion_alone(path)) {
    if (with_skin)
      throw Error(path + ": expected skin weights, found a " + std::string(file_kind(path)->name) +
                  ", which holds none");
    character->joints = rest_joints(read_motion(path));
    character->influences.clear();
    return;
  }
  if (!is_scene(path))
    throw Error(path + ": expected a skeleton (" + extensions_text(kReadsSkeleton) + "), found another extension" +
                remedy(path));
  Character other = read_gltf_character(path, with_skin);
  if (other.joints.empty()) throw Error(path + ": expected a skeleton, found a file without a skin");
  if (with_skin && other.vertices.size() != character->vertices.size())
    throw Error(path + ": expected weights for " + std::to_string(character->vertices.size()) + " vertices, found " +
                std::to_string(other.vertices.size()));
  character->joints = std::move(other.joints);
  character->influences = with_skin ? std::move(other.influences) : std::vector<std::vector<Influence>>();
}

Character read_character(const std::string& path) {
  if (is_scene(path)) {
    Character character = read_gltf(path);
    if (character.joints.empty()) throw Error(path + ": expected a rigged character, found a mesh without a skin");
    return character;
  }
  std::string obj = path;
  if (has_extension(path, ".rig.txt"))
    obj = (std::filesystem::path(path).parent_path() / (stem_of(path) + ".obj")).string();
  else if (!has_extension(path, ".obj"))
    throw Error(path + ": expected a character (.obj or .rig.txt of a pair, " + extensions_text(kReadsWhole) +
                "), found another extension" + remedy(path));
  Character character = read_obj(obj);
  read_rig(rig_path_beside(obj), true, &character);
  return character;
}

}  // namespace sinew
