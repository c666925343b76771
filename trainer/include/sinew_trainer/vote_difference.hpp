// SPDX-License-Identifier: MIT
// How far the votes of the integer network lie from those of the float network.
#ifndef SINEW_TRAINER_VOTE_DIFFERENCE_HPP
#define SINEW_TRAINER_VOTE_DIFFERENCE_HPP

#include <string>

#include "sinew/sinew.h"
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

}  // namespace sinew
#endif
