// SPDX-License-Identifier: MIT
// The engine's int16 network on a sample: for programs that run it beside the float one, and how far their logits lie apart.
#ifndef SINEW_TRAINER_ENGINE_NETWORK_HPP
#define SINEW_TRAINER_ENGINE_NETWORK_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "network/network.hpp"
#include "sinew/sinew.h"
#include "sinew_trainer/sample.hpp"

namespace sinew {

// Views of the sample, which must outlive them.
NetworkInput network_input(const NetworkSample& sample);

// Bytes that run_network() needs for the sample.
size_t network_workspace(const sinew_model& model, const NetworkSample& sample, const NetworkOptions& options = {});

// Runs the engine's network on the sample and returns its output: `count` numbers, by the kernel of the environment.
// Throws Error with the sample's name.
std::vector<int16_t> engine_rows(const sinew_model& model, const NetworkSample& sample, size_t count);

// Runs the engine's network on the sample's features. Returns logits [U x K] in natural log units, absent slots 0.
// Throws Error.
std::vector<float> engine_logits(const sinew_model& model, const Sample& sample);

// Power of the float logits and of their difference, each vertex' mean taken away first (a shift of a whole row means
// nothing to the softmax). Decibels are 10 log10(signal / noise).
struct LogitNoise {
  double signal = 0, noise = 0;
  void add(const Sample& sample, const std::vector<float>& reference, const std::vector<float>& other);
  double decibels() const;
};

}  // namespace sinew
#endif
