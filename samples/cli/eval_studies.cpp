// SPDX-License-Identifier: MIT
// Fingers, measured behind predicted bodies; how often a vertex that the binder is 90 % sure of is right; how much of the
// damage seeded into rigs is found, and how often untouched ones are called damaged.
#include "eval_studies.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "progress.hpp"
#include "sinew_character/bind/bind_character.hpp"
#include "sinew_character/check/check.hpp"
#include "sinew_character/predict/predict_details.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/hand_score.hpp"
#include "sinew_trainer/rig_damage.hpp"
#include "support.hpp"

namespace sinew::cli {

void evaluate_hands(const HandsEvaluation& evaluation) {
  const std::unique_ptr<LoadedModel> body = load_model("", ModelUse::kRig);
  const std::unique_ptr<LoadedModel> hands = load_model(evaluation.model, ModelUse::kHands);
  const std::vector<FoundCharacter> found = characters_in(evaluation.folder);
  std::vector<std::optional<HandScore>> measured(found.size());
  std::vector<std::string> failures(found.size());
  {
    Progress progress(found.size(), "characters");
    parallel_for(found.size(), evaluation.jobs, [&](size_t i, unsigned) {
      try {
        const Character character = read_found(found[i]);
        SkeletonOptions options;
        options.model = &body->model;
        PredictedSkeleton skeleton = predict_skeleton(character, options);
        (void)predict_hands(character, hands->model, options, &skeleton);
        measured[i] = score_hands(character, skeleton);
      } catch (const Error& error) {
        failures[i] = error.what();
      }
      progress.step();
    });
  }
  std::vector<std::pair<std::string, HandScore>> rows;
  size_t failed = 0;
  std::string first;
  for (size_t i = 0; i < found.size(); ++i) {
    if (measured[i]) rows.emplace_back(found[i].name, *measured[i]);
    if (!measured[i] && failed++ == 0) first = failures[i];
  }
  if (!evaluation.json) std::printf("%s", hand_scores_markdown(rows).c_str());
  const std::string figures = with_version("eval", "study", "hands", hand_scores_json(rows));
  if (!evaluation.output.empty()) write_text_file(evaluation.output, figures);
  if (evaluation.json) std::printf("%s", figures.c_str());
  check_failed(failed, found.size(), "characters", first);
}

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

namespace {

// Results of one character.
struct CheckFigures {
  std::map<std::string, std::array<size_t, 3>> damages;  // by kind: seeded, found, found as an error or a warning
  std::map<std::string, size_t> alarms;                  // rules with findings on the untouched rig
  std::vector<std::string> missed, noted;                // kinds: not found; found as a note alone
  bool alarmed = false, broken = false;                  // an error or a warning; an error
  double seconds = 0;
};

//   poses  whether the mesh is posed, too
RigCheck check_of(const DamagedRig& rig, bool poses) {
  return check_rig(rig.character, rig.motion ? &*rig.motion : nullptr, {poses, {}});
}

bool needs_poses(const DamageKind& kind) {
  return std::any_of(kind.rules.begin(), kind.rules.end(), [](const char* rule) { return !check_rule(rule).cheap; });
}

void count_alarms(const RigCheck& check, CheckFigures* f) {
  for (const RigFinding& finding : check.findings) ++f->alarms[finding.rule->name];
  f->alarmed = f->alarmed || check.errors + check.warnings > 0;
  f->broken = f->broken || check.errors > 0;
}

// The walk is added by this study: its findings are separate from those of the artist's file.
void count_clip_alarms(const RigCheck& check, CheckFigures* f) {
  for (const RigFinding& finding : check.findings)
    if (!finding.clip.empty()) ++f->alarms[finding.rule->name];
}

//   least  severity that counts
bool found(const DamageKind& kind, const RigCheck& before, const DamagedRig& from, const RigCheck& now,
           const DamagedRig& to, CheckSeverity least) {
  const CheckChange change = check_change(before, from.character.joints, now, to.character.joints);
  return std::any_of(change.added.begin(), change.added.end(), [&](size_t i) {
    return now.findings[i].severity >= least &&
           std::any_of(kind.rules.begin(), kind.rules.end(),
                       [&](const char* rule) { return std::string(rule) == now.findings[i].rule->name; });
  });
}

CheckFigures figures_of(const Character& c, uint32_t seed) {
  CheckFigures f;
  std::map<DamageNeeds, std::optional<DamagedRig>> wholes;
  std::map<std::pair<DamageNeeds, bool>, RigCheck> checks;
  const auto whole_check = [&](DamageNeeds needs, bool poses) -> const RigCheck& {
    const auto [at, is_new] = checks.try_emplace({needs, poses});
    if (is_new) at->second = check_of(*wholes[needs], poses);
    return at->second;
  };
  const DamageNeeds plain = DamageNeeds::kCharacter;
  wholes[plain] = DamagedRig{c, std::nullopt};
  const auto start = std::chrono::steady_clock::now();
  count_alarms(whole_check(plain, true), &f);
  f.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (const DamageKind& kind : damage_kinds()) {
    const DamageNeeds needs = needs_of(kind);
    if (wholes.count(needs) == 0) {
      wholes[needs] = undamaged(c, needs);
      if (wholes[needs] && needs == DamageNeeds::kWalk) count_clip_alarms(whole_check(needs, false), &f);
    }
    if (!wholes[needs]) continue;
    const std::optional<DamagedRig> broken = damaged(*wholes[needs], kind, seed);
    if (!broken) continue;
    const bool poses = needs_poses(kind);
    const RigCheck now = check_of(*broken, poses);
    const auto is_found = [&](CheckSeverity least) {
      return found(kind, whole_check(needs, poses), *wholes[needs], now, *broken, least);
    };
    const bool told = is_found(CheckSeverity::kNote);
    std::array<size_t, 3>& counts = f.damages[kind.name];
    ++counts[0];
    counts[1] += told ? 1 : 0;
    const bool heavy = told && is_found(CheckSeverity::kWarning);
    counts[2] += heavy ? 1 : 0;
    if (!told) f.missed.push_back(kind.name);
    if (told && !heavy) f.noted.push_back(kind.name);
  }
  return f;
}

}  // namespace

void study_check(const std::string& folder, unsigned jobs, bool names) {
  const std::vector<FoundCharacter> list = characters_in(folder);
  std::vector<CheckFigures> figures(list.size());
  {
    Progress progress(list.size(), "characters");
    parallel_for(list.size(), jobs, [&](size_t i, unsigned) {
      figures[i] = figures_of(read_found(list[i]), static_cast<uint32_t>(i + 1));
      progress.step();
    });
  }
  std::map<std::string, std::array<size_t, 3>> damages;
  std::map<std::string, size_t> alarms;
  std::array<size_t, 3> sums = {};
  size_t alarmed = 0, broken = 0;
  for (size_t i = 0; i < list.size(); ++i) {
    const CheckFigures& f = figures[i];
    for (const auto& [kind, counts] : f.damages)
      for (size_t k = 0; k < counts.size(); ++k) {
        damages[kind][k] += counts[k];
        sums[k] += counts[k];
      }
    for (const auto& [rule, count] : f.alarms) alarms[rule] += count > 0 ? 1 : 0;
    alarmed += f.alarmed ? 1 : 0;
    broken += f.broken ? 1 : 0;
    if (!names) continue;
    for (const auto& [rule, count] : f.alarms)
      std::printf("alarm %s %s %zu\n", list[i].name.c_str(), rule.c_str(), count);
    for (const std::string& kind : f.missed) std::printf("missed %s %s\n", list[i].name.c_str(), kind.c_str());
    for (const std::string& kind : f.noted) std::printf("noted %s %s\n", list[i].name.c_str(), kind.c_str());
  }
  const auto share = [](size_t part, size_t all) {
    return all == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(all);
  };
  std::printf("| damage | seeded | found | as an error or a warning |\n|---|---|---|---|\n");
  for (const DamageKind& kind : damage_kinds()) {
    const auto& [all, hits, heavy] = damages[kind.name];
    std::printf("| %s: %s | %zu | %.1f %% | %.1f %% |\n", kind.name, kind.what, all, share(hits, all),
                share(heavy, all));
  }
  const double count = static_cast<double>(list.size());
  std::printf("| all | %zu | %.1f %% | %.1f %% |\n\n| untouched, findings of | characters | share |\n|---|---|---|\n",
              sums[0], share(sums[1], sums[0]), share(sums[2], sums[0]));
  for (const CheckRule& rule : check_rules())
    if (alarms[rule.name] > 0)
      std::printf("| %s (%s) | %zu | %.1f %% |\n", rule.name, severity_text(rule.severity), alarms[rule.name],
                  100.0 * static_cast<double>(alarms[rule.name]) / count);
  double pairs = 0, seconds = 0;
  for (const auto& [rule, number] : alarms) pairs += static_cast<double>(number);
  for (const CheckFigures& f : figures) seconds = std::max(seconds, f.seconds);
  std::printf(
      "| any error | %zu | %.1f %% |\n| any error or warning | %zu | %.1f %% |\n| mean of rules | | %.2f %% |\n",
      broken, 100.0 * static_cast<double>(broken) / count, alarmed, 100.0 * static_cast<double>(alarmed) / count,
      100.0 * pairs / count / static_cast<double>(check_rules().size()));
  std::fprintf(stderr, "%zu characters, at most %.2f s each\n", list.size(), seconds);
}

}  // namespace sinew::cli
