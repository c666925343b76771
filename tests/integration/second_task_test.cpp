// SPDX-License-Identifier: MIT
// A network is not only bind's: a tiny task over joints and pairs of joints trains, is quantized, and runs in the engine.
// For every joint: how far its farthest neighbor lies, how much the joints tied to it weigh on average, and the heaviest of
// those two steps away.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "aligned_bytes.hpp"
#include "expect_error.hpp"
#include "kernels/select.hpp"
#include "model/reader.hpp"
#include "network/network.hpp"
#include "run/training_run.hpp"
#include "sinew/sinew.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_quant/quantize.hpp"
#include "sinew_trainer/engine_network.hpp"
#include "sinew_trainer/network.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

constexpr uint32_t kTask = kFirstPrivateTask + 7;
constexpr uint32_t kSlots = 3, kOutputs = 3;
constexpr uint16_t kJoints = 0, kPairs = 1;  // inputs

struct JointSample : NetworkSample {
  std::vector<float> target;  // [J x kOutputs]
};

// A chain of joints: weights of the joints, distances to the others in the slots of a pair.
JointSample chain(uint32_t joints, uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto draw = [&] { return static_cast<int16_t>(random() % 8192); };
  JointSample s;
  s.name = "chain" + std::to_string(seed);
  s.family = seed % 2 == 0 ? "even" : "odd";
  s.vertices = s.joints = joints;
  s.candidates = kSlots;
  s.part_count = 1;
  s.inputs = {{1, {}}, {1, {}}};
  s.row_offsets = s.far_offsets = {0};
  s.part_offsets = {0, joints};
  for (uint32_t j = 0; j < joints; ++j) {
    s.part.push_back(0);
    s.part_vertices.push_back(j);
    if (j > 0) s.col_indices.push_back(j - 1);
    if (j + 1 < joints) s.col_indices.push_back(j + 1);
    s.row_offsets.push_back(static_cast<uint32_t>(s.col_indices.size()));
    if (j > 1) s.far_indices.push_back(j - 2);
    if (j + 2 < joints) s.far_indices.push_back(j + 2);
    s.far_offsets.push_back(static_cast<uint32_t>(s.far_indices.size()));
    s.inputs[kJoints].rows.push_back(draw());
    for (uint32_t slot = 0; slot < kSlots; ++slot) {
      const bool present = slot == 0 || (j + slot) % 4 != 0;
      s.candidate.push_back(present ? static_cast<uint16_t>((j + slot + 1) % joints) : uint16_t{0xFFFF});
      s.inputs[kPairs].rows.push_back(present ? draw() : int16_t{0});
    }
  }
  // Absent slots last, as the engine wants them.
  for (uint32_t j = 0; j < joints; ++j) {
    for (uint32_t a = j * kSlots; a + 1 < (j + 1) * kSlots; ++a) {
      if (s.candidate[a] != 0xFFFF || s.candidate[a + 1] == 0xFFFF) continue;
      std::swap(s.candidate[a], s.candidate[a + 1]);
      std::swap(s.inputs[kPairs].rows[a], s.inputs[kPairs].rows[a + 1]);
    }
  }
  for (uint32_t j = 0; j < joints; ++j) {
    int16_t farthest = 0;
    for (uint32_t a = j * kSlots; a < (j + 1) * kSlots; ++a) farthest = std::max(farthest, s.inputs[kPairs].rows[a]);
    float sum = 0;
    for (uint32_t e = s.row_offsets[j]; e < s.row_offsets[j + 1]; ++e) sum += s.inputs[kJoints].rows[s.col_indices[e]];
    const auto count = static_cast<float>(s.row_offsets[j + 1] - s.row_offsets[j]);
    s.target.push_back(static_cast<float>(farthest) / 8192.0f);
    s.target.push_back(sum / count / 8192.0f);
    int16_t heaviest = 0;
    for (uint32_t e = s.far_offsets[j]; e < s.far_offsets[j + 1]; ++e)
      heaviest = std::max(heaviest, s.inputs[kJoints].rows[s.far_indices[e]]);
    s.target.push_back(static_cast<float>(heaviest) / 8192.0f);
  }
  return s;
}

class JointTask : public TrainingTask {
 public:
  explicit JointTask(const RunConfig& config) : config_(config) {}

  FloatNetwork make_network() const override {
    std::mt19937_64 random(config_.seed);
    std::normal_distribution<float> normal;
    FloatNetwork n;
    n.architecture = "chain";
    n.task = kTask;
    n.input_names = {"join", "pair"};
    n.candidate_count = kSlots;
    n.buffers = {{Domain::kJoint, 1},       {Domain::kJointPair, 1},          {Domain::kJointPair, 8},
                 {Domain::kJointPair, 8},   {Domain::kJoint, 3 + 8 * kSlots}, {Domain::kJoint, 16},
                 {Domain::kJoint, kOutputs}};
    const auto linear = [&](Region in, Region out, uint8_t flags) {
      Layer layer;
      layer.flags = flags;
      layer.in = in;
      layer.out = out;
      layer.parameters = static_cast<uint32_t>(n.parameters.size());
      n.layers.push_back(layer);
      LinearParameters p{in.channels, out.channels, {}, std::vector<float>(out.channels, 0.0f)};
      for (uint32_t i = 0; i < p.in * p.out; ++i)
        p.weights.push_back(normal(random) * std::sqrt(2.0f / static_cast<float>(p.in)));
      n.parameters.push_back(p);
    };
    const auto apply = [&](LayerKind kind, Region in, Region out) {
      Layer layer;
      layer.kind = kind;
      layer.in = in;
      layer.out = out;
      n.layers.push_back(layer);
    };
    linear({kPairs, 0, 1}, {2, 0, 8}, kLayerRelu);
    apply(LayerKind::kCandidateMax, {2, 0, 8}, {3, 0, 8});
    apply(LayerKind::kCopy, {kJoints, 0, 1}, {4, 0, 1});
    apply(LayerKind::kRingMean, {kJoints, 0, 1}, {4, 1, 1});
    apply(LayerKind::kRingMax, {kJoints, 0, 1}, {4, 2, 1});
    n.layers.back().flags = kLayerFar;
    apply(LayerKind::kPairToVertex, {3, 0, 8}, {4, 3, 8 * kSlots});
    linear({4, 0, 3 + 8 * kSlots}, {5, 0, 16}, kLayerRelu);
    linear({5, 0, 16}, {6, 0, kOutputs}, 0);
    return n;
  }
  std::vector<std::string> loss_names() const override { return {"squares", "largest"}; }
  std::vector<double> loss(const NetworkSample& sample, const std::vector<float>& outputs,
                           std::vector<float>* d_outputs) const override {
    const std::vector<float>& target = static_cast<const JointSample&>(sample).target;
    EXPECT_EQ(outputs.size(), target.size());
    d_outputs->assign(outputs.size(), 0.0f);
    double sum = 0, largest = 0;
    for (size_t i = 0; i < outputs.size(); ++i) {
      const float e = outputs[i] - target[i];
      sum += static_cast<double>(e * e) / static_cast<double>(outputs.size());
      largest = std::max(largest, static_cast<double>(std::fabs(e)));
      (*d_outputs)[i] = 2 * e / static_cast<float>(outputs.size());
    }
    return {sum, largest};
  }
  std::string score_name() const override { return "error"; }
  double score(const NetworkSample& sample, const std::vector<float>& outputs) const override {
    const std::vector<float>& target = static_cast<const JointSample&>(sample).target;
    double sum = 0;
    for (size_t i = 0; i < target.size(); ++i) sum += static_cast<double>(std::fabs(outputs[i] - target[i]));
    return sum / static_cast<double>(target.size());
  }
  std::string baseline_name() const override { return "half"; }
  double baseline_score(const NetworkSample& sample) const override {
    return score(sample, std::vector<float>(static_cast<const JointSample&>(sample).target.size(), 0.5f));
  }
  std::string config_text() const override { return "{\n  \"task\": \"chain\"\n}"; }

 private:
  const RunConfig config_;
};

struct Scene {
  TempFolder folder;
  RunConfig config;
  TrainOptions options;
  std::vector<JointSample> samples, validation;
  TrainingItems items;

  Scene() {
    config.steps = 400;
    config.validate_every = 100;
    config.learning_rate = 5e-3;
    config.dropout = config.feature_dropout = config.weight_decay = 0;
    config.average_decay = 0.98;
    options.output = folder.file("chain.ckpt");
    options.quiet = true;
    for (uint64_t seed = 0; seed < 6; ++seed) samples.push_back(chain(12 + static_cast<uint32_t>(seed), seed));
    for (uint64_t seed = 50; seed < 53; ++seed) validation.push_back(chain(20, seed));
    for (const JointSample& sample : samples) {
      items.choices.push_back({&sample});
      items.families.push_back(sample.family);
    }
    for (const JointSample& sample : validation) items.validation.push_back(&sample);
  }
  Checkpoint train(bool resume = false) {
    const JointTask task(config);
    options.resume = resume;
    TrainingRun run(task, config, options);
    run.start();
    run.load(items);
    run.go();
    return read_checkpoint(options.output);
  }
};

// The engine's outputs for a sample, in real units.
std::vector<float> run_engine(const FloatNetwork& network, const std::vector<uint8_t>& bytes,
                              const NetworkSample& sample) {
  const test::AlignedBytes file(bytes);
  ModelHeader header;
  sinew_model model;
  EXPECT_EQ(read_header(file.data(), bytes.size(), &header), SINEW_OK);
  EXPECT_EQ(header.task, kTask);
  EXPECT_EQ(open_model(file.data(), bytes.size(), model_task(network), &model), SINEW_OK);
  const NetworkOptions options;
  const Workspace block(network_workspace(model, sample, options));
  Arena arena(block.data(), block.size());
  std::vector<int16_t> out(size_t{sample.vertices} * kOutputs, 0x5A5A);
  EXPECT_EQ(run_network(model, network_input(sample), fastest_kernels(), Progress{}, arena, out.data(), options),
            SINEW_OK);
  std::vector<float> real;
  for (const int16_t value : out) real.push_back(static_cast<float>(value) / 1024.0f);
  return real;
}

TEST(SecondTask, TrainsIsQuantizedAndRuns) {
  Scene scene;
  const Checkpoint trained = scene.train();
  EXPECT_EQ(trained.network.task, kTask);
  EXPECT_EQ(trained.network.input_names, (std::vector<std::string>{"join", "pair"}));
  EXPECT_NE(
      trained.state.log_csv.find("squares,largest,gradient_norm,learning_rate,val_error,val_family_error,half_error"),
      std::string::npos)
      << trained.state.log_csv;

  const JointTask task(scene.config);
  NetworkRunner runner;
  double baseline = 0, error = 0;
  for (const JointSample& sample : scene.validation) {
    baseline += task.baseline_score(sample) / 3;
    error += task.score(sample, runner.forward(trained.network, sample)) / 3;
  }
  EXPECT_GT(baseline, 0.15);
  EXPECT_LT(error, 0.04);

  const Calibration calibration = calibrate(trained.network, scene.items.validation);
  const std::vector<uint8_t> bytes = quantize(trained.network, calibration).bytes;
  for (const JointSample& sample : scene.validation) {
    const std::vector<float> exact = runner.forward(trained.network, sample);
    const std::vector<float> found = run_engine(trained.network, bytes, sample);
    ASSERT_EQ(found.size(), exact.size());
    for (size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(found[i], exact[i], 0.002) << sample.name << " " << i;
  }
}

TEST(SecondTask, ResumesToTheSameBytes) {
  Scene whole, halves;
  whole.config.steps = halves.config.steps = 60;
  whole.config.validate_every = halves.config.validate_every = 20;
  const Checkpoint once = whole.train();
  halves.options.stop_after = 30;
  halves.train();
  halves.options.stop_after = 0;
  const Checkpoint resumed = halves.train(true);
  ASSERT_EQ(once.latest.parameters.size(), resumed.latest.parameters.size());
  for (size_t i = 0; i < once.latest.parameters.size(); ++i)
    EXPECT_EQ(once.latest.parameters[i].weights, resumed.latest.parameters[i].weights) << i;
  EXPECT_EQ(once.network.parameters[0].weights, resumed.network.parameters[0].weights);
}

// Whoever opens a model says what it is for.
TEST(SecondTask, OtherTasksRefuseItsModel) {
  Scene scene;
  const FloatNetwork network = JointTask(scene.config).make_network();
  const std::vector<uint8_t> bytes = quantize(network, calibrate(network, scene.items.validation)).bytes;
  const test::AlignedBytes file(bytes);
  sinew_model model;
  EXPECT_EQ(sinew_model_open(file.data(), bytes.size(), &model), SINEW_ERROR_MODEL_TASK);
  ModelTask task = model_task(network);
  EXPECT_EQ(open_model(file.data(), bytes.size(), task, &model), SINEW_OK);

  // A caller of sinew_bind() is told, too.
  size_t need = 0;
  EXPECT_EQ(sinew_bind_workspace_size(&model, 8, 4, 12, 2, nullptr, &need), SINEW_ERROR_MODEL_TASK);

  std::swap(task.inputs[0].name, task.inputs[1].name);
  EXPECT_EQ(open_model(file.data(), bytes.size(), task, &model), SINEW_ERROR_MODEL_VERSION) << "other names";
  task = model_task(network);
  task.inputs[kPairs].buffer.channels = 2;
  EXPECT_EQ(open_model(file.data(), bytes.size(), task, &model), SINEW_ERROR_MODEL_VERSION) << "other channels";
  task = model_task(network);
  task.output.channels = 1;
  EXPECT_EQ(open_model(file.data(), bytes.size(), task, &model), SINEW_ERROR_MODEL_LAYOUT) << "another output";
  task = model_task(network);
  task.input_count = 1;
  EXPECT_EQ(open_model(file.data(), bytes.size(), task, &model), SINEW_ERROR_MODEL_VERSION) << "fewer inputs";
  task = model_task(network);
  task.output.domain = Domain::kVertex;
  EXPECT_EQ(open_model(file.data(), bytes.size(), task, &model), SINEW_ERROR_MODEL_LAYOUT) << "over vertices";
  task = model_task(network);
  task.far_neighbors = false;
  EXPECT_EQ(open_model(file.data(), bytes.size(), task, &model), SINEW_ERROR_MODEL_LAYOUT) << "no far neighbors";
}

TEST(SecondTask, ARunForAnotherTaskDoesNotStartFromItsWeights) {
  Scene scene;
  scene.config.steps = 2;
  scene.train();
  TrainConfig config;
  TrainOptions options;
  options.output = scene.folder.file("bind.ckpt");
  options.init = scene.options.output;
  options.quiet = true;
  TrainingSet none;
  EXPECT_ERROR(train(config, options, none), "chain.ckpt", "cannot start from its weights");
  const Checkpoint chain_checkpoint = read_checkpoint(scene.options.output);
  EXPECT_ERROR(require_bind_network(chain_checkpoint.network, "x.ckpt"), "x.ckpt", "binding");
}

}  // namespace
}  // namespace sinew
