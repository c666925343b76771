// SPDX-License-Identifier: MIT
// Cross-family validation: whole family groups are left out of training, and the network is measured on them.
#ifndef SINEW_TRAINER_CROSSVAL_HPP
#define SINEW_TRAINER_CROSSVAL_HPP

#include <atomic>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "sinew_trainer/family_groups.hpp"
#include "sinew_trainer/train.hpp"

namespace sinew {

// Figures of the network and of heat on the same characters.
struct CrossvalFigures {
  double l1 = 0, argmax = 0, distance = 0;  // Metrics::l1, argmax, avg_dist with four influences
  double heat_l1 = 0, heat_argmax = 0, heat_distance = 0;
};
struct CrossvalFamily {
  std::string family, group;
  uint32_t fold = 0;      // from 1; 0 = of the validation folder
  size_t characters = 0;  // the figures are means over them
  CrossvalFigures figures;
};
struct CrossvalSeed {
  uint64_t seed = 0;
  std::vector<CrossvalFamily> families;  // left-out ones, by name
  std::vector<CrossvalFamily> val;       // of the validation folder, from the run that left nothing out; may be empty
};
struct CrossvalReport {
  std::string label, config_json;
  std::set<std::string> apart;
  std::map<std::string, std::set<std::string>> means;  // of FamilyGroups
  uint32_t fold_count = 0;
  std::vector<CrossvalSeed> seeds;
};
// Over the families of some groups: the mean of their means over seeds, and where the network is worse than heat.
struct CrossvalMean {
  std::string name;
  size_t families = 0, characters = 0;
  CrossvalFigures figures;
  size_t worse = 0;          // families whose L1 is more than 0.03 above heat's
  std::string worst_family;  // with the largest difference to heat's L1
  double worst_difference = 0;
};
// The deciding figures: means over families of the means over seeds.
struct CrossvalMeans {
  size_t families = 0;
  CrossvalFigures all;
  size_t outside_families = 0;
  CrossvalFigures outside;   // without the groups apart
  size_t worse = 0;          // families whose L1 is more than 0.03 above heat's
  std::string worst_family;  // with the largest difference to heat's L1
  double worst_difference = 0;
  std::vector<CrossvalMean> named;  // report.means that have families, by name
  double spread = 0;                // largest minus smallest `all.l1` of the seeds
  size_t val_characters = 0;
  CrossvalFigures val, val_families;  // means over characters and over families of the validation folder
};
CrossvalMeans crossval_means(const CrossvalReport& report);
// One row per left-out family and the means, as Markdown; the same rows of every seed as CSV; everything as JSON.
std::string crossval_markdown(const CrossvalReport& report);
std::string crossval_csv(const CrossvalReport& report);
std::string crossval_json(const CrossvalReport& report);
// Reads what crossval_json wrote; a folder represents its crossval.json. Throws Error.
CrossvalReport read_crossval(const std::string& path);
// One row per report beside heat's.
std::string crossval_comparison(const std::vector<CrossvalReport>& reports);

// Logits [U x K] of a finished fold's network on a sample.
using LogitsFunction = std::function<std::vector<float>(const Sample&)>;

struct CrossvalOptions {
  std::string data_dir;
  std::string val_dir;    // when given, one more run per seed leaves nothing out and is measured there
  std::string folder;     // checkpoints, figures of every fold, crossval.{md,csv,json}
  std::string cache_dir;  // features; empty = FOLDER/cache
  std::string label;      // name in tables
  FamilyGroups groups;
  std::string leave_out;  // a name of groups.means: only these groups are dealt to folds, all others are trained on
  std::string from;       // a finished run: its networks with this configuration's correction, nothing is trained
  uint32_t fold_count = 5, seed_count = 1;
  uint32_t only_fold = 0;  // from 1; 0 = all, and val
  bool resume = false;
  double minutes = 0;    // per fold; 0 = by the configuration's steps
  uint32_t threads = 2;  // of all folds together
  uint32_t at_once = 0;  // folds side by side; 0 = one per thread
  bool quiet = false;
  const std::atomic<bool>* stop = nullptr;
  // How a finished network is run; empty = float. Called once per fold with samples to calibrate on (of training).
  std::string arithmetic = "float";  // its name, part of what --resume compares
  std::function<LogitsFunction(const FloatNetwork&, const std::vector<const Sample*>&)> logits;
};
// Trains and measures what is not there yet and writes the report of all folds that are finished. Every fold is
// measured with the weights of its last step: nothing is chosen on what was left out. Throws Error; sets nothing when
// stopped.
CrossvalReport crossval(const TrainConfig& config, const CrossvalOptions& options);

}  // namespace sinew
#endif
