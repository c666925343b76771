// SPDX-License-Identifier: MIT
// sinew-lab eval hands: predicts bodies and then hands, as sinew rig --detail hands does, and measures the fingers.
#include <cstdio>
#include <memory>
#include <optional>

#include "eval_studies.hpp"
#include "progress.hpp"
#include "sinew_character/predict/predict_details.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_trainer/hand_score.hpp"
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
  if (failed > 0) throw Error(print("%zu of %zu characters failed; the first: ", failed, found.size()) + first);
}

}  // namespace sinew::cli
