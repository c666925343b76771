// SPDX-License-Identifier: MIT
// Pairs of joints for a map by what votes say that the joints are.
#ifndef SINEW_CHARACTER_PICTURE_PINS_BY_CLASS_HPP
#define SINEW_CHARACTER_PICTURE_PINS_BY_CLASS_HPP

#include <vector>

#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/predict/fit_skeleton.hpp"

namespace sinew {

// Limbs, the head and the pelvis of `target` and `source`, joint by joint: the n-th of a class and a side of one, parents first, is
// the n-th of the other. Sides are those of the names; bone ends are left out. Also of a skeleton that does not hang together as a
// body does, which anatomy makes nothing of.
std::vector<sinew_map_pin> pins_by_class(const LabelledSkeleton& target, const LabelledSkeleton& source);

}  // namespace sinew
#endif
