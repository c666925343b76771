// SPDX-License-Identifier: MIT
// Both networks of the published method: every gradient against central differences, and what a damaged file is told.
#include "network/slot_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "data/slot_sample.hpp"
#include "expect_error.hpp"
#include "ring_of_points.hpp"

namespace sinew {
namespace {

using namespace rigging;

// A fixed mix of the outputs, with squares so that the gradient is not constant.
double mix(const std::vector<double>& outputs, std::vector<double>* d) {
  double total = 0;
  if (d != nullptr) d->resize(outputs.size());
  for (size_t i = 0; i < outputs.size(); ++i) {
    const double r = std::sin(1.7 * static_cast<double>(i) + 0.3);
    total += r * outputs[i] + 0.05 * outputs[i] * outputs[i];
    if (d != nullptr) (*d)[i] = r + 0.1 * outputs[i];
  }
  return total;
}

TEST(SlotNetwork, GradientsOfAllBlocks) {
  FloatNetwork network = make_slot_network({6, 2}, 3);
  std::mt19937_64 random(9);
  for (LinearParameters& p : network.parameters)
    for (float& b : p.bias) b = static_cast<float>(random() % 2001) / 5000.0f - 0.2f;
  const NetworkSample sample = ring_of_points(14, 4);
  DropoutOptions dropout;
  dropout.activations = 0.2f;
  dropout.seed = 5;
  std::vector<LinearBlock<double>> parameters = copy_blocks<double>(network), gradients = zero_blocks<double>(network);
  SlotRunner<double> runner;
  std::vector<double> d_outputs;
  mix(runner.forward(network, parameters, sample, dropout), &d_outputs);
  ASSERT_EQ(d_outputs.size(), kSlotOutputs);
  runner.backward(network, parameters, d_outputs, &gradients);
  for (size_t b = 0; b < parameters.size(); ++b) {
    size_t moved = 0;
    const auto check = [&](std::vector<double>& values, const std::vector<double>& analytic, const char* what) {
      for (size_t i = 0; i < values.size(); i += 1 + values.size() / 25) {
        constexpr double kStep = 1e-8;  // 60,000 units of pairs: at a longer one some pass their kink
        const double kept = values[i];
        values[i] = kept + kStep;
        const double up = mix(runner.forward(network, parameters, sample, dropout), nullptr);
        values[i] = kept - kStep;
        const double down = mix(runner.forward(network, parameters, sample, dropout), nullptr);
        values[i] = kept;
        const double numeric = (up - down) / (2 * kStep);
        EXPECT_NEAR(analytic[i], numeric, 1e-5 * std::max(1.0, std::abs(numeric)))
            << "block " << b << " " << what << " " << i;
        moved += std::abs(numeric) > 1e-9;
      }
    };
    check(parameters[b].weights, gradients[b].weights, "weight");
    check(parameters[b].bias, gradients[b].bias, "bias");
    EXPECT_GT(moved, 0u) << "block " << b << " has no effect: the test would prove nothing";
  }
}

TEST(SlotNetwork, VerticesInAnotherOrderGiveTheSame) {
  const FloatNetwork network = make_slot_network({4, 3}, 3);
  const NetworkSample sample = ring_of_points(20, 6);
  NetworkSample turned = sample;  // vertex v is now v + 3
  for (uint32_t v = 0; v < 20; ++v) {
    const uint32_t to = (v + 3) % 20;
    std::copy_n(sample.inputs[0].rows.begin() + v * kRigChannels, kRigChannels,
                turned.inputs[0].rows.begin() + to * kRigChannels);
  }
  SlotRunner<double> a, b;
  const auto parameters = copy_blocks<double>(network);
  const std::vector<double>& first = a.forward(network, parameters, sample, {});
  const std::vector<double>& second = b.forward(network, parameters, turned, {});
  for (size_t i = 0; i < first.size(); ++i) EXPECT_NEAR(first[i], second[i], 1e-9) << i;
}

TEST(SlotNetwork, DamagedFilesAreRefused) {
  const FloatNetwork good = make_slot_network({}, 1);
  check_slot_network(good, "good");
  size_t parameters = 0;
  for (const LinearParameters& p : good.parameters) parameters += p.weights.size() + p.bias.size();
  EXPECT_LT(2 * parameters, 290000u) << "the default network is to be bundled";
  FloatNetwork other = good;
  other.architecture = "votes";
  EXPECT_ERROR(check_slot_network(other, "x"), "x: expected a network of slots, found votes");
  other = good;
  other.parameters.pop_back();
  EXPECT_ERROR(check_slot_network(other, "x"), "weight blocks, expected");
  other = good;
  LinearParameters& last = other.parameters.back();
  last.in = 3;
  last.weights.resize(3);
  EXPECT_ERROR(check_slot_network(other, "x"), "do not fit together");
  other = good;
  other.feature_set = 1;
  EXPECT_ERROR(check_slot_network(other, "x"), "x: damaged: other inputs");
}

}  // namespace
}  // namespace sinew
