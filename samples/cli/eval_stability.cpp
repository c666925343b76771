// SPDX-License-Identifier: MIT
// sinew eval stability: every character rigged and bound anew in random poses.
#include "eval_stability.hpp"

#include <cstdio>
#include <memory>
#include <vector>

#include "progress.hpp"
#include "sinew_character/bind/bind_character.hpp"
#include "sinew_character/predict/own_skeleton.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_trainer/parallel.hpp"
#include "sinew_trainer/stability.hpp"
#include "support.hpp"

namespace sinew::cli {

void study_stability(const Study& study, const StabilitySettings& settings) {
  const std::unique_ptr<LoadedModel> votes = load_model("", ModelUse::kRig), front = load_front_model();
  SkeletonOptions skeletons;
  skeletons.model = &votes->model;
  skeletons.front_model = &front->model;
  skeletons.find_up = true;
  CharacterBindOptions binding;
  binding.bind.method = study.model == nullptr ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
  binding.bind.model = study.model;
  binding.bind.influence_count = study.influences;
  const auto find = [&](const Character& mesh) {
    Character bound = mesh;
    const PredictedSkeleton skeleton = predict_skeleton(mesh, skeletons);
    return FoundRig{skeleton.joints, bind_to_prediction(skeleton, binding.bind, &bound).influences};
  };
  const auto own = [&](const Character& c) {
    return bind_character(c, choose_joints(c, JointsFrom::kNames), binding).influences;
  };
  const std::vector<FoundCharacter> found = characters_in(study.folder);
  std::vector<StabilityFigures> figures(found.size());
  std::vector<std::string> failures(found.size());
  {
    Progress progress(found.size(), "characters");
    parallel_for(found.size(), study.jobs, [&](size_t i, unsigned) {
      try {
        figures[i] = measure_stability(read_found(found[i]), settings.poses, find, own);
      } catch (const Error& error) {
        failures[i] = error.what();
      }
      progress.step();
    });
  }
  StabilityRows rows;
  size_t failed = 0;
  std::string first;
  for (size_t i = 0; i < found.size(); ++i) {
    if (failures[i].empty()) rows.emplace_back(found[i].name, figures[i]);
    if (!failures[i].empty() && failed++ == 0) first = failures[i];
  }
  if (!settings.json) std::printf("%s", stability_markdown(rows).c_str());
  const std::string text = with_version("eval", "study", "stability", stability_json(rows));
  if (!settings.output.empty()) write_text_file(settings.output, text);
  if (settings.json) std::printf("%s", text.c_str());
  if (failed > 0) throw Error(print("%zu of %zu characters failed; the first: ", failed, found.size()) + first);
}

}  // namespace sinew::cli
