// SPDX-License-Identifier: MIT
// Reads characters and predicted skeletons, measures them side by side, prints and writes the figures.
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "eval_studies.hpp"
#include "progress.hpp"
#include "sinew/published.h"
#include "sinew_character/predict/own_skeleton.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/rig_difference.hpp"
#include "sinew_trainer/rig_score.hpp"
#include "support.hpp"
#include "votes/rig_task.hpp"

namespace fs = std::filesystem;

namespace sinew::cli {
namespace {

std::vector<Joint> read_prediction(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw Error(path.string() + ": no such prediction");
  Character predicted;
  read_skeleton(path.string(), false, &predicted);
  return predicted.joints;
}

// By the name of the character, or in the sub-folder it has itself, as sinew rig DIR leaves it.
fs::path prediction_of(const FoundCharacter& found, const std::string& predictions) {
  const fs::path by_name = fs::path(predictions) / (found.name + ".rig.txt");
  const fs::path as_below = fs::path(predictions) / found.below / (stem_of(found.path) + ".rig.txt");
  std::error_code ignored;
  return !fs::exists(by_name, ignored) && fs::exists(as_below, ignored) ? as_below : by_name;
}

struct MeasuredRig {
  std::string failure;  // empty: measured
  RigScore score;
  bool humanoid = false;
  std::vector<std::string> gaps;
  double owned = 0;          // with a bind
  RigReportPicture picture;  // with a report
  RigScore in_float;         // with a checkpoint
  bool same_tree = false;
};

double measure_owned(const Character& character, const TargetSkeleton& target, const PredictedSkeleton& skeleton,
                     const LabeledSkeleton& labels, const sinew_model* weights) {
  BindOptions options;
  options.method = SINEW_METHOD_MODEL;
  options.model = weights;
  Character bound = character;
  const CharacterBind result = bind_to_prediction(skeleton, options, &bound);
  BoundSkeleton measured{skeleton.joints, labels.classes, result.influences};
  measured.axis = skeleton.facing % 2 == 0 ? 0 : 2;
  measured.plane = skeleton.plane;
  return owned_surface(measured, character, target);
}

// The predictor; one of them.
struct Predictor {
  uint32_t method = SINEW_RIG_VOTES;
  std::unique_ptr<LoadedModel> model, front;
  std::string folder;                    // of predictions
  std::optional<FloatNetwork> in_float;  // measured beside the model

  SkeletonOptions options() const {
    SkeletonOptions result;
    result.method = method;
    if (model) result.model = &model->model;
    if (front) result.front_model = &front->model;
    result.find_up = front != nullptr;
    return result;
  }

  PredictedSkeleton skeleton(const Character& character, const FoundCharacter& found) const {
    if (!folder.empty()) return skeleton_from_joints(read_prediction(prediction_of(found, folder)));
    return predict_skeleton(character, options());
  }
};

MeasuredRig measure_one(const FoundCharacter& found, const RigEvaluation& evaluation, const Predictor& predictor,
                        const sinew_model* weights) {
  MeasuredRig measured;
  try {
    const Character character = read_found(found);
    const PredictedSkeleton prediction = predictor.skeleton(character, found);
    const std::vector<Joint>& joints = prediction.joints;
    const TargetSkeleton target = target_skeleton(character);
    const ScoredSkeleton reference = scored_skeleton(target);
    const ScoredSkeleton skeleton = scored_skeleton(joints, target.side);
    measured.score = score_rig(skeleton, reference);
    if (predictor.in_float) {
      const PredictedSkeleton exact = predict_float_skeleton(character, *predictor.in_float, predictor.options());
      measured.in_float = score_rig(scored_skeleton(exact.joints, target.side), reference);
      measured.same_tree = same_tree(exact, prediction);
    }
    measured.humanoid = is_humanoid(reference);
    if (measured.humanoid) measured.gaps = humanoid_gaps(skeleton);
    if (weights != nullptr) {
      const LabeledSkeleton labels = predictor.folder.empty()
                                         ? LabeledSkeleton{joints, prediction.classes, prediction.ends}
                                         : label_skeleton(joints);
      measured.owned = measure_owned(character, target, prediction, labels, weights);
    }
    if (!evaluation.report.empty()) {
      measured.picture = rig_report_picture(character, target, joints);
      measured.picture.character = found.name;
    }
  } catch (const Error& error) {
    measured.failure = error.what();
  }
  return measured;
}

// The float network's own figures, and how often the model gives the same joints on the same parents.
void tell_float(const RigEvaluation& evaluation, const std::vector<FoundCharacter>& found,
                const std::vector<MeasuredRig>& measured, const RigScores& scores) {
  std::vector<std::pair<std::string, RigScore>> rows;
  size_t same = 0;
  for (size_t i = 0; i < found.size(); ++i) {
    if (!measured[i].failure.empty()) continue;
    rows.emplace_back(found[i].name, measured[i].in_float);
    same += measured[i].same_tree ? 1 : 0;
  }
  const size_t count = rows.size();
  const RigScores exact = summarize(std::move(rows));
  std::fprintf(
      evaluation.json ? stderr : stdout,
      "\nfloat, %s: J2J %.3f / %.3f, int16 %.3f / %.3f (x 100, characters / families); the same tree on %zu of %zu "
      "characters\n",
      printable(evaluation.checkpoint).c_str(), 100 * exact.all.j2j, 100 * exact.family_mean.j2j, 100 * scores.all.j2j,
      100 * scores.family_mean.j2j, same, count);
}

FloatNetwork votes_of(const std::string& checkpoint) {
  FloatNetwork network = read_checkpoint(checkpoint).network;
  if (network.architecture != "votes" || network.feature_set != sinew::rigging::kRigFeatureSet)
    throw Error(checkpoint + ": expected a network of votes for bodies, found one of " + network.architecture);
  return network;
}

}  // namespace

void evaluate_rigs(const RigEvaluation& evaluation) {
  std::error_code ignored;
  if (!evaluation.predictions.empty() && !fs::is_directory(evaluation.predictions, ignored))
    throw Error(evaluation.predictions + ": expected a folder of predicted NAME.rig.txt, found none");
  Predictor predictor;
  predictor.folder = evaluation.predictions;
  if (evaluation.method == "slots") {
    predictor.method = SINEW_RIG_SLOTS;
    predictor.model = load_model(evaluation.model, ModelUse::kSlotJoints);
  } else if (evaluation.method == "shape")
    predictor.method = SINEW_RIG_SHAPE;
  else if (evaluation.method == "regions")
    predictor.method = SINEW_RIG_REGIONS;
  else if (evaluation.predictions.empty())
    predictor.model = load_model(evaluation.model, ModelUse::kRig);
  if (predictor.folder.empty() && (predictor.method == SINEW_RIG_VOTES || predictor.method == SINEW_RIG_SHAPE))
    predictor.front = load_front_model();
  if (!evaluation.checkpoint.empty()) predictor.in_float = votes_of(evaluation.checkpoint);
  std::unique_ptr<LoadedModel> weights;
  if (evaluation.bind) weights = load_model("");
  const std::vector<FoundCharacter> found = characters_in(evaluation.folder);
  std::vector<MeasuredRig> measured(found.size());
  {
    Progress progress(found.size(), "characters");
    parallel_for(found.size(), evaluation.jobs, [&](size_t i, unsigned) {
      measured[i] = measure_one(found[i], evaluation, predictor, weights ? &weights->model : nullptr);
      progress.step();
    });
  }
  std::vector<std::pair<std::string, RigScore>> rows;
  for (size_t i = 0; i < found.size(); ++i)
    if (measured[i].failure.empty()) rows.emplace_back(found[i].name, measured[i].score);
  RigScores scores = summarize(std::move(rows));
  for (size_t i = 0; i < found.size(); ++i) {
    if (!measured[i].failure.empty())
      scores.failures[found[i].name] = measured[i].failure;
    else if (measured[i].humanoid)
      scores.humanoids[found[i].name] = measured[i].gaps;
    if (measured[i].failure.empty() && evaluation.bind) scores.owned[found[i].name] = measured[i].owned;
  }
  if (!evaluation.report.empty()) {
    RigReport report;
    report.scores = scores;
    report.facts = evaluation.facts;
    for (MeasuredRig& one : measured) {
      if (one.failure.empty()) report.pictures.push_back(std::move(one.picture));
    }
    write_text_file(evaluation.report, rig_report_html(report));
    if (!evaluation.json) std::printf("wrote %s\n", printable(evaluation.report).c_str());
  }
  if (!evaluation.json) std::printf("%s", rig_scores_markdown(scores).c_str());
  if (predictor.in_float) tell_float(evaluation, found, measured, scores);
  const std::string figures = with_version("eval", "study", "rig", rig_scores_json(scores));
  if (!evaluation.output.empty()) write_text_file(evaluation.output, figures);
  if (evaluation.json) std::printf("%s", figures.c_str());
  check_failed(scores.failures, found.size());
}

}  // namespace sinew::cli
