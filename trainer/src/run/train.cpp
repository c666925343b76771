// SPDX-License-Identifier: MIT
// Training for skin weights: the samples that a run draws from, characters and their augmented variants, through the cache; the
// task, the run.
#include "sinew_trainer/train.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

#include "data/sample_cache.hpp"
#include "features/features.hpp"
#include "network/networks.hpp"
#include "run/bind_task.hpp"
#include "run/settings.hpp"
#include "run/training_run.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/ranks.hpp"

namespace sinew {
namespace {

// Takes out samples none of whose vertices has reference weights, and names them on stderr unless `silent`.
void drop_unlabeled(std::vector<Sample>* samples, bool silent) {
  const auto unlabeled = [silent](const Sample& sample) {
    const bool labeled = std::any_of(sample.importance.begin(), sample.importance.end(), [](float i) { return i > 0; });
    if (!labeled && !silent)
      std::fprintf(stderr, "left out: %s: no vertex has reference weights\n", sample.name.c_str());
    return !labeled;
  };
  samples->erase(std::remove_if(samples->begin(), samples->end(), unlabeled), samples->end());
}

// Cache, feature settings and threads of a run.
SampleSource sample_source(const TrainConfig& config, const TrainOptions& options) {
  SampleSource source;
  source.candidates = config.field.candidates;
  source.grid = config.field.grid;
  source.feature_flags = feature_flags(config);
  source.seed = config.seed;
  source.cache_dir = options.cache_dir.empty() ? options.output + ".cache" : options.cache_dir;
  source.threads = std::max(options.threads, 1u);
  source.silent = options.ranks != nullptr && options.ranks->rank() > 0;
  source.quiet = options.quiet || source.silent;
  return source;
}

// The characters of a folder themselves, without variants.
std::vector<SampleRequest> character_requests(const std::string& folder) {
  const std::vector<std::string> paths = list_characters(folder), names = character_names(folder, paths);
  std::vector<SampleRequest> requests(paths.size());
  for (size_t i = 0; i < paths.size(); ++i) {
    requests[i].mesh_path = paths[i];
    requests[i].name = names[i];
  }
  return requests;
}

std::vector<SampleRequest> training_requests(const TrainConfig& config, const std::string& folder) {
  std::vector<SampleRequest> characters = character_requests(folder);
  std::erase_if(characters, [&](const SampleRequest& request) { return is_left_out(config.leave_out, request.name); });
  if (characters.empty()) throw Error(folder + ": no characters (NAME.obj with NAME.rig.txt, or .glb)");
  // Variants are optional extras: one that fails (say, because decimation leaves nothing) is only left out.
  std::vector<SampleRequest> requests;
  for (uint32_t variant = 0; variant <= (config.variant_share > 0 ? config.variants : 0); ++variant) {
    for (SampleRequest request : characters) {
      request.variant = variant;
      requests.push_back(std::move(request));
    }
  }
  for (const BodyPlan plan : kBodyPlans) {
    // Far from the small seeds that people look at and test with.
    for (uint32_t i = 0; i < config.synthetic; ++i) requests.push_back({"", "", 0, plan, 1000 + i});
  }
  return requests;
}

// Characters are made smaller for training only.
SampleSource training_source(const TrainConfig& config, const TrainOptions& options) {
  SampleSource source = sample_source(config, options);
  source.vertex_limit = config.vertex_limit;
  return source;
}

}  // namespace

size_t fill_feature_cache(const TrainConfig& config, const TrainOptions& options, uint32_t part, uint32_t parts) {
  size_t made = fill_cache(training_requests(config, options.data_dir), training_source(config, options), part, parts);
  if (options.val_dir.empty()) return made;
  return made + fill_cache(character_requests(options.val_dir), sample_source(config, options), part, parts);
}

TrainingSet load_training_set(const TrainConfig& config, const TrainOptions& options) {
  const std::vector<SampleRequest> requests = training_requests(config, options.data_dir);
  const SampleSource source = training_source(config, options);
  std::vector<Sample> samples = load_requests(requests, source);
  drop_unlabeled(&samples, source.silent);
  TrainingSet set;
  std::map<std::string, size_t> by_name;
  for (Sample& sample : samples) {
    const auto [at, fresh] = by_name.try_emplace(sample.name, set.characters.size());
    if (fresh) {
      set.characters.emplace_back();
      set.families.push_back(sample.family);
    }
    set.characters[at->second].push_back(std::move(sample));
  }
  if (set.characters.empty()) throw Error(options.data_dir + ": no character has reference weights");
  return set;
}

std::vector<Sample> load_samples(const std::string& folder, uint32_t candidates, uint32_t grid,
                                 const std::string& cache_dir, uint32_t threads, bool quiet, uint32_t feature_flags) {
  const std::vector<SampleRequest> requests = character_requests(folder);
  if (requests.empty()) throw Error(folder + ": no characters (NAME.obj with NAME.rig.txt, or .glb)");
  SampleSource source;
  source.candidates = candidates;
  source.grid = grid;
  source.cache_dir = cache_dir;
  source.threads = threads;
  source.quiet = quiet;
  source.feature_flags = feature_flags;
  return load_requests(requests, source);
}

namespace {

std::vector<Sample> load_validation(const TrainConfig& config, const TrainOptions& options) {
  if (options.val_dir.empty()) return {};
  const SampleSource source = sample_source(config, options);
  std::vector<Sample> samples = load_samples(options.val_dir, source.candidates, source.grid, source.cache_dir,
                                             source.threads, source.quiet, source.feature_flags);
  drop_unlabeled(&samples, source.silent);
  return samples;
}

void run_with(const TrainConfig& config, const TrainOptions& options, const TrainingSet* set) {
  TrainOptions checked = options;
  checked.threads = std::max(options.threads, 1u);
  const BindTask task(config);
  const auto run_all = [&] {
    TrainingRun run(task, config, checked);
    run.start();
    TrainingSet loaded;
    if (set == nullptr) {
      if (checked.ranks != nullptr && checked.ranks->size() > 1) {  // what is not in the cache, together
        checked.ranks->together(
            [&] { fill_feature_cache(config, checked, checked.ranks->rank(), checked.ranks->size()); });
      }
      loaded = load_training_set(config, checked);
    }
    const TrainingSet& used = set == nullptr ? loaded : *set;
    const std::vector<Sample> validation = load_validation(config, checked);
    TrainingItems items;
    items.families = used.families;
    for (const std::vector<Sample>& character : used.characters) {
      items.choices.emplace_back();
      for (const Sample& sample : character) items.choices.back().push_back(&sample);
    }
    for (const Sample& sample : validation) items.validation.push_back(&sample);
    run.load(items);
    run.go();
  };
  if (checked.ranks == nullptr) return run_all();
  checked.ranks->together(run_all);
}

}  // namespace

void train(const TrainConfig& config, const TrainOptions& options) { run_with(config, options, nullptr); }

void train(const TrainConfig& config, const TrainOptions& options, const TrainingSet& set) {
  run_with(config, options, &set);
}

void change_correction(double correction, const std::string& source, Checkpoint* checkpoint) {
  if (checkpoint->state.config_json.empty())
    throw Error(source + ": its configuration lacks the share of the correction");
  TrainConfig config = parse_train_config(checkpoint->state.config_json, source);
  if (config.architecture != "field") throw Error(source + ": only networks of the architecture field correct heat");
  checkpoint->network = shrink_correction(checkpoint->network, correction / config.correction, kPairLogRule);
  config.correction = correction;
  checkpoint->state.config_json = train_config_json(parse_train_config(train_config_json(config), source));
}

TrainConfig checkpoint_config(const std::string& path) {
  return parse_train_config(read_checkpoint(path).state.config_json, path);
}

}  // namespace sinew
