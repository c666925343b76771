// SPDX-License-Identifier: MIT
// Joints of a picture lie in its figure.
#ifndef SINEW_CHARACTER_PICTURE_JOINTS_INSIDE_HPP
#define SINEW_CHARACTER_PICTURE_JOINTS_INSIDE_HPP

#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// What lies outside of the silhouette goes to an inner vertex of its middle line: the nearest one, where an inner one is the nearer the deeper it lies.
//   mesh      of the picture plane
//   skeleton  in it; z stays
void move_joints_inside(const Character& mesh, PredictedSkeleton* skeleton);

}  // namespace sinew
#endif
