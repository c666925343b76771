// SPDX-License-Identifier: MIT
// Joints of a picture by its silhouette: they lie inside of it, and limbs beside each other go into one each.
#ifndef SINEW_CHARACTER_PICTURE_JOINTS_INSIDE_HPP
#define SINEW_CHARACTER_PICTURE_JOINTS_INSIDE_HPP

#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Joints outside of the silhouette move to an inner vertex of its middle line: the nearest one, with distances that
// are smaller for deeper vertices.
//   mesh      of the picture plane
//   skeleton  in it; z stays
void move_joints_inside(const Character& mesh, PredictedSkeleton* skeleton);

// Seen from its side a pair of legs is found at one position. Where the silhouette has two legs beside each other there, the left and the right one go into one each, from the
// height on where they part. Joints are in the picture plane already.
//   mesh  in the picture plane
void part_side_limbs(const Character& mesh, PredictedSkeleton* skeleton);

// Votes for two legs that lie on each other make one leg that forks. No arm or leg forks above its hand or foot: the
// path with most joints stays.
void take_forks_off(PredictedSkeleton* skeleton);

}  // namespace sinew
#endif
