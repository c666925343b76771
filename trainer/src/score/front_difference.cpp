// SPDX-License-Identifier: MIT
// Runs both networks on the same points.
#include "sinew_trainer/front_difference.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "data/front_sample.hpp"
#include "run/front_loss.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/calibrate.hpp"
#include "sinew_trainer/network.hpp"
#include "sinew_trainer/network_input.hpp"

namespace sinew {
namespace {

std::vector<FrontSample> some_samples(const std::string& folder, size_t limit) {
  const std::vector<std::string> paths = list_characters(folder);
  const size_t count = limit == 0 ? paths.size() : std::min(limit, paths.size());
  std::vector<FrontSample> samples;
  std::string last;
  for (size_t i = 0; i < count; ++i) {
    try {
      for (FrontSample& sample : FrontSource(read_character(paths[i * paths.size() / count])).make(i, 1))
        samples.push_back(std::move(sample));
    } catch (const Error& error) {
      last = error.what();
    }
  }
  if (samples.empty())
    throw Error(last.empty() ? folder + ": no characters (NAME.obj with NAME.rig.txt, or .glb)" : last);
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
    for (const int16_t value : engine_rows(model, sample, size_t{sample.vertices} * kFrontOutputs))
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
