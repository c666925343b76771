// SPDX-License-Identifier: MIT
// What a program wants of a character: --for vrm. A profile is a row of the table in profile/profiles.cpp.
#ifndef SINEW_CHARACTER_PROFILE_HPP
#define SINEW_CHARACTER_PROFILE_HPP

#include <string>
#include <vector>

#include "sinew_formats/character.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"
#include "sinew_formats/vrm.hpp"

namespace sinew {

struct Profile {
  const char* name;     // "vrm"
  const char* about;    // one line
  const char* source;   // where its conventions are written down
  const char* pose;     // rest pose: "t", "a", "" as it stands
  uint32_t influences;  // most joints a vertex
  bool vrm;             // humanoid map and meta
};
const std::vector<Profile>& profiles();
// Throws Error that lists them.
const Profile& profile_named(const std::string& name);

// Humanoid bones of VRM 1.0 for each joint [J], "" for none: by the classes of names, of chains the parts that a VRM has. Throws Error with
// one line that lists the required bones that are missing.
std::vector<std::string> vrm_bones(const std::vector<Joint>& joints, const std::string& name);

struct ProfileOptions {
  std::vector<std::string> authors;
  std::string title;    // empty: the character's name
  std::string licence;  // as parse_vrm_licence() has it
};
// What can be said before work starts: throws Error where the profile needs more than `options` has.
void check_profile(const Profile& profile, const ProfileOptions& options);
// As write_character(), in the profile's form. Throws Error; the target is as it was then.
void write_for_profile(const Profile& profile, const ProfileOptions& options, const std::string& path,
                       const Character& character, const GlbOptions& glb = {}, const Morphs& morphs = {});

}  // namespace sinew
#endif
