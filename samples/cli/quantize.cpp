// SPDX-License-Identifier: MIT
// sinew-lab quantize: a float checkpoint in, an int16 model out.
#include "sinew_quant/quantize.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "commands.hpp"
#include "eval_studies.hpp"
#include "front/front_points.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_quant/model_writer.hpp"
#include "sinew_trainer/engine_network.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/network.hpp"
#include "sinew_trainer/rig_difference.hpp"
#include "sinew_trainer/train.hpp"
#include "support.hpp"
#include "votes/rig_task.hpp"

namespace sinew::cli {
namespace {

constexpr size_t kCompared = 16;  // characters beside float; more say the same

struct QuantizeCommandSettings {
  std::string checkpoint, folder, compared, output, release, confidence;
  // Characters on which integers are compared with float, and a remark if the ranges are of the same characters.
  const std::string& measured_on() const { return compared.empty() ? folder : compared; }
  const char* remark() const {
    return compared.empty() ? ", including the calibrated ones (--held-out DIR: others)" : "";
  }
  unsigned characters = 40;
  double correction = 0;  // 0 = the checkpoint's
  QuantizeOptions options;
  bool quiet = false;
};

// Returns what was done, a line.
std::string add_confidence(const QuantizeCommandSettings& s, std::vector<uint8_t>* bytes) {
  const std::unique_ptr<LoadedModel> plain = model_from_bytes(*bytes, "the quantized network");
  const std::vector<JudgedConfidence> judged =
      judge_folder({s.confidence, &plain->model, 4, std::max(1u, std::thread::hardware_concurrency())});
  std::vector<ConfidenceEntry> entries;
  for (const auto& [share, hits] : fit_confidence(judged)) entries.push_back({share, hits});
  *bytes = with_confidence(*bytes, entries);
  return print("confidence fitted on %zu characters: %zu entries\n", judged.size(), entries.size());
}

std::vector<Sample> load_samples_of(const std::string& folder, unsigned characters, const FloatNetwork& network) {
  std::optional<Progress> progress;
  return calibration_samples(folder, characters, network.candidate_count, network.grid_size, network.feature_set,
                             [&](size_t, size_t total) {
                               if (!progress) progress.emplace(total, "characters read");
                               progress->step();
                             });
}

// Differences of the integers from the float network.
struct Loss {
  size_t characters = 0;
  WeightDifference all;
  double worst_flips = 0;  // share of a character's vertices whose strongest joint differs
  std::string worst;
};

Loss measure_loss(const FloatNetwork& network, const sinew_model& model, const std::vector<Sample>& samples) {
  constexpr uint32_t kInfluences = 4;
  Loss loss;
  loss.characters = std::min(kCompared, samples.size());
  Progress progress(loss.characters, "characters compared");
  for (size_t i = 0; i < loss.characters; ++i) {
    const Sample& sample = samples[i * samples.size() / loss.characters];
    const auto exact = sample_influences(sample, softmax(sample, forward(network, sample)), kInfluences);
    const auto integers = sample_influences(sample, softmax(sample, engine_logits(model, sample)), kInfluences);
    WeightDifference one;
    one.add(exact, integers);
    loss.all.add(exact, integers);
    if (i == 0 || one.flip_share() > loss.worst_flips) {
      loss.worst_flips = one.flip_share();
      loss.worst = sample.name;
    }
    progress.step();
  }
  return loss;
}

void show_layers(const QuantizedModel& model) {
  std::printf("%-4s %-24s %16s %6s  %s\n", "", "layer", "|accumulator| <=", "class", "shifts");
  for (size_t l = 0; l < model.layers.size(); ++l) {
    const QuantizeLayerReport& layer = model.layers[l];
    std::printf("%-4zu %-24s %16lld %6s  %d..%d\n", l, layer.what.c_str(), static_cast<long long>(layer.bound),
                layer.wide ? "W" : "N", layer.min_shift, layer.max_shift);
  }
}

// Writes the model, reads it again, and prints its difference from the float network.
//   parts       the networks in the file, whose layers are listed
//   difference  of the model from the float network, in words
//   next        the command that uses the model
void finish(const QuantizeCommandSettings& s, const FloatNetwork& network, const std::vector<uint8_t>& bytes,
            const std::vector<QuantizedModel>& parts, ModelUse use,
            const std::function<std::string(const sinew_model&)>& difference, const std::string& next) {
  write_file(s.output, bytes);
  if (!s.release.empty()) {
    Checkpoint weights;
    weights.network = network;
    write_checkpoint(s.release, weights);
  }
  if (s.quiet) return;
  const std::unique_ptr<LoadedModel> loaded = model_from_bytes(bytes, s.output, use);
  std::printf("%s: %zu bytes; beside the float network %s\n", s.output.c_str(), bytes.size(),
              difference(loaded->model).c_str());
  for (const QuantizedModel& part : parts) show_layers(part);
  std::printf("\nnext: sinew-lab %s %s\n", next.c_str(), s.output.c_str());
}

// Both networks of the published method become one file.
void quantize_slots(const QuantizeCommandSettings& s, const FloatNetwork& network) {
  const SlotNetworks networks = calibrate_slots(network, s.folder, s.characters);
  const QuantizedModel joints = quantize(networks.joints, networks.joint_ranges, s.options),
                       connections = quantize(networks.connections, networks.connection_ranges, s.options);
  const auto difference = [&](const sinew_model& model) {
    const SlotDifference d = compare_slots(network, model, s.measured_on(), kCompared);
    return print(
        "joints move by %.5f of the longest side (at most %.5f), %.2f %% of the slots and %.2f %% of the connections "
        "are unchanged; %zu characters compared%s",
        d.mean, d.most, 100 * d.same_presence, 100 * d.same_connections, d.characters, s.remark());
  };
  finish(s, network, with_second_network(joints.bytes, connections.bytes), {joints, connections}, ModelUse::kSlotJoints,
         difference, "rig MESH.obj --method slots --model");
}

void quantize_front(const QuantizeCommandSettings& s, const FloatNetwork& network) {
  const QuantizedModel model = quantize(network, calibrate_front(network, s.folder, s.characters), s.options);
  const auto difference = [&](const sinew_model& integers) {
    const FrontDifference d = compare_fronts(network, integers, s.measured_on(), kCompared);
    return print("answers of length 1 move by %.5f (at most %.5f); %zu characters compared%s", d.mean, d.most,
                 d.characters, s.remark());
  };
  finish(s, network, model.bytes, {model}, ModelUse::kFront, difference, "rig MESH.obj --front-model");
}

void quantize_votes(const QuantizeCommandSettings& s, const FloatNetwork& network) {
  const QuantizedModel model = quantize(network, calibrate_rig(network, s.folder, s.characters), s.options);
  const auto difference = [&](const sinew_model& integers) {
    const VoteDifference d = compare_votes(network, integers, s.measured_on(), kCompared);
    return print(
        "votes move by %.5f of the longest side (at most %.5f), %.2f %% keep their class; %zu characters compared%s",
        d.mean, d.most, 100 * d.same_class, d.characters, s.remark());
  };
  const bool hands = network.feature_set == sinew::rigging::kHandsFeatureSet;
  finish(s, network, model.bytes, {model}, hands ? ModelUse::kHands : ModelUse::kRig, difference,
         "rig MESH.obj --model");
}

// A network of skeletons: no confidences, and votes instead of weights to compare.
void quantize_rig(const QuantizeCommandSettings& s, const FloatNetwork& network) {
  if (!s.confidence.empty() || s.correction > 0)
    throw UsageError(s.checkpoint +
                     " predicts skeletons, but --calibrate-confidence and --correction are for skin weights");
  if (network.architecture == "slots") return quantize_slots(s, network);
  if (network.feature_set == sinew::rigging::kFrontFeatureSet) return quantize_front(s, network);
  quantize_votes(s, network);
}

void quantize_weights(const QuantizeCommandSettings& s, const FloatNetwork& network) {
  const std::vector<Sample> samples = load_samples_of(s.folder, s.characters, network);
  QuantizedModel model = quantize(network, calibrate(network, samples), s.options);
  std::string confidence;
  if (!s.confidence.empty()) confidence = add_confidence(s, &model.bytes);
  const auto difference = [&](const sinew_model& integers) {
    const std::vector<Sample> others =
        s.compared.empty() ? std::vector<Sample>() : load_samples_of(s.compared, s.characters, network);
    const Loss loss = measure_loss(network, integers, s.compared.empty() ? samples : others);
    return print(
        "%.2f %% of the vertices change their joint (at most %.2f %%, %s), %.2f %% of the weights differ by more than "
        "1/255\ncalibrated on %zu characters, compared on %zu%s\n%s",
        100 * loss.all.flip_share(), 100 * loss.worst_flips, loss.worst.c_str(), 100 * (1 - loss.all.close_share()),
        samples.size(), loss.characters, s.remark(), confidence.c_str());
  };
  finish(s, network, model.bytes, {model}, ModelUse::kBind, difference,
         "eval " + (s.confidence.empty() ? s.folder : s.confidence) + " --model");
}

// A model stays as it is but for its table of confidences.
void fit_model(const QuantizeCommandSettings& s) {
  if (s.confidence.empty() || !s.folder.empty() || !s.release.empty())
    throw UsageError(
        s.checkpoint +
        " is a model already: only its confidence table can change, with --calibrate-confidence DIR alone");
  std::vector<uint8_t> bytes = read_file(s.checkpoint);
  (void)model_from_bytes(bytes, s.checkpoint);
  const std::string confidence = add_confidence(s, &bytes);
  write_file(s.output, bytes);
  if (!s.quiet) std::printf("%s: %zu bytes\n%s", s.output.c_str(), bytes.size(), confidence.c_str());
}

void run_quantize(const QuantizeCommandSettings& s) {
  check_output(s.output, {".sinew"});
  if (has_extension(s.checkpoint, ".sinew")) return fit_model(s);
  if (s.folder.empty())
    throw UsageError("--calibrate DIR is required: the characters that the integer ranges are measured on");
  Checkpoint checkpoint = read_checkpoint(s.checkpoint);
  if (checkpoint.network.task == kTaskRig) return quantize_rig(s, checkpoint.network);
  if (s.correction > 0) change_correction(s.correction, s.checkpoint, &checkpoint);
  quantize_weights(s, checkpoint.network);
}

}  // namespace

void add_quantize(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("quantize", "Quantize a checkpoint to an int16 model");
  auto s = std::make_shared<QuantizeCommandSettings>();
  sub->add_option("checkpoint", s->checkpoint,
                  "Checkpoint of sinew-lab train. Or a model, with --calibrate-confidence alone")
      ->required()
      ->type_name("CKPT");
  shared_option(sub, "-o,--output", s->output, "Model (.sinew)")->required();
  shared_option(sub, "--calibrate", s->folder);
  sub->add_option(
         "--held-out", s->compared,
         "Characters for comparing the integers with float. By default those of --calibrate, whose ranges are known")
      ->type_name("DIR");
  sub->add_option("--calibrate-confidence", s->confidence,
                  "Characters for the confidence table, from many families outside the training data. The table maps "
                  "the share of the strongest joint to how often it is right (sinew-lab eval confidence measures how "
                  "well it generalizes)")
      ->type_name("DIR");
  sub->add_option("--characters", s->characters, "Number of calibration characters, spread over the folder; 0 = all")
      ->capture_default_str()
      ->type_name("N");
  sub->add_option("--correction", s->correction,
                  "Share of the learned correction of heat, instead of the trained one. Less is better on families "
                  "outside the training data, more on those inside")
      ->check(CLI::Range(0.01, 1.0))
      ->type_name("X");
  sub->add_option("--margin", s->options.margin, "Ranges are the largest observed value times this")
      ->check(CLI::Range(1.0, 16.0))
      ->capture_default_str()
      ->type_name("X");
  sub->add_option("--bits", s->options.weight_bits, "Bits per weight; below 16 for studying the error")
      ->check(CLI::IsMember({16, 12, 10, 8}))
      ->capture_default_str()
      ->type_name("N");
  shared_option(sub, "--release", s->release);
  shared_flag(sub, "--quiet", s->quiet);
  sub->footer(
      "Example:\n  sinew-lab quantize run.sinewckpt --calibrate characters/train -o run.sinew\n"
      "  sinew-lab quantize run.sinew --calibrate-confidence characters/others -o run.sinew");
  sub->callback([s] { run_quantize(*s); });
}

}  // namespace sinew::cli
