// SPDX-License-Identifier: MIT
#include "picture/pins_by_class.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "sinew_character/rig/joint_mirror.hpp"

namespace sinew {
namespace {

bool is_pinned(uint8_t joint_class) {
  switch (joint_class) {
    case SINEW_CLASS_PELVIS:
    case SINEW_CLASS_HEAD:
    case SINEW_CLASS_UPPER_ARM:
    case SINEW_CLASS_FOREARM:
    case SINEW_CLASS_HAND:
    case SINEW_CLASS_THIGH:
    case SINEW_CLASS_CALF:
    case SINEW_CLASS_FOOT:
    case SINEW_CLASS_WING:
      return true;
    default:
      return false;
  }
}

using Group = std::pair<uint8_t, int>;  // class and side

std::map<Group, std::vector<size_t>> groups_of(const LabelledSkeleton& skeleton) {
  std::map<Group, std::vector<size_t>> groups;
  for (size_t j = 0; j < skeleton.joints.size(); ++j)
    if (skeleton.ends[j] == 0 && is_pinned(skeleton.classes[j]))
      groups[{skeleton.classes[j], static_cast<int>(side_of_name(skeleton.joints[j].name))}].push_back(j);
  return groups;
}

}  // namespace

std::vector<sinew_map_pin> pins_by_class(const LabelledSkeleton& target, const LabelledSkeleton& source) {
  std::vector<sinew_map_pin> pins;
  const auto sources = groups_of(source);
  for (const auto& [group, joints] : groups_of(target)) {
    const auto found = sources.find(group);
    if (found == sources.end()) continue;
    for (size_t k = 0; k < std::min(joints.size(), found->second.size()); ++k)
      pins.push_back({static_cast<uint32_t>(joints[k]), static_cast<int32_t>(found->second[k])});
  }
  return pins;
}

}  // namespace sinew
