// SPDX-License-Identifier: MIT
// Limbs of a picture that lie on each other or beside each other.
#ifndef SINEW_CHARACTER_PICTURE_SIDE_LIMBS_HPP
#define SINEW_CHARACTER_PICTURE_SIDE_LIMBS_HPP

#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Seen from its side a pair of legs is found at one position. Where the silhouette has two legs beside each other there, the left and the right one go into one each, from the
// height on where they part. Joints are in the picture plane already.
//   mesh  in the picture plane
void part_side_limbs(const Character& mesh, PredictedSkeleton* skeleton);

// Votes for two legs that lie on each other make one leg that forks. No arm or leg does, above hand or foot: the way with most joints stays.
void take_forks_off(PredictedSkeleton* skeleton);

}  // namespace sinew
#endif
