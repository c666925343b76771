// SPDX-License-Identifier: MIT
// Legs of a picture from the side, where both of a pair are to be seen.
#ifndef SINEW_CHARACTER_PICTURE_SIDE_LIMBS_HPP
#define SINEW_CHARACTER_PICTURE_SIDE_LIMBS_HPP

#include "sinew_character/predict_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Seen from its side a pair of legs is found in one place. Where the silhouette has two legs beside each other there, the left and the right one go into one each, from the
// height on where they part. Joints are in the picture plane already.
//   mesh  in the picture plane
void part_side_limbs(const Character& mesh, PredictedSkeleton* skeleton);

}  // namespace sinew
#endif
