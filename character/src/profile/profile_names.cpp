// SPDX-License-Identifier: MIT
// Names of a profile's convention.
#include <cctype>
#include <cstring>

#include "profile/standard_bones.hpp"
#include "sinew_character/profile/profile.hpp"
#include "text/joint_names.hpp"

namespace sinew {
namespace {

std::string in_convention(std::string name, const ProfileNames& names) {
  const size_t prefix = std::strlen(names.without);
  if (prefix > 0 && name.compare(0, prefix, names.without) == 0) name.erase(0, prefix);
  const size_t thumb = names.older_thumb ? name.find("Thumb") : std::string::npos;
  if (thumb != std::string::npos) {
    const std::string part = name.substr(thumb + 5);
    name = name.substr(0, thumb + 5) + (part == "Metacarpal" ? "Proximal" : part == "Proximal" ? "Intermediate" : part);
  }
  if (names.capital) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

}  // namespace

std::vector<std::string> profile_names(const std::vector<Joint>& joints, const ProfileNames& names) {
  std::vector<std::string> standard(joints.size()), all;
  if (names.naming >= 0) standard = standard_bones(joints, static_cast<uint32_t>(names.naming));
  // Standard names come first, so that a joint's own that is one of them gets the number.
  std::vector<size_t> order;
  for (const bool own : {false, true})
    for (size_t j = 0; j < joints.size(); ++j)
      if (standard[j].empty() == own) order.push_back(j);
  for (const size_t j : order) {
    std::string name = standard[j].empty() ? joints[j].name : in_convention(standard[j], names);
    for (char& c : name)
      if (std::strchr(names.forbidden, c) != nullptr && c != 0) c = '_';
    all.push_back(std::move(name));
  }
  make_names_unique(&all);
  std::vector<std::string> out(joints.size());
  for (size_t k = 0; k < order.size(); ++k) out[order[k]] = std::move(all[k]);
  return out;
}

}  // namespace sinew
