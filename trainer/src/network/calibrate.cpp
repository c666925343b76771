// SPDX-License-Identifier: MIT
// Calibration of a float network on samples.
#include "sinew_trainer/calibrate.hpp"

#include <algorithm>
#include <cmath>

#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/network.hpp"

namespace sinew {

Calibration calibrate(const FloatNetwork& network, const std::vector<const NetworkSample*>& samples) {
  if (samples.empty()) throw Error("calibration: no character to calibrate on");
  Calibration calibration;
  calibration.layer_max.assign(network.layers.size(), 0.0f);
  NetworkRunner runner;
  for (const NetworkSample* sample : samples) {
    runner.forward(network, *sample);
    for (size_t l = 0; l < network.layers.size(); ++l) {
      const Region& out = network.layers[l].out;
      const size_t channels = network.buffers[out.buffer].channels;
      const std::vector<float>& values = runner.buffer(out.buffer);
      float largest = calibration.layer_max[l];
      for (size_t row = 0; row + channels <= values.size(); row += channels) {
        for (size_t c = 0; c < out.channels; ++c) largest = std::max(largest, std::fabs(values[row + out.offset + c]));
      }
      calibration.layer_max[l] = largest;
    }
  }
  return calibration;
}

std::vector<Sample> calibration_samples(const std::string& folder, size_t limit, uint32_t candidates, uint32_t grid,
                                        uint32_t feature_set,
                                        const std::function<void(size_t done, size_t total)>& progress) {
  const std::vector<std::string> paths = list_characters(folder);
  const size_t count = limit == 0 ? paths.size() : std::min(limit, paths.size());
  std::vector<Sample> samples;
  std::string last_failure;
  for (size_t i = 0; i < count; ++i) {
    try {
      samples.push_back(make_sample(read_character(paths[i * paths.size() / count]), candidates, grid, feature_set));
    } catch (const Error& error) {
      last_failure = error.what();
    }
    if (progress) progress(i + 1, count);
  }
  if (samples.empty()) {
    throw Error(folder + ": no character to calibrate on" + (last_failure.empty() ? "" : " (" + last_failure + ")"));
  }
  return samples;
}

}  // namespace sinew
