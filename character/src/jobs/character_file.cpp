// SPDX-License-Identifier: MIT
// Which reader, which writer.
#include "sinew_character/jobs/character_file.hpp"

#include <filesystem>

#include "sinew_character/clips/builtin_motion.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/memory_files.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {
namespace {

Character skeleton_alone(const std::string& path) {
  Character character;
  character.name = stem_of(path);
  read_skeleton(path, false, &character);
  return character;
}

CharacterFile open_obj(const std::string& path) {
  const std::string rig = rig_path_beside(path);
  if (!is_file(rig)) return {read_mesh(path), true};
  try {
    return {read_character(path), false};
  } catch (const Error& error) {
    Character character = read_mesh(path);  // reports the error of the mesh
    character.notes.push_back("left out: " + std::string(error.what()));
    return {std::move(character), true};
  }
}

Character skeleton_of(const Motion& motion) {
  Character character;
  character.name = motion.name;
  character.joints = rest_joints(motion);
  return character;
}

// A file of joints or motion alone has no mesh.
CharacterFile open_scene(const std::string& path) {
  try {
    return {read_mesh(path), true};
  } catch (const OutOfMemory&) {
    throw;
  } catch (const Error&) {
    try {
      return {skeleton_alone(path), true};
    } catch (const Error&) {
    }
    try {
      return {skeleton_of(read_motion(path)), true};
    } catch (const Error&) {
    }
    throw;  // what is wrong with the mesh
  }
}

}  // namespace

CharacterFile open_character(const std::string& path) {
  if (is_builtin_motion(path)) return {skeleton_of(builtin_motions(path)[0]), true};
  if (is_motion_alone(path)) return {skeleton_alone(path), true};
  const FileKind* kind = file_kind(path);
  if (kind == nullptr || kind->reader == FileReader::kNone)
    return {read_mesh(path), true};  // throws Error that lists the extensions
  switch (kind->reader) {
    case FileReader::kObj:
      return open_obj(path);
    case FileReader::kRig: {
      const std::string beside = (std::filesystem::path(path).parent_path() / (stem_of(path) + ".obj")).string();
      return {has_extension(path, ".rig.txt") && is_file(beside) ? read_character(path) : skeleton_alone(path), false};
    }
    default:
      return open_scene(path);
  }
}

void write_character(const std::string& path, const Character& character, const GlbOptions& options,
                     const Morphs& morphs) {
  const FileKind* kind = path == "-" ? nullptr : file_kind(path);
  if (kind == nullptr || kind->reader == FileReader::kRig) {
    write_rig(path, character);
  } else if (kind->reader != FileReader::kObj) {
    write_gltf_morphs(path, character, options, morphs);
  } else {
    write_obj(path, character);
    if (!character.joints.empty()) write_rig(rig_path_beside(path), character);
  }
}

}  // namespace sinew
