// SPDX-License-Identifier: MIT
// A character with fewer joints by the engine's sinew_simplify(), weights summed up, and maps between such skeletons.
#ifndef SINEW_CHARACTER_SIMPLIFY_SKELETON_HPP
#define SINEW_CHARACTER_SIMPLIFY_SKELETON_HPP

#include <string>
#include <vector>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

struct SimplifyOptions {
  bool low = false;                   // level of detail, see sinew/simplify.h
  bool as_drawn = false;              // the published conditions alone
  uint32_t joints = 0;                // 0: as the level says; else so many are left
  std::vector<std::string> keep;      // joints that stay, by name
  std::vector<uint32_t> keep_joints;  // and by number
};

struct Simplified {
  std::vector<uint32_t> into;  // [J before] index of the joint that it is part of, among those that were there before
  std::vector<int> number;     // [J before] its number now, -1 where it is gone
};

// [J] what each joint is part of, without changing anything. Throws as simplify_skeleton().
std::vector<uint32_t> joints_to_merge(const SimplifyOptions& options, const Character& character);

// The joints that stay, in their order, below what is left above them; `number` as in Simplified.
//   into  [J] of joints_to_merge()
std::vector<Joint> joints_left(const std::vector<Joint>& joints, const std::vector<uint32_t>& into,
                               std::vector<int>* number);

// Leaves joints out of the skeleton; those below hang on what is left above, and its vertices move with what it became part
// of. Where the character has weights, how much surface a joint moves counts. Joints keep their order and names.
// Throws Error for a skeleton without joints, one that the engine refuses, or a name in `keep` that no joint has; the
// character is as it was then.
Simplified simplify_skeleton(const SimplifyOptions& options, Character* character);

// As map_skeleton(), between what both skeletons keep at the high level of sinew_simplify(). Joints that go have no source;
// pinned ones stay.
//   low  the map is then reduced by the low level: a joint of the target that goes leaves its source to the joint that it
//        is part of, if that has none, and a source that goes gives way to the joint that it is part of, where no other
//        joint of the target has that one
MappedSkeleton map_at_level(const MapRig& target, const MapRig& source, const MapSkeletonOptions& options, bool low);

}  // namespace sinew
#endif
