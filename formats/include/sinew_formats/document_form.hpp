// SPDX-License-Identifier: MIT
// The same character in the form of another program: other joint axes and names, an additional root, a rotation of
// the whole. Apart from the rotation the mesh and its motion look the same.
#ifndef SINEW_FORMATS_DOCUMENT_FORM_HPP
#define SINEW_FORMATS_DOCUMENT_FORM_HPP

#include <map>
#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"

namespace sinew {

// Data of a VRM in addition to its glTF: the extension VRMC_vrm of VRM 1.0, or VRM of 0.x.
struct VrmData {
  std::string file_name;                       // the default title
  std::string title;                           // empty: the file's own
  std::vector<std::string> authors;            // empty: the file's own
  std::map<std::string, std::string> license;  // members of VRMC_vrm.meta as parse_vrm_license() gives them
  std::vector<std::string> bones;              // [J] humanoid bone of each joint in the terms of 1.0, "" for none
  bool zero = false;                           // VRM 0.x
};

// "creditNotation=required,commercialUsage=corporation", "allowRedistribution=true", or the address of a license text (otherLicenseUrl). The
// words are those of the specification: github.com/vrm-c/vrm-specification, VRMC_vrm-1.0, meta. Missing members keep
// the default of the specification, the strictest value. Throws Error that lists the allowed values.
std::map<std::string, std::string> parse_vrm_license(const std::string& text);

// Required humanoid bones of a VRM, in the terms of 1.0; VRM 0.x also requires a chest and a neck.
const std::vector<std::string>& vrm_required_bones(bool zero);

// Returns whether its file is a VRM of any version.
bool has_vrm_data(const Character& character);
// [J] The humanoid bone that the character's own VRM (1.0 or 0.x) gives each joint, in the file's words, "" for none; empty where its file is no
// VRM, names no joint, or the joints do not begin with those of the file. References that are broken count as none.
std::vector<std::string> vrm_file_bones(const Character& character);

struct DocumentForm {
  Rotation turn = kNoRotation;  // rotation of the whole character, world space
  std::vector<Rotation>
      axes;  // [J] the joints' axes in the rest pose, as columns, in the rotated world; empty: unchanged
  std::vector<std::string> names;  // [J] new names; empty: unchanged
  std::string root;                // name of a joint at the origin that carries all others; empty: none is added
  const VrmData* vrm = nullptr;    // data of a VRM; null: none
};

// Like write_gltf_morphs(). Inverse bind matrices, animations, drivers of corrections and child nodes of joints
// follow: each joint's world transform W becomes turn * W * C with a constant rotation C per joint. A joint with
// nonuniform scale keeps its axes, and so does every joint of a document whose constraints depend on axes. Returns
// notes about these for the user, one line each. Throws Error.
std::vector<std::string> write_gltf_form(const std::string& path, const Character& character, const GlbOptions& options,
                                         const Morphs& morphs, const DocumentForm& form);

}  // namespace sinew
#endif
