// SPDX-License-Identifier: MIT
// Which joint of a character moves as which joint of a motion, and what joints are for.
#ifndef SINEW_CHARACTER_MOTION_MAP_HPP
#define SINEW_CHARACTER_MOTION_MAP_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_character/motion/map_cover.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/base/axis.hpp"

namespace sinew {

// Below it left and right may be exchanged.
constexpr float kDoubtfulSides = 0.5f;

struct MotionMap {
  std::vector<int> sources;      // [target] joint of the source, or -1
  std::vector<uint8_t> reasons;  // [target] sinew_map_reason; of a file's map pinned
  std::string how;               // "anatomy and names", for the user
  float certainty = 1;           // of front and sides, see MappedSkeleton
  MapCover cover;                // of a found map
};

// From a file where `map_file` is not empty: what has no line there has no source. Else by map_skeleton(). The rigs' names are
// their files, for messages. Throws Error with the line for a joint that does not exist, and where no joint is mapped.
//   pins                  that map_skeleton() keeps, without a file
MotionMap map_motion(const MapRig& target, const MapRig& source, MaybeAxis target_up, MaybeAxis source_up,
                     const std::string& map_file, const std::vector<sinew_map_pin>& pins = {});

// sinew_joint_class [target]: by the joints' own names, else by those of their sources; where both say nothing of arms and
// legs, by what a human body has there.
std::vector<uint8_t> motion_classes(const MapRig& target, const MapRig& source, MaybeAxis target_up,
                                    const std::vector<int>& sources);

}  // namespace sinew
#endif
