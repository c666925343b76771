// SPDX-License-Identifier: MIT
// The public face of the float network: logits, probabilities, gradients for one sample.
#include "sinew_trainer/network.hpp"

#include <algorithm>
#include <cmath>

#include "data/sample_index.hpp"
#include "features/features.hpp"
#include "network/layer_runner.hpp"

namespace sinew {

struct NetworkRunner::State {
  LayerRunner<float> runner;
  std::vector<LinearBlock<float>> parameters, gradients;
  FloatNetwork shape;  // buffers and layers of the last forward(), for buffer()
  mutable std::vector<float> buffer;
};

NetworkRunner::NetworkRunner(const FloatNetwork& network) : state_(new State) { check_network(network); }
NetworkRunner::~NetworkRunner() { delete state_; }

const std::vector<float>& NetworkRunner::forward(const FloatNetwork& network, const Sample& sample, float dropout,
                                                 uint64_t seed, float feature_dropout) {
  state_->parameters = copy_blocks<float>(network);
  state_->shape.buffers = network.buffers;
  state_->shape.layers = network.layers;
  DropoutOptions options;
  options.activations = dropout;
  options.features = feature_dropout;
  options.kept_pair_features = {kPairLogRule, kPairLogParts};
  options.seed = seed;
  return state_->runner.forward(network, state_->parameters, sample, options);
}

void NetworkRunner::backward(const FloatNetwork& network, const Sample&, const std::vector<float>& d_logits,
                             std::vector<LinearParameters>* gradients) {
  state_->gradients = zero_blocks<float>(network);
  state_->runner.backward(network, state_->parameters, d_logits, &state_->gradients);
  for (size_t i = 0; i < gradients->size(); ++i) {
    std::vector<float>& weights = (*gradients)[i].weights;
    std::vector<float>& bias = (*gradients)[i].bias;
    for (size_t k = 0; k < weights.size(); ++k) weights[k] += state_->gradients[i].weights[k];
    for (size_t k = 0; k < bias.size(); ++k) bias[k] += state_->gradients[i].bias[k];
  }
}

const std::vector<float>& NetworkRunner::buffer(uint16_t index) const {
  state_->runner.copy_buffer(state_->shape, index, &state_->buffer);
  return state_->buffer;
}

std::vector<float> forward(const FloatNetwork& network, const Sample& sample) {
  return NetworkRunner(network).forward(network, sample);
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
