// SPDX-License-Identifier: MIT
// Reads characters and predicted skeletons, measures them side by side, prints and writes the figures.
#include "eval_rig.hpp"

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "progress.hpp"
#include "rig_slots.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/predict_skeleton.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_trainer/parallel.hpp"
#include "sinew_trainer/rig_score.hpp"
#include "support.hpp"

namespace fs = std::filesystem;

namespace sinew::cli {
namespace {

std::vector<Joint> read_prediction(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw Error(path.string() + ": there is no such prediction");
  Character predicted;
  read_skeleton(path.string(), false, &predicted);
  return predicted.joints;
}

struct Measured {
  std::string failure;  // empty: measured
  RigScore score;
  bool humanoid = false;
  std::vector<std::string> gaps;
};

// What predicts; one of them.
struct Predictor {
  std::unique_ptr<LoadedModel> model;
  std::optional<FloatNetwork> slots;
  std::string folder;  // of predictions

  std::vector<Joint> joints(const Character& character, const std::string& name) const {
    if (slots) return predict_slots(character, *slots, {}).joints;
    if (!model) return read_prediction(fs::path(folder) / (name + ".rig.txt"));
    SkeletonOptions options;
    options.model = &model->model;
    return predict_skeleton(character, options).joints;
  }
};

Measured measure_one(const FoundCharacter& found, const Predictor& predictor) {
  Measured measured;
  try {
    const Character character = read_found(found);
    const std::vector<Joint> joints = predictor.joints(character, found.name);
    const TargetSkeleton target = target_skeleton(character);
    const ScoredSkeleton reference = scored_skeleton(target);
    const ScoredSkeleton skeleton = scored_skeleton(joints, target.side);
    measured.score = score_rig(skeleton, reference);
    measured.humanoid = is_humanoid(reference);
    if (measured.humanoid) measured.gaps = humanoid_gaps(skeleton);
  } catch (const Error& error) {
    measured.failure = error.what();
  }
  return measured;
}

}  // namespace

void evaluate_rigs(const RigEvaluation& evaluation) {
  std::error_code ignored;
  if (!evaluation.predictions.empty() && !fs::is_directory(evaluation.predictions, ignored))
    throw Error(evaluation.predictions + ": expected a folder of predicted NAME.rig.txt, found no such folder");
  Predictor predictor;
  predictor.folder = evaluation.predictions;
  if (evaluation.slots)
    predictor.slots = load_slots(evaluation.model);
  else if (evaluation.predictions.empty())
    predictor.model = load_model(evaluation.model, ModelUse::kRig);
  const std::vector<FoundCharacter> found = characters_in(evaluation.folder);
  std::vector<Measured> measured(found.size());
  {
    Progress progress(found.size(), "characters");
    parallel_for(found.size(), evaluation.jobs, [&](size_t i, unsigned) {
      measured[i] = measure_one(found[i], predictor);
      progress.step();
    });
  }
  std::vector<std::pair<std::string, RigScore>> rows;
  for (size_t i = 0; i < found.size(); ++i)
    if (measured[i].failure.empty()) rows.emplace_back(found[i].name, measured[i].score);
  RigScores scores = summarise(std::move(rows));
  for (size_t i = 0; i < found.size(); ++i) {
    if (!measured[i].failure.empty())
      scores.failures[found[i].name] = measured[i].failure;
    else if (measured[i].humanoid)
      scores.humanoids[found[i].name] = measured[i].gaps;
  }
  if (evaluation.json != "-") std::printf("%s", rig_scores_markdown(scores).c_str());
  if (!evaluation.json.empty()) write_text_file(evaluation.json, rig_scores_json(scores) + "\n");
  if (!scores.failures.empty())
    throw Error(print("%zu of %zu characters failed; the first: ", scores.failures.size(), found.size()) +
                scores.failures.begin()->first + ": " + scores.failures.begin()->second);
}

}  // namespace sinew::cli
