// SPDX-License-Identifier: MIT
// A network in a wider one: what it computes stays, what is added can learn.
#include "network/widen.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "expect_error.hpp"
#include "network/layer_runner.hpp"
#include "network/networks.hpp"
#include "network/rig_network.hpp"
#include "random_sample.hpp"
#include "rig/rig_task.hpp"

namespace sinew {
namespace {

using testing::random_sample;

// A ring of points with random rows, as votes see them.
NetworkSample ring(uint32_t points) {
  std::mt19937_64 random(5);
  NetworkSample s;
  s.name = "ring";
  s.vertices = points;
  s.candidates = s.part_count = s.joints = 1;
  s.inputs = {{rigging::kRigChannels, {}}};
  s.row_offsets = {0};
  s.part_offsets = {0, points};
  for (uint32_t v = 0; v < points; ++v) {
    for (uint32_t c = 0; c < rigging::kRigChannels; ++c)
      s.inputs[0].rows.push_back(static_cast<int16_t>(static_cast<int>(random() % 16001) - 8000));
    s.col_indices.insert(s.col_indices.end(), {(v + 1) % points, (v + points - 1) % points});
    s.row_offsets.push_back(static_cast<uint32_t>(s.col_indices.size()));
    s.candidate.push_back(0);
    s.far_indices.insert(s.far_indices.end(), {(v + 5) % points, (v + 9) % points});
    s.part.push_back(0);
    s.part_vertices.push_back(v);
  }
  s.far_offsets = s.row_offsets;
  return s;
}

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

TEST(Widen, VotesStayTheSame) { expect_same(make_rig_network({8, 3}, 1), make_rig_network({13, 3}, 2), ring(14)); }

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
