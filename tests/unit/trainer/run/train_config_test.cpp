// SPDX-License-Identifier: MIT
// Configuration files: what is written is read, what is shipped is valid, errors name the key.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/train.hpp"

namespace sinew {
namespace {

TEST(TrainConfig, WhatIsWrittenIsRead) {
  TrainConfig config;
  config.field.width = 24;
  config.field.rounds = 0;
  config.learning_rate = 0.0123;
  config.seed = 1234567890123ull;
  config.feature_dropout = 0.25;
  config.without = {"pair.soft*", "vertex.normal_up"};
  config.leave_out = {{"f__1", "one foot is bound to the shin"}, {"g__*", "joints at one place"}};
  const std::string json = train_config_json(config);
  EXPECT_EQ(train_config_json(parse_train_config(json, "test")), json);
  EXPECT_EQ(parse_train_config(json, "test").seed, 1234567890123ull);
  EXPECT_EQ(parse_train_config(json, "test").leave_out, config.leave_out);
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
      {R"({"leave_out": ["f__1"]})", "leave_out"},
      {R"({"leave_out": {"f__1": 3}})", "leave_out: f__1"},
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
