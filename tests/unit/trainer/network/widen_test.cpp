// SPDX-License-Identifier: MIT
// A network in a wider one: what it computes stays, what is added can learn.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "expect_error.hpp"
#include "network/layer_runner.hpp"
#include "network/networks.hpp"
#include "random_sample.hpp"
#include "ring_of_points.hpp"

namespace sinew {
namespace {

using testing::random_sample;

std::vector<double> outputs(const FloatNetwork& network, const NetworkSample& sample) {
  LayerRunner<double> runner;
  return runner.forward(network, copy_blocks<double>(network), sample, {});
}

void expect_same(const FloatNetwork& narrow, FloatNetwork wide, const NetworkSample& sample) {
  const std::vector<double> before = outputs(narrow, sample), fresh = outputs(wide, sample);
  widen(narrow, "narrow", &wide);
  const std::vector<double> after = outputs(wide, sample);
  ASSERT_EQ(after.size(), before.size());
  double moved = 0, largest = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(after[i], before[i], 1e-9) << i;
    moved = std::max(moved, std::abs(fresh[i] - before[i]));
    largest = std::max(largest, std::abs(before[i]));
  }
  EXPECT_GT(moved, 1e-3) << "the wide network computed this before: the test would prove nothing";
  EXPECT_GT(largest, 1e-3);
}

TEST(Widen, VotesStayTheSame) {
  expect_same(make_rig_network({8, 3}, 1), make_rig_network({13, 3}, 2), ring_of_points(14, 5));
}

TEST(Widen, FieldStaysTheSame) {
  FieldOptions narrow, wide;
  narrow.width = 6;
  wide.width = 9;
  narrow.vertex_width = 4;
  wide.vertex_width = 7;
  narrow.rounds = wide.rounds = 2;
  narrow.candidates = wide.candidates = 4;
  const InputShape inputs{5, 6, 2, 0};
  FloatNetwork trained = build_field(narrow, inputs, 1);
  std::mt19937_64 random(3);
  for (LinearParameters& p : trained.parameters)
    for (float& w : p.weights) w += static_cast<float>(random() % 2001) / 4000.0f - 0.25f;
  expect_same(trained, build_field(wide, inputs, 2), random_sample({}));
}

// Every added channel reads something: with zeros both in and out it would have no gradient for ever.
TEST(Widen, AddedChannelsReadWhatIsThere) {
  FloatNetwork wide = make_rig_network({12, 2}, 2);
  widen(make_rig_network({8, 2}, 1), "narrow", &wide);
  const LinearParameters& first = wide.parameters[0];
  for (uint32_t n = 8; n < 12; ++n) {
    double squares = 0;
    for (uint32_t k = 0; k < first.in; ++k) squares += std::pow(first.weights[size_t{n} * first.in + k], 2);
    EXPECT_GT(squares, 0.1) << n;
  }
}

TEST(Widen, OthersAreRefused) {
  FloatNetwork wide = make_rig_network({12, 3}, 2);
  EXPECT_ERROR(widen(make_rig_network({16, 3}, 1), "some.ckpt", &wide), "some.ckpt: cannot start from its weights");
  EXPECT_ERROR(widen(make_rig_network({8, 2}, 1), "some.ckpt", &wide), "or one that is wider");
  EXPECT_ERROR(widen(make_rig_network({8, 3, true}, 1), "some.ckpt", &wide), "cannot start from its weights");
}

}  // namespace
}  // namespace sinew
