// SPDX-License-Identifier: MIT
// Optimisers on a parabola, clipping, schedule, running average, the drawing of families, configuration files.
#include "run/optimizer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "data/family_queue.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

FloatNetwork one_weight(float weight, float bias) {
  FloatNetwork network;
  network.parameters.push_back({1, 1, {weight}, {bias}});
  return network;
}

TEST(Optimizer, EveryKindFindsTheBottomOfAParabola) {
  for (const char* kind : {"sgd", "adam", "adamw"}) {
    TrainConfig config;
    config.optimizer = kind;
    config.weight_decay = 0;
    FloatNetwork network = one_weight(3, -2);
    TrainingState state;
    for (int i = 0; i < 2000; ++i) {
      const std::vector<LinearBlock<float>> gradient = {
          {{2 * (network.parameters[0].weights[0] - 1)}, {2 * (network.parameters[0].bias[0] - 0.5f)}}};
      optimizer_step(config, 0.01, gradient, &network, &state);
      ++state.step;
    }
    EXPECT_NEAR(network.parameters[0].weights[0], 1, 1e-3) << kind;
    EXPECT_NEAR(network.parameters[0].bias[0], 0.5, 1e-3) << kind;
  }
}

TEST(Optimizer, DecoupledDecayShrinksWeightsByRateTimesDecayAndLeavesBiases) {
  TrainConfig config;
  config.optimizer = "adamw";
  config.weight_decay = 0.5;
  FloatNetwork network = one_weight(2, 2);
  TrainingState state;
  optimizer_step(config, 0.1, {{{0.0f}, {0.0f}}}, &network, &state);
  EXPECT_FLOAT_EQ(network.parameters[0].weights[0], 2 * (1 - 0.05f));
  EXPECT_FLOAT_EQ(network.parameters[0].bias[0], 2);
}

TEST(Optimizer, FirstAdamStepHasTheLengthOfTheRate) {
  TrainConfig config;
  config.weight_decay = 0;
  FloatNetwork network = one_weight(0, 0);
  TrainingState state;
  optimizer_step(config, 0.01, {{{1e-3f}, {-50.0f}}}, &network, &state);
  EXPECT_NEAR(network.parameters[0].weights[0], -0.01, 1e-6);
  EXPECT_NEAR(network.parameters[0].bias[0], 0.01, 1e-6);
}

TEST(Optimizer, ClippingKeepsDirectionAndSmallGradients) {
  std::vector<LinearBlock<float>> gradient = {{{3.0f}, {4.0f}}};
  EXPECT_NEAR(clip_gradients(&gradient, 1.0), 5.0, 1e-6);
  EXPECT_NEAR(gradient[0].weights[0], 0.6, 1e-6);
  EXPECT_NEAR(gradient[0].bias[0], 0.8, 1e-6);
  clip_gradients(&gradient, 2.0);
  EXPECT_NEAR(gradient[0].bias[0], 0.8, 1e-6);
}

TEST(Optimizer, ScheduleWarmsUpThenFallsToAHundredth) {
  EXPECT_LT(schedule(0), 0.2);
  EXPECT_GT(schedule(0), 0);
  EXPECT_NEAR(schedule(0.02), 1, 1e-9);
  EXPECT_NEAR(schedule(0.51), 0.505, 0.01);
  EXPECT_NEAR(schedule(1), 0.01, 1e-9);
  EXPECT_NEAR(schedule(7), 0.01, 1e-9);
}

TEST(Optimizer, AverageForgetsTheStart) {
  FloatNetwork average = one_weight(100, 100);
  const FloatNetwork network = one_weight(1, 2);
  for (uint64_t step = 1; step <= 200; ++step) update_average(network, 0.99, step, &average);
  EXPECT_NEAR(average.parameters[0].weights[0], 1, 0.01);
  EXPECT_NEAR(average.parameters[0].bias[0], 2, 0.01);
}

TEST(FamilyQueue, FamiliesAreDrawnByThePowerOfTheirSizeAndMembersEqually) {
  std::vector<std::string> families(100, "many");
  families.insert(families.end(), 4, "few");
  Random random(1);
  std::map<uint32_t, int> count;
  size_t draws = 0;
  for (int round = 0; round < 400; ++round) {
    for (uint32_t character : draw_round(families, 0.5, &random)) {
      ++count[character];
      ++draws;
    }
  }
  int few = 0;
  for (uint32_t i = 100; i < 104; ++i) few += count[i];
  EXPECT_NEAR(static_cast<double>(few) / static_cast<double>(draws), 2.0 / 12.0,
              0.005);  // sqrt(4) / (sqrt(100) + sqrt(4))
  for (uint32_t i = 100; i < 104; ++i) EXPECT_NEAR(count[i], few / 4.0, 0.1 * few / 4.0);
  for (uint32_t i = 0; i < 100; ++i) EXPECT_GT(count[i], 200);
}

TEST(TrainConfig, WhatIsWrittenIsRead) {
  TrainConfig config;
  config.field.width = 24;
  config.field.rounds = 0;
  config.learning_rate = 0.0123;
  config.seed = 1234567890123ull;
  config.feature_dropout = 0.25;
  config.without = {"pair.soft*", "vertex.normal_up"};
  const std::string json = train_config_json(config);
  EXPECT_EQ(train_config_json(parse_train_config(json, "test")), json);
  EXPECT_EQ(parse_train_config(json, "test").seed, 1234567890123ull);
  EXPECT_EQ(train_config_json(parse_train_config("{}", "test")), train_config_json(TrainConfig()));
}

TEST(TrainConfig, ShippedFilesAreValid) {
  for (const char* name : {"field", "classic"}) {
    const std::string path = std::string(SINEW_SOURCE_DIR) + "/trainer/configs/" + name + ".json";
    FILE* file = std::fopen(path.c_str(), "rb");
    ASSERT_NE(file, nullptr) << path;
    std::string text(1 << 16, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), file));
    std::fclose(file);
    EXPECT_EQ(parse_train_config(text, path).architecture, name);
  }
}

TEST(TrainConfig, AblationFilesAreValid) {
  size_t files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SINEW_SOURCE_DIR) + "/trainer/configs/ablation")) {
    const std::vector<uint8_t> bytes = read_file(entry.path().string());
    EXPECT_GT(parse_train_config(std::string(bytes.begin(), bytes.end()), entry.path().string()).steps, 0u);
    ++files;
  }
  EXPECT_GT(files, 20u);
}

TEST(TrainConfig, ErrorsNameFileAndKey) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"stepz": 3})", "stepz"},
      {R"({"field": {"widht": 3}})", "field.widht"},
      {R"({"field": 3})", "field"},
      {R"({"steps": "many"})", "steps"},
      {R"({"steps": -1})", "steps"},
      {R"({"batch": 1.5})", "batch"},
      {R"({"batch": 99999999999})", "batch"},
      {R"({"optimizer": 1})", "optimizer"},
      {R"({"optimizer": "rmsprop"})", "optimizer"},
      {R"({"architecture": "fields"})", "architecture"},
      {R"({"learning_rate": 0})", "learning_rate"},
      {R"({"dropout": 1})", "dropout"},
      {R"({"field": {"candidates": 17}})", "field.candidates"},
      {R"({"without": "pair.soft"})", "without"},
      {R"({"without": [3]})", "without"},
      {R"({"without": ["pair.sofd"]})", "pair.sofd"},
      {R"({"without": ["pair.rule_*"]})", "pair.rule_log"},
      {R"({"architecture": "classic", "without": ["pair.soft"]})", "without"},
      {R"([1])", "object"},
      {R"({"steps": )", "not JSON"},
  };
  for (const auto& [json, word] : cases) {
    try {
      parse_train_config(json, "run.json");
      ADD_FAILURE() << json << " was accepted";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("run.json"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace sinew
