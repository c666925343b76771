// SPDX-License-Identifier: MIT
// sinew-lab dataset convert, decimate and target: characters in other formats, one or a folder of them for training; their
// target skeletons.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "commands.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sinew_data_sets/dataset.hpp"
#include "sinew_data_sets/target_skeleton.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "support.hpp"

namespace fs = std::filesystem;

namespace sinew::cli {
namespace {

struct DatasetConvertCommandSettings {
  std::string input, skeleton, output, format;
  double ratio = 0;
};

void convert_one(const DatasetConvertCommandSettings& s) {
  check_output(s.output, kWritesCharacter, true);
  if (!s.format.empty()) throw UsageError("--format needs a folder of characters, and " + s.input + " is not a folder");
  if (has_extension(s.input, ".obj") && has_extension(s.skeleton, ".obj"))
    throw UsageError("--skeleton " + s.skeleton + ": an OBJ holds no skeleton; expected a .rig.txt");
  Character character = read_any(s.input);
  if (!s.skeleton.empty()) read_skeleton(s.skeleton, true, &character);
  if (s.ratio > 0) character = decimate(character, s.ratio);
  if (!has_extension(s.output, ".obj") && character.joints.empty()) {
    throw Error(s.input + ": has no skeleton, but " + (s.output == "-" ? std::string("a rig") : s.output) +
                " needs one; give --skeleton FILE");
  }
  write_character(s.output, character);
  if (s.output != "-") {
    std::printf("%s: %zu vertices, %zu faces, %zu joints, wrote %s\n", character.name.c_str(),
                character.vertices.size(), character.face_count(), character.joints.size(), s.output.c_str());
    for (const std::string& note : character.notes) std::printf("%s\n", note.c_str());
  }
}

// A training set's name: FAMILY__NAME as it is; else the folders it lies in are its family.
std::string set_name(const FoundCharacter& found) {
  const std::string name = stem_of(found.path);
  if (name.find("__") != std::string::npos || found.below.empty()) return name;
  std::string family;
  for (const fs::path& folder : fs::path(found.below)) family += (family.empty() ? "" : "_") + folder.string();
  return family + "__" + name;
}

std::vector<std::string> set_paths(const DatasetConvertCommandSettings& s, const std::vector<FoundCharacter>& found) {
  const std::string extension = "." + (s.format.empty() ? std::string("obj") : s.format);
  std::map<std::string, std::string> input_of;
  std::vector<std::string> paths;
  for (const FoundCharacter& one : found) {
    paths.push_back((fs::path(s.output) / (set_name(one) + extension)).string());
    const auto [other, is_new] = input_of.emplace(paths.back(), one.path);
    if (!is_new)
      throw Error(other->second + " and " + one.path + " would both become " + paths.back() + "; rename one of them");
  }
  return paths;
}

// Inputs are never replaced, nor found again by the next run.
void refuse_output_inside(const DatasetConvertCommandSettings& s) {
  std::error_code ignored;
  const fs::path in = fs::weakly_canonical(fs::absolute(s.input), ignored);
  const std::string below = fs::weakly_canonical(fs::absolute(s.output), ignored).lexically_relative(in).string();
  if (below.empty() || below.rfind("..", 0) != 0)
    throw UsageError("-o " + s.output + ": lies inside " + s.input + "; give another folder");
}

void convert_folder(const DatasetConvertCommandSettings& s) {
  if (!s.skeleton.empty()) throw UsageError("--skeleton takes one character, but " + s.input + " is a folder");
  refuse_output_inside(s);
  const std::vector<FoundCharacter> found = characters_in(s.input);
  const std::vector<std::string> paths = set_paths(s, found);
  make_folder(s.output);
  size_t failed = 0;
  Progress progress(found.size(), "characters");
  for (size_t i = 0; i < found.size(); ++i) {
    try {
      Character character = read_character(found[i].path);
      if (character.influences.empty()) throw Error(found[i].path + ": has no skin weights to train on");
      character.name = stem_of(paths[i]);
      write_character(paths[i], character);
      progress.say(stdout, print("%s: %zu vertices, %zu joints from ", printable(paths[i]).c_str(),
                                 character.vertices.size(), character.joints.size()) +
                               printable(found[i].path));
      for (const std::string& note : character.notes) progress.say(stdout, "  " + printable(note));
    } catch (const Error& error) {
      ++failed;
      progress.say(stderr, "sinew: error: " + printable(error.what()));
    }
    progress.step();
  }
  check_failed(failed, found.size(), "characters");
}

void convert(const DatasetConvertCommandSettings& s) {
  std::error_code ignored;
  fs::is_directory(s.input, ignored) ? convert_folder(s) : convert_one(s);
}

std::string written_files() {
  return extensions_text(kWritesCharacter) + " (an .obj with its .rig.txt); - for rig.txt on standard output";
}

}  // namespace

void add_dataset_convert(CLI::App* parent) {
  CLI::App* sub =
      parent->add_subcommand("convert", "Convert characters to another format: one, or a folder for training");
  auto s = std::make_shared<DatasetConvertCommandSettings>();
  sub->add_option("input", s->input,
                  "Character, or a folder of them with subfolders. " + mesh_files() +
                      "; NAME.rig.txt beside NAME.obj is read too")
      ->required()
      ->type_name("IN|DIR");
  shared_option(sub, "output,-o,--output", s->output,
                written_files() + "; for a folder, a folder that gets FAMILY__NAME for FAMILY/NAME")
      ->required();
  shared_option(sub, "--skeleton", s->skeleton, "With its weights");
  shared_option(sub, "--format", s->format, "For a folder; obj comes with .rig.txt")
      ->check(CLI::IsMember(format_names(kWritesWithMesh)))
      ->default_str("obj");
  sub->footer(
      "Examples:\n  sinew-lab dataset convert hero.obj hero.glb\n"
      "  sinew-lab dataset convert studio -o characters && sinew-lab train characters -o studio.ckpt");
  sub->callback([s] { convert(*s); });
}

void add_dataset_decimate(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("decimate", "Reduce the vertices of a character, with its weights");
  auto s = std::make_shared<DatasetConvertCommandSettings>();
  sub->add_option("input", s->input, "Character. " + mesh_files() + "; NAME.rig.txt beside NAME.obj is read too")
      ->required()
      ->type_name("IN");
  shared_option(sub, "output,-o,--output", s->output, written_files())->required();
  shared_option(sub, "--skeleton", s->skeleton, "With its weights");
  sub->add_option("--ratio", s->ratio, "Share of the vertices to keep")
      ->required()
      ->check(CLI::Range(0.01, 1.0))
      ->type_name("X");
  sub->footer("Example:\n  sinew-lab dataset decimate hero.obj hero_small.obj --ratio 0.5");
  sub->callback([s] { convert_one(*s); });
}

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
      throw UsageError("-o " + s.output + ": " + paths.back() + " lies among the inputs; give another folder");
    const auto [other, is_new] = input_of.emplace(paths.back(), one.path);
    if (!is_new)
      throw UsageError(one.path + " and " + other->second + " would both become " + paths.back() +
                       "; rename one of them");
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
  check_failed(failed, found.size(), "characters", first);
}

}  // namespace

void add_dataset_target(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("target", "Write the reference skeletons of eval rig");
  auto s = std::make_shared<DatasetTargetCommandSettings>();
  sub->add_option("inputs", s->inputs, "Rigged characters, or folders of them with subfolders")
      ->required()
      ->type_name("FILE|DIR");
  shared_option(sub, "-o,--output", s->output,
                "Folder for a NAME.rig.txt of each: joints and hierarchy without weights")
      ->required();
  shared_option(sub, "--detail", s->detail,
                "body: the reference of eval rig; hands: with fingers, the reference of eval hands")
      ->check(CLI::IsMember({"body", "hands"}))
      ->capture_default_str();
  sub->footer(
      "Example:\n  sinew-lab dataset target characters/val -o targets\n\nThe reference skeleton has the joints that "
      "move the body: fingers, faces and twist bones are merged into their\nparents, joints with less than a 0.2 % "
      "share of the mesh are left out, joints at one position are merged. Each leaf\nhas a bone end, a joint NAME_end "
      "below it.");
  sub->callback([s] { make_targets(*s); });
}

}  // namespace sinew::cli
