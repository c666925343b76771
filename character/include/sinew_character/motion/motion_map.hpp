// SPDX-License-Identifier: MIT
// Maps the joints of a character to those of a motion, measures how much of both bodies is mapped, and maps joints
// for weights.
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

// Below this share a motion does not fit a character.
constexpr float kLeastCover = 0.5f;

struct MapCover {
  float share =
      1;  // 0..1: minimum of the share of legs, arms or wings that move and of the similarity of posture (upright or not); 1 if neither has limbs
  std::string missing;  // the main reason, for the user: "no legs, arms or wings"
  std::vector<std::string>
      warnings;            // parts that move wrongly: "the left leg does not move", "the head follows the jaw"
  std::string rigid;       // parts that stay rigid because the source has no match: "hair and tail"; may be empty
  size_t kinds_apart = 0;  // difference in the number of legs, plus one if only one of the bodies is upright
  bool legless = false;    // the motion has moving legs, but the body only arms
};

//   sources  [target J] joint of the source or -1
MapCover map_cover(const MapRig& target, MaybeAxis target_up, const MapRig& source, MaybeAxis source_up,
                   const std::vector<int>& sources);

// Below this certainty left and right may be exchanged.
constexpr float kDoubtfulSides = 0.5f;

struct MotionMap {
  std::vector<int> sources;      // [target] joint of the source, or -1
  std::vector<uint8_t> reasons;  // [target] sinew_map_reason; pinned for a map file
  std::string how;               // "anatomy and names", for the user
  float certainty = 1;           // certainty of front and sides, see MappedSkeleton
  MapCover cover;                // `share` is 1 for a map file
};

// Reads `map_file` if it is not empty: joints without a line have no source. Otherwise uses map_skeleton(). The rigs'
// names are their files, for messages. Throws Error with the line for a joint that does not exist, and if no joint is
// mapped.
MotionMap map_motion(const MapRig& target, const MapRig& source, const MapSkeletonOptions& options,
                     const std::string& map_file);

// Returns sinew_joint_class [target]: from the joints' names, else from those of their sources, else, without arms
// and legs, by fitting a human body.
std::vector<uint8_t> motion_classes(const MapRig& target, const MapRig& source, MaybeAxis target_up,
                                    const std::vector<int>& sources);

// Returns the number of target joints with a source.
inline size_t moved_joints(const MotionMap& map) {
  return static_cast<size_t>(
      std::count_if(map.sources.begin(), map.sources.end(), [](int joint) { return joint >= 0; }));
}

// Returns [source joints] the matching joint of the target (a character of the file `path`): by the file `map` if it
// is not empty, by equal names if most joints have one, else by anatomy. Throws Error if no joint is mapped.
JointMapping find_joint_map(const Character& source, const std::string& map, const std::string& path,
                            const Character& target, std::string* mapped_by);

}  // namespace sinew
#endif
