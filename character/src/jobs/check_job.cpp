// SPDX-License-Identifier: MIT
// A file's mesh, skeleton and animations, checked.
#include "sinew_character/check/check_output.hpp"
#include "sinew_character/jobs/character_file.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"

namespace sinew {
namespace {

// None is fine: the file itself was read before.
Motion motion_in(const std::string& path, const Character& character) {
  if (!has_use(path, kReadsMotion)) return motion_of(character.joints);
  try {
    return read_motion(path);
  } catch (const OutOfMemory&) {
    throw;
  } catch (const Error&) {
    return motion_of(character.joints);
  }
}

}  // namespace

CheckedFile check_file(const std::string& path, const CheckOptions& options) {
  CheckedFile out;
  out.file = path;
  out.character = open_character(path).character;
  if (out.character.joints.empty()) throw Error(path + ": has no skeleton to check; sinew rig makes one");
  out.motion = motion_in(path, out.character);
  out.check = check_rig(out.character, &out.motion, options);
  return out;
}

void check_against(const std::string& path, const CheckOptions& options, CheckedFile* file) {
  CheckedFile older = check_file(path, options);
  file->before = std::move(older.check);
  file->joints_before = std::move(older.character.joints);
  file->change = check_change(*file->before, file->joints_before, file->check, file->character.joints);
}

}  // namespace sinew
