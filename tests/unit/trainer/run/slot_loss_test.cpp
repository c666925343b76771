// SPDX-License-Identifier: MIT
// Mean absolute errors of joint vectors and connections, their shares, and the gradient.
#include "run/slot_loss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "network/slot_network.hpp"

namespace sinew {
namespace {

using namespace rigging;

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

}  // namespace
}  // namespace sinew
