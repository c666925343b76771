// SPDX-License-Identifier: MIT
// The public face of the float network: outputs, logits, probabilities for one sample.
#include "sinew_trainer/network.hpp"

#include <algorithm>
#include <cmath>

#include "data/sample_index.hpp"
#include "network/layer_runner.hpp"
#include "sinew_formats/error.hpp"

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

}  // namespace sinew
