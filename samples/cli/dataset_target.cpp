// SPDX-License-Identifier: MIT
// sinew-lab dataset target: the target skeletons of characters as files.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <set>

#include "dataset.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sinew_data_sets/target_skeleton.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace fs = std::filesystem;

namespace sinew::cli {
namespace {

struct DatasetTargetCommandSettings {
  std::vector<std::string> inputs;
  std::string output, detail = "body";
};

std::string folder_of(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(path.has_parent_path() ? path.parent_path() : fs::path("."), ignored).string();
}

// One for each input, where eval looks for predictions. None lies beside a character, whose own skeleton it would
// replace, and no two are one.
std::vector<std::string> output_paths(const DatasetTargetCommandSettings& s, const std::vector<FoundCharacter>& found) {
  std::set<std::string> input_folders;
  for (const FoundCharacter& one : found) input_folders.insert(folder_of(one.path));
  std::vector<std::string> paths;
  std::map<std::string, std::string> input_of;
  for (const FoundCharacter& one : found) {
    paths.push_back((fs::path(s.output) / (one.name + ".rig.txt")).string());
    if (input_folders.count(folder_of(paths.back())) > 0)
      throw UsageError("-o " + s.output + ": " + paths.back() + " would lie among the inputs; give another folder");
    const auto [other, is_new] = input_of.emplace(paths.back(), one.path);
    if (!is_new) throw UsageError(one.path + " and " + other->second + " would both become " + paths.back());
  }
  return paths;
}

void write_target(const std::string& input, const std::string& output, bool hands, Progress* progress) {
  const Character character = read_character(input);
  TargetSkeleton target = target_skeleton(character);
  if (hands) target = with_fingers(character, std::move(target));
  Character skeleton;
  skeleton.joints = target_joints(target);
  make_folder(fs::path(output).parent_path().string());
  write_rig(output, skeleton);
  size_t ends = 0;
  for (const TargetJoint& joint : target.joints) ends += joint.tip ? 1 : 0;
  progress->say(stdout, print("%s: %zu joints and %zu bone ends, of %zu joints", output.c_str(),
                              target.joints.size() - ends, ends, target.owners.size()));
}

void make_targets(const DatasetTargetCommandSettings& s) {
  const std::vector<FoundCharacter> found = expand(s.inputs);
  const std::vector<std::string> outputs = output_paths(s, found);
  make_folder(s.output);
  size_t failed = 0;
  std::string first;
  {
    Progress progress(found.size(), "characters");
    for (size_t i = 0; i < found.size(); ++i) {
      try {
        write_target(found[i].path, outputs[i], s.detail == "hands", &progress);
      } catch (const Error& error) {
        if (failed++ == 0) first = error.what();
      }
      progress.step();
    }
  }
  if (failed > 0) throw Error(print("%zu of %zu characters failed; the first: ", failed, found.size()) + first);
}

}  // namespace

void add_dataset_target(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("target", "Write the target skeletons that eval rig compares with");
  auto s = std::make_shared<DatasetTargetCommandSettings>();
  sub->add_option("inputs", s->inputs, "Rigged characters and folders of them, sub-folders too")
      ->required()
      ->type_name("FILE|DIR");
  shared_option(sub, "-o,--output", s->output,
                "A folder for NAME.rig.txt of each: joints and their hierarchy, no weights")
      ->required();
  shared_option(sub, "--detail", s->detail,
                "body: what eval rig compares with; hands: with the fingers that eval hands compares with")
      ->check(CLI::IsMember({"body", "hands"}))
      ->capture_default_str();
  sub->footer(
      "Example:\n  sinew-lab dataset target characters/val -o targets\n\n"
      "The target skeleton has the joints that move the body: fingers, faces and twist bones belong to their parents,\n"
      "joints without a 0.2 % share of the mesh are left out, joints at one place are one. Every leaf has a bone end,\n"
      "a joint NAME_end below it.");
  sub->callback([s] { make_targets(*s); });
}

}  // namespace sinew::cli
