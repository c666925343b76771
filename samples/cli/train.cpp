// SPDX-License-Identifier: MIT
// sinew-lab train: a folder of rigged characters in, a float checkpoint out.
#include "sinew_trainer/train.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "commands.hpp"
#include "options.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_trainer/ranks.hpp"
#include "sinew_trainer/rig_train.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

struct TrainCommandSettings {
  TrainOptions options;
  std::string config, task = "bind";
  std::string shard, release;
  uint64_t steps = 0;
  bool print_config = false, cache_only = false, threads_given = false;
};

// "2/5" -> {1, 5}: the second of five.
std::pair<uint32_t, uint32_t> parse_shard(const std::string& text) {
  unsigned part = 0, parts = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%u/%u%c", &part, &parts, &rest) != 2 || part < 1 || part > parts || parts > 100000)
    throw UsageError("--shard: expected I/N with I from 1 to N, found " + text);
  return {part - 1, parts};
}

void fill_cache(const TrainCommandSettings& s, const TrainConfig& config, const TrainOptions& options,
                const Ranks& ranks) {
  std::pair<uint32_t, uint32_t> shard = {ranks.rank(), ranks.size()};
  if (!s.shard.empty()) shard = parse_shard(s.shard);
  const size_t made = fill_feature_cache(config, options, shard.first, shard.second);
  if (ranks.size() > 1) {
    std::printf("%s: rank %u made %zu samples\n", options.cache_dir.c_str(), ranks.rank(), made);
  } else {
    std::printf("%s: %zu samples made\n", options.cache_dir.c_str(), made);
  }
}

void say_next(const TrainOptions& options) {
  const Checkpoint checkpoint = read_checkpoint(options.output);
  const TrainingState& state = checkpoint.state;
  std::string line = print("wrote %s: %llu steps in %.0f s", options.output.c_str(),
                           static_cast<unsigned long long>(state.step), state.seconds);
  if (state.best_score < 1e9) line += print(", best score %.4f on val", state.best_score);
  std::printf("%s; log %s.csv\n", line.c_str(), options.output.c_str());
  const std::string model = std::filesystem::path(options.output).replace_extension(".sinew").string();
  std::printf("next: sinew-lab quantize %s --calibrate %s -o %s\n", options.output.c_str(), options.data_dir.c_str(),
              model.c_str());
}

void say_end(const TrainCommandSettings& s, const TrainOptions& options, const Ranks& ranks) {
  if (ranks.rank() > 0) return;
  if (!s.release.empty() && !*options.stop) {
    Checkpoint weights;
    weights.network = read_checkpoint(options.output).network;
    write_checkpoint(s.release, weights);
  }
  if (*options.stop) {
    std::fprintf(stderr, "\nstopped; go on with: sinew-lab train ... -o %s --resume\n", options.output.c_str());
  } else if (!options.quiet) {
    say_next(options);
  }
}

void run_rig(const TrainCommandSettings& s, TrainOptions options, Ranks* ranks) {
  RigTrainConfig config;
  if (s.task == "front") config = front_train_config();
  if (!s.config.empty()) config = parse_rig_config(read_text_file(s.config), s.config);
  if (options.resume && s.config.empty())
    config = parse_rig_config(read_checkpoint(options.output).state.config_json, options.output);
  if (s.steps > 0) config.steps = s.steps;
  if ((config.architecture == "front") != (s.task == "front"))
    throw UsageError("--task " + s.task + ": the configuration is of the architecture " + config.architecture);
  if (s.print_config) {
    if (ranks->rank() == 0) std::printf("%s\n", rig_config_json(config).c_str());
    return;
  }
  if (s.cache_only)
    throw UsageError("--cache-only: the run itself makes the samples of --task " + s.task +
                     " , and keeps them in --cache; leave it out");
  check_output(options.output, {".sinewckpt", ".ckpt"});
  options.stop = &stop_on_signals();
  train_rig(config, options);
  say_end(s, options, *ranks);
}

// Under mpirun every rank comes here with the same command line.
void run_ranks(const TrainCommandSettings& s, Ranks* ranks) {
  if (s.task != "bind") {
    TrainOptions options = s.options;
    options.ranks = ranks;
    if (!s.threads_given) options.threads = std::max(1u, options.threads / ranks->local_size());
    return run_rig(s, options, ranks);
  }
  TrainConfig config;
  if (!s.config.empty()) config = parse_train_config(read_text_file(s.config), s.config);
  TrainOptions options = s.options;
  if (options.resume && s.config.empty()) config = checkpoint_config(options.output);
  if (s.steps > 0) config.steps = s.steps;
  if (s.print_config) {
    if (ranks->rank() == 0) std::printf("%s\n", train_config_json(config).c_str());
    return;
  }
  options.ranks = ranks;
  if (!s.threads_given) options.threads = std::max(1u, options.threads / ranks->local_size());
  if (s.cache_only) return fill_cache(s, config, options, *ranks);
  check_output(options.output, {".sinewckpt", ".ckpt"});
  options.stop = &stop_on_signals();
  train(config, options);
  say_end(s, options, *ranks);
}

void run_train(const TrainCommandSettings& s) {
  if (s.options.data_dir.empty() && !s.print_config)
    throw UsageError("DIR is required: a folder of NAME.obj with NAME.rig.txt, or of .glb files");
  if (s.cache_only && s.options.cache_dir.empty()) throw UsageError("--cache-only needs --cache DIR");
  if (!s.shard.empty() && !s.cache_only) throw UsageError("--shard needs --cache-only");
  if (!s.shard.empty()) parse_shard(s.shard);
  if (s.options.output.empty() && !s.print_config && !s.cache_only) throw UsageError("-o CKPT is required");
  if (!s.release.empty()) {
    check_output(s.release, {".sinewckpt", ".ckpt"});
    if (s.release == s.options.output)
      throw UsageError("--release: give another file than -o, which --resume continues from");
  }
  if (s.options.resume && !s.options.init.empty())
    throw UsageError("--resume continues -o, --init starts anew; give one of them");
  Ranks ranks;
  ranks.together([&] { run_ranks(s, &ranks); });
}

void add_train_inputs(CLI::App* sub, TrainCommandSettings* s) {
  sub->add_option("dir", s->options.data_dir, "Folder of NAME.obj + NAME.rig.txt pairs and .glb files, with subfolders")
      ->type_name("DIR");
  sub->add_option("--task", s->task,
                  "Network to train: bind = skin weights, rig = a skeleton for a bare mesh, front = the direction that "
                  "a mesh faces")
      ->type_name("TASK")
      ->check(CLI::IsMember({"bind", "rig", "front"}))
      ->capture_default_str();
  shared_option(sub, "-o,--output", s->options.output,
                "Checkpoint (.sinewckpt or .ckpt), with its log beside it as .csv");
  shared_option(sub, "--val", s->options.val_dir, "The best checkpoint is chosen on them");
  shared_option(sub, "--config", s->config, "With --resume: by default those of CKPT");
  shared_option(sub, "--minutes", s->options.minutes, "By default limited by steps")->check(CLI::PositiveNumber);
  shared_option(sub, "--steps", s->steps, "By default the configuration's")->check(CLI::PositiveNumber);
  shared_flag(sub, "--resume", s->options.resume, "From the checkpoint -o");
  sub->add_option("--init", s->options.init, "Start from the weights of this checkpoint or model (.sinew)")
      ->type_name("FILE");
}

CLI::Option* add_rest(CLI::App* sub, TrainCommandSettings* s) {
  sub->add_flag("--print-config", s->print_config, "Print the configuration as JSON and stop");
  shared_flag(sub, "--quiet", s->options.quiet);
  section(sub, "Features");
  shared_option(sub, "--cache", s->options.cache_dir)->default_str("CKPT.cache");
  sub->add_flag("--cache-only", s->cache_only,
                "Fill --cache for DIR and --val and stop; any number of processes in parallel");
  sub->add_option("--shard", s->shard, "With --cache-only: begin with part I of N. By default one part")
      ->type_name("I/N");
  section(sub, "Other options");
  shared_option(sub, "--release", s->release);
  return shared_option(sub, "--threads", s->options.threads,
                       "Per rank under mpirun; by default the cores divided by the ranks")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
}

}  // namespace

void add_train(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("train", "Train a float network on rigged characters");
  auto s = std::make_shared<TrainCommandSettings>();
  s->options.threads = std::max(1u, std::thread::hardware_concurrency());
  add_train_inputs(sub, s.get());
  CLI::Option* const threads = add_rest(sub, s.get());
  sub->footer(
      "Example:\n  sinew-lab train characters/train --val characters/val -o run.sinewckpt --minutes 60\nthen\n  "
      "sinew-lab quantize run.sinewckpt --calibrate characters/train -o run.sinew\n\nSeveral ranks share each batch "
      "and give the same checkpoint as one; all need the same files:\n  mpirun -n 2 sinew-lab train characters/train "
      "-o run.sinewckpt\nFeatures from two processes in parallel:\n  sinew-lab train characters/train --cache cache "
      "--cache-only --shard 1/2 &\n  sinew-lab train characters/train --cache cache --cache-only --shard 2/2");
  sub->callback([s, threads] {
    s->threads_given = threads->count() > 0;
    run_train(*s);
  });
}

}  // namespace sinew::cli
