// SPDX-License-Identifier: MIT
// sinew eval robustness: the table of what changes of the input do to the weights.
#include <algorithm>
#include <cstdio>

#include "eval_studies.hpp"
#include "progress.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_trainer/parallel.hpp"
#include "sinew_trainer/robustness.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

constexpr double kClose = 0.05;  // mean L1 of a character

}  // namespace

void study_robustness(const Study& study) {
  const std::vector<FoundCharacter> found = characters_in(study.folder);
  BindOptions options;
  options.method = study.model == nullptr ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
  options.model = study.model;
  options.influence_count = study.influences;
  std::vector<std::vector<RobustnessFigure>> figures(found.size());
  {
    Progress progress(found.size(), "characters");
    parallel_for(found.size(), study.jobs, [&](size_t i, unsigned) {
      figures[i] =
          measure_robustness(read_found(found[i]), [&](const Character& c) { return bind(c, options).influences; });
      progress.step();
    });
  }
  std::printf(
      "| change (%zu characters) | mean L1 between the weights | characters above %.2f | worst character | its name | "
      "largest of a vertex |\n|---|---|---|---|---|---|\n",
      found.size(), kClose);
  for (size_t k = 0; k < figures[0].size(); ++k) {
    double sum = 0, largest = 0;
    size_t worst = 0, above = 0;
    for (size_t i = 0; i < found.size(); ++i) {
      const RobustnessFigure& figure = figures[i][k];
      sum += figure.mean;
      largest = std::max(largest, figure.largest);
      above += figure.mean > kClose ? 1 : 0;
      if (figure.mean > figures[worst][k].mean) worst = i;
    }
    const double most = figures[worst][k].mean;
    std::printf("| %s | %.5f | %zu | %.5f | %s | %.5f |\n", figures[0][k].change.c_str(),
                sum / static_cast<double>(found.size()), above, most, most > 0 ? found[worst].name.c_str() : "",
                largest);
  }
}

}  // namespace sinew::cli
