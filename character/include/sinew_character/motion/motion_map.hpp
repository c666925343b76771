// SPDX-License-Identifier: MIT
// Which joint of a character moves as which joint of a motion, how much of both bodies that reaches, and maps of joints for weights.
#ifndef SINEW_CHARACTER_MOTION_MAP_HPP
#define SINEW_CHARACTER_MOTION_MAP_HPP

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew_character/bind/transfer.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Below it a motion is not for a character, and what it would make of it is no motion of that body.
constexpr float kLeastCover = 0.5f;

struct MapCover {
  float share =
      1;  // 0..1: the lesser of the share of legs, arms or wings that move and of how alike both go upright; 1 where neither has limbs
  std::string missing;  // what is least, for the user: "no legs, arms or wings"
  std::vector<std::string>
      warnings;       // parts that do not move as they should: "the left leg does not move", "the head follows the jaw"
  std::string rigid;  // what stays rigid because the source has nothing like it: "hair and tail"; may be empty
  size_t kinds_apart = 0;  // by how many legs the two bodies differ, one more where one of them alone is upright
  bool legless = false;    // the motion has legs that move, the body has arms alone
};

//   sources  [target J] joint of the source or -1
MapCover map_cover(const MapRig& target, MaybeAxis target_up, const MapRig& source, MaybeAxis source_up,
                   const std::vector<int>& sources);

// Below it left and right may be exchanged.
constexpr float kDoubtfulSides = 0.5f;

struct MotionMap {
  std::vector<int> sources;      // [target] joint of the source, or -1
  std::vector<uint8_t> reasons;  // [target] sinew_map_reason; of a file's map pinned
  std::string how;               // "anatomy and names", for the user
  float certainty = 1;           // of front and sides, see MappedSkeleton
  MapCover cover;                // of a file's map `share` is 1
};

// From a file where `map_file` is not empty: what has no line there has no source. Else by map_skeleton(). The rigs' names are
// their files, for messages. Throws Error with the line for a joint that does not exist, and where no joint is mapped.
MotionMap map_motion(const MapRig& target, const MapRig& source, const MapSkeletonOptions& options,
                     const std::string& map_file);

// sinew_joint_class [target]: by the joints' own names, else by those of their sources; where both say nothing of arms and
// legs, by what a human body has there.
std::vector<uint8_t> motion_classes(const MapRig& target, const MapRig& source, MaybeAxis target_up,
                                    const std::vector<int>& sources);

// How many joints of the target have one of the source.
inline size_t moved_joints(const MotionMap& map) {
  return static_cast<size_t>(
      std::count_if(map.sources.begin(), map.sources.end(), [](int joint) { return joint >= 0; }));
}

// Which joint of the target (a character of the file `path`) stands for which of the source's [source joints]: by the file `map` where
// it is not empty, by equal names where most joints have one, else by anatomy. Throws Error where none does.
JointMapping find_joint_map(const Character& source, const std::string& map, const std::string& path,
                            const Character& target, std::string* mapped_by);

}  // namespace sinew
#endif
