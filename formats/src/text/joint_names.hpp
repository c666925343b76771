// SPDX-License-Identifier: MIT
// Names of joints made unique, and joints found by them, for files that tell joints apart by name.
#ifndef SINEW_FORMATS_TEXT_JOINT_NAMES_HPP
#define SINEW_FORMATS_TEXT_JOINT_NAMES_HPP

#include <cstdint>
#include <map>
#include <string>
#include <unordered_set>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// Empty names become joint_INDEX; of equal names the first stays, the others get _2, _3, ...
inline void make_names_unique(std::vector<std::string>* names) {
  std::unordered_set<std::string> taken(names->begin(), names->end()), used;
  for (size_t j = 0; j < names->size(); ++j) {
    std::string& name = (*names)[j];
    if (name.empty()) name.append("joint_").append(std::to_string(j));
    if (used.insert(name).second) {
      taken.insert(name);
      continue;
    }
    size_t number = 2;
    std::string numbered;
    do {
      numbered = name;
      numbered.append("_").append(std::to_string(number++));
    } while (taken.count(numbered) != 0);
    name = numbered;
    taken.insert(name);
    used.insert(name);
  }
}

// Blanks and control characters become '_', and the result is unique.
inline std::vector<std::string> names_without_blanks(const std::vector<Joint>& joints) {
  std::vector<std::string> names;
  for (const Joint& joint : joints) {
    names.push_back(joint.name);
    for (char& c : names.back())
      if (static_cast<unsigned char>(c) <= ' ' || c == 127) c = '_';
  }
  make_names_unique(&names);
  return names;
}

// Joints by name, both as the skeleton has it and as a text file writes it; the first joint of a name has it.
inline std::map<std::string, uint32_t> joints_by_name(const std::vector<Joint>& joints) {
  std::map<std::string, uint32_t> numbers;
  for (size_t j = 0; j < joints.size(); ++j) numbers.emplace(joints[j].name, static_cast<uint32_t>(j));
  const std::vector<std::string> written = names_without_blanks(joints);
  for (size_t j = 0; j < joints.size(); ++j) numbers.emplace(written[j], static_cast<uint32_t>(j));
  return numbers;
}

}  // namespace sinew
#endif
