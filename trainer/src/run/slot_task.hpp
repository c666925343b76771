// SPDX-License-Identifier: MIT
// The published method as a task of a training run: both networks at once.
#ifndef SINEW_TRAINER_RUN_SLOT_TASK_HPP
#define SINEW_TRAINER_RUN_SLOT_TASK_HPP

#include <memory>

#include "run/rig_config_task.hpp"

namespace sinew {

class SlotTask : public RigConfigTask {
 public:
  using RigConfigTask::RigConfigTask;

  FloatNetwork make_network() const override;
  void check(const FloatNetwork& network, const std::string& source) const override;
  std::unique_ptr<SampleRunner<float>> make_runner() const override;
  std::vector<std::string> loss_names() const override;
  std::vector<double> loss(const NetworkSample& sample, const std::vector<float>& outputs,
                           std::vector<float>* d_outputs) const override;
  // The total, as drawn: training stops when it no longer falls.
  std::string score_name() const override { return "total"; }
  double score(const NetworkSample& sample, const std::vector<float>& outputs) const override;
  // Every joint at the middle of the floor, nothing present, nothing connected.
  std::string baseline_name() const override { return "nothing"; }
  double baseline_score(const NetworkSample& sample) const override;
};

}  // namespace sinew
#endif
