// SPDX-License-Identifier: MIT
// What a VRM 1.0 says beside its glTF: the extension VRMC_vrm.
#ifndef SINEW_FORMATS_VRM_HPP
#define SINEW_FORMATS_VRM_HPP

#include <map>
#include <string>
#include <vector>

#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"

namespace sinew {

struct VrmData {
  std::string title;
  std::vector<std::string> authors;            // at least one
  std::map<std::string, std::string> licence;  // members of VRMC_vrm.meta as parse_vrm_licence() gives them
  std::vector<std::string> bones;              // [J] humanoid bone of each joint, "" for none
};

// "creditNotation=required,commercialUsage=corporation", "allowRedistribution=true", or the address of a licence text (otherLicenseUrl). The
// words are those of the specification: github.com/vrm-c/vrm-specification, VRMC_vrm-1.0, meta. What is not said is left out, and means what
// the specification says: the strictest. Throws Error that lists what is allowed.
std::map<std::string, std::string> parse_vrm_licence(const std::string& text);

// Humanoid bones that a VRM must have.
const std::vector<std::string>& vrm_required_bones();

// What write_gltf_morphs() writes, with VRMC_vrm: as .vrm or .glb. Expressions, look-at and first person of an input's own VRMC_vrm stay; the
// older extension VRM goes. Throws Error where a required bone is missing or named twice, and without an author.
void write_vrm(const std::string& path, const Character& character, const GlbOptions& options, const Morphs& morphs,
               const VrmData& vrm);

}  // namespace sinew
#endif
