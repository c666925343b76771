// SPDX-License-Identifier: MIT
// Runs a float network over samples and takes the largest value of every layer: what the quantizer needs to know.
#ifndef SINEW_TRAINER_CALIBRATE_HPP
#define SINEW_TRAINER_CALIBRATE_HPP

#include <functional>
#include <string>
#include <vector>

#include "sinew_formats/float_network.hpp"
#include "sinew_trainer/sample.hpp"

namespace sinew {

// Largest absolute value in each layer's output region over all samples, for a network of any task. Throws Error when
// there is no sample.
Calibration calibrate(const FloatNetwork& network, const std::vector<const NetworkSample*>& samples);
template <class S>
Calibration calibrate(const FloatNetwork& network, const std::vector<S>& samples) {
  std::vector<const NetworkSample*> pointers;
  for (const S& sample : samples) pointers.push_back(&sample);
  return calibrate(network, pointers);
}

// Samples of at most `limit` characters spread evenly over a folder's sorted list (0 = all). Characters that the engine
// refuses are left out; throws Error when none is left. `progress`, if there is one, hears how many of how many are done.
std::vector<Sample> calibration_samples(const std::string& folder, size_t limit, uint32_t candidates, uint32_t grid,
                                        uint32_t feature_set,
                                        const std::function<void(size_t done, size_t total)>& progress = {});

}  // namespace sinew
#endif
