// SPDX-License-Identifier: MIT
// Profiles from the command line.
#include "profile_options.hpp"

#include "options.hpp"
#include "support.hpp"

namespace sinew::cli {

void add_profile_options(CLI::App* sub, ProfileSettings* settings) {
  std::string names, about;
  for (const Profile& one : profiles()) {
    names += (names.empty() ? "" : "|") + std::string(one.name);
    about += (about.empty() ? "" : "; ") + std::string(one.about);
  }
  section(sub, "For another program");
  sub->add_option("--for", settings->profile, "Write what a program or format wants. " + about)->type_name(names);
  sub->add_option("--author", settings->options.authors, "With --for vrm: who made it; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  sub->add_option("--licence,--license", settings->options.licence,
                  "With --for vrm: what others may do. In the format's words, "
                  "creditNotation=required,commercialUsage=corporation, or a web address; "
                  "what is not said is not allowed")
      ->type_name("KEY=VALUE,...");
  sub->add_option("--title", settings->options.title, "With --for vrm: the character's name. The file's unless given")
      ->type_name("NAME");
}

void settle_profile(const ProfileSettings& settings, std::string* to_pose) {
  const bool said =
      !settings.options.authors.empty() || !settings.options.licence.empty() || !settings.options.title.empty();
  if (settings.profile.empty()) {
    if (said) throw UsageError("--author, --licence and --title are for --for vrm");
    return;
  }
  try {
    const Profile& profile = profile_named(settings.profile);
    check_profile(profile, settings.options);
    if (to_pose != nullptr && to_pose->empty()) *to_pose = profile.pose;
  } catch (const Error& error) {
    throw UsageError(std::string("--for ") + settings.profile + ": " + error.what());
  }
}

void write_as(const ProfileSettings& settings, const std::string& path, const Character& character,
              const GlbOptions& glb, const Morphs& morphs) {
  if (settings.profile.empty())
    write_character(path, character, glb, morphs);
  else
    write_for_profile(profile_named(settings.profile), settings.options, path, character, glb, morphs);
}

}  // namespace sinew::cli
