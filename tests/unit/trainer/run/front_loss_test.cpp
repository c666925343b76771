// SPDX-License-Identifier: MIT
// The answer of all points, what it costs, and the gradient.
#include "run/front_loss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "network/layer_runner.hpp"
#include "network/rig_network.hpp"

namespace sinew {
namespace {

FrontSample scene(bool upright, uint32_t points = 24) {
  FrontSample s;
  std::mt19937 random(5);
  const auto value = [&] { return static_cast<float>(random() % 2000) / 1000.0f - 1; };
  s.vertices = points;
  s.candidates = s.part_count = s.joints = 1;
  s.upright = upright;
  s.front = {0.6f, 0.8f};
  s.inputs.resize(1);
  s.inputs[0].channels = rigging::kFrontChannels;
  s.candidate.assign(points, 0xFFFF);
  s.part.assign(points, 0);
  s.part_offsets = {0, points};
  s.row_offsets.assign(points + 1, 0);
  for (uint32_t i = 0; i < points; ++i) {
    s.part_vertices.push_back(i);
    for (uint32_t c = 0; c < rigging::kFrontChannels; ++c)
      s.inputs[0].rows.push_back(static_cast<int16_t>(4000 * value()));
    for (int axis = 0; axis < 2; ++axis) {
      s.positions.push_back(0.4f * value());
      s.normals.push_back(value());
    }
  }
  return s;
}

TEST(FrontLoss, TheAnswerIsWhatPointsAndNormalsSumUpTo) {
  FrontSample s = scene(true, 1);
  s.positions = {0.1f, 0};
  s.normals = {0, 1};
  const std::vector<float> outputs = {0.75f, 0.4f, 0};
  const FrontLoss loss = front_loss(s, outputs, nullptr);
  EXPECT_NEAR(loss.answer[0], 0.6, 1e-6);
  EXPECT_NEAR(loss.answer[1], 0.8, 1e-6);
  EXPECT_NEAR(loss.front, 0, 1e-9);
  EXPECT_NEAR(loss.angle, 0, 1e-6);
  EXPECT_NEAR(loss.upright, std::log(2.0), 1e-6) << "a coin toss";
  s.front = {-0.6f, -0.8f};
  EXPECT_NEAR(front_loss(s, outputs, nullptr).angle, 1, 1e-6) << "exactly behind";
  s.upright = false;
  EXPECT_EQ(front_loss(s, outputs, nullptr).front, 0) << "what lies has no front";
}

// Central differences of the loss of outputs, of answers short and long, upright or not.
TEST(FrontLoss, GradientIsThatOfTheTotal) {
  for (const bool upright : {true, false}) {
    for (const float size : {0.5f, 12.0f}) {
      const FrontSample s = scene(upright);
      std::mt19937 random(3);
      std::vector<float> outputs;
      for (uint32_t i = 0; i < s.vertices * rigging::kFrontOutputs; ++i)
        outputs.push_back(size * (static_cast<float>(random() % 1000) / 500.0f - 1));
      std::vector<float> d;
      front_loss(s, outputs, &d);
      for (size_t i = 0; i < outputs.size(); ++i) {
        constexpr float kStep = 1.0f / 64;
        std::vector<float> more = outputs, less = outputs;
        more[i] += kStep;
        less[i] -= kStep;
        const double slope = (front_loss(s, more, nullptr).total - front_loss(s, less, nullptr).total) / (2.0 * kStep);
        EXPECT_NEAR(static_cast<double>(d[i]), slope, 2e-3 * std::fabs(slope) + 2e-5) << i << " " << size;
      }
    }
  }
}

// And of the weights, through the layer list.
TEST(FrontLoss, GradientReachesTheWeights) {
  const FrontSample s = scene(true);
  FloatNetwork network = make_front_network({8, 2}, 7);
  std::vector<LinearBlock<double>> blocks = copy_blocks<double>(network);
  LayerRunner<double> runner;
  const auto total = [&](std::vector<double>* d_outputs) {
    const std::vector<double>& rows = runner.forward(network, blocks, s, {});
    std::vector<float> d;
    const FrontLoss loss =
        front_loss(s, std::vector<float>(rows.begin(), rows.end()), d_outputs == nullptr ? nullptr : &d);
    if (d_outputs != nullptr) d_outputs->assign(d.begin(), d.end());
    return loss.total;
  };
  std::vector<double> d_outputs;
  total(&d_outputs);
  std::vector<LinearBlock<double>> gradients = blocks;
  for (LinearBlock<double>& block : gradients) {
    std::fill(block.weights.begin(), block.weights.end(), 0.0);
    std::fill(block.bias.begin(), block.bias.end(), 0.0);
  }
  runner.backward(network, blocks, d_outputs, &gradients);
  for (size_t b = 0; b < blocks.size(); ++b) {
    double largest = 0;
    size_t at = 0;
    for (size_t i = 0; i < blocks[b].weights.size(); ++i) {
      if (std::fabs(gradients[b].weights[i]) <= largest) continue;
      largest = std::fabs(gradients[b].weights[i]);
      at = i;
    }
    EXPECT_GT(largest, 0) << b;
    constexpr double kStep = 1.0 / 8192;  // small, because kinks are near
    const double kept = blocks[b].weights[at];
    blocks[b].weights[at] = kept + kStep;
    const double more = total(nullptr);
    blocks[b].weights[at] = kept - kStep;
    const double less = total(nullptr);
    blocks[b].weights[at] = kept;
    EXPECT_NEAR(gradients[b].weights[at], (more - less) / (2 * kStep), 0.03 * largest + 1e-5) << b;
  }
}

}  // namespace
}  // namespace sinew
