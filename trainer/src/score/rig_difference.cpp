// SPDX-License-Identifier: MIT
// Runs both networks on the same points: votes and fronts.
#include "sinew_trainer/rig_difference.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "data/front_sample.hpp"
#include "data/hand_sample.hpp"
#include "data/some_characters.hpp"
#include "run/front_loss.hpp"
#include "sinew_trainer/calibrate.hpp"
#include "sinew_trainer/network.hpp"
#include "sinew_trainer/network_input.hpp"
#include "votes/rig_task.hpp"

namespace sinew {
namespace {

using namespace rigging;

std::vector<RigSample> vote_samples(const FloatNetwork& network, const std::string& folder, size_t limit) {
  std::vector<RigSample> samples;
  each_of_some_characters(folder, limit, [&](const Character& character, size_t i) {
    const size_t before = samples.size();
    if (network.feature_set != kHandsFeatureSet) {
      samples.push_back(RigSource(character).make(i, {}));
      return true;
    }
    for (const HandSource& hand : hand_sources(character)) {
      std::optional<RigSample> sample = hand.make(i, 0);
      if (sample) samples.push_back(std::move(*sample));
    }
    return samples.size() > before;
  });
  return samples;
}

template <class T>
uint32_t most_likely(const T* logits, uint32_t count) {
  return static_cast<uint32_t>(std::max_element(logits, logits + count) - logits);
}

std::vector<FrontSample> front_samples(const std::string& folder, size_t limit) {
  std::vector<FrontSample> samples;
  each_of_some_characters(folder, limit, [&](const Character& character, size_t i) {
    for (FrontSample& sample : FrontSource(character).make(i, {.strength = 1})) samples.push_back(std::move(sample));
    return true;
  });
  return samples;
}

}  // namespace

Calibration calibrate_rig(const FloatNetwork& network, const std::string& folder, size_t limit) {
  return calibrate(network, vote_samples(network, folder, limit));
}

VoteDifference compare_votes(const FloatNetwork& network, const sinew_model& model, const std::string& folder,
                             size_t limit) {
  VoteDifference difference;
  NetworkRunner runner;
  size_t votes = 0;
  for (const RigSample& sample : vote_samples(network, folder, limit)) {
    const std::vector<float>& exact = runner.forward(network, sample);
    const std::vector<int16_t> rows = engine_rows(model, sample, size_t{sample.vertices} * kRigOutputs);
    ++difference.characters;
    for (uint32_t i = 0; i < sample.vertices; ++i) {
      const float* const a = &exact[size_t{i} * kRigOutputs];
      const int16_t* const b = &rows[size_t{i} * kRigOutputs];
      for (const uint32_t end : {static_cast<uint32_t>(kRigStart), static_cast<uint32_t>(kRigEnd)}) {
        double squared = 0;
        for (uint32_t axis = 0; axis < 3; ++axis) {
          const double e = static_cast<double>(a[end + axis]) - b[end + axis] / 1024.0;
          squared += e * e;
        }
        const double distance = std::sqrt(squared) / kRigOffsetScale;
        difference.mean += distance;
        difference.most = std::max(difference.most, distance);
        ++votes;
      }
      difference.same_class +=
          most_likely(a + kRigStartClass, kJointClasses) == most_likely(b + kRigStartClass, kJointClasses);
      difference.same_class += most_likely(a + kRigEndClass, kEndClasses) == most_likely(b + kRigEndClass, kEndClasses);
    }
  }
  difference.mean /= static_cast<double>(votes);
  difference.same_class /= static_cast<double>(votes);
  return difference;
}

Calibration calibrate_front(const FloatNetwork& network, const std::string& folder, size_t limit) {
  return calibrate(network, front_samples(folder, limit));
}

FrontDifference compare_fronts(const FloatNetwork& network, const sinew_model& model, const std::string& folder,
                               size_t limit) {
  FrontDifference difference;
  NetworkRunner runner;
  size_t answers = 0;
  for (const FrontSample& sample : front_samples(folder, limit)) {
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
