// SPDX-License-Identifier: MIT
// Maps of joints by equal names.
#include "sinew_character/bind/joint_map.hpp"

#include <algorithm>

#include "text/joint_names.hpp"

namespace sinew {
JointMapping map_joints_by_name(const std::vector<Joint>& source, const std::vector<Joint>& target) {
  const std::map<std::string, uint32_t> numbers = joints_by_name(target);
  const std::vector<std::string> written = names_without_blanks(source);
  JointMapping mapping(source.size(), -1);
  for (size_t j = 0; j < source.size(); ++j) {
    auto found = numbers.find(source[j].name);
    if (found == numbers.end()) found = numbers.find(written[j]);
    if (found != numbers.end()) mapping[j] = static_cast<int32_t>(found->second);
  }
  return mapping;
}

size_t mapped_count(const JointMapping& mapping) {
  return static_cast<size_t>(std::count_if(mapping.begin(), mapping.end(), [](int32_t to) { return to >= 0; }));
}

}  // namespace sinew
