// SPDX-License-Identifier: MIT
#ifndef SINEW_CHARACTER_MAP_MOVED_JOINTS_HPP
#define SINEW_CHARACTER_MAP_MOVED_JOINTS_HPP

#include <algorithm>

#include "sinew_character/motion/motion_map.hpp"

namespace sinew {

// How many joints of the target have one of the source.
inline size_t moved_joints(const MotionMap& map) {
  return static_cast<size_t>(
      std::count_if(map.sources.begin(), map.sources.end(), [](int joint) { return joint >= 0; }));
}

}  // namespace sinew
#endif
