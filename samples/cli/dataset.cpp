// SPDX-License-Identifier: MIT
// sinew-lab dataset: the subcommands together; characters made from a seed.
#include "sinew_data_sets/dataset.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "commands.hpp"
#include "options.hpp"
#include "sinew_data_sets/synthesize.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"

namespace fs = std::filesystem;

namespace sinew::cli {
namespace {

struct SynthesizeSettings {
  std::string output, plan = "characters";
  uint64_t seed = 1;
  unsigned count = 1;
  int resolution = 48;
  bool no_clothing = false;
};

void synthesize_all(const SynthesizeSettings& s) {
  std::vector<BodyPlan> chosen;
  for (BodyPlan plan : kBodyPlans) {
    if (s.plan == "characters" || s.plan == "all" || s.plan == body_plan_name(plan)) chosen.push_back(plan);
  }
  for (BodyPlan plan : kCreaturePlans) {
    if (s.plan == "creatures" || s.plan == "all" || s.plan == body_plan_name(plan)) chosen.push_back(plan);
  }
  const bool one_file = has_use(s.output, kWritesWithMesh);
  if (one_file) {
    if (chosen.size() * s.count != 1)
      throw UsageError("one output file holds one character; give --plan and no --count, or a folder as output");
    check_output(s.output, kWritesWithMesh);
  } else {
    make_folder(s.output);
  }
  for (BodyPlan plan : chosen) {
    for (unsigned i = 0; i < s.count; ++i) {
      SynthesizeOptions options;
      options.plan = plan;
      options.seed = s.seed + i;
      options.resolution = s.resolution;
      options.clothing = !s.no_clothing;
      Character character = synthesize(options);
      const std::string path = one_file ? s.output : (fs::path(s.output) / (character.name + ".obj")).string();
      character.name = stem_of(path);
      write_character(path, character);
      std::printf("%s: %s, seed %llu, %zu vertices, %zu joints\n", path.c_str(), body_plan_name(plan),
                  static_cast<unsigned long long>(options.seed), character.vertices.size(), character.joints.size());
    }
  }
}

void add_synthesize(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("synthesize", "Make synthetic characters with exact weights from a seed");
  auto s = std::make_shared<SynthesizeSettings>();
  shared_option(sub, "-o,--output", s->output, "Folder, or one file: " + extensions_text(kWritesWithMesh))->required();
  std::vector<std::string> plans = {"characters", "creatures", "all"};
  for (BodyPlan plan : kBodyPlans) plans.push_back(body_plan_name(plan));
  for (BodyPlan plan : kCreaturePlans) plans.push_back(body_plan_name(plan));
  sub->add_option("--plan", s->plan, "Body plan; \"characters\": the five with clothes, \"creatures\": the others")
      ->type_name("PLAN")
      ->check(CLI::IsMember(plans))
      ->capture_default_str();
  shared_option(sub, "--seed", s->seed, "Of the first character")->capture_default_str();
  sub->add_option("--count", s->count, "Characters per plan, with consecutive seeds")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str()
      ->type_name("N");
  sub->add_option("--resolution", s->resolution, "Number of voxels along the longest side")
      ->check(CLI::Range(24, 256))
      ->capture_default_str()
      ->type_name("N");
  sub->add_flag("--no-clothing", s->no_clothing, "Make bodies without clothes");
  sub->footer(
      "Examples:\n  sinew-lab dataset synthesize --count 20 -o made\n  sinew-lab dataset synthesize --plan biped "
      "--seed 2 -o "
      "hero.obj");
  sub->callback([s] { synthesize_all(*s); });
}

}  // namespace

void add_dataset(CLI::App& app) {
  CLI::App* sub = app.add_subcommand("dataset", "Check, describe, split, convert, decimate and make characters");
  sub->require_subcommand(1);
  sub->footer("Example:\n  sinew-lab dataset stats characters/train");
  add_dataset_check(sub);
  add_dataset_stats(sub);
  add_dataset_dedup(sub);
  add_dataset_split(sub);
  add_dataset_target(sub);
  add_dataset_convert(sub);
  add_dataset_decimate(sub);
  add_synthesize(sub);
}

}  // namespace sinew::cli
