// SPDX-License-Identifier: MIT
// The same character in another program's form: joints with other axes and names, a root above them, the whole turned. What is shown stays
// but for the turn.
#ifndef SINEW_FORMATS_DOCUMENT_FORM_HPP
#define SINEW_FORMATS_DOCUMENT_FORM_HPP

#include <map>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"

namespace sinew {

// What a VRM says beside its glTF: the extension VRMC_vrm of VRM 1.0, VRM of 0.x.
struct VrmData {
  std::string file_name;                       // the title where nobody says one
  std::string title;                           // empty: the file's own
  std::vector<std::string> authors;            // empty: the file's own
  std::map<std::string, std::string> license;  // members of VRMC_vrm.meta as parse_vrm_license() gives them
  std::vector<std::string> bones;              // [J] humanoid bone of each joint in the words of 1.0, "" for none
  bool zero = false;                           // VRM 0.x
};

// "creditNotation=required,commercialUsage=corporation", "allowRedistribution=true", or the address of a license text (otherLicenseUrl). The
// words are those of the specification: github.com/vrm-c/vrm-specification, VRMC_vrm-1.0, meta. What is not said is left out, and means what
// the specification says: the strictest. Throws Error that lists what is allowed.
std::map<std::string, std::string> parse_vrm_license(const std::string& text);

// Humanoid bones that a VRM must have, in the words of 1.0: one of 0.x has a chest and a neck as well.
const std::vector<std::string>& vrm_required_bones(bool zero);

// Whether its file is a VRM of any version.
bool has_vrm_data(const Character& character);

struct DocumentForm {
  Rotation turn = kNoRotation;  // of the whole character, world space
  std::vector<Rotation>
      axes;  // [J] the joints' axes in the rest pose, as columns, in the turned world; empty: they stay
  std::vector<std::string> names;  // [J] new names; empty: they stay
  std::string root;                // name of a joint at the origin that carries all others; empty: none is added
  const VrmData* vrm = nullptr;    // what a VRM says; null: nothing
};

// As write_gltf_morphs(). Inverse bind matrices, animations, drivers of corrections and what hangs on joints follow: each joint's world
// transform W becomes turn * W * C with a rotation C of its own that is the same at all times. A joint that is scaled unevenly, and every joint of
// a document whose constraints are bound to axes, keeps its axes. Returns such remarks for the user, a line each. Throws Error.
std::vector<std::string> write_gltf_form(const std::string& path, const Character& character, const GlbOptions& options,
                                         const Morphs& morphs, const DocumentForm& form);

}  // namespace sinew
#endif
