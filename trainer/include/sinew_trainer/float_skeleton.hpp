// SPDX-License-Identifier: MIT
// A skeleton by a network in float: what the int16 model of it is measured against.
#ifndef SINEW_TRAINER_FLOAT_SKELETON_HPP
#define SINEW_TRAINER_FLOAT_SKELETON_HPP

#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/float_network.hpp"

namespace sinew {

// As predict_skeleton() with the model, whose network is replaced by the float one: points, votes in steps of 1/1024 and
// everything behind them are the engine's.
//   network  of task rig, for bodies
//   options  model is set, of the same layers
// Throws Error with the character's name, and OutOfMemory.
PredictedSkeleton predict_float_skeleton(const Character& character, const FloatNetwork& network,
                                         const SkeletonOptions& options);

// Whether both have the same joints, by class and side of the plane, on the same parents.
bool same_tree(const PredictedSkeleton& a, const PredictedSkeleton& b);

}  // namespace sinew
#endif
