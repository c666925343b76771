// SPDX-License-Identifier: MIT
// Runs both networks on the same points.
#include "sinew_trainer/front_difference.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "data/front_sample.hpp"
#include "data/some_characters.hpp"
#include "run/front_loss.hpp"
#include "sinew_trainer/calibrate.hpp"
#include "sinew_trainer/network.hpp"
#include "sinew_trainer/network_input.hpp"

namespace sinew {
namespace {

std::vector<FrontSample> some_samples(const std::string& folder, size_t limit) {
  std::vector<FrontSample> samples;
  each_of_some_characters(folder, limit, [&](const Character& character, size_t i) {
    for (FrontSample& sample : FrontSource(character).make(i, {.strength = 1})) samples.push_back(std::move(sample));
    return true;
  });
  return samples;
}

}  // namespace

Calibration calibrate_front(const FloatNetwork& network, const std::string& folder, size_t limit) {
  const std::vector<FrontSample> samples = some_samples(folder, limit);
  std::vector<const NetworkSample*> views;
  for (const FrontSample& sample : samples) views.push_back(&sample);
  return calibrate(network, views);
}

FrontDifference compare_fronts(const FloatNetwork& network, const sinew_model& model, const std::string& folder,
                               size_t limit) {
  FrontDifference difference;
  NetworkRunner runner;
  size_t answers = 0;
  for (const FrontSample& sample : some_samples(folder, limit)) {
    const FrontLoss exact = front_loss(sample, runner.forward(network, sample), nullptr);
    std::vector<float> integers;
    for (const int16_t value : engine_rows(model, sample, size_t{sample.vertices} * rigging::kFrontOutputs))
      integers.push_back(static_cast<float>(value) / 1024.0f);
    const FrontLoss rounded = front_loss(sample, integers, nullptr);
    const double distance = std::hypot(exact.answer[0] - rounded.answer[0], exact.answer[1] - rounded.answer[1]);
    difference.mean += distance;
    difference.most = std::max(difference.most, distance);
    ++answers;
  }
  constexpr size_t kSamplesEach = 3;
  difference.characters = answers / kSamplesEach;
  difference.mean /= static_cast<double>(answers);
  return difference;
}

}  // namespace sinew
