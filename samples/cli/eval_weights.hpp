// SPDX-License-Identifier: MIT
// sinew-lab eval weights: every character of a folder bound in several ways and compared with its reference.
#ifndef SINEW_CLI_EVAL_WEIGHTS_HPP
#define SINEW_CLI_EVAL_WEIGHTS_HPP

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "option_groups.hpp"
#include "sinew_trainer/confidence.hpp"
#include "sinew_trainer/engine_network.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/report.hpp"
#include "sinew_trainer/sample.hpp"

namespace sinew::cli {

// Measurements and their output files. Empty paths: none.
struct WeightsEvaluation {
  std::string folder, model, checkpoint, method, joints;
  std::string calibrate;           // characters for the integers of a checkpoint; empty: those of `folder`
  std::vector<std::string> peers;  // NAME=DIR
  StyleOptions style;              // of what is evaluated, not of heat beside it
  std::string output, report;      // all figures as JSON; a page
  std::string predictions;         // a folder for NAME.rig.txt of every character
  std::string label;               // of the first column
  unsigned influences = 4, jobs = 1;
  bool known = false, against_nearest = false;
  bool json = false;  // all figures on standard output, instead of the table
};

using Rows = std::vector<std::vector<Influence>>;

struct Prediction {
  Rows rows;
  double seconds = 0;
  std::vector<float> logits;        // for signal to noise; empty when not known
  std::vector<uint8_t> confidence;  // [V]; empty when the binder tells none
};

// One variant of binding. `sample` is null unless some variant asks for it.
struct Variant {
  std::string label;
  int bits = 0;
  size_t size_bytes = 0;
  std::string confidence = "the largest weight of a vertex";
  uint32_t candidates = 0, grid = 0, feature_set = 0;  // of the sample it needs; 0 = none
  std::function<Prediction(const Character&, const Sample*)> predict;
  std::vector<std::pair<std::string, Metrics>> figures;
  std::map<std::string, std::vector<double>> pose_distances;
  LogitNoise noise;
  WeightDifference difference;  // from the first variant
};

constexpr const char* kNearest = "nearest bone";

// The evaluated character, then the data beside it. `evaluation` must outlive them.
std::vector<Variant> make_variants(const WeightsEvaluation& evaluation);

// Results of binding a folder.
struct WeightsFigures {
  std::vector<Variant> variants;
  size_t main = 0;  // the variant that the page shows
  std::vector<Scores> scores;
  std::map<std::string, std::string> failures;
  // For the page, by name: sums of doubles must not depend on which thread was first.
  std::map<std::string, std::pair<std::string, Rows>> drawn;  // path, main variant's rows
  std::map<std::string, JudgedConfidence> confidence;
  std::map<std::string, Clothing> dressed;  // the dressed ones

  // Characters on which nearest bone is better than the main variant; nullopt where it was not bound.
  std::optional<std::vector<std::pair<std::string, double>>> beaten() const;
};

void write_weights_report(const WeightsEvaluation& evaluation, const WeightsFigures& figures);

// Prints a table, writes what was asked for. A character that cannot be read counts as failed: the others are measured, and
// Error is thrown at the end.
void evaluate_weights(const WeightsEvaluation& evaluation);

}  // namespace sinew::cli
#endif
