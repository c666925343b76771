// SPDX-License-Identifier: MIT
// sinew-lab dataset stats: sizes, influences and candidates' recall of a folder, as a table, JSON and a page with pictures.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "commands.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sinew_character/draw/image.hpp"
#include "sinew_data_sets/dataset_page.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

constexpr uint32_t kGrid = 64;  // the default of training and binding

struct DatasetStatsCommandSettings {
  std::string folder, page;
  unsigned jobs = 1;
  int picture = 220;
  bool json = false, no_recall = false;
};

// Figures of one character; `failure` has the error if it cannot be read.
std::optional<CharacterStats> stats_of(const DatasetStatsCommandSettings& s, const FoundCharacter& found,
                                       const std::vector<uint32_t>& candidate_counts, std::string* failure) {
  try {
    const Character character = read_found(found);
    CharacterStats one = character_stats(character);
    if (!s.no_recall && !character.influences.empty())
      one.recall = candidate_recall(character, candidate_counts, kGrid);
    if (!s.page.empty()) {
      RenderOptions options;
      options.width = options.height = s.picture;
      options.draw_skeleton = false;
      one.png = encode_png(render(character, weight_colors(character), options));
    }
    return one;
  } catch (const Error& error) {
    *failure = error.what();
    return std::nullopt;
  }
}

DatasetStats measure_folder(const DatasetStatsCommandSettings& s, const std::vector<FoundCharacter>& found) {
  DatasetStats all;
  all.folder = s.folder;
  if (!s.no_recall) all.candidate_counts = {6, 8, 12, 16};
  std::vector<std::optional<CharacterStats>> measured(found.size());
  std::vector<std::string> failures(found.size());
  Progress progress(found.size(), "characters");
  parallel_for(found.size(), s.jobs, [&](size_t i, unsigned) {
    measured[i] = stats_of(s, found[i], all.candidate_counts, &failures[i]);
    progress.step();
  });
  for (size_t i = 0; i < found.size(); ++i) {
    if (measured[i]) all.characters.push_back(std::move(*measured[i]));
    if (!failures[i].empty()) all.unreadable.emplace_back(found[i].name, failures[i]);
  }
  return all;
}

void stats(const DatasetStatsCommandSettings& s) {
  if (!s.page.empty()) check_output(s.page, {".html", ".htm"});
  const std::vector<FoundCharacter> found = characters_in(s.folder);
  const DatasetStats all = measure_folder(s, found);
  std::fputs((s.json ? with_version("dataset", "about", "stats", dataset_json(all)) : dataset_table(all)).c_str(),
             stdout);
  if (!s.page.empty()) write_text_file(s.page, dataset_html(all));
  if (!all.unreadable.empty())
    throw Error(print("%zu of %zu characters cannot be read; the first: ", all.unreadable.size(), found.size()) +
                all.unreadable[0].second);
}

}  // namespace

void add_dataset_stats(CLI::App* parent) {
  CLI::App* sub = parent->add_subcommand("stats", "Print sizes, influences and candidate recall of families");
  auto s = std::make_shared<DatasetStatsCommandSettings>();
  s->jobs = std::max(1u, std::thread::hardware_concurrency());
  sub->add_option("dir", s->folder, "Folder of FAMILY__NAME characters, with subfolders")->required()->type_name("DIR");
  shared_option(sub, "-o,--output", s->page, "Plots and a picture of each character with its warnings");
  sub->add_option("--picture-size", s->picture, "Side length of the pictures in pixels")
      ->check(CLI::Range(64, 1024))
      ->capture_default_str()
      ->type_name("N");
  sub->add_flag("--no-recall", s->no_recall, "Leave out the recall of 6, 8, 12 and 16 candidates (faster)");
  add_jobs(sub, s->jobs)->capture_default_str();
  shared_flag(sub, "--json", s->json, "Sizes are [smallest, median, largest]");
  sub->footer(
      "Example:\n  sinew-lab dataset stats characters/train -o train.html\n\nRecall: share of the reference weight on "
      "the K joints that the network may choose from, at grid 64.");
  sub->callback([s] { stats(*s); });
}

}  // namespace sinew::cli
