// SPDX-License-Identifier: MIT
// run_network against a plain interpreter of the layer list: the same integers for every list, tile size and mesh;
// workspace as measured; cancel and full workspace as documented; quantized against float.
#include <gtest/gtest.h>

#include <cstdio>

#include "kernels/select.hpp"
#include "lent_threads.hpp"
#include "model/reader.hpp"
#include "network/plan.hpp"
#include "network_fixture.hpp"
#include "sinew_quant/quantize.hpp"

namespace sinew::test {
namespace {

struct Outcome {
  sinew_status status = SINEW_OK;
  std::vector<int16_t> logits;
  size_t high_water = 0, measured = 0;
};

// `lanes` pieces of work, the last one first.
Outcome run(const std::vector<uint8_t>& bytes, const Graph& g, uint32_t tile, size_t less = 0, Progress progress = {},
            uint32_t lanes = 1) {
  Outcome outcome;
  AlignedBytes file(bytes);
  sinew_model model{};
  outcome.status = sinew_model_open(file.data(), file.size(), &model);
  EXPECT_EQ(outcome.status, SINEW_OK);
  if (outcome.status != SINEW_OK) return outcome;
  Arena measure;
  NetworkOptions options;
  options.tile_vertices = tile;
  NetworkInput input = g.input();
  sinew_test::LoopLog log;
  input.threads = {lanes, sinew_test::run_backwards, &log};
  const Kernels kernels = fastest_kernels();
  EXPECT_EQ(run_network(model, input, kernels, {}, measure, nullptr, options), SINEW_OK);
  outcome.measured = measure.high_water();
  AlignedBytes workspace(outcome.measured - less);
  Arena arena(workspace.data(), workspace.size());
  outcome.logits.assign(size_t{g.vertices} * g.k, 12345);
  outcome.status = run_network(model, input, kernels, progress, arena, outcome.logits.data(), options);
  outcome.high_water = arena.high_water();
  EXPECT_EQ(arena.used(), 0u) << "scratch is given back";
  return outcome;
}

void expect_same(const std::vector<int16_t>& got, const std::vector<int16_t>& want, const Graph& g,
                 const std::string& what) {
  ASSERT_EQ(got.size(), want.size());
  for (size_t i = 0; i < got.size(); ++i) {
    const int16_t expected = g.present(i) ? want[i] : static_cast<int16_t>(0);
    ASSERT_EQ(got[i], expected) << what << ", vertex " << i / g.k << " slot " << i % g.k;
  }
}

TEST(Executor, EqualsInterpreterOnRandomLists) {
  size_t kinds[kLayerKindCount + 1] = {}, wide = 0, several_stages = 0, distinct = 0;
  for (uint32_t seed = 1; seed <= 150; ++seed) {
    const uint32_t k = 1 + seed % 9;
    const IntegerModel model = random_model(seed, k);
    const Graph g = random_graph(seed * 7, 1 + seed % 45, k, 3 + seed % 20, 1 + seed % 5, any_feature);
    const std::vector<uint8_t> bytes = write_model(model);
    const std::vector<int16_t> want = run_integer(model, g);
    for (const uint32_t tile : {1u, 5u, kTileVertices, 64u}) {
      const Outcome outcome = run(bytes, g, tile);
      ASSERT_EQ(outcome.status, SINEW_OK) << "seed " << seed;
      EXPECT_EQ(outcome.high_water, outcome.measured) << "seed " << seed;
      expect_same(outcome.logits, want, g, "seed " + std::to_string(seed) + " tile " + std::to_string(tile));
      if (HasFatalFailure()) return;
    }
    for (const uint32_t lanes : {2u, 5u}) {  // small tiles, so that every lane has some
      const Outcome outcome = run(bytes, g, 2, 0, {}, lanes);
      ASSERT_EQ(outcome.status, SINEW_OK) << "seed " << seed;
      EXPECT_EQ(outcome.high_water, outcome.measured) << "seed " << seed;
      expect_same(outcome.logits, want, g, "seed " + std::to_string(seed) + " lanes " + std::to_string(lanes));
      if (HasFatalFailure()) return;
    }
    for (const Layer& layer : model.layers) ++kinds[static_cast<size_t>(layer.kind)];
    for (const IntegerLinear& linear : model.linears) wide += linear.accumulator == AccumulatorClass::kWide;
    AlignedBytes file(bytes);
    sinew_model opened{};
    ASSERT_EQ(sinew_model_open(file.data(), file.size(), &opened), SINEW_OK);
    NetworkPlan plan;
    make_plan(opened, opened.candidate_count, &plan);
    several_stages += plan.stage_count > 2;
    distinct += std::set<int16_t>(want.begin(), want.end()).size() > 3;
  }
  // The comparison is worth something only when the lists were.
  for (size_t kind = 1; kind <= kLayerKindCount; ++kind) EXPECT_GT(kinds[kind], 20u) << "kind " << kind;
  EXPECT_GT(wide, 50u);
  EXPECT_GT(several_stages, 30u);
  EXPECT_GT(distinct, 75u);
}

TEST(Executor, EqualsInterpreterOnQuantizedNetworks) {
  for (const bool field : {true, false}) {
    const uint32_t k = 8;
    const FloatNetwork network = field ? field_like(3, k, 16, 2) : classic_like(4, k, 24);
    const Graph g = random_graph(5, 150, k, 20, 4, usual_feature);
    const QuantizedModel model = quantize(network, {run_float(network, g).layer_max});
    const std::vector<int16_t> want = run_integer(parse_model(model.bytes), g);
    for (const uint32_t tile : {7u, kTileVertices}) {
      expect_same(run(model.bytes, g, tile).logits, want, g, field ? "field" : "classic");
      if (HasFatalFailure()) return;
    }
  }
}

TEST(Executor, FieldStoresOnlyItsStates) {
  const FloatNetwork network = field_like(3, 8, 32, 2);
  const Graph g = random_graph(5, 60, 8, 20, 4, usual_feature);
  AlignedBytes file(quantize(network, {run_float(network, g).layer_max}).bytes);
  sinew_model model{};
  ASSERT_EQ(sinew_model_open(file.data(), file.size(), &model), SINEW_OK);
  NetworkPlan plan;
  make_plan(model, model.candidate_count, &plan);
  EXPECT_EQ(plan.stage_count, 3u);
  // Two pair states of 32 channels live at once; nothing of the 192 concatenated channels is stored.
  EXPECT_EQ(plan.store_values, 2u * 8 * 32);
}

TEST(Executor, DeadStorageIsReused) {
  const FloatNetwork network = field_like(3, 4, 16, 5);
  const Graph g = random_graph(5, 60, 4, 20, 4, usual_feature);
  AlignedBytes file(quantize(network, {run_float(network, g).layer_max}).bytes);
  sinew_model model{};
  ASSERT_EQ(sinew_model_open(file.data(), file.size(), &model), SINEW_OK);
  NetworkPlan plan;
  make_plan(model, model.candidate_count, &plan);
  EXPECT_EQ(plan.stage_count, 6u);
  EXPECT_EQ(plan.store_values, 2u * 4 * 16);
}

TEST(Executor, OneByteTooFewIsAStatus) {
  const IntegerModel model = random_model(11, 4);
  const Graph g = random_graph(5, 40, 4, 9, 3, any_feature);
  EXPECT_EQ(run(write_model(model), g, kTileVertices, 1).status, SINEW_ERROR_WORKSPACE);
}

struct Calls {
  uint32_t count = 0, stop_at = 0, last = 0;
  bool rising = true;
};
int on_progress(void* user, uint32_t permille) {
  Calls* calls = static_cast<Calls*>(user);
  calls->rising = calls->rising && permille >= calls->last && permille <= 1000;
  calls->last = permille;
  return ++calls->count == calls->stop_at;
}

TEST(Executor, ReportsAndCancelsBetweenRoundsOfTiles) {
  const FloatNetwork network = field_like(3, 4, 8, 1);
  const Graph g = random_graph(5, 500, 4, 9, 3, usual_feature);
  const std::vector<uint8_t> bytes = quantize(network, {run_float(network, g).layer_max}).bytes;
  Calls calls;
  EXPECT_EQ(run(bytes, g, 1, 0, {on_progress, &calls}).status, SINEW_OK);
  EXPECT_GE(calls.count, 20u);
  EXPECT_TRUE(calls.rising);
  EXPECT_GT(calls.last, 850u);
  Calls stopping;
  stopping.stop_at = 13;
  EXPECT_EQ(run(bytes, g, 1, 0, {on_progress, &stopping}).status, SINEW_ERROR_CANCELLED);
  EXPECT_EQ(stopping.count, 13u);
}

// Logit signal-to-noise against float64 and the difference of the probabilities after softmax.
TEST(Executor, QuantizedFieldKeepsTheFloatLogits) {
  const uint32_t k = 8;
  double worst_db = 1e9;
  for (uint32_t seed = 1; seed <= 3; ++seed) {
    const FloatNetwork network = field_like(seed, k, 32, 2);
    const Graph calibration = random_graph(seed + 50, 300, k, 25, 3, usual_feature);
    const Graph g = random_graph(seed + 80, 300, k, 25, 3, usual_feature);
    const QuantizedModel model = quantize(network, {run_float(network, calibration).layer_max});
    const Outcome outcome = run(model.bytes, g, kTileVertices);
    const std::vector<double> exact = run_float(network, g).logits;
    double signal = 0, noise = 0, dp_sum = 0, dp_max = 0, mean = 0;
    size_t n = 0;
    for (size_t i = 0; i < exact.size(); ++i) {
      if (!g.present(i)) continue;
      mean += exact[i];
      ++n;
    }
    mean /= static_cast<double>(n);
    for (size_t first = 0; first < exact.size(); first += k) {
      double e[16], q[16], e_sum = 0, q_sum = 0;
      for (size_t s = 0; s < k; ++s) {
        const size_t i = first + s;
        const double logit = outcome.logits[i] / (1024 * 1.4426950408889634);
        e[s] = g.present(i) ? std::exp(exact[i]) : 0;
        q[s] = g.present(i) ? std::exp(logit) : 0;
        e_sum += e[s];
        q_sum += q[s];
        if (!g.present(i)) continue;
        signal += (exact[i] - mean) * (exact[i] - mean);
        noise += (exact[i] - logit) * (exact[i] - logit);
      }
      for (size_t s = 0; s < k; ++s) {
        const double dp = std::abs(e[s] / e_sum - q[s] / q_sum);
        dp_sum += dp;
        dp_max = std::max(dp_max, dp);
      }
    }
    const double db = 10 * std::log10(signal / noise);
    worst_db = std::min(worst_db, db);
    EXPECT_LE(dp_sum / static_cast<double>(n), 3e-4);
    EXPECT_LE(dp_max, 5e-3);
  }
  std::printf("worst logit signal-to-noise %.1f dB\n", worst_db);
  EXPECT_GE(worst_db, 55);
}

}  // namespace
}  // namespace sinew::test
