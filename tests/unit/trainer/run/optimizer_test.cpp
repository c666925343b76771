// SPDX-License-Identifier: MIT
// Optimizers on a parabola, clipping, schedule, running average.
#include "run/optimizer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sinew {
namespace {

FloatNetwork one_weight(float weight, float bias) {
  FloatNetwork network;
  network.parameters.push_back({1, 1, {weight}, {bias}});
  return network;
}

TEST(Optimizer, EveryKindFindsTheBottomOfAParabola) {
  for (const char* kind : {"sgd", "adam", "adamw"}) {
    TrainConfig config;
    config.optimizer = kind;
    config.weight_decay = 0;
    FloatNetwork network = one_weight(3, -2);
    TrainingState state;
    for (int i = 0; i < 2000; ++i) {
      const std::vector<LinearBlock<float>> gradient = {
          {{2 * (network.parameters[0].weights[0] - 1)}, {2 * (network.parameters[0].bias[0] - 0.5f)}}};
      optimizer_step(config, 0.01, gradient, &network, &state);
      ++state.step;
    }
    EXPECT_NEAR(network.parameters[0].weights[0], 1, 1e-3) << kind;
    EXPECT_NEAR(network.parameters[0].bias[0], 0.5, 1e-3) << kind;
  }
}

TEST(Optimizer, DecoupledDecayShrinksWeightsByRateTimesDecayAndLeavesBiases) {
  TrainConfig config;
  config.optimizer = "adamw";
  config.weight_decay = 0.5;
  FloatNetwork network = one_weight(2, 2);
  TrainingState state;
  optimizer_step(config, 0.1, {{{0.0f}, {0.0f}}}, &network, &state);
  EXPECT_FLOAT_EQ(network.parameters[0].weights[0], 2 * (1 - 0.05f));
  EXPECT_FLOAT_EQ(network.parameters[0].bias[0], 2);
}

TEST(Optimizer, FirstAdamStepHasTheLengthOfTheRate) {
  TrainConfig config;
  config.weight_decay = 0;
  FloatNetwork network = one_weight(0, 0);
  TrainingState state;
  optimizer_step(config, 0.01, {{{1e-3f}, {-50.0f}}}, &network, &state);
  EXPECT_NEAR(network.parameters[0].weights[0], -0.01, 1e-6);
  EXPECT_NEAR(network.parameters[0].bias[0], 0.01, 1e-6);
}

TEST(Optimizer, ClippingKeepsDirectionAndSmallGradients) {
  std::vector<LinearBlock<float>> gradient = {{{3.0f}, {4.0f}}};
  EXPECT_NEAR(clip_gradients(&gradient, 1.0), 5.0, 1e-6);
  EXPECT_NEAR(gradient[0].weights[0], 0.6, 1e-6);
  EXPECT_NEAR(gradient[0].bias[0], 0.8, 1e-6);
  clip_gradients(&gradient, 2.0);
  EXPECT_NEAR(gradient[0].bias[0], 0.8, 1e-6);
}

TEST(Optimizer, ScheduleWarmsUpThenFallsToAHundredth) {
  EXPECT_LT(schedule(0), 0.2);
  EXPECT_GT(schedule(0), 0);
  EXPECT_NEAR(schedule(0.02), 1, 1e-9);
  EXPECT_NEAR(schedule(0.51), 0.505, 0.01);
  EXPECT_NEAR(schedule(1), 0.01, 1e-9);
  EXPECT_NEAR(schedule(7), 0.01, 1e-9);
}

TEST(Optimizer, AverageForgetsTheStart) {
  FloatNetwork average = one_weight(100, 100);
  const FloatNetwork network = one_weight(1, 2);
  for (uint64_t step = 1; step <= 200; ++step) update_average(network, 0.99, step, &average);
  EXPECT_NEAR(average.parameters[0].weights[0], 1, 0.01);
  EXPECT_NEAR(average.parameters[0].bias[0], 2, 0.01);
}

}  // namespace
}  // namespace sinew
