// SPDX-License-Identifier: MIT
// Training for skin weights: the samples of a folder, the task, the run.
#include "sinew_trainer/train.hpp"

#include <algorithm>

#include "features/features.hpp"
#include "network/networks.hpp"
#include "run/bind_task.hpp"
#include "run/training_run.hpp"
#include "run/training_set.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

std::vector<Sample> load_validation(const TrainConfig& config, const TrainOptions& options) {
  if (options.val_dir.empty()) return {};
  const SampleSource source = sample_source(config, options);
  std::vector<Sample> samples = load_samples(options.val_dir, source.candidates, source.grid, source.cache_dir,
                                             source.threads, source.quiet, source.feature_flags);
  drop_unlabelled(&samples, source.silent);
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
    throw Error(source + ": no configuration in it tells how much of the correction it has");
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
