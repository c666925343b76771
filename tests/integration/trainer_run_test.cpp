// SPDX-License-Identifier: MIT
// Whole training runs on synthesized characters: overfitting, resuming, starting from weights, the cache on disk,
// augmentation.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "data/sample_cache.hpp"
#include "run/loss.hpp"
#include "sinew_data_sets/dataset.hpp"
#include "sinew_data_sets/synthesize.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/train.hpp"

namespace sinew {
namespace {

namespace fs = std::filesystem;

class TrainerRun : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(SINEW_BINARY_DIR) / "trainer_run_test" /
            ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(root_);
    fs::create_directories(root_ / "data");
    add(BodyPlan::kBiped, 1, "two");
    add(BodyPlan::kBird, 2, "wings");
    config_.field = {16, 8, 1, 8, 32};
    config_.variants = 0;
    config_.synthetic = 0;
    config_.correction = 1;
    config_.validate_every = 1000000;
  }
  void TearDown() override {
    if (!HasFailure()) fs::remove_all(root_);
  }
  void add(BodyPlan plan, uint64_t seed, const std::string& family) {
    Character character = decimate(synthesize({plan, seed, 24, true}), 0.4);  // some 600 vertices are enough
    character.name = family + "__" + std::to_string(seed);
    write_obj((root_ / "data" / (character.name + ".obj")).string(), character);
    write_rig((root_ / "data" / (character.name + ".rig.txt")).string(), character);
  }
  TrainOptions options(const std::string& output) const {
    TrainOptions o;
    o.data_dir = (root_ / "data").string();
    o.output = (root_ / output).string();
    o.cache_dir = (root_ / "cache").string();
    o.quiet = true;
    return o;
  }
  std::vector<Sample> samples() const {
    return load_samples((root_ / "data").string(), config_.field.candidates, config_.field.grid,
                        (root_ / "cache").string(), 2, true);
  }
  fs::path root_;
  TrainConfig config_;
};

std::vector<float> all_numbers(const FloatNetwork& network) {
  std::vector<float> all;
  for (const LinearParameters& p : network.parameters) {
    all.insert(all.end(), p.weights.begin(), p.weights.end());
    all.insert(all.end(), p.bias.begin(), p.bias.end());
  }
  return all;
}
void expect_same(const Checkpoint& a, const Checkpoint& b) {
  EXPECT_EQ(all_numbers(a.latest), all_numbers(b.latest));
  EXPECT_EQ(all_numbers(a.network), all_numbers(b.network));
  ASSERT_EQ(a.state.averages.size(), b.state.averages.size());
  for (size_t i = 0; i < a.state.averages.size(); ++i) {
    EXPECT_EQ(all_numbers(a.state.averages[i]), all_numbers(b.state.averages[i]));
  }
  EXPECT_EQ(a.state.step, b.state.step);
  EXPECT_EQ(a.state.adam_m, b.state.adam_m);
  EXPECT_EQ(a.state.adam_v, b.state.adam_v);
  EXPECT_EQ(a.state.rng, b.state.rng);
  EXPECT_EQ(a.state.queue, b.state.queue);
  EXPECT_EQ(a.state.best_score, b.state.best_score);
}

TEST_F(TrainerRun, CharactersThatTheConfigurationLeavesOutAreNotDrawn) {
  add(BodyPlan::kSnake, 3, "wings");
  config_.leave_out = {{"wings__2", "its labels are wrong"}, {"tw", "no character is called so"}};
  EXPECT_EQ(load_training_set(config_, options("run.ckpt")).families, (std::vector<std::string>{"two", "wings"}));
  config_.leave_out = {{"wings*", "both"}};
  EXPECT_EQ(load_training_set(config_, options("run.ckpt")).families, std::vector<std::string>{"two"});
}

TEST_F(TrainerRun, TwoCharactersAreLearnedByHeart) {
  config_.field.width = 32;
  config_.field.rounds = 2;
  config_.steps = 400;
  config_.learning_rate = 1e-2;
  config_.weight_decay = config_.dropout = config_.feature_dropout = config_.average_decay = 0;
  config_.loss_regret = 0;
  train(config_, options("heart.ckpt"));
  const FloatNetwork network = read_checkpoint((root_ / "heart.ckpt").string()).network;
  double l1 = 0, heat = 0;
  for (const Sample& sample : samples()) {
    l1 += sample_l1(sample, predict(network, sample), 4) / 2;
    heat += sample_l1(sample, sample.heat, 4) / 2;
  }
  EXPECT_LT(l1, 0.05) << "heat: " << heat;
  EXPECT_GT(heat, 2 * l1) << "heat is as good, so nothing had to be learned";
}

TEST_F(TrainerRun, ResumingEqualsNotStoppingAndThreadsChangeNothing) {
  config_.steps = 6;
  config_.batch = 3;
  config_.variants = 1;
  config_.variant_share = 0.5;
  config_.feature_dropout = 0.1;
  config_.validate_every = 2;
  TrainOptions whole = options("whole.ckpt"), parts = options("parts.ckpt"), single = options("single.ckpt");
  whole.val_dir = parts.val_dir = single.val_dir = whole.data_dir;
  train(config_, whole);
  parts.stop_after = 3;
  train(config_, parts);
  EXPECT_EQ(read_checkpoint(parts.output).state.step, 3u);
  parts.resume = true;
  parts.stop_after = 0;
  train(config_, parts);
  single.threads = 1;
  train(config_, single);
  const Checkpoint expected = read_checkpoint(whole.output);
  EXPECT_EQ(expected.state.step, 6u);
  expect_same(expected, read_checkpoint(parts.output));
  expect_same(expected, read_checkpoint(single.output));
  EXPECT_NE(all_numbers(expected.latest), all_numbers(make_field(config_.field, config_.seed)));

  // The log plots: a header and one line per validation, each with as many fields.
  std::ifstream log(parts.output + ".csv");
  std::string line;
  std::vector<size_t> fields;
  while (std::getline(log, line)) fields.push_back(static_cast<size_t>(std::count(line.begin(), line.end(), ',')));
  EXPECT_EQ(fields, std::vector<size_t>(4, fields.at(0)));
}

TEST_F(TrainerRun, ResumeAndInitRefuseWhatDoesNotFit) {
  config_.steps = 2;
  train(config_, options("a.ckpt"));
  TrainOptions resume = options("a.ckpt");
  resume.resume = true;
  TrainConfig other = config_;
  other.learning_rate = 0.5;
  EXPECT_THROW(train(other, resume), Error);
  EXPECT_EQ(train_config_json(checkpoint_config(resume.output)), train_config_json(config_));

  TrainOptions init = options("b.ckpt");
  init.init = resume.output;
  other = config_;
  other.seed = 99;
  train(other, init);  // another seed has the same shapes
  other.field.width = config_.field.width - 1;
  EXPECT_THROW(train(other, init), Error);
  other.field.width = config_.field.width + 1;
  train(other, init);  // goes on in a wider network
  other = config_;
  other.architecture = "classic";
  EXPECT_THROW(train(other, init), Error);
  init.init = (root_ / "none.ckpt").string();
  EXPECT_THROW(train(config_, init), Error);

  TrainOptions empty = options("c.ckpt");
  empty.data_dir = (root_ / "cache").string();
  EXPECT_THROW(train(config_, empty), Error);
}

TEST_F(TrainerRun, InitStartsFromTheGivenWeights) {
  config_.steps = 4;
  train(config_, options("a.ckpt"));
  TrainConfig still = config_;
  still.steps = 1;
  still.learning_rate = 1e-12;
  still.weight_decay = 0;
  TrainOptions init = options("b.ckpt");
  init.init = options("a.ckpt").output;
  train(still, init);
  const std::vector<float> a = all_numbers(read_checkpoint(init.init).network),
                           b = all_numbers(read_checkpoint(init.output).latest);
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 1e-6);
}

TEST_F(TrainerRun, InitShareKeepsThatMuchOfTheStart) {
  config_.steps = 3;
  config_.average_decay = 0;
  train(config_, options("first.ckpt"));
  const std::vector<float> start = all_numbers(read_checkpoint(options("first.ckpt").output).network);
  config_.seed = 7;
  TrainOptions o = options("alone.ckpt");
  o.init = options("first.ckpt").output;
  train(config_, o);
  const std::vector<float> alone = all_numbers(read_checkpoint(o.output).network);
  config_.init_share = 0.75;
  o.output = options("shared.ckpt").output;
  o.stop_after = 2;
  train(config_, o);
  o.stop_after = 0;
  o.init.clear();
  o.resume = true;  // the start is in the checkpoint
  train(config_, o);
  const std::vector<float> shared = all_numbers(read_checkpoint(o.output).network);
  ASSERT_EQ(shared.size(), start.size());
  double moved = 0;
  for (size_t i = 0; i < start.size(); ++i) {
    EXPECT_NEAR(shared[i], 0.75f * start[i] + 0.25f * alone[i], 1e-6f) << i;
    moved += std::abs(static_cast<double>(alone[i] - start[i]));
  }
  EXPECT_GT(moved, 0);
}

TEST_F(TrainerRun, WithoutAChannelNoWeightReadsIt) {
  config_.steps = 4;
  config_.without = {"pair.bone_*", "vertex.mean_curvature"};
  train(config_, options("without.ckpt"));
  const FloatNetwork network = read_checkpoint(options("without.ckpt").output).network;
  const FloatNetwork start = make_field(config_.field, config_.seed);
  const std::vector<Sample> all = samples();
  Sample changed = all[0];
  for (size_t v = 0; v < changed.vertices; ++v) changed.inputs[0].rows[v * changed.inputs[0].channels] = -4321;
  EXPECT_EQ(forward(network, changed), forward(network, all[0]));
  EXPECT_NE(forward(start, changed), forward(start, all[0])) << "the channel says nothing in any network";
  size_t silent = 0;
  for (const Layer& layer : network.layers) {
    if (layer.kind != LayerKind::kLinear || layer.in.buffer != 1) continue;  // the pair features
    const LinearParameters& linear = network.parameters[layer.parameters];
    for (uint32_t c = 0; c < linear.in; ++c) {
      bool any = false;
      for (uint32_t out = 0; out < linear.out; ++out) any |= linear.weights[size_t{out} * linear.in + c] != 0;
      silent += !any;
    }
  }
  EXPECT_EQ(silent, 2u * 7u) << "pair.bone_* are seven channels, read by two layers";
}

TEST_F(TrainerRun, StopFlagWritesTheCheckpoint) {
  config_.steps = 1000000;
  std::atomic<bool> stop{true};
  TrainOptions o = options("stopped.ckpt");
  o.stop = &stop;
  train(config_, o);
  EXPECT_EQ(read_checkpoint(o.output).state.step, 0u);
}

TEST_F(TrainerRun, DamagedCacheFilesAreMadeAgainAndGoodOnesUsed) {
  const std::vector<Sample> first = samples();
  ASSERT_EQ(first.size(), 2u);
  std::map<fs::path, std::vector<uint8_t>> good;
  for (const auto& entry : fs::directory_iterator(root_ / "cache"))
    good[entry.path()] = read_file(entry.path().string());
  ASSERT_EQ(good.size(), 2u);
  for (const size_t where : {size_t{3}, size_t{12}, size_t{40}, good.begin()->second.size() - 1}) {
    for (const auto& [path, bytes] : good) {
      std::vector<uint8_t> bad = bytes;
      bad[where] ^= 0x40;
      if (where == 40) bad.resize(bad.size() / 2);
      write_file(path.string(), bad);
    }
    const std::vector<Sample> again = samples();
    ASSERT_EQ(again.size(), 2u);
    for (size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(again[i].inputs[1].rows, first[i].inputs[1].rows);
      EXPECT_EQ(again[i].target, first[i].target);
    }
    for (const auto& [path, bytes] : good) EXPECT_EQ(read_file(path.string()), bytes);
  }
  // A valid file is believed: put one character's in the place of the other's.
  write_file(good.begin()->first.string(), good.rbegin()->second);
  EXPECT_EQ(samples()[0].target, first[1].target);  // the name is the folder's to give
}

TEST_F(TrainerRun, TwoProcessesFillOneCache) {
  add(BodyPlan::kSnake, 3, "long");
  add(BodyPlan::kQuadruped, 4, "four");
  TrainOptions o = options("none.ckpt");
  config_.vertex_limit = 0;  // then val needs what training needs
  o.val_dir = o.data_dir;
  std::vector<pid_t> children;
  for (uint32_t part = 0; part < 2; ++part) {
    children.push_back(fork());
    if (children.back() == 0) {
      o.threads = 1;
      _exit(fill_feature_cache(config_, o, part, 2) >= 1 ? 0 : 1);  // each has made something
    }
  }
  for (const pid_t child : children) {
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  size_t files = 0;
  for (const auto& entry : fs::directory_iterator(root_ / "cache")) {
    ++files;
    EXPECT_EQ(entry.path().extension(), ".sample");
  }
  EXPECT_EQ(files, 4u);
  EXPECT_EQ(fill_feature_cache(config_, o, 0, 1), 0u) << "what they made is sound and complete";
  fs::resize_file(fs::directory_iterator(root_ / "cache")->path(), 1000);
  EXPECT_EQ(fill_feature_cache(config_, o, 1, 2), 1u) << "a damaged file is made again, though it is the other's part";
  EXPECT_EQ(samples().size(), 4u);
}

TEST_F(TrainerRun, ResumingAFinishedRunSaysSoAndChangesNothing) {
  config_.steps = 2;
  TrainOptions o = options("done.ckpt");
  train(config_, o);
  const std::vector<uint8_t> checkpoint = read_file(o.output), log = read_file(o.output + ".csv");
  o.resume = true;
  o.quiet = false;
  ::testing::internal::CaptureStderr();
  train(config_, o);
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("done.ckpt: nothing to do: all 2 steps are done"),
            std::string::npos);
  o.minutes = 1e-6;
  ::testing::internal::CaptureStderr();
  train(config_, o);
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("minutes are used up"), std::string::npos);
  EXPECT_EQ(read_file(o.output), checkpoint);
  EXPECT_EQ(read_file(o.output + ".csv"), log);
}

TEST_F(TrainerRun, CacheNoticesChangedCharacters) {
  samples();
  add(BodyPlan::kSnake, 1, "two");  // another content under the same name
  samples();
  size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(root_ / "cache")) ++files;
  EXPECT_EQ(files, 3u);
}

TEST_F(TrainerRun, LargeCharactersAreDecimatedAndSyntheticOnesJoin) {
  config_.vertex_limit = 0;
  const TrainingSet whole = load_training_set(config_, options("run.ckpt"));
  ASSERT_EQ(whole.characters.size(), 2u);
  config_.vertex_limit = 200;
  config_.synthetic = 1;
  const TrainingSet set = load_training_set(config_, options("run.ckpt"));
  ASSERT_EQ(set.characters.size(), 7u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_GT(whole.characters[i][0].vertices, 300u);
    EXPECT_LE(set.characters[i][0].vertices, 210u);
    EXPECT_EQ(set.characters[i][0].name, whole.characters[i][0].name);
  }
  std::vector<std::string> families(set.families.begin() + 2, set.families.end());
  std::sort(families.begin(), families.end());
  EXPECT_EQ(families, (std::vector<std::string>{"synthetic_biped", "synthetic_bird", "synthetic_many-legged",
                                                "synthetic_quadruped", "synthetic_snake"}));
  for (const auto& character : set.characters) EXPECT_LE(character[0].vertices, 210u);
}

TEST_F(TrainerRun, OneBadCharacterIsLeftOutAndAllBadOnesAreAnError) {
  write_text_file((root_ / "data" / "bad__1.obj").string(), "v 0 0 zero\n");
  write_text_file((root_ / "data" / "bad__1.rig.txt").string(), "joints a 0 0 0\nroot a\n");
  EXPECT_EQ(samples().size(), 2u);
  fs::create_directories(root_ / "bad");
  fs::rename(root_ / "data" / "bad__1.obj", root_ / "bad" / "bad__1.obj");
  fs::rename(root_ / "data" / "bad__1.rig.txt", root_ / "bad" / "bad__1.rig.txt");
  EXPECT_THROW(load_samples((root_ / "bad").string(), 8, 32, (root_ / "cache").string(), 2, true), Error);
}

TEST(Augment, SameSeedSameCharacterOtherSeedAnother) {
  const Character character = synthesize({BodyPlan::kBiped, 3, 24, true});
  const Character a = augment(character, 5), b = augment(character, 5), c = augment(character, 6);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (size_t v = 0; v < a.vertices.size(); ++v) {
    ASSERT_EQ(a.vertices[v].x, b.vertices[v].x);
    ASSERT_EQ(a.vertices[v].z, b.vertices[v].z);
  }
  EXPECT_NE(a.vertices[0].x, c.vertices[0].x);
}

// What a thinner skeleton, controls and another rest pose must not break, whatever the seed draws.
TEST(Augment, SkeletonsStayTreesAndRowsStayWhole) {
  const Character original = decimate(synthesize({BodyPlan::kBiped, 3, 24, true}), 0.4);
  bool fewer = false, more = false;
  for (uint64_t seed = 0; seed < 40; ++seed) {
    const Character changed = augment(original, seed);
    fewer = fewer || changed.joints.size() < original.joints.size();
    more = more || changed.joints.size() > original.joints.size();
    for (size_t j = 0; j < changed.joints.size(); ++j) {
      int at = static_cast<int>(j);
      for (size_t steps = 0; at >= 0 && steps <= changed.joints.size(); ++steps) {
        ASSERT_LT(at, static_cast<int>(changed.joints.size()));
        at = changed.joints[static_cast<size_t>(at)].parent;
      }
      ASSERT_EQ(at, -1) << "a cycle above joint " << j << ", seed " << seed;
    }
    ASSERT_EQ(changed.influences.size(), changed.vertices.size());
    for (const auto& row : changed.influences) {
      double sum = 0;
      for (const Influence& i : row) {
        ASSERT_LT(i.joint, changed.joints.size());
        sum += static_cast<double>(i.weight);
      }
      EXPECT_NEAR(sum, 1.0, 1e-3) << seed;
    }
  }
  EXPECT_TRUE(fewer);
  EXPECT_TRUE(more);
}

TEST(Augment, KeepsWeightsSeamsAndWindingAndSometimesThinsOut) {
  Character character = synthesize({BodyPlan::kBiped, 3, 24, false});
  // A seam: the first vertex twice, each used by some of its faces.
  character.vertices.push_back(character.vertices[0]);
  character.influences.push_back(character.influences[0]);
  bool used = false;
  for (uint32_t& v : character.face_vertices) {
    if (v == 0) {
      if (used) v = static_cast<uint32_t>(character.vertices.size() - 1);
      used = true;
    }
  }
  const auto volume = [](const Character& c) {
    double total = 0;
    for (size_t f = 0; f < c.face_count(); ++f) {
      const Vec3& a = c.vertices[c.face_vertices[c.face_offsets[f]]];
      for (uint32_t i = c.face_offsets[f] + 1; i + 1 < c.face_offsets[f + 1]; ++i) {
        const Vec3 &b = c.vertices[c.face_vertices[i]], &d = c.vertices[c.face_vertices[i + 1]];
        total += a.x * (b.y * d.z - b.z * d.y) + a.y * (b.z * d.x - b.x * d.z) + a.z * (b.x * d.y - b.y * d.x);
      }
    }
    return total / 6;
  };
  const double before = volume(character);
  ASSERT_GT(std::abs(before), 0);
  size_t thinned = 0;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const Character a = augment(character, seed);
    ASSERT_EQ(a.vertices.size(), a.influences.size());
    // Stretched by 0.8 to 1.2 per axis, bent in another rest pose; mirrored with faces turned round.
    const double ratio = volume(a) / before;
    EXPECT_GT(ratio, 0.8 * 0.8 * 0.8 * 0.8) << seed;
    EXPECT_LT(ratio, 1.2 * 1.2 * 1.2 * 1.2) << seed;
    if (a.vertices.size() < character.vertices.size() * 95 / 100) {
      ++thinned;
      continue;
    }
    if (a.vertices.size() == character.vertices.size()) {
      EXPECT_EQ(a.vertices[0].x, a.vertices.back().x) << "the seam came apart, seed " << seed;
      EXPECT_EQ(a.vertices[0].y, a.vertices.back().y);
    }
  }
  EXPECT_GT(thinned, 0u);
  EXPECT_LT(thinned, 20u);
}

}  // namespace
}  // namespace sinew
