// SPDX-License-Identifier: MIT
// A rig's own axes: the normal of its mirror plane, the up direction, and the mirrored joints.
#ifndef SINEW_MAPPING_FRAME_HPP
#define SINEW_MAPPING_FRAME_HPP

#include "mapping/hierarchy.hpp"

namespace sinew::mapping {

struct Frame {
  Point across, up, front;  // unit vectors; across points to the left once front is known
  double plane = 0;         // the mirror plane lies at P.across = plane
  double symmetry = 0;      // how many joints have a mirror image, each at most 1
  int32_t* mate = nullptr;  // [n] the joint's mirror image, -1 = none
  bool posed = false;       // `mate` is by bones of the same lengths (take_twins()): images are elsewhere
  int8_t* side = nullptr;   // [n] of a posed rig, 1 and -1 where its sides begin, else 0

  bool allocate(Arena& arena, uint32_t joints);
};

// Fills a frame; the sign of `front` is not known yet. `up` null: guessed.
bool find_frame(const Hierarchy& rig, const Point* up, Arena& arena, Frame* frame);

// Where few of the joints that have such a twin are its mirror image, the twins become the frame's sides: their mean
// direction `across`, `plane` through their parents, `mate`, and `posed`. A frame with mirror images stays.
//   up    null: not known yet
//   twin  [n] scratch
void take_twins(const Hierarchy& rig, const Point* up, int32_t* twin, Frame* frame);

}  // namespace sinew::mapping
#endif
