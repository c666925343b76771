// SPDX-License-Identifier: MIT
// How much of two bodies a map of a motion reaches: what tells a walk on a horse from a walk on a person.
#ifndef SINEW_CHARACTER_MAP_COVER_HPP
#define SINEW_CHARACTER_MAP_COVER_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/base/axis.hpp"

namespace sinew {

// Below it a motion is not for a character. Of 840 pairs of skeletons it refuses all 60 of people and four-legged animals, and of the
// others 8 between animals whose legs the map does not find.
constexpr float kLeastCover = 0.5f;

struct MapCover {
  float share =
      1;  // 0..1: the least of legs, of arms or the head, of the trunk, and of how alike both go upright; 1 where neither has legs
  std::string missing;  // what is least, for the user: "no legs"
};

//   sources  [target J] joint of the source or -1
MapCover map_cover(const MapRig& target, MaybeAxis target_up, const MapRig& source, MaybeAxis source_up,
                   const std::vector<int>& sources);

}  // namespace sinew
#endif
