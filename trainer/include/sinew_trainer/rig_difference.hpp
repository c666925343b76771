// SPDX-License-Identifier: MIT
// Networks of skeletons and fronts, quantized step by step: skeletons by the float network; ranges over a folder's
// characters; how far the integers' answers lie from float's.
#ifndef SINEW_TRAINER_RIG_DIFFERENCE_HPP
#define SINEW_TRAINER_RIG_DIFFERENCE_HPP

#include <string>

#include "sinew/sinew.h"
#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/float_network.hpp"

namespace sinew {

// A folder's characters, at most `limit` of them spread evenly (0 = all), as skeleton prediction sees them. Those that fail are
// left out; Error when none is left.
Calibration calibrate_rig(const FloatNetwork& network, const std::string& folder, size_t limit);

// Shares of the mesh's longest side, over both ends of all points' votes.
struct VoteDifference {
  size_t characters = 0;
  double mean = 0, most = 0;
  double same_class = 0;  // share of the votes whose most likely class is the same
};
VoteDifference compare_votes(const FloatNetwork& network, const sinew_model& model, const std::string& folder,
                             size_t limit);

// As calibrate_rig().
Calibration calibrate_front(const FloatNetwork& network, const std::string& folder, size_t limit);

struct FrontDifference {
  size_t characters = 0;
  double mean = 0, most = 0;  // distance of the answers, of which a sure one has the length 1
};
FrontDifference compare_fronts(const FloatNetwork& network, const sinew_model& model, const std::string& folder,
                               size_t limit);

// The published method's two networks, one for each of a checkpoint's, which become a file's two.
struct SlotNetworks {
  FloatNetwork joints, connections;
  Calibration joint_ranges, connection_ranges;
};
// Ranges over a folder's characters, at most `limit` of them spread evenly (0 = all). Those that fail are left out; Error when
// none is left.
//   both  of the architecture slots
SlotNetworks calibrate_slots(const FloatNetwork& both, const std::string& folder, size_t limit);

struct SlotDifference {
  size_t characters = 0;
  double mean = 0, most = 0;    // of joints that are there, shares of the longest side
  double same_presence = 0;     // share of slots that hold a joint by both or by neither
  double same_connections = 0;  // share of pairs of joints that both or neither predict as connected
};
//   model  of calibrate_slots(), quantized and opened by sinew_rig_model_open()
SlotDifference compare_slots(const FloatNetwork& both, const sinew_model& model, const std::string& folder,
                             size_t limit);

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
