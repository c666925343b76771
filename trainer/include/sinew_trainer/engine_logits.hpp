// SPDX-License-Identifier: MIT
// Logits of a quantised network on a sample, and their noise beside the float network's.
#ifndef SINEW_TRAINER_ENGINE_LOGITS_HPP
#define SINEW_TRAINER_ENGINE_LOGITS_HPP

#include <vector>

#include "sinew/sinew.h"
#include "sinew_trainer/sample.hpp"

namespace sinew {

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
