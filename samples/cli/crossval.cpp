// SPDX-License-Identifier: MIT
// sinew-lab crossval: trains with whole family groups left out and measures on them; compares such runs.
#include "sinew_trainer/crossval.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "commands.hpp"
#include "options.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_quant/quantize.hpp"
#include "sinew_trainer/engine_network.hpp"
#include "sinew_trainer/network.hpp"
#include "sinew_trainer/ranks.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

struct CrossvalCommandSettings {
  CrossvalOptions options;
  std::string config, groups;
  std::vector<std::string> compare;
  uint64_t steps = 0;
  bool int16 = false;
};

// The network as the engine runs it, calibrated on characters of the fold's training.
LogitsFunction engine_runner(const FloatNetwork& network, const std::vector<const Sample*>& samples) {
  std::vector<Sample> copies;
  for (const Sample* sample : samples) copies.push_back(*sample);
  const QuantizedModel quantized = quantize(network, calibrate(network, copies), {});
  std::shared_ptr<LoadedModel> model = model_from_bytes(quantized.bytes, "the quantized network");
  return [model](const Sample& sample) { return engine_logits(model->model, sample); };
}

void run_crossval(CrossvalCommandSettings s) {
  if (!s.compare.empty()) {
    if (!s.options.data_dir.empty()) throw UsageError("DIR trains, --compare reads finished runs: give one of them");
    std::vector<CrossvalReport> reports;
    for (const std::string& path : s.compare) reports.push_back(read_crossval(path));
    std::printf("%s", crossval_comparison(reports).c_str());
    return;
  }
  if (s.options.data_dir.empty())
    throw UsageError("DIR is required: a folder of FAMILY__NAME.obj with .rig.txt, or of .glb files");
  if (Ranks().size() > 1)
    throw UsageError("crossval runs its folds in parallel without mpirun; on several machines give each its --fold");
  if (s.steps > 0 && s.options.minutes > 0) throw UsageError("--steps and --minutes exclude each other; give one");
  TrainConfig config;
  if (!s.config.empty()) config = parse_train_config(read_text_file(s.config), s.config);
  if (s.steps > 0) config.steps = s.steps;
  const std::string name = s.config.empty() ? "defaults" : stem_of(s.config);
  if (s.options.folder.empty()) s.options.folder = "crossval-" + name;
  if (s.options.label.empty()) s.options.label = name;
  if (!s.groups.empty()) s.options.groups = read_family_groups(s.groups);
  if (s.int16) {
    s.options.arithmetic = "int16";
    s.options.logits = engine_runner;
  }
  s.options.stop = &stop_on_signals();
  const CrossvalReport report = crossval(config, s.options);
  if (!report.seeds.empty()) std::printf("%s", crossval_markdown(report).c_str());
  if (*s.options.stop) {
    throw Error("stopped; continue with: sinew-lab crossval ... -o " + s.options.folder + " --resume");
  }
}

}  // namespace

void add_crossval(CLI::App& app) {
  CLI::App* sub =
      app.add_subcommand("crossval", "Train with families left out and evaluate on them; compare such runs");
  auto s = std::make_shared<CrossvalCommandSettings>();
  CrossvalOptions& o = s->options;
  o.threads = std::max(1u, std::thread::hardware_concurrency());
  sub->add_option("dir", o.data_dir, "Folder of FAMILY__NAME.obj + .rig.txt pairs and .glb files")->type_name("DIR");
  shared_option(sub, "-o,--output", o.folder, "Folder for checkpoints and figures")->default_str("crossval-CONFIG");
  shared_option(sub, "--config", s->config);
  sub->add_option("--folds", o.fold_count, "Number of parts of the family groups")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str()
      ->type_name("N");
  shared_option(sub, "--groups", s->groups, "By default mh_* together, others by name without trailing digits");
  shared_option(sub, "--val", o.val_dir, "Evaluate on them an additional run per seed that leaves nothing out");
  shared_flag(sub, "--resume", o.resume, "Of FOLDER: keep finished folds, continue stopped ones");
  shared_option(sub, "--steps", s->steps, "Per fold; by default the configuration's")->check(CLI::PositiveNumber);
  shared_option(sub, "--minutes", o.minutes, "Per fold; by default limited by steps")->check(CLI::PositiveNumber);
  sub->add_option("--compare", s->compare, "Print one table of finished runs: FOLDERs or their crossval.json")
      ->type_name("RUN");
  section(sub, "Choice of runs");
  sub->add_option(
         "--leave-out", o.leave_out,
         "Deal out only the groups of this mean of --groups, and train on all others always. By default all groups")
      ->type_name("MEAN");
  sub->add_option("--reuse", o.from,
                  "Reuse the networks of this finished run with the configuration's correction, without training")
      ->type_name("RUN");
  sub->add_option("--seeds", o.seed_count, "Number of runs per fold: the configuration's seed and the next ones")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str()
      ->type_name("N");
  sub->add_option("--fold", o.only_fold, "Run only this fold, from 1. By default all")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  sub->add_flag("--int16", s->int16, "Evaluate the quantized network in the engine's arithmetic, not float");
  section(sub, "Other options");
  shared_option(sub, "--cache", o.cache_dir)->default_str("FOLDER/cache");
  shared_option(sub, "--threads", o.threads, "Total of all folds")->check(CLI::Range(1, 256))->capture_default_str();
  sub->add_option("--at-once", o.at_once, "Number of folds to run in parallel. By default one per thread")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  shared_option(sub, "--label", o.label, "By default the configuration's");
  shared_flag(sub, "--quiet", o.quiet);
  sub->footer(
      "FOLDER gets crossval.md, crossval.csv and crossval.json; the table goes to standard output.\n"
      "Examples:\n"
      "  sinew-lab crossval characters/train --groups trainer/configs/groups.json -o base\n"
      "  sinew-lab crossval --compare base wide\n\n"
      "  sinew-lab crossval characters/train --groups groups.json --leave-out old --folds 2 -o quick\n"
      "  sinew-lab crossval characters/train --config wide.json --groups groups.json -o wide --seeds 2");
  sub->callback([s] { run_crossval(*s); });
}

}  // namespace sinew::cli
