// SPDX-License-Identifier: MIT
// sinew eval hints: how much the vertices around painted ones gain.
#include <algorithm>
#include <cstdio>
#include <map>
#include <mutex>
#include <random>

#include "eval_studies.hpp"
#include "progress.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_character/rig/mesh_neighbours.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/parallel.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

// The same on every machine: FNV-1a of the name seeds the choice.
uint64_t seed_of(const std::string& name) {
  uint64_t hash = 1469598103934665603ull;
  for (const char c : name) hash = (hash ^ static_cast<uint8_t>(c)) * 1099511628211ull;
  return hash;
}

std::vector<uint8_t> choose(const Character& c, const std::string& kind, double share) {
  std::mt19937_64 random(seed_of(c.name));
  std::vector<uint32_t> bound;
  for (uint32_t v = 0; v < c.influences.size(); ++v) {
    if (!c.influences[v].empty()) bound.push_back(v);
  }
  std::vector<uint8_t> chosen(c.vertices.size(), 0);
  const size_t wanted = std::max<size_t>(1, static_cast<size_t>(share * static_cast<double>(bound.size()) + 0.5));
  if (bound.empty()) return chosen;
  for (size_t i = 0; i < wanted && i < bound.size(); ++i) std::swap(bound[i], bound[i + random() % (bound.size() - i)]);
  if (kind == "random") {
    for (size_t i = 0; i < wanted && i < bound.size(); ++i) chosen[bound[i]] = 1;
    return chosen;
  }
  const std::vector<std::vector<uint32_t>> neighbours = neighbours_of(c);
  std::vector<uint32_t> reached = {bound[0]};
  chosen[bound[0]] = 1;
  for (size_t i = 0; i < reached.size() && reached.size() < wanted; ++i) {
    for (const uint32_t n : neighbours[reached[i]]) {
      if (chosen[n] != 0 || c.influences[n].empty() || reached.size() >= wanted) continue;
      chosen[n] = 1;
      reached.push_back(n);
    }
  }
  return chosen;
}

struct HintGain {
  double before = 0, after = 0, worse = 0;  // L1 of the vertices that were not given; share of them worse by over 0.05
  size_t characters = 0;
  void add(const HintGain& g) {
    before += g.before;
    after += g.after;
    worse += g.worse;
    characters += g.characters;
  }
};

HintGain hint_gain(const Study& study, const Character& c, const std::string& kind, double share) {
  BindOptions options;
  options.method = study.model == nullptr ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
  options.model = study.model;
  options.influence_count = study.influences;
  std::vector<float> without, with;
  measure(c, bind(c, options).influences, c.name, 0, &without);
  options.hints = choose(c, kind, share);
  measure(c, bind(c, options).influences, c.name, 0, &with);
  HintGain gain;
  size_t counted = 0;
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    if (options.hints[v] != 0 || c.influences[v].empty()) continue;
    gain.before += static_cast<double>(without[v]);
    gain.after += static_cast<double>(with[v]);
    gain.worse += with[v] > without[v] + 0.05f ? 1 : 0;
    ++counted;
  }
  const double n = static_cast<double>(std::max<size_t>(1, counted));
  gain.before /= n;
  gain.after /= n;
  gain.worse /= n;
  gain.characters = 1;
  return gain;
}

void print_hint_row(const std::string& name, const HintGain& sum) {
  const double n = static_cast<double>(sum.characters);
  std::printf("| %s | %zu | %.4f | %.4f | %.1f %% | %.2f %% |\n", name.c_str(), sum.characters, sum.before / n,
              sum.after / n, 100 * (sum.before - sum.after) / std::max(sum.before, 1e-12), 100 * sum.worse / n);
}

}  // namespace

void study_hints(const Study& study, const std::string& kind, double share) {
  const std::vector<FoundCharacter> found = characters_in(study.folder);
  std::vector<HintGain> gains(found.size());
  {
    Progress progress(found.size(), "characters");
    parallel_for(found.size(), study.jobs, [&](size_t i, unsigned) {
      const Character c = read_found(found[i]);
      if (c.influences.empty()) throw Error(found[i].path + ": has no reference weights to take hints from");
      gains[i] = hint_gain(study, c, kind, share);
      progress.step();
    });
  }
  std::map<std::string, HintGain> families;
  HintGain all, family_mean;
  for (size_t i = 0; i < found.size(); ++i) {
    families[family_of(found[i].name)].add(gains[i]);
    all.add(gains[i]);
  }
  std::printf(
      "| family (%s, %.3g %% of the vertices given) | characters | L1 of the others | with hints | less | worse by "
      "0.05 |\n"
      "|---|---|---|---|---|---|\n",
      kind.c_str(), 100 * share);
  for (const auto& [name, sum] : families) {
    print_hint_row(name, sum);
    const double n = static_cast<double>(sum.characters);
    family_mean.add({sum.before / n, sum.after / n, sum.worse / n, 1});
  }
  print_hint_row("mean of families", family_mean);
  print_hint_row("mean of characters", all);
}

}  // namespace sinew::cli
