// SPDX-License-Identifier: MIT
// Losses of skeletons: errors count as they are said to, points that teach their class alone, the answer of all points; gradients.
#include "run/rig_loss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/random.hpp"
#include "network/layer_runner.hpp"
#include "network/networks.hpp"
#include "network/slot_network.hpp"
#include "votes/rig_task.hpp"

namespace sinew {
namespace {

using namespace rigging;

RigSample two_points() {
  RigSample s;
  s.vertices = 2;
  s.medial = {0, 0, 0, 0.1f, 0.2f, 0.3f};
  s.start = {0.1f, 0, 0, 0.2f, 0.2f, 0.3f};
  s.end = {0.2f, 0.1f, 0, 0.3f, 0.1f, 0.3f};
  s.weight = {1, 0};
  s.class_weight = {1, 0.5f};
  s.start_class = {2, 0};
  s.end_class = {3, 0};
  return s;
}

std::vector<float> some_outputs() {
  Random random(5);
  std::vector<float> outputs(size_t{2} * kRigOutputs);
  for (float& o : outputs) o = static_cast<float>(random.uniform(-1, 1));
  for (const size_t row : {size_t{0}, size_t{kRigOutputs}}) {
    outputs[row + kRigStartSpread] = -2.3f;
    outputs[row + kRigEndSpread] = -3.1f;
  }
  return outputs;
}

TEST(RigLoss, GradientIsThatOfFiniteDifferences) {
  const RigSample s = two_points();
  std::vector<float> outputs = some_outputs(), gradient;
  (void)rig_loss(s, outputs, &gradient);
  for (size_t i = 0; i < outputs.size(); ++i) {
    const float kept = outputs[i], step = 1e-2f;
    outputs[i] = kept + step;
    const double more = rig_loss(s, outputs, nullptr).total;
    outputs[i] = kept - step;
    const double less = rig_loss(s, outputs, nullptr).total;
    outputs[i] = kept;
    EXPECT_NEAR((more - less) / (2 * static_cast<double>(step)), static_cast<double>(gradient[i]), 2e-3) << i;
  }
}

TEST(RigLoss, APointWithoutWeightTeachesItsClassAlone) {
  const RigSample s = two_points();
  std::vector<float> gradient;
  (void)rig_loss(s, some_outputs(), &gradient);
  const float* const row = gradient.data() + kRigOutputs;
  for (uint32_t c = 0; c < kRigStartClass; ++c) EXPECT_EQ(row[c], 0) << c;
  EXPECT_LT(row[kRigStartClass], 0) << "more of its class";
  EXPECT_LT(row[kRigEndClass], 0);
}

// Two joints, which hang together, and a third that does not.
struct Scene {
  SlotSample sample;
  std::vector<float> outputs = std::vector<float>(kSlotOutputs, 0.0f);  // all right

  Scene() {
    sample.joints.assign(size_t{kSlots} * 4, 0.0f);
    for (const uint32_t slot : {0u, 1u, 5u}) {
      sample.present[slot] = 1;
      for (uint32_t c = 0; c < 4; ++c)
        outputs[slot * kSlotNumbers + c] = sample.joints[4 * slot + c] = 0.1f * static_cast<float>(slot + c);
      outputs[slot * kSlotNumbers + kSlotPresence] = 1;
    }
    sample.connected[slot_pair(0, 1)] = 1;
    connection(0, 1) = 1;
  }
  float& number(uint32_t slot, uint32_t n) { return outputs[slot * kSlotNumbers + n]; }
  float& connection(uint32_t i, uint32_t j) { return outputs[kSlots * kSlotNumbers + slot_pair(i, j)]; }
  SlotLoss loss(double balance, bool balanced = true) const {
    return slot_loss(sample, {balance, balanced}, outputs, nullptr);
  }
};

TEST(SlotLoss, EachErrorCountsAsItIsSaidTo) {
  Scene s;
  EXPECT_EQ(s.loss(0.7).total, 0);
  s.number(1, 0) += 0.03f;
  s.number(1, 1) -= 0.04f;
  EXPECT_NEAR(s.loss(0.7).joints, 0.07 / 12, 1e-8) << "of three joints' four numbers each";
  EXPECT_NEAR(s.loss(0.7).distance, 0.05 / 3, 1e-8);
  s = Scene();
  s.number(5, kSlotOffset) += 0.06f;
  EXPECT_NEAR(s.loss(0.7).joints, 0.06 / 12, 1e-8);
  EXPECT_EQ(s.loss(0.7).distance, 0) << "the offset from the skin is no place";
  s = Scene();
  s.number(7, 0) = 9;
  s.connection(0, 7) = 1;
  EXPECT_EQ(s.loss(0.7).total, 0) << "of a slot that holds nothing only the presence counts";
  s.number(7, kSlotPresence) = 0.6f;
  EXPECT_NEAR(s.loss(0.7).joints, kPresenceShare * 0.6 / kSlots, 1e-8);
  EXPECT_NEAR(s.loss(0.7).presence, 1.0 / kSlots, 1e-12);
  s = Scene();
  s.connection(0, 1) = 0.75f;
  s.connection(1, 5) = 0.5f;
  EXPECT_NEAR(s.loss(0.7).connections, 0.5 * 0.25 + 0.5 * 0.5 / 2, 1e-8) << "one pair hangs together, two do not";
  EXPECT_NEAR(s.loss(0.7).total, 0.3 * 0.25, 1e-8);
  EXPECT_NEAR(s.loss(1).total, 0, 1e-12);
}

TEST(SlotLoss, AsPublishedBothArePlainMeans) {
  Scene s;
  EXPECT_EQ(s.loss(0.7, false).total, 0);
  s.number(1, 0) += 0.03f;
  s.number(7, kSlotPresence) = 0.6f;
  EXPECT_NEAR(s.loss(0.7, false).joints, (0.03 + 0.6) / (3 * 4 + kSlots), 1e-8) << "every number counts the same";
  s.connection(0, 1) = 0.75f;
  s.connection(1, 5) = 0.5f;
  EXPECT_NEAR(s.loss(0.7, false).connections, (0.25 + 0.5) / 3, 1e-8) << "and so does every pair";
}

TEST(SlotLoss, GradientIsThatOfTheTotal) {
  Scene s;
  std::mt19937 random(3);
  for (float& o : s.outputs) o = static_cast<float>(random() % 1000) / 1000.0f;
  std::vector<float> d;
  slot_loss(s.sample, {0.6, true}, s.outputs, &d);
  ASSERT_EQ(d.size(), s.outputs.size());
  size_t moved = 0;
  for (size_t i = 0; i < d.size(); ++i) {
    constexpr float kStep = 1e-3f;
    Scene up = s, down = s;
    up.outputs[i] += kStep;
    down.outputs[i] -= kStep;
    const double numeric = (up.loss(0.6).total - down.loss(0.6).total) / (2 * static_cast<double>(kStep));
    EXPECT_NEAR(static_cast<double>(d[i]), numeric, 1e-5) << i;
    moved += std::abs(numeric) > 1e-9 ? 1 : 0;
  }
  EXPECT_EQ(moved, 3 * 4 + kSlots + 3);
}

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
