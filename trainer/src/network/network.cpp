// SPDX-License-Identifier: MIT
// The public face of the float network: outputs, logits, probabilities for one sample, calibration on many.
#include "sinew_trainer/network.hpp"

#include <algorithm>
#include <cmath>

#include "data/sample_index.hpp"
#include "network/layer_runner.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {

struct NetworkRunner::State {
  LayerRunner<float> runner;
  FloatNetwork shape;  // without parameters: of the last forward(), for buffer()
  mutable std::vector<float> buffer;
};

NetworkRunner::NetworkRunner() : state_(std::make_unique<State>()) {}
NetworkRunner::~NetworkRunner() = default;

const std::vector<float>& NetworkRunner::forward(const FloatNetwork& network, const NetworkSample& sample) {
  check_network(network, sample.name);
  state_->shape.buffers = network.buffers;
  state_->shape.layers = network.layers;
  return state_->runner.forward(network, copy_blocks<float>(network), sample, {});
}

const std::vector<float>& NetworkRunner::buffer(uint16_t index) const {
  state_->runner.copy_buffer(state_->shape, index, &state_->buffer);
  return state_->buffer;
}

void require_bind_network(const FloatNetwork& network, const std::string& source) {
  check_network(network, source);
  const Buffer output = model_task(network).output;
  if (network.task != kTaskBind || output.domain != Domain::kPair || output.channels != 1)
    throw Error(
        source +
        ": expected a network for binding, which gives one logit per vertex and candidate; found one for task " +
        std::to_string(network.task));
}

std::vector<float> forward(const FloatNetwork& network, const Sample& sample) {
  require_bind_network(network, sample.name);
  return NetworkRunner().forward(network, sample);
}

std::vector<float> softmax(const Sample& sample, const std::vector<float>& logits) {
  std::vector<float> probabilities(logits.size(), 0.0f);
  const uint32_t slots = sample.candidates;
  for (uint32_t v = 0; v < sample.vertices; ++v) {
    const size_t row = size_t{v} * slots;
    float largest = -INFINITY, sum = 0;
    for (size_t k = row; k < row + slots; ++k) {
      if (sample.candidate[k] != kAbsent) largest = std::max(largest, logits[k]);
    }
    for (size_t k = row; k < row + slots; ++k) {
      if (sample.candidate[k] != kAbsent) sum += probabilities[k] = std::exp(logits[k] - largest);
    }
    for (size_t k = row; k < row + slots && sum > 0; ++k) probabilities[k] /= sum;
  }
  return probabilities;
}

std::vector<float> predict(const FloatNetwork& network, const Sample& sample) {
  return softmax(sample, forward(network, sample));
}

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
