// SPDX-License-Identifier: MIT
// Training for skeletons: configuration, samples, the run.
#include "sinew_trainer/rig_train.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <optional>

#include "core/random.hpp"
#include "data/hand_sample.hpp"
#include "run/rig_task.hpp"
#include "run/settings.hpp"
#include "run/training_run.hpp"
#include "run/training_set.hpp"
#include "sinew_datasets/synthesize.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/parallel.hpp"
#include "sinew_trainer/ranks.hpp"

namespace sinew {
namespace {

template <class Config, class Visitor>
void visit_settings(Config& c, Visitor&& visit) {
  visit("width", c.width);
  visit("rounds", c.rounds);
  visit("part", c.part);
  visit("variants", c.variants);
  visit("synthetic", c.synthetic);
  visit("leave_out", c.leave_out);
  visit_run_settings(c, visit);
}

// A character's samples: the first is itself, then the others.
std::vector<RigSample> samples_of(const Character& character, uint32_t variants, uint64_t seed) {
  const RigSource source(character);
  std::vector<RigSample> samples;
  samples.push_back(source.make(mix_seeds(seed, 0), 0));
  if (variants > 0) samples.push_back(source.make(mix_seeds(seed, 1), 0));
  for (uint32_t v = 0; v < variants; ++v)
    samples.push_back(source.make(mix_seeds(seed, 2 + v), v % 3 == 0 ? 0.5 : 1.0));
  return samples;
}

// The same of its hands, which take turns.
std::vector<RigSample> hand_samples_of(const Character& character, uint32_t variants, uint64_t seed) {
  const std::vector<HandSource> hands = hand_sources(character);
  std::vector<RigSample> samples;
  for (uint32_t v = 0; v < (variants > 0 ? variants + 2 : 1) && !hands.empty(); ++v) {
    std::optional<RigSample> sample = hands[v % hands.size()].make(mix_seeds(seed, v), v < 2        ? 0
                                                                                       : v % 3 == 0 ? 0.5
                                                                                                    : 1);
    if (sample) samples.push_back(std::move(*sample));
  }
  if (samples.empty()) throw Error(character.name + ": no hand to learn from");
  return samples;
}

struct Request {
  std::string path, name;  // of a file, or
  BodyPlan plan = BodyPlan::kBiped;
  uint64_t seed = 0;
};

std::vector<std::vector<RigSample>> make_samples(const std::vector<Request>& requests, bool hands, uint32_t variants,
                                                 uint64_t seed, uint32_t threads, bool quiet) {
  std::vector<std::vector<RigSample>> made(requests.size());
  std::atomic<size_t> done{0};
  parallel_for(requests.size(), threads, [&](size_t i, unsigned) {
    const Request& r = requests[i];
    try {
      Character character;
      if (r.path.empty()) {
        SynthesizeOptions options;
        options.plan = r.plan;
        options.seed = r.seed;
        options.resolution = 32;
        character = synthesize(options);
      } else {
        character = read_character(r.path);
        character.name = r.name;
      }
      made[i] = (hands ? hand_samples_of : samples_of)(character, variants, mix_seeds(seed, i));
    } catch (const Error& error) {
      if (!quiet && !hands) std::fprintf(stderr, "left out: %s\n", error.what());  // most have no hands
    }
    const size_t count = ++done;
    if (!quiet && (count % 50 == 0 || count == requests.size()))
      std::fprintf(stderr, "samples of %zu of %zu characters\n", count, requests.size());
  });
  std::erase_if(made, [](const std::vector<RigSample>& samples) { return samples.empty(); });
  return made;
}

std::vector<Request> character_requests(const std::string& folder,
                                        const std::map<std::string, std::string>& leave_out) {
  const std::vector<std::string> paths = list_characters(folder), names = character_names(folder, paths);
  std::vector<Request> requests;
  for (size_t i = 0; i < paths.size(); ++i) {
    if (!is_left_out(leave_out, names[i])) requests.push_back({paths[i], names[i]});
  }
  if (requests.empty()) throw Error(folder + ": no characters (NAME.obj with NAME.rig.txt, or .glb)");
  return requests;
}

}  // namespace

RigTrainConfig::RigTrainConfig() {
  learning_rate = 2e-3;
  steps = 9000;
  batch = 8;
  average_decay = 0.998;
  validate_every = 500;
  variant_share = 0.75;
  family_power = 0.6;
  dropout = 0.03;
  feature_dropout = 0;
}

RigTrainConfig parse_rig_config(const std::string& json, const std::string& source) {
  RigTrainConfig config;
  read_settings(json, source, "", [&](auto&& visit) { visit_settings(config, visit); });
  const Requirement require{source};
  check_run_settings(config, require);
  require(config.width >= 1 && config.width <= 256, "width", "1 to 256");
  require(config.rounds >= 2 && config.rounds <= 8, "rounds", "2 to 8");
  require(config.part == "body" || config.part == "hands", "part", "body or hands");
  require(config.variants <= 64, "variants", "0 to 64");
  require(config.synthetic <= 1000, "synthetic", "0 to 1000");
  return config;
}

std::string rig_config_json(const RigTrainConfig& config) {
  return write_settings("", [&](auto&& visit) { visit_settings(config, visit); });
}

void train_rig(const RigTrainConfig& config, const TrainOptions& options) {
  TrainOptions checked = options;
  checked.threads = std::max(options.threads, 1u);
  const RigTask task(config);
  const auto run_all = [&] {
    TrainingRun run(task, config, checked);
    run.start();
    std::vector<Request> requests = character_requests(checked.data_dir, config.leave_out);
    std::erase_if(requests, [&](const Request& r) {  // families that are not drawn need no samples
      const auto& families = checked.leave_out;
      return std::find(families.begin(), families.end(), family_of(r.name)) != families.end();
    });
    for (const BodyPlan plan : kBodyPlans) {
      for (uint32_t i = 0; i < config.synthetic; ++i) requests.push_back({"", "", plan, 1000 + i});
    }
    const bool quiet = checked.quiet || (checked.ranks != nullptr && checked.ranks->rank() > 0);
    const std::vector<std::vector<RigSample>> characters =
        make_samples(requests, is_hands(config), config.variants, config.seed, checked.threads, quiet);
    std::vector<std::vector<RigSample>> validation;
    if (!checked.val_dir.empty())
      validation = make_samples(character_requests(checked.val_dir, {}), is_hands(config), 0, config.seed,
                                checked.threads, quiet);
    TrainingItems items;
    for (const std::vector<RigSample>& samples : characters) {
      items.families.push_back(samples[0].family);
      items.choices.emplace_back();
      for (const RigSample& sample : samples) items.choices.back().push_back(&sample);
    }
    for (const std::vector<RigSample>& samples : validation) items.validation.push_back(&samples[0]);
    run.load(items);
    run.go();
  };
  if (checked.ranks == nullptr) return run_all();
  checked.ranks->together(run_all);
}

}  // namespace sinew
