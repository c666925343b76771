// SPDX-License-Identifier: MIT
// sinew eval seams: how much weight lies on the wrong side where parts have grown together.
#include <cstdio>
#include <map>

#include "eval_studies.hpp"
#include "progress.hpp"
#include "sinew_character/bind/bind_character.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/parallel.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

struct SeamFigures {
  double characters = 0, seams = 0;                       // seams that were found
  double with_seams = 0;                                  // characters that truly have some
  double surface = 0, wrong_before = 0, wrong_after = 0;  // sums over those
  double l1_before = 0, l1_after = 0;                     // sums over all characters
  void add(const SeamFigures& f, double share) {
    characters += share * f.characters;
    seams += share * f.seams;
    with_seams += share * f.with_seams;
    surface += share * f.surface;
    wrong_before += share * f.wrong_before;
    wrong_after += share * f.wrong_after;
    l1_before += share * f.l1_before;
    l1_after += share * f.l1_after;
  }
};

SeamFigures figures_of(const Study& study, const Character& c) {
  CharacterBindOptions options;
  options.bind.method = study.model == nullptr ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
  options.bind.model = study.model;
  options.bind.influence_count = study.influences;
  options.keep_apart = false;
  WeightRows rows = bind_character(c, choose_joints(c, JointsFrom::kNames), options).influences;
  SeamFigures f;
  f.characters = 1;
  f.l1_before = measure(c, rows, c.name, 0).l1;
  const SeamLeak before = measure_seam_leak(c, rows);
  const Seams seams = find_seams(c, rows);
  keep_apart(c, seams, {}, &rows);
  f.seams = static_cast<double>(seams.seams.size());
  f.l1_after = measure(c, rows, c.name, 0).l1;
  if (before.surface > 0) {
    f.with_seams = 1;
    f.surface = before.surface;
    f.wrong_before = before.wrong;
    f.wrong_after = measure_seam_leak(c, rows).wrong;
  }
  return f;
}

void print_row(const std::string& name, const SeamFigures& f) {
  const double n = f.with_seams > 0 ? f.with_seams : 1;
  std::printf("| %s | %.0f | %.0f | %.2f | %.1f %% | %.2f %% | %.2f %% | %.4f | %.4f |\n", name.c_str(), f.characters,
              f.with_seams, f.seams / f.characters, 100 * f.surface / n, 100 * f.wrong_before / n,
              100 * f.wrong_after / n, f.l1_before / f.characters, f.l1_after / f.characters);
}

}  // namespace

void study_seams(const Study& study) {
  const std::vector<FoundCharacter> found = characters_in(study.folder);
  std::vector<SeamFigures> figures(found.size());
  {
    Progress progress(found.size(), "characters");
    parallel_for(found.size(), study.jobs, [&](size_t i, unsigned) {
      const Character c = read_found(found[i]);
      if (c.influences.empty()) throw Error(found[i].path + ": has no reference weights to compare with");
      figures[i] = figures_of(study, c);
      progress.step();
    });
  }
  std::map<std::string, SeamFigures> families;
  SeamFigures all, family_mean;
  for (size_t i = 0; i < found.size(); ++i) {
    families[family_of(found[i].name)].add(figures[i], 1);
    all.add(figures[i], 1);
  }
  std::printf(
      "| family | characters | with seams | seams found each | surface near them | weight across, bound plainly | kept "
      "apart | L1 plainly | kept apart |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& [name, sum] : families) {
    print_row(name, sum);
    family_mean.add(sum, 1 / sum.characters);
  }
  print_row("mean of families", family_mean);
  print_row("mean of characters", all);
}

}  // namespace sinew::cli
