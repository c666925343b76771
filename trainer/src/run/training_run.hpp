// SPDX-License-Identifier: MIT
// A training run for any task: samples in, a checkpoint out.
#ifndef SINEW_TRAINER_RUN_TRAINING_RUN_HPP
#define SINEW_TRAINER_RUN_TRAINING_RUN_HPP

#include <memory>
#include <string>
#include <vector>

#include "run/batch_gradient.hpp"
#include "run/task.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_trainer/train.hpp"

namespace sinew {

// Training and validation samples of a run; borrowed, the samples must outlive the run.
struct TrainingItems {
  std::vector<std::vector<const NetworkSample*>> choices;  // each: the original, then its variants
  std::vector<std::string> families;                       // of choices
  std::vector<const NetworkSample*> validation;            // may be empty
};

// Mean over samples and mean over families of TrainingTask::score().
struct ValScore {
  double samples = 0, families = 0;
  double mean() const { return 0.5 * (samples + families); }
};

// Call start(), load() and go() once each, in this order. Of the options it reads neither data_dir nor val_dir nor
// cache_dir. Errors and promises are those of train().
class TrainingRun {
 public:
  // `task` must outlive it.
  TrainingRun(const TrainingTask& task, const RunConfig& config, const TrainOptions& options);
  // The first network, or the checkpoint to go on from; before the samples, so that a resume that does not fit fails at
  // once.
  void start();
  void load(const TrainingItems& items);
  void go();

 private:
  void say_finished() const;
  void agree();
  void show_speed(uint64_t steps);
  uint32_t threads() const;
  double progress() const;
  std::string settled() const;
  const std::vector<const NetworkSample*>& draw();
  void step(double rate);
  void validate(double rate);
  void save();
  void show(double rate, bool validated);

  const TrainingTask& task_;
  const RunConfig config_;
  TrainOptions options_;
  std::vector<std::vector<const NetworkSample*>> drawn_;  // choices of the families that are not left out
  std::vector<std::string> families_;                     // of drawn_
  std::vector<const NetworkSample*> val_;
  ValScore baseline_, last_val_;
  Checkpoint checkpoint_;
  std::unique_ptr<BatchGradient> gradient_;
  std::vector<BatchItem> items_;  // of a step
  std::vector<std::vector<double>> losses_;
  bool main_;  // this rank writes files and talks
  bool stopping_ = false;
  std::vector<double> recent_;  // sums of losses_ since the last line of the log
  double recent_norm_ = 0, shown_loss_ = 0;
  size_t recent_count_ = 0;
};

}  // namespace sinew
#endif
