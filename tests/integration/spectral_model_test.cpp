// SPDX-License-Identifier: MIT
// A network that asks for spectral channels, from sample to bind: features, float network, quantized model, C API.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "features/features.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_quant/quantize.hpp"
#include "sinew_trainer/engine_network.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/network.hpp"
#include "sinew_trainer/train.hpp"
#include "spectral/spectral.hpp"

namespace sinew {
namespace {

const Character& character() {
  static const Character c = read_character(SINEW_SOURCE_DIR "/samples/data/snake__long.obj");
  return c;
}

TEST(SpectralModel, SampleHasTheChannelsBehindTheOthers) {
  const Sample plain = make_sample(character(), 8, 64), more = make_sample(character(), 8, 64, kSpectralFlag);
  ASSERT_EQ(plain.inputs[0].channels, kVertexFeatures);
  ASSERT_EQ(more.inputs[0].channels, kVertexFeatures + kSpectralChannels);
  EXPECT_EQ(plain.inputs[1].rows, more.inputs[1].rows);
  int64_t sum = 0;
  for (size_t v = 0; v < plain.vertices; ++v) {
    for (size_t i = 0; i < plain.inputs[0].channels; ++i) {
      ASSERT_EQ(plain.inputs[0].rows[v * plain.inputs[0].channels + i],
                more.inputs[0].rows[v * more.inputs[0].channels + i]);
    }
    for (size_t i = plain.inputs[0].channels; i < more.inputs[0].channels; ++i) {
      sum += std::abs(more.inputs[0].rows[v * more.inputs[0].channels + i]);
    }
  }
  EXPECT_GT(sum / (int64_t{plain.vertices} * kSpectralChannels), 100);
}

TEST(SpectralModel, QuantizedAndBound) {
  const std::vector<Sample> samples = {make_sample(character(), 8, 64, kSpectralFlag)};
  FloatNetwork network = make_classic(8, 64, 3, kSpectralFlag);
  EXPECT_EQ(network.feature_set, kFeatureSet | kSpectralFlag);
  const QuantizedModel quantized = quantize(network, calibrate(network, samples));
  std::vector<uint64_t> aligned(quantized.bytes.size() / 8 + 1);
  std::memcpy(aligned.data(), quantized.bytes.data(), quantized.bytes.size());
  sinew_model model;
  ASSERT_EQ(sinew_model_open(aligned.data(), quantized.bytes.size(), &model), SINEW_OK);
  EXPECT_EQ(model.feature_set, kFeatureSet | kSpectralFlag);
  LogitNoise noise;
  noise.add(samples[0], forward(network, samples[0]), engine_logits(model, samples[0]));
  EXPECT_GT(noise.decibels(), 40);

  // The whole bind makes the same features itself: its strongest joint is the float network's almost everywhere.
  BindOptions options;
  options.method = SINEW_METHOD_MODEL;
  options.model = &model;
  const BindResult bound = bind(character(), options);
  EXPECT_LE(bound.used_bytes, bound.workspace_bytes);
  const auto expected = sample_influences(samples[0], predict(network, samples[0]), 4);
  size_t same = 0;
  for (size_t v = 0; v < expected.size(); ++v) {
    if (!bound.influences[v].empty() && bound.influences[v][0].joint == expected[v][0].joint) ++same;
  }
  EXPECT_GE(same, expected.size() * 98 / 100);
}

TEST(SpectralModel, ShippedClassicModelBindsASample) {
  const std::vector<uint8_t> file = read_file(SINEW_SOURCE_DIR "/samples/data/sinew_classic.sinew");
  std::vector<uint64_t> aligned(file.size() / 8 + 1);
  std::memcpy(aligned.data(), file.data(), file.size());
  sinew_model model;
  ASSERT_EQ(sinew_model_open(aligned.data(), file.size(), &model), SINEW_OK);
  EXPECT_EQ(model.feature_set, kFeatureSet | kSpectralFlag | kAttributesFlag);
  EXPECT_NE(model.fixed_candidates, 0u);
  BindOptions options;
  options.method = SINEW_METHOD_MODEL;
  options.model = &model;
  const Metrics metrics = measure(character(), bind(character(), options).influences, "snake");
  EXPECT_GT(metrics.argmax, 0.6) << "an untrained one finds an eighth";
}

TEST(SpectralModel, ConfigurationTurnsItOn) {
  TrainConfig config = parse_train_config(R"({"spectral": true})", "test");
  EXPECT_EQ(feature_flags(config), kSpectralFlag);
  EXPECT_EQ(feature_flags(TrainConfig{}), 0u);
  EXPECT_EQ(feature_flags(parse_train_config(train_config_json(config), "test")), kSpectralFlag);
  EXPECT_THROW(parse_train_config(R"({"spectral": 1})", "test"), std::exception);
}

}  // namespace
}  // namespace sinew
