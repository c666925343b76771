// SPDX-License-Identifier: MIT
// The table of profiles. To add one: a row here.
#include "sinew_character/profile.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_names.hpp"

namespace sinew {

const std::vector<Profile>& profiles() {
  // Axes of new joints are the world's, which is what VRM programs expect of models that are made for both of its versions.
  static const std::vector<Profile> kProfiles = {
      {"vrm", "VRM 1.0: humanoid map, author and licence, T pose",
       "github.com/vrm-c/vrm-specification, specification/VRMC_vrm-1.0", "t", 4, true},
  };
  return kProfiles;
}

const Profile& profile_named(const std::string& name) {
  std::string known;
  for (const Profile& one : profiles()) {
    if (one.name == name) return one;
    known += (known.empty() ? "" : ", ") + std::string(one.name);
  }
  throw Error("no profile is called " + name + "; there are: " + known);
}

void check_profile(const Profile& profile, const ProfileOptions& options) {
  if (!profile.vrm) return;
  if (options.authors.empty()) throw Error("a VRM names its author: give --author");
  parse_vrm_licence(options.licence);
}

void write_for_profile(const Profile& profile, const ProfileOptions& options, const std::string& path,
                       const Character& character, const GlbOptions& glb, const Morphs& morphs) {
  if (!profile.vrm) return write_gltf_morphs(path, character, glb, morphs);
  const bool as_vrm = has_extension(path, ".vrm");
  if (!as_vrm && !has_extension(path, ".glb")) throw Error(path + ": a VRM is one file: write a .vrm or a .glb");
  VrmData vrm;
  vrm.title = options.title.empty() ? character.name : options.title;
  vrm.authors = options.authors;
  vrm.licence = parse_vrm_licence(options.licence);
  vrm.bones = vrm_bones(character.joints, path);
  write_vrm(path, character, glb, morphs, vrm);
}

}  // namespace sinew
