// SPDX-License-Identifier: MIT
// Characters to files and memory, as the command writes them.
#include "handle.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/file_names.hpp"

namespace sinew {
namespace {

void write_clip(sinew_character* from, const std::string& path) {
  Motion added = motion_of(from->character.joints);
  added.clips = from->clips;
  const Motion& motion = from->clips.empty() ? own_motion(from) : added;
  if (motion.clips.size() != 1)
    throw Error(path + ": a BVH holds one clip, and there are " + std::to_string(motion.clips.size()) +
                "; write a .glb");
  write_bvh(path, motion, motion.clips[0]);
}

void save(sinew_character* from, const std::string& path) {
  const FileKind* kind = file_kind(path);
  if (kind == nullptr || (kind->uses & (kWritesCharacter | kWritesMotion)) == 0)
    throw Error(path + ": cannot write, expected a name that ends with one of " + extensions_text(kWritesCharacter) +
                ", .bvh");
  if (kind->reader == FileReader::kBvh) return write_clip(from, path);
  const Character& character = from->character;
  if (character.vertices.empty() && kind->reader != FileReader::kRig)
    throw Error(path + ": cannot write, " + character.name + " has no mesh; expected a .rig.txt or .bvh");
  if (from->posed && kind->reader == FileReader::kObj) return write_obj(path, character);
  Character plain;  // confidence is written where it was asked for
  const bool leave_out = !from->keep_confidence && !character.confidence.empty();
  if (leave_out) {
    plain = character;
    plain.confidence.clear();
  }
  Motion motion = motion_of(character.joints);
  motion.clips = from->clips;
  GlbOptions options;
  options.keep_skin = from->same_skin;
  options.drop_animations = from->drop_animations;
  options.motion = &motion;
  write_character(path, leave_out ? plain : character, options, from->morphs);
}

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" {

sinew_status sinew_character_save(sinew_character* character, const char* path) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(path != nullptr, "path");
    const FilesOf scope(*character);
    save(character, path);
  });
}

sinew_status sinew_character_write(sinew_character* character, const char* name, const sinew_file** files,
                                   uint32_t* file_count) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(name != nullptr, "name");
    need(files != nullptr && file_count != nullptr, "files, file_count");
    std::vector<NamedBytes> written;
    {
      const MemoryFiles scope(character->files.get(), &written);
      save(character, name);
    }
    std::stable_partition(written.begin(), written.end(), [&](const NamedBytes& file) { return file.path == name; });
    character->written = std::move(written);
    character->written_files.clear();
    for (const NamedBytes& file : character->written)
      character->written_files.push_back({file.path.c_str(), file.bytes.data(), file.bytes.size()});
    *files = character->written_files.data();
    *file_count = count32(character->written_files.size());
  });
}

}  // extern "C"
