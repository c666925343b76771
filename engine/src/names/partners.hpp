// SPDX-License-Identifier: MIT
// Left and right of a skeleton: joints of the same name on the other side, and those that stand on its other side.
#ifndef SINEW_NAMES_PARTNERS_HPP
#define SINEW_NAMES_PARTNERS_HPP

#include "names/named_joints.hpp"

namespace sinew::names {

// [n] the first joint of the same name on the other side, -1 without one.
void find_partners(const NamedJoints& joints, int32_t* partners);

struct Mirror {
  bool exact = false;
  uint32_t axis = 0;
  int32_t* images = nullptr;  // [n]
};

// Tries a plane across x, z, y, and takes the one with the most images. The joints have positions.
//   planes   where it is on each axis
//   scratch  [n] overwritten
void find_mirror(const NamedJoints& joints, const int32_t* partners, const float* planes, int32_t* scratch,
                 Mirror* best);

// Where a plane across an axis would be: the middle of partners, else of all joints.
//   scratch  [n] overwritten
float mirror_plane(const NamedJoints& joints, const int32_t* partners, uint32_t axis, float* scratch);

}  // namespace sinew::names
#endif
