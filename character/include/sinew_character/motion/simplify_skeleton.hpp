// SPDX-License-Identifier: MIT
// Simplifies a character by sinew_simplify(), with summed weights; maps such skeletons.
#ifndef SINEW_CHARACTER_SIMPLIFY_SKELETON_HPP
#define SINEW_CHARACTER_SIMPLIFY_SKELETON_HPP

#include <string>
#include <vector>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

struct SimplifyOptions {
  bool low = false;                   // level of detail, see sinew/simplify.h
  bool as_drawn = false;              // the published conditions only
  uint32_t joints = 0;                // 0: by the level; else the number of joints to keep
  std::vector<std::string> keep;      // joints to keep, by name
  std::vector<uint32_t> keep_joints;  // and by index
};

struct Simplified {
  std::vector<uint32_t> into;  // [J before] index (before) of the joint that it was merged into
  std::vector<int> number;     // [J before] its new index, -1 if it was removed
};

// Returns [J] the joint that each joint would be merged into; changes nothing. Throws like simplify_skeleton().
std::vector<uint32_t> joints_to_merge(const SimplifyOptions& options, const Character& character);

// Returns the remaining joints in their order, with remaining ancestors as parents; `number` as in Simplified.
//   into  [J] of joints_to_merge()
std::vector<Joint> joints_left(const std::vector<Joint>& joints, const std::vector<uint32_t>& into,
                               std::vector<int>* number);

// Removes joints from the skeleton; their children move to the remaining ancestor, and their vertices follow the
// joint that they were merged into. If the character has weights, the surface of each joint counts. Joints keep their
// order and names. Throws Error for a skeleton without joints, one that the engine rejects, or an unknown name in
// `keep`, and then leaves the character unchanged.
Simplified simplify_skeleton(const SimplifyOptions& options, Character* character);

// Like map_skeleton(), but maps only joints that both skeletons keep at the high level of sinew_simplify(). Removed
// joints have no source; pinned ones are kept.
//   low  then reduces the map by the low level: a removed target joint passes its source to the joint that it was merged into, if that has none, and a removed source is replaced by the joint that it was merged into, unless another target joint has it
MappedSkeleton map_at_level(const MapRig& target, const MapRig& source, const MapSkeletonOptions& options, bool low);

}  // namespace sinew
#endif
