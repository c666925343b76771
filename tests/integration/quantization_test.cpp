// SPDX-License-Identifier: MIT
// Accuracy against quantization on the sample characters: the bundled float weights, the model made from them, and the
// same network at fewer bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "features/features.hpp"
#include "network/networks.hpp"
#include "open_bundled_model.hpp"
#include "shared_data.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_character/models/models.hpp"
#include "sinew_data_sets/synthesize.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_quant/model_writer.hpp"
#include "sinew_quant/quantize.hpp"
#include "sinew_trainer/engine_network.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/network.hpp"
#include "sinew_trainer/rig_difference.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

const std::string kData = SINEW_SOURCE_DIR "/samples/data";

// One synthetic character of each plan, of a seed that no sample has.
std::vector<Sample> calibration_characters(const FloatNetwork& network) {
  std::vector<Sample> samples;
  for (const BodyPlan plan : kBodyPlans) {
    SynthesizeOptions options;
    options.plan = plan;
    options.seed = 501;
    options.resolution = 28;
    samples.push_back(
        make_sample(synthesize(options), network.candidate_count, network.grid_size, network.feature_set));
  }
  return samples;
}

struct Scene {
  std::vector<Character> characters;
  std::vector<Sample> samples;
  std::vector<Sample> others;  // that ranges are calibrated on and nothing is measured on
  FloatNetwork network;
  std::vector<std::vector<float>> logits;  // of the float network

  Scene() : network(read_checkpoint(kData + "/sinew_default.ckpt").network) {
    for (const std::string& path : list_characters(kData)) {
      if (path.ends_with(".gltf")) continue;  // the same character as one of the OBJ files
      characters.push_back(read_character(path));
      samples.push_back(
          make_sample(characters.back(), network.candidate_count, network.grid_size, network.feature_set));
      logits.push_back(forward(network, samples.back()));
    }
    others = calibration_characters(network);
  }
};

const Scene& scene() {
  static const Scene s;
  return s;
}

struct Row {
  double l1 = 0, decibels = 0, mean_change = 0, largest_change = 0;
};

// Mean L1 over the characters, and how far probabilities are from the float network's.
Row compare(const std::vector<std::vector<float>>& logits) {
  Row row;
  LogitNoise noise;
  double pairs = 0;
  for (size_t c = 0; c < scene().samples.size(); ++c) {
    const Sample& sample = scene().samples[c];
    noise.add(sample, scene().logits[c], logits[c]);
    const std::vector<float> exact = softmax(sample, scene().logits[c]), p = softmax(sample, logits[c]);
    for (size_t i = 0; i < p.size(); ++i) {
      if (sample.candidate[i] == 0xFFFF) continue;
      const double change = std::fabs(static_cast<double>(p[i]) - static_cast<double>(exact[i]));
      row.mean_change += change;
      row.largest_change = std::max(row.largest_change, change);
      pairs += 1;
    }
    row.l1 += measure(scene().characters[c], sample_influences(sample, p, 4), sample.name).l1 /
              static_cast<double>(scene().samples.size());
  }
  row.mean_change /= pairs;
  row.decibels = noise.decibels();
  return row;
}

std::vector<std::vector<float>> logits_of(const sinew_model& model) {
  std::vector<std::vector<float>> all;
  for (const Sample& sample : scene().samples) all.push_back(engine_logits(model, sample));
  return all;
}

TEST(Quantization, TableOfBits) {
  const Calibration calibration = calibrate(scene().network, scene().others);
  std::map<int, Row> rows;
  rows[32] = compare(scene().logits);
  std::printf("| bits | L1 | logit SNR dB | mean dp | max dp |\n|---|---|---|---|---|\n");
  std::printf("| float | %.4f | - | - | - |\n", rows[32].l1);
  for (int bits : {16, 12, 10, 8}) {
    QuantizeOptions options;
    options.weight_bits = bits;
    options.activation_bits = std::min(bits, 14);
    const QuantizedModel quantized = quantize(scene().network, calibration, options);
    std::vector<uint64_t> aligned(quantized.bytes.size() / 8 + 1);
    std::copy(quantized.bytes.begin(), quantized.bytes.end(), reinterpret_cast<uint8_t*>(aligned.data()));
    sinew_model model;
    ASSERT_EQ(sinew_model_open(aligned.data(), quantized.bytes.size(), &model), SINEW_OK);
    rows[bits] = compare(logits_of(model));
    std::printf("| %d | %.4f | %.1f | %.2e | %.2e |\n", bits, rows[bits].l1, rows[bits].decibels,
                rows[bits].mean_change, rows[bits].largest_change);
  }
  EXPECT_NEAR(rows[16].l1, rows[32].l1, 0.003);
  EXPECT_GE(rows[16].decibels, 55.0);
  EXPECT_LE(rows[16].mean_change, 3e-4);
  EXPECT_LE(rows[16].largest_change, 5e-3);
  // Fewer bits must show: a table whose rows are all alike measures nothing.
  EXPECT_GT(rows[16].decibels, rows[12].decibels);
  EXPECT_GT(rows[12].decibels, rows[10].decibels);
  EXPECT_GT(rows[10].decibels, rows[8].decibels);
}

// The committed model against the committed weights, through the whole C API.
TEST(Quantization, BundledModelIsWithinThreeThousandthsOfItsWeights) {
  const sinew_model* model = bundled_model();
  ASSERT_NE(model, nullptr);
  ASSERT_FALSE(scene().samples.empty());
  double exact = 0, bundled = 0;
  for (size_t c = 0; c < scene().samples.size(); ++c) {
    const Character& character = scene().characters[c];
    const Sample& sample = scene().samples[c];
    BindOptions options;
    options.method = SINEW_METHOD_MODEL;
    options.model = model;
    const double a =
        measure(character, sample_influences(sample, softmax(sample, scene().logits[c]), 4), sample.name).l1;
    const double b = measure(character, bind(character, options).influences, sample.name).l1;
    EXPECT_NEAR(a, b, 0.003) << character.name;
    exact += a;
    bundled += b;
  }
  EXPECT_NEAR(exact, bundled, 0.003 * static_cast<double>(scene().samples.size()));
}

// What a shipped model computes, as float, quantized again with ranges of other characters: signal to noise on trained
// weights, of the network as published for weights.
TEST(Quantization, SignalToNoiseOfTrainedClassicWeights) {
  constexpr uint32_t kPublished = kSpectralFlag | kAttributesFlag;
  FloatNetwork network = make_classic(8, 64, 1, kPublished, 2);
  read_model_weights(kData + "/sinew_classic.sinew", &network);
  const Calibration calibration = calibrate(network, calibration_characters(network));
  double last = 1000;
  std::printf("| classic, bits | logit SNR dB |\n|---|---|\n");
  for (const int bits : {16, 12, 8}) {
    QuantizeOptions options;
    options.weight_bits = bits;
    options.activation_bits = std::min(bits, 14);
    const auto model = model_from_bytes(quantize(network, calibration, options).bytes, "classic");
    LogitNoise noise;
    for (const char* name : {"snake__long", "bird__winged"}) {
      const Sample sample = make_sample(read_character(kData + "/" + name + ".obj"), 8, 64, kPublished);
      noise.add(sample, forward(network, sample), engine_logits(model->model, sample));
    }
    std::printf("| %d | %.1f |\n", bits, noise.decibels());
    if (bits == 16) {
      EXPECT_GE(noise.decibels(), 50);
    }
    EXPECT_LT(noise.decibels(), last) << "fewer bits must show";
    last = noise.decibels();
  }
}

QuantizeOptions of_bits(int bits) {
  QuantizeOptions options;
  options.weight_bits = bits;
  options.activation_bits = std::min(bits, 14);
  return options;
}

// One synthetic character of each plan, as files.
struct CalibrationFolder : TempFolder {
  CalibrationFolder() {
    for (const BodyPlan plan : kBodyPlans) {
      SynthesizeOptions options;
      options.plan = plan;
      options.seed = 501;
      options.resolution = 28;
      const Character character = synthesize(options);
      write_obj(file(character.name + ".obj"), character);
      write_rig(file(character.name + ".rig.txt"), character);
    }
  }
  std::string path() const { return file(""); }
};

// The shipped networks of skeletons, likewise: how far votes and joints move beside float, shares of the longest side.
TEST(Quantization, SkeletonsAtFewerBits) {
  const CalibrationFolder folder;
  FloatNetwork votes = make_rig_network({64, 4, false}, 1);
  read_model_weights(kData + "/sinew_rig.sinew", &votes);
  const FloatNetwork slots = read_checkpoint(kData + "/sinew_slots.ckpt").network;
  const Calibration ranges = calibrate_rig(votes, folder.path(), 0);
  const SlotNetworks parts = calibrate_slots(slots, folder.path(), 0);
  double last_votes = 0, last_slots = 0;
  std::printf("| bits | votes | same class | slots | same slots |\n|---|---|---|---|---|\n");
  for (const int bits : {16, 12, 8}) {
    const auto rig = model_from_bytes(quantize(votes, ranges, of_bits(bits)).bytes, "votes", ModelUse::kRig);
    const auto joints =
        model_from_bytes(with_second_network(quantize(parts.joints, parts.joint_ranges, of_bits(bits)).bytes,
                                             quantize(parts.connections, parts.connection_ranges, of_bits(bits)).bytes),
                         "slots", ModelUse::kSlotJoints);
    const VoteDifference v = compare_votes(votes, rig->model, kData, 0);
    const SlotDifference s = compare_slots(slots, joints->model, kData, 0);
    std::printf("| %d | %.5f | %.4f | %.5f | %.4f |\n", bits, v.mean, v.same_class, s.mean, s.same_presence);
    if (bits == 16) {
      EXPECT_LT(v.mean, 1e-3);
      EXPECT_GT(v.same_class, 0.995);
      EXPECT_LT(s.mean, 1e-3);
      EXPECT_GT(s.same_presence, 0.99);
    }
    EXPECT_GT(v.mean, last_votes) << "fewer bits must show";
    EXPECT_GT(s.mean, last_slots) << "fewer bits must show";
    last_votes = v.mean;
    last_slots = s.mean;
  }
}

// Hands: no sample of the repository has fingers.
TEST(QuantizationShared, HandsAtFewerBits) {
  if (shared_folder().empty())
    GTEST_SKIP() << "NOT CHECKED: there is no shared data; set SINEW_SHARED_DIR to quantize hands at fewer bits";
  const std::string characters = (shared_folder() / "data" / "characters" / "val").string();
  FloatNetwork network = make_rig_network({48, 3, true}, 1);
  read_model_weights(kData + "/sinew_hands.sinew", &network);
  const Calibration ranges = calibrate_rig(network, characters, 20);
  double last = 0;
  std::printf("| bits | hands | same class |\n|---|---|---|\n");
  for (const int bits : {16, 12, 8}) {
    const auto model = model_from_bytes(quantize(network, ranges, of_bits(bits)).bytes, "hands", ModelUse::kHands);
    const VoteDifference v = compare_votes(network, model->model, characters, 20);
    std::printf("| %d | %.5f | %.4f |\n", bits, v.mean, v.same_class);
    EXPECT_LT(v.mean, bits == 16 ? 1e-3 : 1.0);
    EXPECT_GT(v.same_class, bits == 16 ? 0.995 : 0.9);
    EXPECT_GT(v.mean, last) << "fewer bits must show";
    last = v.mean;
  }
}

}  // namespace
}  // namespace sinew
