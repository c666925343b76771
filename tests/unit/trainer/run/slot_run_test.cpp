// SPDX-License-Identifier: MIT
// Runs of the published method: it learns, and a run that was stopped and resumed is the run that was not.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "sinew_formats/checkpoint.hpp"
#include "sinew_trainer/rig_train.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

namespace fs = std::filesystem;

struct SlotScene {
  TempFolder folder;
  RigTrainConfig config;
  TrainOptions options;

  SlotScene() {
    const std::string data = std::string(SINEW_SOURCE_DIR) + "/samples/data/";
    fs::create_directories(folder.file("set"));
    for (const char* name : {"biped__robot", "snake__long"})
      for (const char* end : {".obj", ".rig.txt"}) fs::copy(data + name + end, folder.file("set"));
    config.architecture = "slots";
    config.width = 8;
    config.variants = 1;
    config.synthetic = 0;
    config.batch = 3;
    config.steps = 40;
    config.validate_every = 10;
    config.average_decay = 0.9;
    options.data_dir = folder.file("set");
    options.threads = 1;
    options.quiet = true;
  }
  Checkpoint train(const std::string& name) {
    options.output = folder.file(name);
    train_rig(config, options);
    return read_checkpoint(options.output);
  }
};

std::vector<double> totals(const std::string& log) {
  std::vector<double> column;
  for (size_t at = log.find('\n'); at + 1 < log.size(); at = log.find('\n', at + 1)) {
    const size_t first = log.find(',', at), second = log.find(',', first + 1);
    column.push_back(std::stod(log.substr(second + 1)));
  }
  return column;
}

TEST(SlotRun, LearnsAndGoesOnAsIfItHadNotStopped) {
  SlotScene scene;
  const Checkpoint whole = scene.train("whole.ckpt");
  const std::vector<double> total = totals(whole.state.log_csv);
  ASSERT_EQ(total.size(), 4u);
  EXPECT_LT(total.back(), 0.8 * total.front());

  scene.options.stop_after = 17;
  scene.train("parts.ckpt");
  scene.options.stop_after = 0;
  scene.options.resume = true;
  const Checkpoint parts = scene.train("parts.ckpt");
  ASSERT_EQ(parts.network.parameters.size(), whole.network.parameters.size());
  for (size_t i = 0; i < parts.network.parameters.size(); ++i) {
    EXPECT_EQ(parts.network.parameters[i].weights, whole.network.parameters[i].weights) << "block " << i;
    EXPECT_EQ(parts.latest.parameters[i].weights, whole.latest.parameters[i].weights) << "block " << i;
  }
}

TEST(SlotRun, ThreadsChangeNoNumber) {
  SlotScene scene;
  const Checkpoint one = scene.train("one.ckpt");
  scene.options.threads = 3;
  const Checkpoint three = scene.train("three.ckpt");
  for (size_t i = 0; i < one.network.parameters.size(); ++i)
    EXPECT_EQ(one.network.parameters[i].weights, three.network.parameters[i].weights) << "block " << i;
}

}  // namespace
}  // namespace sinew
