// SPDX-License-Identifier: MIT
// Skeleton of a wheeled vehicle.
#ifndef SINEW_CHARACTER_VEHICLE_SKELETON_HPP
#define SINEW_CHARACTER_VEHICLE_SKELETON_HPP

#include <optional>

#include "sinew_character/predict/part_skeleton.hpp"

namespace sinew {

// Makes one root for everything that does not move, and a joint per moving part: wheels, which are bodies of
// revolution about a lateral axle, at their centers; a turret, with a gun on it, on the hull; doors, flat parts of a
// side, at their front edges (hinges). Parts inside a wheel move with it. A vehicle of one piece has only the root.
//   front  unit vector, horizontal; nullopt: perpendicular to the axles, in the positive direction of the axis, a guess
PartSkeleton vehicle_skeleton(const Character& mesh, Axis up, const std::optional<std::array<float, 3>>& front);

}  // namespace sinew
#endif
