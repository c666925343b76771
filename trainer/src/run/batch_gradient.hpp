// SPDX-License-Identifier: MIT
// The mean gradient of a batch: characters are shared out to ranks and threads, their gradients added in one order.
#ifndef SINEW_TRAINER_RUN_BATCH_GRADIENT_HPP
#define SINEW_TRAINER_RUN_BATCH_GRADIENT_HPP

#include <cstdint>
#include <memory>
#include <vector>

#include "core/team.hpp"
#include "network/layer_runner.hpp"
#include "run/task.hpp"
#include "sinew_trainer/ranks.hpp"
#include "sinew_trainer/train.hpp"

namespace sinew {

struct BatchItem {
  const NetworkSample* sample = nullptr;
  uint64_t seed = 0;  // of the dropout
};

class BatchGradient {
 public:
  // `task` must outlive it. `ranks` may be null. `threads` is the most that later calls ask for.
  BatchGradient(const TrainingTask& task, const RunConfig& config, uint32_t threads, Ranks* ranks);

  // Mean over the items. Items are added in the order given, whichever rank and thread did them: the same bytes for any
  // number of both. losses: TrainingTask::loss() of each item. All ranks call it with the same items.
  const std::vector<LinearBlock<float>>& run(const FloatNetwork& network, const std::vector<BatchItem>& items,
                                             uint32_t threads, std::vector<std::vector<double>>* losses);
  // TrainingTask::score() of every sample, without dropout; on all ranks.
  std::vector<double> scores(const FloatNetwork& network, const std::vector<const NetworkSample*>& samples,
                             uint32_t threads);

  const Team& team() const { return team_; }
  double wall_seconds() const { return wall_seconds_; }  // that run() took

 private:
  struct Slot {
    std::vector<LinearBlock<float>> gradients;
    std::vector<float> d_outputs;
    std::vector<double> losses;
  };
  std::vector<uint32_t> owners(const std::vector<const NetworkSample*>& samples) const;
  void exchange(const std::vector<uint32_t>& owner);

  const TrainingTask& task_;
  DropoutOptions dropout_;  // but for the seed
  Ranks* ranks_;
  Team team_;
  std::vector<std::unique_ptr<SampleRunner<float>>> runners_;  // one per thread
  std::vector<Slot> slots_;                                    // one per item
  double wall_seconds_ = 0;
};

}  // namespace sinew
#endif
