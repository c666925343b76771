// SPDX-License-Identifier: MIT
// The skeleton of a machine on wheels.
#ifndef SINEW_CHARACTER_VEHICLE_SKELETON_HPP
#define SINEW_CHARACTER_VEHICLE_SKELETON_HPP

#include <optional>

#include "sinew_character/predict/part_skeleton.hpp"

namespace sinew {

// One root for all that stays as it is, and a joint for every part that moves by itself: wheels, which are bodies of revolution
// about an axle across, in their middles; a turret, with a gun on it, on the hull; doors, flat parts of a side, at their front edges,
// where hinges are. What lies within a wheel goes with it. Bodies of one piece have the root alone.
//   front  unit vector, horizontal; nothing: across the axles, towards the axis that counts up, which is a guess
PartSkeleton vehicle_skeleton(const Character& mesh, Axis up, const std::optional<std::array<float, 3>>& front);

}  // namespace sinew
#endif
