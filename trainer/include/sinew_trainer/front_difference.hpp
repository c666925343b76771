// SPDX-License-Identifier: MIT
// The network of the front on its way to integers, and how far its answers lie from float's.
#ifndef SINEW_TRAINER_FRONT_DIFFERENCE_HPP
#define SINEW_TRAINER_FRONT_DIFFERENCE_HPP

#include <string>

#include "sinew/sinew.h"
#include "sinew_formats/float_network.hpp"

namespace sinew {

// As calibrate_rig().
Calibration calibrate_front(const FloatNetwork& network, const std::string& folder, size_t limit);

struct FrontDifference {
  size_t characters = 0;
  double mean = 0, most = 0;  // distance of the answers, of which a sure one has the length 1
};
FrontDifference compare_fronts(const FloatNetwork& network, const sinew_model& model, const std::string& folder,
                               size_t limit);

}  // namespace sinew
#endif
