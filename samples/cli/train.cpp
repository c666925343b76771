// SPDX-License-Identifier: MIT
// sinew train: a folder of rigged characters in, a float checkpoint out.
#include "sinew_trainer/train.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "commands.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

std::atomic<bool> stop_requested = false;

struct Settings {
  TrainOptions options;
  std::string config;
  bool print_config = false;
};

void run(Settings s) {
  TrainConfig config;
  if (!s.config.empty()) {
    const std::vector<uint8_t> bytes = read_file(s.config);
    config = parse_train_config(std::string(bytes.begin(), bytes.end()), s.config);
  }
  if (s.print_config) {
    std::printf("%s\n", train_config_json(config).c_str());
    return;
  }
  if (s.options.data_dir.empty())
    throw UsageError("DIR is required: a folder of NAME.obj with NAME.rig.txt, or of .glb files");
  if (s.options.output.empty()) throw UsageError("-o CKPT is required");
  if (s.options.resume && !s.options.init.empty())
    throw UsageError("--resume goes on from -o, --init starts anew: give one of them");
  check_output(s.options.output, {".sinewckpt", ".ckpt"});
  if (s.options.resume && s.config.empty()) config = checkpoint_config(s.options.output);
  // Ctrl-C ends the run after its step, with everything on disk that --resume needs.
  TrainOptions options = s.options;
  options.stop = &stop_requested;
  std::signal(SIGINT, [](int) { stop_requested = true; });
  train(config, options);
  if (stop_requested)
    std::fprintf(stderr, "\nstopped; go on with: sinew train ... -o %s --resume\n", s.options.output.c_str());
}

}  // namespace

void add_train(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("train", "Train a float network on rigged characters");
  auto s = std::make_shared<Settings>();
  s->options.threads = std::max(1u, std::thread::hardware_concurrency());
  sub->add_option("dir", s->options.data_dir, "Folder of NAME.obj + NAME.rig.txt pairs and .glb files")
      ->type_name("DIR");
  sub->add_option("-o,--output", s->options.output,
                  "Checkpoint to write (.sinewckpt or .ckpt); the log goes beside it as .csv")
      ->type_name("CKPT");
  sub->add_option("--val", s->options.val_dir, "Folder that the best checkpoint is chosen on")->type_name("DIR");
  sub->add_option("--config", s->config,
                  "Settings that differ from the defaults, as JSON [with --resume: those of CKPT]")
      ->type_name("FILE");
  sub->add_flag("--print-config", s->print_config, "Print all settings as JSON and stop");
  sub->add_flag("--resume", s->options.resume, "Go on from the checkpoint -o, with the same result as not stopping");
  sub->add_option("--init", s->options.init, "Start from the weights of this checkpoint")->type_name("CKPT");
  sub->add_option("--minutes", s->options.minutes, "Stop after so many minutes [by steps]")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  sub->add_option("--cache", s->options.cache_dir, "Folder for computed features [CKPT.cache]")->type_name("DIR");
  sub->add_option("--threads", s->options.threads, "Threads")
      ->check(CLI::Range(1, 256))
      ->capture_default_str()
      ->type_name("N");
  sub->add_flag("--quiet", s->options.quiet, "No progress bar");
  sub->footer(
      "Example:\n  sinew train characters/train --val characters/val -o run.sinewckpt --minutes 60\n"
      "then\n  sinew quantize run.sinewckpt --calibrate characters/train -o run.sinew");
  sub->callback([s] { run(*s); });
}

}  // namespace sinew::cli
