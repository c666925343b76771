// SPDX-License-Identifier: MIT
// --for PROFILE, --keep-axes, --author and --licence of the commands that write characters.
#ifndef SINEW_CLI_PROFILE_OPTIONS_HPP
#define SINEW_CLI_PROFILE_OPTIONS_HPP

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "sinew_character/profile/profile.hpp"

namespace sinew::cli {

struct ProfileSettings {
  std::string profile;   // empty: none
  std::string controls;  // file of controls; empty: none
  ProfileOptions options;
};

void add_profile_options(CLI::App* sub, ProfileSettings* settings);
// --controls, of the commands that make or move skeletons.
void add_controls_option(CLI::App* sub, ProfileSettings* settings);
// Before any work: the profile's rest pose where none is asked for, none for "none", and what it needs. Throws UsageError.
//   to_pose  in/out; null where the command keeps the character's
void settle_profile(const ProfileSettings& settings, std::string* to_pose);
// ".glb", or what the profile has.
std::string container_of(const ProfileSettings& settings);
// write_character(), or write_for_profile(), and the file of controls; remarks go to `notes`.
void write_as(const ProfileSettings& settings, const std::string& path, const Character& character,
              std::vector<std::string>* notes, const GlbOptions& glb = {}, const Morphs& morphs = {});

}  // namespace sinew::cli
#endif
