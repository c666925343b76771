// SPDX-License-Identifier: MIT
// sinew-lab dataset dedup and split: which characters are copies, and two folders of what belongs together.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "commands.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sinew_data_sets/dedup.hpp"
#include "sinew_data_sets/split.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_trainer/family_groups.hpp"
#include "support.hpp"

namespace fs = std::filesystem;

namespace sinew::cli {
namespace {

using Json = nlohmann::ordered_json;

struct DedupSettings {
  std::vector<std::string> inputs;
  std::string output;
  bool one_per_mesh = false, json = false;
};

std::vector<DuplicateGroup> find_copies(const std::vector<FoundCharacter>& found) {
  DuplicateFinder finder;
  Progress progress(found.size(), "characters");
  for (const FoundCharacter& one : found) {
    finder.add(read_character(one.path));
    progress.step();
  }
  return finder.groups();
}

void place(const FoundCharacter& found, const std::string& folder) {
  place_character(found.path, (fs::path(folder) / found.below).string());
}

void dedup(const DedupSettings& s) {
  const std::vector<FoundCharacter> found = expand(s.inputs);
  const std::vector<DuplicateGroup> groups = find_copies(found);

  std::set<size_t> dropped;
  for (const DuplicateGroup& group : groups) {
    Json members = Json::array();
    if (!s.json) std::printf("%zu characters with the same mesh\n", group.members.size());
    for (const DuplicateGroup::Member& m : group.members) {
      const bool first = m.index == group.members[0].index;
      const bool drop = m.like != m.index || (s.one_per_mesh && !first);
      if (drop) dropped.insert(m.index);
      const std::string what = first ? "" : likeness_text(m.likeness);
      members.push_back({{"file", found[m.index].path},
                         {"drop", drop},
                         {"likeness", first ? "first" : what},
                         {"copy_of", found[m.like].path},
                         {"position", m.position},
                         {"weights_l1", m.weights}});
      if (s.json) continue;
      std::printf("  %s  %s", drop ? "drop" : "keep", found[m.index].path.c_str());
      if (!first) std::printf("  %s (positions %.5f, weights L1 %.3f)", what.c_str(), m.position, m.weights);
      if (m.like != m.index && m.like != group.members[0].index) std::printf(" as %s", found[m.like].path.c_str());
      std::printf("\n");
    }
    if (s.json)
      std::printf("%s\n", json_line({{"sinew_dataset", 1}, {"about", "dedup"}, {"members", members}}).c_str());
  }
  if (!s.output.empty()) {
    make_folder(s.output);
    for (size_t i = 0; i < found.size(); ++i)
      if (dropped.count(i) == 0) place(found[i], s.output);
  }
  if (s.json) return;
  std::printf(
      "%zu characters, %zu groups with the same mesh, %zu to drop%s\n", found.size(), groups.size(), dropped.size(),
      s.output.empty() ? "" : print(", %zu written to ", found.size() - dropped.size()).append(s.output).c_str());
}

struct SplitSettings {
  std::string folder, output, by = "family", groups;
  double share = 0.1;
  uint64_t seed = 1;
  bool lists = false;
};

void refuse_filled(const fs::path& folder) {
  std::error_code ignored;
  if (fs::exists(folder, ignored) && !fs::is_empty(folder, ignored))
    throw Error(folder.string() + ": is not empty, expected a new folder");
}

void split(const SplitSettings& s) {
  if (!s.groups.empty() && s.by != "family") throw UsageError("--groups needs --by family");
  std::optional<FamilyGroups> groups;
  if (!s.groups.empty()) groups = read_family_groups(s.groups);
  const std::vector<FoundCharacter> found = characters_in(s.folder);
  std::vector<std::string> keys;
  for (const FoundCharacter& one : found) {
    const std::string family = family_of(one.name);
    keys.push_back(s.by == "character" ? one.name : groups ? groups->group(family) : family);
  }
  const std::vector<SplitUnit> units = split_units(keys);
  const std::vector<bool> chosen = choose_validation(units, s.share, s.seed);

  std::vector<uint8_t> side(found.size(), 0);
  for (size_t u = 0; u < units.size(); ++u)
    for (const size_t i : units[u].members) side[i] = chosen[u] ? 1 : 0;
  const char* const sides[] = {"train", "val"};
  if (!s.lists)
    for (const char* name : sides) refuse_filled(fs::path(s.output) / name);
  make_folder(s.output);
  size_t counts[2] = {0, 0};
  for (const size_t which : {size_t{0}, size_t{1}}) {
    std::string list;
    for (size_t i = 0; i < found.size(); ++i) {
      if (side[i] != which) continue;
      ++counts[which];
      list += found[i].path + "\n";
      if (!s.lists) place(found[i], (fs::path(s.output) / sides[which]).string());
    }
    if (s.lists) write_text_file((fs::path(s.output) / (std::string(sides[which]) + ".txt")).string(), list);
  }
  for (size_t u = 0; u < units.size() && s.by == "family"; ++u)
    std::printf("%-5s %4zu  %s\n", sides[chosen[u] ? 1 : 0], units[u].members.size(), units[u].name.c_str());
  std::printf("%zu characters for training, %zu for validation (%.1f %%)\n", counts[0], counts[1],
              100.0 * static_cast<double>(counts[1]) / static_cast<double>(found.size()));
}

}  // namespace

void add_dataset_dedup(CLI::App* parent) {
  CLI::App* sub =
      parent->add_subcommand("dedup", "Find copies: the same character, or the same mesh with another skeleton");
  auto s = std::make_shared<DedupSettings>();
  sub->add_option("inputs", s->inputs,
                  "Characters, or folders of them with subfolders. Of several copies the first is kept")
      ->required()
      ->type_name("FILE|DIR");
  shared_option(sub, "-o,--output", s->output, "Folder for one of each group, as hard links where possible");
  sub->add_flag("--one-per-mesh", s->one_per_mesh, "Also drop characters that share only the mesh");
  shared_flag(sub, "--json", s->json, "One line per group with the same mesh");
  sub->footer(
      "Examples:\n  sinew-lab dataset dedup characters/train -o characters/unique\n  sinew-lab dataset dedup "
      "characters/train characters/val      # does val hold a copy of train?\n\nMeshes are compared after translation "
      "and scaling, weights by joints at the same position. Near copies: positions\nwithin 1 % of the size and a mean "
      "L1 of weights within 0.05. Nothing is deleted.");
  sub->callback([s] { dedup(*s); });
}

void add_dataset_split(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("split", "Split a folder into train and val, families together");
  auto s = std::make_shared<SplitSettings>();
  sub->add_option("dir", s->folder, "Folder of FAMILY__NAME characters, with subfolders")->required()->type_name("DIR");
  sub->add_option("--val-share", s->share,
                  "Share of the characters for validation. Whole families come as close as possible")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str()
      ->type_name("X");
  sub->add_option("--by", s->by, "What stays together")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"family", "character"}))
      ->capture_default_str();
  shared_option(sub, "--groups", s->groups, "As for crossval: {\"groups\": {\"group\": [\"family\", ...], ...}}");
  shared_option(sub, "--seed", s->seed)->capture_default_str();
  sub->add_flag("--lists", s->lists, "Write paths to OUT/train.txt and OUT/val.txt instead of folders");
  shared_option(sub, "-o,--output", s->output,
                "Folder for train and val: hard links, or copies where links are impossible")
      ->required();
  sub->footer(
      "Example:\n  sinew-lab dataset split characters --val-share 0.1 --groups trainer/configs/groups.json -o "
      "divided\n\nFind copies first (sinew-lab dataset dedup); otherwise they end up on both sides.");
  sub->callback([s] { split(*s); });
}

}  // namespace sinew::cli
