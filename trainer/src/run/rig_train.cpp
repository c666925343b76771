// SPDX-License-Identifier: MIT
// Training for skeletons: configuration, samples, the run.
#include "sinew_trainer/rig_train.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "core/random.hpp"
#include "data/cache_file.hpp"
#include "data/front_sample.hpp"
#include "data/hand_sample.hpp"
#include "data/rig_sample.hpp"
#include "data/rig_sample_cache.hpp"
#include "data/slot_sample.hpp"
#include "data/thing_sample.hpp"
#include "run/rig_tasks.hpp"
#include "run/settings.hpp"
#include "run/training_run.hpp"
#include "sinew_data_sets/synthesize.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/memory_files.hpp"
#include "sinew_trainer/ranks.hpp"

namespace sinew {
namespace {

template <class Config, class Visitor>
void visit_rig_settings(Config& c, Visitor&& visit) {
  visit("architecture", c.architecture);
  visit("width", c.width);
  visit("rounds", c.rounds);
  visit("part", c.part);
  visit("variants", c.variants);
  visit("least_variants", c.least_variants);
  visit("synthetic", c.synthetic);
  visit("things", c.things);
  visit("wide", c.wide);
  visit("grown", c.grown);
  visit("walls", c.walls);
  visit("specks", c.specks);
  visit("pictures", c.pictures);
  visit("balance", c.balance);
  visit("losses", c.losses);
  visit("leave_out", c.leave_out);
  visit_run_settings(c, visit);
}

constexpr uint32_t kLeastCells = 64, kMostCells = 104;  // of a shell: 5,000 to 60,000 faces

constexpr uint64_t kSampleVersion = 1;  // grows whenever a sample of the same request changes

using Samples = RigSamples;

// The first is the character itself, then come the others.
template <class Make>
Samples samples_of(uint32_t variants, uint64_t seed, Make&& make) {
  Samples samples;
  const auto add = [&](uint64_t number, double strength) {
    auto sample = make(mix_seeds(seed, number), strength);
    samples.push_back(std::make_unique<decltype(sample)>(std::move(sample)));
  };
  add(0, 0);
  if (variants > 0) add(1, 0);
  for (uint32_t v = 0; v < variants; ++v) add(2 + v, v % 3 == 0 ? 0.5 : 1.0);
  return samples;
}

// The kind of a copy; the character itself is unchanged.
RigVariant draw_variant(const RigTrainConfig& config, uint64_t seed, double strength) {
  RigVariant variant;
  variant.strength = strength;
  if (strength <= 0) return variant;
  Random random(mix_seeds(seed, 0x67726f776e));
  variant.wide = random.uniform() < config.wide;
  const uint32_t cells = kLeastCells + random.below(kMostCells - kLeastCells + 1);
  if (random.uniform() < config.grown) variant.cells = cells;
  variant.wall = random.uniform() < config.walls;
  variant.specks = random.uniform() < config.specks;
  variant.picture = random.uniform() < config.pictures;
  return variant;
}

// The same of its hands, which take turns.
Samples hand_samples_of(const Character& character, uint32_t variants, uint64_t seed) {
  const std::vector<HandSource> hands = hand_sources(character);
  Samples samples;
  for (uint32_t v = 0; v < (variants > 0 ? variants + 2 : 1) && !hands.empty(); ++v) {
    const double strength = v < 2 ? 0 : v % 3 == 0 ? 0.5 : 1;
    std::optional<RigSample> sample = hands[v % hands.size()].make(mix_seeds(seed, v), strength);
    if (sample) samples.push_back(std::make_unique<RigSample>(std::move(*sample)));
  }
  if (samples.empty()) throw Error(character.name + ": no hand to train on");
  return samples;
}

// The character itself is first, upright; its variants come with their tilted meshes. A variant in eight keeps its pose.
Samples front_samples_of(const Character& character, const RigTrainConfig& config, uint32_t variants, uint64_t seed) {
  constexpr uint32_t kUpright = 4;  // of each copy: another look at it costs less than another copy
  const FrontSource source(character);
  Samples samples;
  samples.push_back(std::make_unique<FrontSample>(source.original(mix_seeds(seed, 0))));
  for (uint32_t v = 0; v < variants; ++v) {
    const uint64_t own = mix_seeds(seed, 1 + v);
    RigVariant variant = draw_variant(config, own, v % 4 == 0 ? 0.5 : 1.0);
    if (v % 8 == 1) variant.strength = 0;
    for (FrontSample& sample : source.make(own, variant, kUpright))
      samples.push_back(std::make_unique<FrontSample>(std::move(sample)));
  }
  return samples;
}

Samples samples_of(const Character& character, const RigTrainConfig& config, uint32_t variants, uint64_t seed) {
  if (is_hands(config)) return hand_samples_of(character, variants, seed);
  if (config.architecture == "front") return front_samples_of(character, config, variants, seed);
  if (config.architecture == "slots") {
    const RigSource source(character);
    return samples_of(variants, seed,
                      [&](uint64_t own, double strength) { return make_slot_sample(source, own, strength); });
  }
  const RigSource source(character);
  return samples_of(variants, seed, [&](uint64_t own, double strength) {
    return source.make(own, draw_variant(config, own, strength));
  });
}

// Things that are no bodies, one sample for each `variant` and one more.
Samples thing_samples_of(const RigTrainConfig& config, uint32_t variants, uint64_t seed) {
  Samples samples;
  for (uint32_t v = 0; v <= variants; ++v) {
    const uint64_t own = mix_seeds(seed, v);
    const RigVariant variant = draw_variant(config, own, 1.0);
    samples.push_back(std::make_unique<RigSample>(make_thing_sample(own, variant.cells)));
  }
  return samples;
}

struct Request {
  std::string path, name;  // of a file, or
  BodyPlan plan = BodyPlan::kBiped;
  uint64_t seed = 0;
  bool thing = false;
  std::string family() const { return thing ? "thing" : path.empty() ? body_plan_name(plan) : family_of(name); }
};

// How many of each; a family that is drawn seldom per character needs fewer.
std::vector<uint32_t> count_variants(const std::vector<Request>& requests, const RigTrainConfig& config) {
  std::map<std::string, uint32_t> members;
  for (const Request& r : requests) ++members[r.family()];
  std::vector<uint32_t> counts;
  for (const Request& r : requests) {
    const double share = std::pow(members[r.family()], config.family_power - 1);
    const auto few = static_cast<uint32_t>(std::lround(config.variants * share));
    counts.push_back(config.least_variants == 0 ? config.variants
                                                : std::min(config.variants, std::max(few, config.least_variants)));
  }
  return counts;
}

Samples samples_of(const Request& r, const RigTrainConfig& config, uint32_t variants, uint64_t seed) {
  if (r.thing) return thing_samples_of(config, variants, seed);
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
  return samples_of(character, config, variants, seed);
}

// Where the samples of a request are kept: a name by all that they depend on.
//   index  of the request, which its seed is made of
std::string cached_at(const Request& r, const RigTrainConfig& config, uint32_t variants, size_t index,
                      const std::string& folder) {
  std::string content;
  if (!r.path.empty()) {
    for (const std::string& path : {r.path, rig_path_beside(r.path)}) {
      if (!is_file(path)) continue;
      const std::vector<uint8_t> bytes = read_file(path);
      content.append(bytes.begin(), bytes.end());
    }
  }
  RigTrainConfig relevant;  // what a run does with samples is nothing to them
  relevant.architecture = config.architecture;
  relevant.part = config.part;
  relevant.seed = config.seed;
  relevant.wide = config.wide;
  relevant.grown = config.grown;
  relevant.walls = config.walls;
  relevant.specks = config.specks;
  relevant.pictures = config.pictures;
  content += rig_config_json(relevant) + r.name + body_plan_name(r.plan) + (r.thing ? "thing" : "");
  const uint64_t settings = mix_seeds(mix_seeds(kSampleVersion, r.seed), index, variants);
  const std::string stem = r.thing ? "thing" : r.path.empty() ? std::string(body_plan_name(r.plan)) : stem_of(r.path);
  return (std::filesystem::path(folder) /
          (stem + "-" + cache_key(reinterpret_cast<const uint8_t*>(content.data()), content.size(), settings) +
           ".samples"))
      .string();
}

// variants  [requests]
std::vector<Samples> make_samples(const std::vector<Request>& requests, const RigTrainConfig& config,
                                  const std::vector<uint32_t>& variants, const std::string& cache, uint32_t threads,
                                  bool quiet) {
  std::vector<Samples> made(requests.size());
  std::atomic<size_t> done{0};
  std::filesystem::create_directories(cache);
  parallel_for(requests.size(), threads, [&](size_t i, unsigned) {
    try {
      const std::string path = cached_at(requests[i], config, variants[i], i, cache);
      if (std::optional<Samples> kept = read_rig_samples(path)) {
        made[i] = std::move(*kept);
      } else {
        made[i] = samples_of(requests[i], config, variants[i], mix_seeds(config.seed, i));
        write_rig_samples(path, made[i]);
      }
    } catch (const Error& error) {
      if (!quiet && !is_hands(config)) std::fprintf(stderr, "left out: %s\n", error.what());  // most have no hands
    }
    const size_t count = ++done;
    if (!quiet && (count % 50 == 0 || count == requests.size()))
      std::fprintf(stderr, "samples of %zu of %zu characters\n", count, requests.size());
  });
  std::erase_if(made, [](const Samples& samples) { return samples.empty(); });
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

RigTrainConfig front_train_config() {
  RigTrainConfig config;
  config.architecture = "front";
  config.rounds = 2;
  config.variants = 12;
  config.synthetic = 0;
  config.batch = 16;
  return config;
}

RigTrainConfig parse_rig_config(const std::string& json, const std::string& source) {
  RigTrainConfig config;
  read_settings(json, source, "", [&](auto&& visit) { visit_rig_settings(config, visit); });
  const Requirement require{source};
  check_run_settings(config, require);
  require(config.architecture == "votes" || config.architecture == "slots" || config.architecture == "front",
          "architecture", "\"votes\", \"slots\" or \"front\"");
  require(config.balance >= 0 && config.balance <= 1, "balance", "0 to 1");
  require(config.losses == "published" || config.losses == "balanced", "losses", "\"published\" or \"balanced\"");
  require(config.width >= 1 && config.width <= 256, "width", "1 to 256");
  require(config.rounds >= 2 && config.rounds <= 8, "rounds", "2 to 8");
  require(config.part == "body" || config.part == "hands", "part", "body or hands");
  require(config.part == "body" || config.architecture == "votes", "part",
          "body with the architectures slots and front");
  require(config.variants <= 64, "variants", "0 to 64");
  require(config.least_variants <= config.variants, "least_variants", "0 to variants");
  for (const auto& [name, share] :
       {std::pair("wide", config.wide), std::pair("grown", config.grown), std::pair("walls", config.walls),
        std::pair("specks", config.specks), std::pair("pictures", config.pictures)})
    require(share >= 0 && share <= 1, name, "0 to 1");
  require(config.synthetic <= 1000, "synthetic", "0 to 1000");
  require(config.things <= 1000, "things", "0 to 1000");
  require(config.things == 0 || (config.architecture == "votes" && config.part == "body"), "things",
          "0 but for votes of bodies");
  return config;
}

std::string rig_config_json(const RigTrainConfig& config) {
  return write_settings("", [&](auto&& visit) { visit_rig_settings(config, visit); });
}

void train_rig(const RigTrainConfig& config, const TrainOptions& options) {
  TrainOptions checked = options;
  checked.threads = std::max(options.threads, 1u);
  std::unique_ptr<const TrainingTask> task = std::make_unique<RigTask>(config);
  if (config.architecture == "slots") task = std::make_unique<SlotTask>(config);
  if (config.architecture == "front") task = std::make_unique<FrontTask>(config);
  const auto run_all = [&] {
    TrainingRun run(*task, config, checked);
    run.start();
    std::vector<Request> requests = character_requests(checked.data_dir, config.leave_out);
    std::erase_if(requests, [&](const Request& r) {  // families that are not drawn need no samples
      const auto& families = checked.leave_out;
      return std::find(families.begin(), families.end(), family_of(r.name)) != families.end();
    });
    const auto add_synthetic = [&](BodyPlan plan) {
      for (uint32_t i = 0; i < config.synthetic; ++i) requests.push_back({"", "", plan, 1000 + i});
    };
    for (const BodyPlan plan : kBodyPlans) add_synthetic(plan);
    for (const BodyPlan plan : kCreaturePlans) {
      // A plan that is younger than most configurations: those that do not name it train what they did.
      const bool asked = plan != BodyPlan::kMascot || config.family_shares.count(body_plan_name(plan)) != 0;
      if (asked) add_synthetic(plan);
    }
    for (uint32_t i = 0; i < config.things; ++i) {
      requests.push_back({});
      requests.back().thing = true;
    }
    const bool quiet = checked.quiet || (checked.ranks != nullptr && checked.ranks->rank() > 0);
    const std::string cache = checked.cache_dir.empty() ? checked.output + ".cache" : checked.cache_dir;
    const std::vector<Samples> characters =
        make_samples(requests, config, count_variants(requests, config), cache, checked.threads, quiet);
    std::vector<Samples> validation;
    if (!checked.val_dir.empty()) {
      const std::vector<Request> kept = character_requests(checked.val_dir, {});
      validation = make_samples(kept, config, std::vector<uint32_t>(kept.size(), 0), cache, checked.threads, quiet);
    }
    TrainingItems items;
    for (const Samples& samples : characters) {
      items.families.push_back(samples[0]->family);
      items.choices.emplace_back();
      for (const auto& sample : samples) items.choices.back().push_back(sample.get());
    }
    for (const Samples& samples : validation) items.validation.push_back(samples[0].get());
    run.load(items);
    run.go();
  };
  if (checked.ranks == nullptr) return run_all();
  checked.ranks->together(run_all);
}

}  // namespace sinew
