// SPDX-License-Identifier: MIT
// quantize(): fewer bits cost what they should, proofs hold in both classes, odd networks work or are refused in one
// line.
#include "sinew_quant/quantize.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "model/reader.hpp"
#include "network_fixture.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace sinew::test {
namespace {

double snr_db(const std::vector<uint8_t>& bytes, const Graph& g, const std::vector<double>& exact) {
  const std::vector<int16_t> logits = run_integer(parse_model(bytes), g);
  double signal = 0, noise = 0, mean = 0, n = 0;
  for (size_t i = 0; i < exact.size(); ++i) {
    if (!g.present(i)) continue;
    mean += exact[i];
    ++n;
  }
  mean /= n;
  for (size_t i = 0; i < exact.size(); ++i) {
    if (!g.present(i)) continue;
    const double logit = logits[i] / (1024 * 1.4426950408889634);
    signal += (exact[i] - mean) * (exact[i] - mean);
    noise += (exact[i] - logit) * (exact[i] - logit);
  }
  return 10 * std::log10(signal / noise);
}

TEST(Quantize, FewerBitsCostMore) {
  const FloatNetwork network = field_like(9, 6, 24, 2);
  const Graph g = random_graph(10, 80, 6, 20, 3, usual_feature);
  const FloatRun exact = run_float(network, g);
  const auto snr = [&](int weight_bits, int activation_bits) {
    QuantizeOptions options;
    options.weight_bits = weight_bits;
    options.activation_bits = activation_bits;
    return snr_db(quantize(network, {exact.layer_max}, options).bytes, g, exact.logits);
  };
  const double full = snr(16, 14), w12 = snr(12, 14), w10 = snr(10, 14), w8 = snr(8, 14), a10 = snr(16, 10),
               a8 = snr(16, 8);
  std::printf("logit SNR dB: full %.1f, weights 12/10/8 bit %.1f %.1f %.1f, activations 10/8 bit %.1f %.1f\n", full,
              w12, w10, w8, a10, a8);
  EXPECT_GE(full, 55);
  EXPECT_GT(w12, w10 + 6);  // two bits are 12 dB
  EXPECT_GT(w10, w8 + 6);
  EXPECT_GT(full, w8 + 20);
  EXPECT_GT(full, a10 + 10);
  EXPECT_GT(a10, a8 + 6);
}

// One wide linear layer over `in` channels, made of relu units.
FloatNetwork wide_layer(uint32_t in) {
  NetworkBuilder b(1, 4);
  const uint16_t units = b.add(Domain::kPair, in), logits = b.add(Domain::kPair, 1);
  b.linear(b.whole(kPairInput), b.whole(units), true);
  b.linear(b.whole(units), b.whole(logits), false);
  FloatNetwork network = b.take();
  const float size = 2 / std::sqrt(static_cast<float>(in));
  for (uint32_t i = 0; i < in; ++i) network.parameters[1].weights[i] = i % 2 == 0 ? size : -size;
  return network;
}

TEST(Quantize, WideClassWhereInt32WouldCostBits) {
  const Graph g = random_graph(11, 40, 4, 9, 2, usual_feature);
  for (const uint32_t in : {8u, 1500u}) {
    const FloatNetwork network = wide_layer(in);
    const FloatRun exact = run_float(network, g);
    const QuantizedModel model = quantize(network, {exact.layer_max});
    ASSERT_EQ(model.layers.size(), 2u);
    EXPECT_EQ(model.layers[1].what, "linear " + std::to_string(in) + " -> 1");
    EXPECT_EQ(model.layers[1].wide, in == 1500);
    EXPECT_FALSE(model.layers[0].wide);
    const IntegerModel integers = parse_model(model.bytes);
    const IntegerLinear& last = integers.linears[1];
    if (last.accumulator == AccumulatorClass::kWide) {
      EXPECT_GE(last.block, 2u);
      EXPECT_GE(model.layers[1].bound, int64_t{1} << 31);
    } else {
      EXPECT_LT(model.layers[1].bound, int64_t{1} << 31);
      EXPECT_GE(model.layers[1].bound, int64_t{1} << 24) << "the finest weights that the proof allows";
    }
    EXPECT_GE(snr_db(model.bytes, g, exact.logits), 55);
  }
}

TEST(Quantize, ResidualOfAnotherScale) {
  NetworkBuilder b(5, 4);
  const uint16_t state = b.add(Domain::kPair, 8), next = b.add(Domain::kPair, 8), logits = b.add(Domain::kPair, 1);
  const Region residual = b.whole(state);
  b.linear(b.whole(kPairInput), b.whole(state), true);
  b.linear(b.whole(kPairInput), b.whole(next), false, &residual);
  b.linear(b.whole(next), b.whole(logits), false);
  FloatNetwork network = b.take();
  for (float& w : network.parameters[0].weights) w *= 20;  // the residual is far larger than what is added to it
  for (float& w : network.parameters[2].weights) w /= 20;  // logits stay inside +-22
  const Graph g = random_graph(12, 60, 4, 9, 2, usual_feature);
  const FloatRun exact = run_float(network, g);
  EXPECT_GE(snr_db(quantize(network, {exact.layer_max}).bytes, g, exact.logits), 55);
}

TEST(Quantize, UnitsThatNeverFire) {
  FloatNetwork network = field_like(9, 4, 8, 1);
  LinearParameters& first = network.parameters[0];
  first.weights.assign(first.weights.size(), 0.0f);
  first.bias.assign(first.bias.size(), -1.0f);
  const Graph g = random_graph(13, 30, 4, 9, 2, usual_feature);
  const FloatRun exact = run_float(network, g);
  ASSERT_EQ(exact.layer_max[0], 0.0f);
  EXPECT_GE(snr_db(quantize(network, {exact.layer_max}).bytes, g, exact.logits), 55);
}

void expect_error(const FloatNetwork& network, const Calibration& calibration, const std::string& part,
                  const QuantizeOptions& options = {}) {
  try {
    quantize(network, calibration, options);
    FAIL() << "not refused: " << part;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

TEST(Quantize, RefusesInOneLine) {
  const FloatNetwork good = field_like(9, 4, 8, 1);
  const Calibration calibration{std::vector<float>(good.layers.size(), 1.0f)};
  quantize(good, calibration);

  FloatNetwork bad = good;
  bad.parameters[1].weights[3] = std::numeric_limits<float>::quiet_NaN();
  expect_error(bad, calibration, "not finite");
  bad = good;
  bad.parameters[1].weights.pop_back();
  expect_error(bad, calibration, "weight block 1");
  bad = good;
  bad.parameters[1].weights[0] = 1e9f;
  expect_error(bad, calibration, "too large");
  bad = good;
  bad.feature_set = kFeatureSet + 1;
  expect_error(bad, calibration, "refuses");
  bad = good;
  bad.layers.back().flags = kLayerRelu;
  expect_error(bad, calibration, "ReLU");
  bad = good;
  bad.layers[0].in.offset = 60000;
  expect_error(bad, calibration, "outside its buffers");
  bad = good;
  std::swap(bad.layers[1], bad.layers[3]);
  expect_error(bad, calibration, "no earlier layer writes");
  bad = good;
  bad.layers.pop_back();
  expect_error(bad, {std::vector<float>(bad.layers.size(), 1.0f)}, "last layer");
  expect_error(good, {{1.0f}}, "calibration");
  expect_error(FloatNetwork(), {}, "0 buffers");
  QuantizeOptions options;
  options.weight_bits = 2;
  expect_error(good, calibration, "weight_bits", options);
  options = {};
  options.margin = 0.5;
  expect_error(good, calibration, "margin", options);
}

// Weights of a network that starts anew from a model, with shapes of the first and other numbers.
FloatNetwork read_back(const std::string& path, FloatNetwork shape) {
  for (LinearParameters& p : shape.parameters) {
    std::fill(p.weights.begin(), p.weights.end(), 7.0f);
    std::fill(p.bias.begin(), p.bias.end(), 7.0f);
  }
  read_model_weights(path, &shape);
  return shape;
}

TEST(ModelWeights, ComputeWhatTheModelDoes) {
  const TempFolder folder;
  const std::string path = folder.file("m.sinew");
  const FloatNetwork network = field_like(9, 6, 24, 2);
  const Graph g = random_graph(10, 80, 6, 20, 3, usual_feature);
  const FloatRun exact = run_float(network, g);
  const QuantizedModel model = quantize(network, {exact.layer_max});
  write_file(path, model.bytes);
  const FloatNetwork back = read_back(path, network);
  EXPECT_GE(snr_db(model.bytes, g, run_float(back, g).logits), 55);
  // Weights have the size of fresh ones where that is free: the square root of 2 over the inputs.
  const LinearParameters& first = back.parameters[0];
  double squares = 0;
  for (const float w : first.weights) squares += w * w;
  EXPECT_NEAR(squares / static_cast<double>(first.weights.size()) * first.in, 2, 1e-3);
}

TEST(ModelWeights, RefusesOthersInOneLine) {
  const TempFolder folder;
  const std::string path = folder.file("m.sinew");
  FloatNetwork network = field_like(9, 6, 24, 2);
  const Calibration calibration{std::vector<float>(network.layers.size(), 1.0f)};
  std::vector<uint8_t> bytes = quantize(network, calibration).bytes;
  const auto expect_refused = [&](FloatNetwork shape, const std::string& part) {
    write_file(path, bytes);
    try {
      read_model_weights(path, &shape);
      FAIL() << "not refused: " << part;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  };
  expect_refused(field_like(9, 6, 16, 2), "other shapes");
  expect_refused(field_like(9, 6, 24, 1), "other shapes");
  network.task = kTaskRig;
  expect_refused(network, "another task");
  bytes[bytes.size() / 2] ^= 1;
  expect_refused(field_like(9, 6, 24, 2), "checksum");
  bytes.resize(20);
  expect_refused(field_like(9, 6, 24, 2), path);
}

}  // namespace
}  // namespace sinew::test
