// SPDX-License-Identifier: MIT
// Networks in float, on Eigen: the layer list of engine/src/model/layers.hpp forward and backward, over samples, and the largest
// value of every layer, which is what the quantizer needs to know.
#ifndef SINEW_TRAINER_NETWORK_HPP
#define SINEW_TRAINER_NETWORK_HPP

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/float_network.hpp"
#include "sinew_trainer/sample.hpp"

namespace sinew {

struct FieldOptions {
  uint32_t width = 48;         // channels of a pair state
  uint32_t vertex_width = 16;  // channels of the vertex branch
  uint32_t rounds = 3;         // message passing rounds, 0 is legal
  uint32_t candidates = 8;
  uint32_t grid = 64;
};
// Networks of trainer/README.md with seeded initial weights. field: the last layer starts at the heat prior.
// feature_flags: of the feature set (features/features.hpp of the engine).
FloatNetwork make_field(const FieldOptions& options, uint64_t seed, uint32_t feature_flags = 0);
// The network of patent CN110288681A, figures 7 and 8: N x 64 first feature, graph convolution, graph pooling, N x 576
// second feature, global and local branches, softmax over K distance-sorted candidates.
FloatNetwork make_classic(uint32_t candidates, uint32_t grid, uint64_t seed, uint32_t feature_flags = 0,
                          uint32_t block_layers = 1);

// Throws Error unless the network is bind's: one logit per pair.
void require_bind_network(const FloatNetwork& network, const std::string& source);
// Logits [U x K] in natural log units; absent slots are 0 and masked by the caller.
std::vector<float> forward(const FloatNetwork& network, const Sample& sample);
// Softmax over present candidates -> probabilities [U x K].
std::vector<float> softmax(const Sample& sample, const std::vector<float>& logits);
std::vector<float> predict(const FloatNetwork& network, const Sample& sample);

// Runs networks of any task. Scratch is reused between calls of one instance; one instance per thread.
class NetworkRunner {
 public:
  NetworkRunner();
  ~NetworkRunner();
  NetworkRunner(const NetworkRunner&) = delete;
  NetworkRunner& operator=(const NetworkRunner&) = delete;
  // The output's rows: [U x C] or, in a domain with slots, [U x K x C] with absent slots 0. Throws Error when the network
  // is damaged or does not fit the sample.
  const std::vector<float>& forward(const FloatNetwork& network, const NetworkSample& sample);
  // A whole buffer after forward(): [rows x channels] row-major, absent rows 0. For calibration.
  const std::vector<float>& buffer(uint16_t index) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

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
