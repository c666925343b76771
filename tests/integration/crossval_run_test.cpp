// SPDX-License-Identifier: MIT
// Whole cross-validations on synthesized characters: nothing of a left-out family is seen, runs go on after a stop,
// threads change nothing.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>

#include "expect_error.hpp"
#include "sinew_data_sets/dataset.hpp"
#include "sinew_data_sets/synthesize.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/crossval.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

namespace fs = std::filesystem;

class CrossvalRun : public ::testing::Test {
 protected:
  CrossvalRun() {
    fs::create_directories(folder_.file("data"));
    fs::create_directories(folder_.file("val"));
    add("data", BodyPlan::kBiped, 1, "two");
    add("data", BodyPlan::kBiped, 2, "two19");
    add("data", BodyPlan::kBird, 3, "wings");
    add("data", BodyPlan::kSnake, 4, "long");
    add("val", BodyPlan::kQuadruped, 5, "four");
    config_.field = {8, 4, 1, 8, 32};
    config_.steps = 6;
    config_.validate_every = 2;
    config_.learning_rate = 0.02;
    config_.variants = 0;
    config_.synthetic = 0;
  }
  void add(const std::string& where, BodyPlan plan, uint64_t seed, const std::string& family) {
    Character character = decimate(synthesize({plan, seed, 24, true}), 0.3);
    character.name = family + "__" + std::to_string(seed);
    write_obj(folder_.file(where + "/" + character.name + ".obj"), character);
    write_rig(folder_.file(where + "/" + character.name + ".rig.txt"), character);
  }
  CrossvalOptions options(const std::string& name) const {
    CrossvalOptions o;
    o.data_dir = folder_.file("data");
    o.val_dir = folder_.file("val");
    o.folder = folder_.file(name);
    o.cache_dir = folder_.file("cache");
    o.label = "test";
    o.fold_count = 3;
    o.quiet = true;
    return o;
  }
  const TempFolder folder_;
  TrainConfig config_;
};

TEST_F(CrossvalRun, EveryFamilyIsMeasuredOnceByARunThatNeverSawItsGroup) {
  CrossvalOptions o = options("a");
  o.seed_count = 2;
  const CrossvalReport report = crossval(config_, o);
  ASSERT_EQ(report.seeds.size(), 2u);
  for (const CrossvalSeed& seed : report.seeds) {
    ASSERT_EQ(seed.families.size(), 4u);
    EXPECT_EQ(seed.families[1].fold, seed.families[2].fold) << "two and two19 are one group";
    ASSERT_EQ(seed.val.size(), 1u);
    EXPECT_EQ(seed.val[0].family, "four");
    for (const CrossvalFamily& family : seed.families) {
      EXPECT_GT(family.figures.l1, 0);
      EXPECT_NE(family.figures.l1, family.figures.heat_l1) << "nothing was learned";
    }
  }
  EXPECT_EQ(report.seeds[0].families[0].figures.heat_l1, report.seeds[1].families[0].figures.heat_l1);
  EXPECT_NE(report.seeds[0].families[0].figures.l1, report.seeds[1].families[0].figures.l1);
  EXPECT_TRUE(fs::exists(folder_.file("a/crossval.md")));
  EXPECT_EQ(crossval_csv(read_crossval(folder_.file("a"))), crossval_csv(report));

  // A fold's checkpoint is that of a plain training run without its families.
  TrainOptions plain;
  fs::create_directories(folder_.file("rest"));
  for (const CrossvalFamily& family : report.seeds[0].families) {
    if (family.fold == 1) continue;
    for (const auto& entry : fs::directory_iterator(folder_.file("data"))) {
      if (family_of(entry.path().stem().string()) == family.family)
        fs::copy(entry.path(), fs::path(folder_.file("rest")) / entry.path().filename());
    }
  }
  plain.data_dir = folder_.file("rest");
  plain.output = folder_.file("plain.ckpt");
  plain.cache_dir = folder_.file("cache");
  plain.quiet = true;
  train(config_, plain);
  const FloatNetwork expected = read_checkpoint(plain.output).network,
                     fold = read_checkpoint(folder_.file("a/seed1.fold1.ckpt")).network;
  for (size_t i = 0; i < expected.parameters.size(); ++i)
    EXPECT_EQ(fold.parameters[i].weights, expected.parameters[i].weights);
}

TEST_F(CrossvalRun, OnlyTheGroupsOfAMeanAreLeftOut) {
  CrossvalOptions o = options("some");
  o.groups.means["some"] = {"wings", "long"};
  o.fold_count = 2;
  o.leave_out = "some";
  const CrossvalReport report = crossval(config_, o);
  ASSERT_EQ(report.seeds[0].families.size(), 2u);
  EXPECT_EQ(report.seeds[0].families[0].family, "long");
  EXPECT_NE(report.seeds[0].families[0].fold, report.seeds[0].families[1].fold);
  EXPECT_EQ(crossval_means(report).named.at(0).families, 2u);
  o.leave_out = "other";
  EXPECT_ERROR(crossval(config_, o), "no mean named other");
}

TEST_F(CrossvalRun, AnotherShareOfTheCorrectionNeedsNoTraining) {
  config_.correction = 1;
  const CrossvalReport whole = crossval(config_, options("whole"));
  CrossvalOptions o = options("same");
  o.from = options("whole").folder;
  EXPECT_EQ(crossval_csv(crossval(config_, o)), crossval_csv(whole));
  o.folder = folder_.file("little");
  TrainConfig little = config_;
  little.correction = 0.001;
  const CrossvalReport report = crossval(little, o);
  for (size_t f = 0; f < report.seeds[0].families.size(); ++f) {
    const CrossvalFigures &now = report.seeds[0].families[f].figures, &then = whole.seeds[0].families[f].figures;
    EXPECT_NEAR(now.l1, now.heat_l1, 0.01);
    EXPECT_GT(std::abs(then.l1 - then.heat_l1), 2 * std::abs(now.l1 - now.heat_l1));
  }
  EXPECT_EQ(checkpoint_config(o.folder + "/seed1.fold1.ckpt").correction, 0.001);
  little.steps = 7;
  o.folder = folder_.file("other");
  EXPECT_ERROR(crossval(little, o), "another configuration: steps");
  o.folder = folder_.file("others");
  o.fold_count = 2;
  EXPECT_ERROR(crossval(config_, o), "its folds differ");
}

TEST_F(CrossvalRun, GoesOnAfterAStopWithTheSameFigures) {
  CrossvalOptions o = options("whole");
  const CrossvalReport whole = crossval(config_, o);
  o = options("parts");
  o.threads = 1;
  o.only_fold = 2;
  EXPECT_EQ(crossval(config_, o).seeds[0].val.size(), 0u);
  EXPECT_ERROR(crossval(config_, o), "--resume");
  const auto finished = fs::last_write_time(folder_.file("parts/seed1.fold2.json"));
  // A run that was killed between two saves: its checkpoint is older than its end.
  fs::remove(folder_.file("parts/seed1.fold2.json"));
  TrainOptions half;
  half.data_dir = o.data_dir;
  half.output = folder_.file("parts/seed1.fold3.ckpt");
  half.cache_dir = o.cache_dir;
  half.quiet = true;
  half.stop_after = 3;
  for (const CrossvalFamily& family : whole.seeds[0].families) {
    if (family.fold == 3) half.leave_out.push_back(family.family);
  }
  train(config_, half);
  o = options("parts");
  o.resume = true;
  const CrossvalReport parts = crossval(config_, o);
  EXPECT_EQ(crossval_csv(parts), crossval_csv(whole));
  EXPECT_GE(fs::last_write_time(folder_.file("parts/seed1.fold2.json")), finished);

  // What is finished is not done again, and another plan is refused.
  const auto checkpoint = fs::last_write_time(folder_.file("parts/seed1.fold1.ckpt"));
  EXPECT_EQ(crossval_csv(crossval(config_, o)), crossval_csv(whole));
  EXPECT_EQ(fs::last_write_time(folder_.file("parts/seed1.fold1.ckpt")), checkpoint);
  TrainConfig other = config_;
  other.learning_rate = 0.5;
  EXPECT_ERROR(crossval(other, o), "config.learning_rate has changed");
  o.fold_count = 2;
  EXPECT_ERROR(crossval(config_, o), "folds has changed");
}

TEST_F(CrossvalRun, AStopLeavesUnmeasuredFoldsOut) {
  std::atomic<bool> stop{true};
  CrossvalOptions o = options("stopped");
  o.stop = &stop;
  EXPECT_EQ(crossval(config_, o).seeds.size(), 0u);
  stop = false;
  o.resume = true;
  EXPECT_EQ(crossval(config_, o).seeds.at(0).families.size(), 4u);
}

}  // namespace
}  // namespace sinew
