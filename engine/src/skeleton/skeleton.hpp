// SPDX-License-Identifier: MIT
// The caller's joints as a checked hierarchy on the grid: order, usable joints, bones.
#ifndef SINEW_SKELETON_SKELETON_HPP
#define SINEW_SKELETON_SKELETON_HPP

#include "core/arena.hpp"
#include "core/counts.hpp"
#include "core/fixed.hpp"
#include "grid/grid_quantizer.hpp"

namespace sinew {

struct Skeleton {
  uint32_t joint_count = 0;         // J
  Vec3i* positions = nullptr;       // [J] grid units
  int32_t* parents = nullptr;       // [J] -1 for roots
  uint32_t* order = nullptr;        // [J] topological: parents before children
  uint16_t* child_count = nullptr;  // [J]
  uint16_t* depth = nullptr;        // [J] 0 for roots
  uint8_t* usable = nullptr;        // [J] 0: must get no weight (flags), 1: may
  bool deform_known = false;        // the caller said which joints deform
  // [J] A joint's bone as one segment: it starts at positions[j] and ends here, at the mean of the joint's children. A
  // leaf's bone goes on in the direction from its parent, half as far as its parent's distance, at most a tenth of the
  // skeleton's size (longest side of the joints' box). The bone of a lone joint is a point.
  Vec3i* bone_tail = nullptr;

  // Allocates everything (works with a measuring arena). The caller does this before build_skeleton().
  // Returns arena.ok().
  bool allocate(Arena& arena, const Counts& counts);
};

// Whether the caller's skeleton has that joint, and its flags let it get weight.
bool may_get_weight(const sinew_skeleton& input, uint32_t joint);

// Fills a skeleton, allocated beforehand, from the caller's view.
// Returns SINEW_OK, SINEW_ERROR_NOT_FINITE, SINEW_ERROR_INDEX for a parent that is no joint, SINEW_ERROR_HIERARCHY for
// parents in a circle, or SINEW_ERROR_NO_JOINT when no joint may get weight.
sinew_status build_skeleton(const sinew_skeleton& input, const GridQuantizer& quantizer, Skeleton* skeleton);

}  // namespace sinew
#endif
