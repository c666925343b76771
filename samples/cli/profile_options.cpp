// SPDX-License-Identifier: MIT
// Profiles from the command line.
#include "profile_options.hpp"

#include "options.hpp"
#include "sinew_character/profile/controls.hpp"
#include "sinew_formats/io.hpp"
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
  sub->add_flag("--keep-axes", settings->options.keep_axes,
                "With --for: axes, names and roots of the skeleton stay as they are, as they do without --for");
  sub->add_option("--author", settings->options.authors, "With --for vrm, vrm0: who made it; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  sub->add_option("--licence,--license", settings->options.licence,
                  "With --for vrm, vrm0: what others may do. In the format's words, "
                  "creditNotation=required,commercialUsage=corporation, or a web address; "
                  "what is not said is not allowed")
      ->type_name("KEY=VALUE,...");
  sub->add_option("--title", settings->options.title,
                  "With --for vrm, vrm0: the character's name. The file's unless given")
      ->type_name("NAME");
}

void add_controls_option(CLI::App* sub, ProfileSettings* settings) {
  sub->add_option("--controls", settings->controls,
                  "Also write which joints controls of an animator move: legs, arms, feet, spine, head, fingers "
                  "(formats/spec/controls.md). The Blender add-on makes them; a glTF has it in its extras as well")
      ->type_name("FILE.controls.json");
}

void settle_profile(const ProfileSettings& settings, std::string* to_pose) {
  const ProfileOptions& said = settings.options;
  if (!settings.controls.empty()) check_output(settings.controls, {".json"});
  if (settings.profile.empty()) {
    if (!said.authors.empty() || !said.licence.empty() || !said.title.empty() || said.keep_axes)
      throw UsageError("--author, --licence, --title and --keep-axes go with --for");
  } else {
    try {
      const Profile& profile = profile_named(settings.profile);
      check_profile(profile, said);
      if (to_pose != nullptr && to_pose->empty()) *to_pose = profile.pose;
    } catch (const Error& error) {
      throw UsageError(std::string("--for ") + settings.profile + ": " + error.what());
    }
  }
  if (to_pose != nullptr && *to_pose == "none") to_pose->clear();
}

std::string container_of(const ProfileSettings& settings) {
  return settings.profile.empty() ? ".glb" : profile_named(settings.profile).container;
}

void write_as(const ProfileSettings& settings, const std::string& path, const Character& character,
              std::vector<std::string>* notes, const GlbOptions& glb, const Morphs& morphs) {
  const bool controls = !settings.controls.empty();
  std::string text;
  if (settings.profile.empty()) {
    GlbOptions how = glb;
    if (controls) how.extras = controls_extras(text = controls_text(character));
    write_character(path, character, how, morphs);
  } else {
    const Profile& profile = profile_named(settings.profile);
    ProfileOptions options = settings.options;
    options.controls = controls;
    if (controls) text = controls_for_profile(profile, options, character);
    for (std::string& note : write_for_profile(profile, options, path, character, glb, morphs))
      notes->push_back(std::move(note));
  }
  if (!controls) return;
  write_text_file(settings.controls, text);
  for (const std::string& note : find_controls(character).notes) notes->push_back("controls: " + note);
}

}  // namespace sinew::cli
