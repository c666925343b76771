// SPDX-License-Identifier: MIT
// What a VRM says beside its glTF: the extension VRMC_vrm of VRM 1.0, VRM of 0.x.
#ifndef SINEW_FORMATS_VRM_HPP
#define SINEW_FORMATS_VRM_HPP

#include <map>
#include <string>
#include <vector>

namespace sinew {

struct VrmData {
  std::string title;
  std::vector<std::string> authors;            // at least one
  std::map<std::string, std::string> licence;  // members of VRMC_vrm.meta as parse_vrm_licence() gives them
  std::vector<std::string> bones;              // [J] humanoid bone of each joint in the words of 1.0, "" for none
  bool zero = false;                           // VRM 0.x
};

// "creditNotation=required,commercialUsage=corporation", "allowRedistribution=true", or the address of a licence text (otherLicenseUrl). The
// words are those of the specification: github.com/vrm-c/vrm-specification, VRMC_vrm-1.0, meta. What is not said is left out, and means what
// the specification says: the strictest. Throws Error that lists what is allowed.
std::map<std::string, std::string> parse_vrm_licence(const std::string& text);

// Humanoid bones that a VRM must have, in the words of 1.0: one of 0.x has a chest and a neck as well.
const std::vector<std::string>& vrm_required_bones(bool zero);

}  // namespace sinew
#endif
