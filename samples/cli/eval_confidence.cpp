// SPDX-License-Identifier: MIT
// sinew-lab eval confidence: is a vertex that the binder is 90 % sure of right nine times in ten?
#include <cstdio>

#include "eval_studies.hpp"
#include "progress.hpp"
#include "sinew_character/bind/bind_character.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "support.hpp"

namespace sinew::cli {

std::vector<JudgedConfidence> judge_folder(const ConfidenceStudy& study) {
  const std::vector<FoundCharacter> found = characters_in(study.folder);
  sinew_model model = {};
  if (study.model != nullptr) model = *study.model;
  model.confidence_count = 0;  // the share itself
  std::vector<JudgedConfidence> judged(found.size());
  Progress progress(found.size(), "characters");
  parallel_for(found.size(), study.jobs, [&](size_t i, unsigned) {
    const Character c = read_found(found[i]);
    if (c.influences.empty()) throw Error(found[i].path + ": has no reference weights to compare with");
    CharacterBindOptions options;  // as sinew bind without the weights of the file
    options.bind.method = study.model == nullptr ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
    options.bind.model = &model;
    options.bind.influence_count = study.influences;
    const CharacterBind result = bind_character(c, choose_joints(c, JointsFrom::kNames), options);
    judged[i] = judge_confidence(c, result.influences, result.confidence);
    progress.step();
  });
  return judged;
}

namespace {

ConfidenceTable table_of(const sinew_model& model) {
  ConfidenceTable table;
  for (uint32_t i = 0; i < model.confidence_count; ++i) {
    const uint8_t* entry = model.bytes + model.confidence_offset + 4 * i;
    table.emplace_back(static_cast<uint16_t>(entry[0] | entry[1] << 8),
                       static_cast<uint16_t>(entry[2] | entry[3] << 8));
  }
  return table;
}

void print_reliability(const std::string& title, const Reliability& r) {
  std::printf(
      "%s: expected calibration error %.4f\n\n| confidence | vertices | mean confidence | right |\n|---|---|---|---|\n",
      title.c_str(), r.error);
  for (size_t i = 0; i < r.bins.size(); ++i) {
    if (r.bins[i].share <= 0) continue;
    std::printf("| %zu to %zu %% | %.1f %% | %.1f %% | %.1f %% |\n", 10 * i, 10 * i + 10, 100 * r.bins[i].share,
                100 * r.bins[i].confidence, 100 * r.bins[i].right);
  }
  std::printf("\n");
}

void print_lift(const std::vector<JudgedConfidence>& judged) {
  const DoubtLift lift = doubt_lift(judged);
  std::printf(
      "doubt: among the least sure tenth of a character %.1f %% of the strongest joints are wrong, %.2f x the average "
      "(%.1f %%; means of %zu characters)\n\n",
      100 * lift.wrong_first, lift.times_average, 100 * lift.wrong, lift.characters);
}

}  // namespace

void study_confidence(const ConfidenceStudy& study) {
  const std::vector<JudgedConfidence> judged = judge_folder(study);
  print_reliability("strongest joint's share, no table", reliability(judged));
  print_lift(judged);
  if (study.model != nullptr && study.model->confidence_count > 0) {
    const std::vector<JudgedConfidence> mapped = apply_confidence(judged, table_of(*study.model));
    print_reliability("the model's table", reliability(mapped));
    print_lift(mapped);
  }
  print_reliability("table fitted on the other half of the families", reliability_across_families(judged));
}

}  // namespace sinew::cli
