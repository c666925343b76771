// SPDX-License-Identifier: MIT
// The float layers: every gradient against central differences in double, absent pairs, vertex order, the untrained
// networks.
#include "sinew_trainer/network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include "features/features.hpp"
#include "network/layer_runner.hpp"
#include "network/networks.hpp"
#include "random_sample.hpp"
#include "run/loss.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

using testing::random_sample;
using testing::RandomSampleOptions;

// A network of two inputs and whatever `add` appends; parameters random.
struct Builder {
  FloatNetwork network;
  std::mt19937_64 random{7};

  explicit Builder(const Sample& sample) {
    network.architecture = "test";
    network.candidate_count = sample.candidates;
    network.buffers = {{Domain::kVertex, static_cast<uint16_t>(sample.inputs[0].channels)},
                       {Domain::kPair, static_cast<uint16_t>(sample.inputs[1].channels)}};
  }
  Region buffer(Domain domain, uint32_t channels) {
    network.buffers.push_back({domain, static_cast<uint16_t>(channels)});
    return {static_cast<uint16_t>(network.buffers.size() - 1), 0, static_cast<uint16_t>(channels)};
  }
  Region input(uint16_t index) const { return {index, 0, network.buffers[index].channels}; }
  Region linear(Region in, uint32_t out_channels, uint8_t flags = 0, Region residual = {}) {
    const Region out = buffer(network.buffers[in.buffer].domain, out_channels);
    Layer layer;
    layer.flags = flags;
    layer.in = in;
    layer.out = out;
    layer.residual = residual;
    layer.parameters = static_cast<uint32_t>(network.parameters.size());
    network.layers.push_back(layer);
    LinearParameters p;
    p.in = in.channels;
    p.out = out_channels;
    for (uint32_t i = 0; i < p.in * p.out; ++i)
      p.weights.push_back(static_cast<float>(random() % 2001) / 1000.0f - 1.0f);
    for (uint32_t i = 0; i < p.out; ++i) p.bias.push_back(static_cast<float>(random() % 2001) / 2000.0f - 0.5f);
    network.parameters.push_back(p);
    return out;
  }
  void apply(LayerKind kind, Region in, Region out) {
    Layer layer;
    layer.kind = kind;
    layer.in = in;
    layer.out = out;
    network.layers.push_back(layer);
  }
  Region apply(LayerKind kind, Region in, Domain domain, uint32_t channels) {
    const Region out = buffer(domain, channels);
    apply(kind, in, out);
    return out;
  }
};

// sum of r * logits with fixed r over present slots, plus a square so that the gradient is not constant.
double scalar(const std::vector<double>& logits, std::vector<double>* d) {
  double total = 0;
  if (d != nullptr) d->resize(logits.size());
  for (size_t i = 0; i < logits.size(); ++i) {
    const double r = std::sin(1.7 * static_cast<double>(i) + 0.3);
    total += r * logits[i] + 0.05 * logits[i] * logits[i];
    if (d != nullptr) (*d)[i] = r + 0.1 * logits[i];
  }
  return total;
}

// `checks` parameters of each block are tried, spread over it.
void expect_gradients(const FloatNetwork& network, const Sample& sample, const DropoutOptions& dropout = {},
                      size_t checks = 30) {
  std::vector<LinearBlock<double>> parameters = copy_blocks<double>(network);
  LayerRunner<double> runner;
  std::vector<double> d_logits;
  scalar(runner.forward(network, parameters, sample, dropout), &d_logits);
  std::vector<LinearBlock<double>> gradients = zero_blocks<double>(network);
  runner.backward(network, parameters, d_logits, &gradients);
  size_t moved = 0;
  const auto check = [&](double* value, double analytic, const std::string& what) {
    constexpr double kStep = 1e-6;
    const double kept = *value;
    *value = kept + kStep;
    const double up = scalar(runner.forward(network, parameters, sample, dropout), nullptr);
    *value = kept - kStep;
    const double down = scalar(runner.forward(network, parameters, sample, dropout), nullptr);
    *value = kept;
    const double numeric = (up - down) / (2 * kStep);
    EXPECT_NEAR(analytic, numeric, 1e-5 * std::max(1.0, std::abs(numeric))) << what;
    moved += std::abs(numeric) > 1e-9;
  };
  for (size_t b = 0; b < parameters.size(); ++b) {
    const size_t stride =
        1 + parameters[b].weights.size() / 30;  // every weight of a small network, samples of a large one
    for (size_t i = 0; i < parameters[b].weights.size(); i += stride) {
      check(&parameters[b].weights[i], gradients[b].weights[i],
            "block " + std::to_string(b) + " weight " + std::to_string(i));
    }
    for (size_t i = 0; i < parameters[b].bias.size(); i += 1 + parameters[b].bias.size() / checks) {
      check(&parameters[b].bias[i], gradients[b].bias[i], "block " + std::to_string(b) + " bias " + std::to_string(i));
    }
  }
  EXPECT_GT(moved, 0u) << "no parameter has any effect: the test would prove nothing";
}

// Initial biases are 0, which puts pairs without any input exactly on the corner of the ReLU; the last layer is near 0.
void leave_the_start(FloatNetwork* network) {
  std::mt19937_64 random(9);
  for (LinearParameters& p : network->parameters) {
    for (float& b : p.bias) b = static_cast<float>(random() % 2001) / 5000.0f - 0.2f;
  }
  for (float& w : network->parameters.back().weights) w += 0.3f;
}

class LayerGradient : public ::testing::TestWithParam<uint64_t> {
 protected:
  Sample sample_ = random_sample({.seed = GetParam()});
  Builder b_{sample_};
};

TEST_P(LayerGradient, LinearWithReluAndResidual) {
  const Region first = b_.linear(b_.input(kPairInput), 3, kLayerRelu);
  const Region second = b_.linear(first, 3, kLayerRelu | kLayerResidual, first);
  b_.linear(second, 1);
  expect_gradients(b_.network, sample_);
}

TEST_P(LayerGradient, PairAggregations) {
  for (LayerKind kind : {LayerKind::kRingMean, LayerKind::kRingMax, LayerKind::kPartMean, LayerKind::kGlobalMean,
                         LayerKind::kGlobalMax, LayerKind::kCandidateMax, LayerKind::kCopy}) {
    SCOPED_TRACE(static_cast<int>(kind));
    Builder b(sample_);
    const Region state = b.linear(b.input(kPairInput), 3);
    b.linear(b.apply(kind, state, Domain::kPair, 3), 1);
    expect_gradients(b.network, sample_);
  }
}

TEST_P(LayerGradient, VertexAggregations) {
  for (LayerKind kind : {LayerKind::kRingMean, LayerKind::kRingMax, LayerKind::kPartMean, LayerKind::kGlobalMean,
                         LayerKind::kGlobalMax, LayerKind::kCopy}) {
    SCOPED_TRACE(static_cast<int>(kind));
    Builder b(sample_);
    const Region state = b.linear(b.input(kVertexInput), 3);
    const Region pooled = b.apply(kind, state, Domain::kVertex, 3);
    b.linear(b.apply(LayerKind::kVertexToPair, pooled, Domain::kPair, 3), 1);
    expect_gradients(b.network, sample_);
  }
}

TEST_P(LayerGradient, PairToVertexAndBackToSlots) {
  const uint32_t k = sample_.candidates;
  const Region state = b_.linear(b_.input(kPairInput), 2, kLayerRelu);
  const Region flat = b_.apply(LayerKind::kPairToVertex, state, Domain::kVertex, 2 * k);
  const Region mixed = b_.linear(flat, 2 * k);
  b_.linear(b_.apply(LayerKind::kVertexToSlots, mixed, Domain::kPair, 2), 1);
  expect_gradients(b_.network, sample_);
}

TEST_P(LayerGradient, RegionsInsideOneBufferAndSeveralReaders) {
  const Region concat = b_.buffer(Domain::kPair, 7);
  const Region left{concat.buffer, 0, 3}, right{concat.buffer, 3, 3}, one{concat.buffer, 6, 1};
  const Region state = b_.linear(b_.input(kPairInput), 3, kLayerRelu);
  b_.apply(LayerKind::kCopy, state, left);
  b_.apply(LayerKind::kRingMean, state, right);
  b_.apply(LayerKind::kCopy, {state.buffer, 1, 1}, one);
  const Region next = b_.linear(concat, 3, kLayerRelu | kLayerResidual, left);
  b_.linear(next, 1, kLayerResidual, one);
  expect_gradients(b_.network, sample_);
}

TEST_P(LayerGradient, WholeFieldAndClassicNetworks) {
  const InputShape inputs{sample_.inputs[0].channels, sample_.inputs[1].channels, 2};
  for (uint32_t rounds : {0u, 1u, 2u}) {
    FloatNetwork network = build_field({3, 2, rounds, sample_.candidates, 64}, inputs, GetParam());
    leave_the_start(&network);
    expect_gradients(network, sample_);
  }
  if (GetParam() == 1) {  // half a million weights: few vertices and few of them are enough
    FloatNetwork classic = build_classic(sample_.candidates, 64, inputs, GetParam());
    leave_the_start(&classic);
    expect_gradients(classic, random_sample({.vertices = 8, .part_count = 2, .seed = 9}), {}, 2);
  }
  DropoutOptions dropout;
  dropout.activations = 0.3f;
  dropout.features = 0.3f;
  dropout.seed = 5;
  FloatNetwork network = build_field({4, 2, 1, sample_.candidates, 64}, inputs, 3);
  leave_the_start(&network);
  expect_gradients(network, sample_, dropout);
}

INSTANTIATE_TEST_SUITE_P(Seeds, LayerGradient, ::testing::Values(1, 2, 3));

TEST(FloatNetwork, AbsentPairsAreZeroAndNeverCounted) {
  Sample sample = random_sample({.seed = 4});
  Builder b(sample);
  const Region negative = b.linear(b.input(kPairInput), 1);
  for (float& w : b.network.parameters[0].weights) w = 0;
  b.network.parameters[0].bias[0] =
      -3;  // every present value is -3: a counted 0 would win any maximum and move any mean
  b.apply(LayerKind::kCandidateMax, negative, b.buffer(Domain::kPair, 1));
  b.apply(LayerKind::kGlobalMean, negative, b.buffer(Domain::kPair, 1));
  b.apply(LayerKind::kGlobalMax, negative, b.buffer(Domain::kPair, 1));
  NetworkRunner runner;
  runner.forward(b.network, sample);
  for (uint16_t buffer = 2; buffer < b.network.buffers.size(); ++buffer) {
    const std::vector<float>& values = runner.buffer(buffer);
    for (size_t i = 0; i < values.size(); ++i) {
      EXPECT_FLOAT_EQ(values[i], sample.candidate[i] == 0xFFFF ? 0.0f : -3.0f) << "buffer " << buffer << " slot " << i;
    }
  }
}

TEST(FloatNetwork, RingAndPartMeansFollowTheJoint) {
  // Two joined vertices and one of another part; joint 5 is candidate of all, joint 6 of the first alone.
  Sample s;
  s.vertices = 3;
  s.candidates = 2;
  s.part_count = 2;
  s.joints = 7;
  s.inputs = {{1, {0, 0, 0}}, {1, {8192, 2 * 8192 - 1, -8192, 0, 4096, 0}}};
  s.candidate = {5, 6, 5, 0xFFFF, 5, 0xFFFF};
  s.row_offsets = {0, 1, 2, 2};
  s.col_indices = {1, 0};
  s.part = {0, 0, 1};
  s.part_offsets = {0, 2, 3};
  s.part_vertices = {0, 1, 2};
  Builder b(s);
  const Region ring = b.apply(LayerKind::kRingMean, b.input(kPairInput), Domain::kPair, 1);
  const Region part = b.apply(LayerKind::kPartMean, b.input(kPairInput), Domain::kPair, 1);
  const Region largest = b.apply(LayerKind::kRingMax, b.input(kPairInput), Domain::kPair, 1);
  NetworkRunner runner;
  runner.forward(b.network, s);
  const std::vector<float> ring_values = runner.buffer(ring.buffer), part_values = runner.buffer(part.buffer);
  const float almost_two = (2 * 8192 - 1) / 8192.0f;
  EXPECT_EQ(ring_values, (std::vector<float>{-1, 0, 1, 0, 0, 0}));
  EXPECT_EQ(part_values, (std::vector<float>{0, almost_two / 2, 0, 0, 0.5f, 0}));
  EXPECT_EQ(runner.buffer(largest.buffer), (std::vector<float>{-1, 0, 1, 0, 0, 0}))
      << "a lone negative neighbor is the largest";
}

TEST(FloatNetwork, VertexOrderDoesNotMatter) {
  const Sample sample = random_sample({.vertices = 60, .candidates = 5, .joints = 9, .seed = 11});
  std::vector<uint32_t> to(sample.vertices);  // old index -> new index
  std::iota(to.begin(), to.end(), 0u);
  std::shuffle(to.begin(), to.end(), std::mt19937_64(3));
  Sample moved = sample;
  const auto permute = [&](auto& out, const auto& in, size_t channels) {
    for (uint32_t v = 0; v < sample.vertices; ++v)
      std::copy_n(in.begin() + v * channels, channels, out.begin() + to[v] * channels);
  };
  permute(moved.inputs[0].rows, sample.inputs[0].rows, sample.inputs[0].channels);
  permute(moved.inputs[1].rows, sample.inputs[1].rows, size_t{sample.candidates} * sample.inputs[1].channels);
  permute(moved.candidate, sample.candidate, sample.candidates);
  permute(moved.part, sample.part, 1);
  for (uint32_t& v : moved.part_vertices) v = to[v];
  std::vector<std::vector<uint32_t>> rows(sample.vertices);
  for (uint32_t v = 0; v < sample.vertices; ++v) {
    for (uint32_t e = sample.row_offsets[v]; e < sample.row_offsets[v + 1]; ++e)
      rows[to[v]].push_back(to[sample.col_indices[e]]);
  }
  moved.row_offsets = {0};
  moved.col_indices.clear();
  for (const auto& row : rows) {
    moved.col_indices.insert(moved.col_indices.end(), row.begin(), row.end());
    moved.row_offsets.push_back(static_cast<uint32_t>(moved.col_indices.size()));
  }
  const InputShape inputs{sample.inputs[0].channels, sample.inputs[1].channels, 2};
  for (FloatNetwork network : {build_field({8, 4, 2, 5, 64}, inputs, 1), build_classic(5, 64, inputs, 1)}) {
    for (float& w : network.parameters.back().weights) w += 0.3f;
    const std::vector<float> here = predict(network, sample), there = predict(network, moved);
    for (uint32_t v = 0; v < sample.vertices; ++v) {
      for (uint32_t k = 0; k < sample.candidates; ++k) {
        EXPECT_NEAR(here[v * sample.candidates + k], there[to[v] * sample.candidates + k], 1e-5)
            << network.architecture;
      }
    }
  }
}

TEST(FloatNetwork, UntrainedFieldIsTheHeatBinder) {
  const Sample sample = random_sample({.vertices = 80,
                                       .candidates = 8,
                                       .joints = 20,
                                       .vertex_features = kVertexFeatures,
                                       .pair_features = kPairFeatures,
                                       .seed = 5});
  const std::vector<float> p = predict(make_field({}, 1), sample);
  for (uint32_t v = 0; v < sample.vertices; ++v) {
    std::vector<double> expected(8, 0.0);
    double sum = 0;
    for (uint32_t k = 0; k < 8; ++k) {
      const size_t slot = size_t{v} * 8 + k;
      if (sample.candidate[slot] == 0xFFFF) continue;
      expected[k] = std::exp(sample.inputs[1].rows[slot * kPairFeatures + kPairLogRule] / 8192.0 * kLogFeatureDivisor);
      sum += expected[k];
    }
    for (uint32_t k = 0; k < 8; ++k) EXPECT_NEAR(p[size_t{v} * 8 + k], expected[k] / sum, 1e-3);
  }
}

TEST(FloatNetwork, ShrunkCorrectionLiesBetweenHeatAndTheTrainedNetwork) {
  const Sample sample = random_sample({.vertices = 40, .seed = 6});
  const InputShape inputs{sample.inputs[0].channels, sample.inputs[1].channels, 2};
  const FloatNetwork untrained = build_field({8, 4, 1, sample.candidates, 64}, inputs, 1);
  FloatNetwork trained = untrained;
  leave_the_start(&trained);
  for (float& w : trained.parameters[trained.parameters.size() - 2].weights) w += 0.5f;
  FloatNetwork prior = untrained;  // without the small random last layer
  for (float& w : prior.parameters.back().weights) w = 0;
  const std::vector<float> heat = forward(prior, sample), all = forward(trained, sample);
  const std::vector<float> some = forward(shrink_correction(trained, 0.25, inputs.log_rule), sample);
  double moved = 0;
  for (size_t i = 0; i < heat.size(); ++i) {
    EXPECT_NEAR(some[i], heat[i] + 0.25f * (all[i] - heat[i]), 1e-4);
    moved += std::abs(all[i] - heat[i]);
  }
  EXPECT_GT(moved, 1);
  EXPECT_EQ(forward(shrink_correction(trained, 1, inputs.log_rule), sample), all);
}

TEST(FloatNetwork, ClassicHasThePublishedWidthsAndFitsTheBudget) {
  const FloatNetwork network = make_classic(8, 64, 1);
  size_t parameters = 0, multiplications = 0;
  bool first_64 = false, second_576 = false;
  for (const Layer& layer : network.layers) {
    if (layer.kind != LayerKind::kLinear) continue;
    const LinearParameters& p = network.parameters[layer.parameters];
    parameters += p.weights.size() + p.bias.size();
    multiplications += p.weights.size();  // every linear layer of classic runs once per vertex
    first_64 |= p.out == 64;
    second_576 |= p.in == 576;
  }
  EXPECT_TRUE(first_64);
  EXPECT_TRUE(second_576);
  EXPECT_LE(parameters, 1000000u);
  EXPECT_LE(multiplications, 900000u);
}

TEST(FloatNetwork, DamagedNetworksAreRefused) {
  const FloatNetwork good = make_field({}, 1);
  check_network(good, "x");
  const std::vector<std::function<void(FloatNetwork&)>> damages = {
      [](FloatNetwork& n) { n.layers[0].in.buffer = 60; },
      [](FloatNetwork& n) { n.layers[0].out.channels = 999; },
      [](FloatNetwork& n) { n.layers[0].parameters = 999; },
      [](FloatNetwork& n) { n.parameters[0].weights.pop_back(); },
      [](FloatNetwork& n) { n.parameters[1].bias.push_back(0); },
      [](FloatNetwork& n) { n.layers.back().out.buffer = 1; },
      [](FloatNetwork& n) { n.layers.clear(); },
      [](FloatNetwork& n) { n.candidate_count = 99; },
      [](FloatNetwork& n) { n.layers[2].kind = LayerKind::kPairToVertex; },
  };
  for (const auto& damage : damages) {
    FloatNetwork bad = good;
    damage(bad);
    EXPECT_THROW(check_network(bad, "x"), Error);
  }
  const Sample other = random_sample({});
  EXPECT_THROW(forward(good, other), Error) << "a sample with other features was accepted";
}

}  // namespace
}  // namespace sinew
