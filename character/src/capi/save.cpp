// SPDX-License-Identifier: MIT
// Characters to files and memory, as the command writes them.
#include "handle.hpp"
#include "sinew_character/profile/controls.hpp"
#include "sinew_character/profile/vrm_clips.hpp"
#include "sinew_formats/file_kinds.hpp"

namespace sinew {
namespace {

void write_clip(sinew_character* from, const std::string& path) {
  Motion added = motion_of(from->character.joints);
  added.clips = from->clips;
  write_clips(path, from->character, from->clips.empty() ? own_motion(from) : added);
}

void save(sinew_character* from, const std::string& path) {
  const FileKind* kind = file_kind(path);
  if (kind == nullptr || (kind->uses & (kWritesCharacter | kWritesMotion)) == 0)
    throw Error(path + ": cannot write, expected a name that ends with one of " + extensions_text(kWritesCharacter) +
                ", .bvh, .vrma");
  if (is_motion_alone(path)) return write_clip(from, path);
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
  options.springs = from->springs ? &*from->springs : nullptr;
  const Character& written = leave_out ? plain : character;
  if (from->profile.empty()) {
    if (from->profile_options.controls) options.extras = controls_extras(controls_text(written));
    return write_character(path, written, options, from->morphs);
  }
  std::vector<std::string> notes =
      write_for_profile(profile_named(from->profile), from->profile_options, path, written, options, from->morphs);
  std::vector<std::string>& told = from->character.notes;
  for (std::string& note : notes)
    if (std::find(told.begin(), told.end(), note) == told.end()) told.push_back(std::move(note));
}

std::string text_of(const char* text) { return text == nullptr ? std::string() : std::string(text); }

void set_profile(sinew_character* character, const sinew_character_profile_options& given) {
  need(given.author_count == 0 || given.authors != nullptr, "authors");
  check_at_most("keep_axes", given.keep_axes, 1);
  check_at_most("controls", given.controls, 1);
  ProfileOptions options;
  options.keep_axes = given.keep_axes != 0;
  options.controls = given.controls != 0;
  options.license = text_of(given.license);
  options.title = text_of(given.title);
  for (uint32_t a = 0; a < given.author_count; ++a) {
    need(given.authors[a] != nullptr, "authors");
    options.authors.emplace_back(given.authors[a]);
  }
  const std::string profile = text_of(given.profile);
  if (!profile.empty()) check_profile(profile_named(profile), options);
  character->profile = profile;
  character->profile_options = std::move(options);
}

std::string controls_now(const sinew_character& from) {
  if (from.character.joints.empty()) throw Error(from.character.name + ": has no skeleton for controls");
  if (from.profile.empty()) return controls_text(from.character);
  return controls_for_profile(profile_named(from.profile), from.profile_options, from.character);
}

std::string all_profiles() {
  std::string names;
  for (const Profile& profile : profiles()) names += (names.empty() ? "" : " ") + std::string(profile.name);
  return names;
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

sinew_status sinew_character_set_profile(sinew_character* character, const sinew_character_profile_options* options) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    set_profile(character, options_of(options));
  });
}

sinew_status sinew_character_controls(sinew_character* character, const char** text) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(text != nullptr, "text");
    character->controls = controls_now(*character);
    *text = character->controls.c_str();
  });
}

const char* sinew_character_profiles(void) {
  static const std::string names = all_profiles();
  return names.c_str();
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
