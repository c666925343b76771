// SPDX-License-Identifier: MIT
// Skeleton prediction as a task of a training run.
#ifndef SINEW_TRAINER_RUN_RIG_TASK_HPP
#define SINEW_TRAINER_RUN_RIG_TASK_HPP

#include "run/rig_config_task.hpp"

namespace sinew {

class RigTask : public RigConfigTask {
 public:
  using RigConfigTask::RigConfigTask;

  FloatNetwork make_network() const override;
  void check(const FloatNetwork& network, const std::string& source) const override;
  std::vector<std::string> loss_names() const override;
  std::vector<double> loss(const NetworkSample& sample, const std::vector<float>& outputs,
                           std::vector<float>* d_outputs) const override;
  // Mean distance of both ends of a point's bone, share of the side.
  std::string score_name() const override { return "distance"; }
  double score(const NetworkSample& sample, const std::vector<float>& outputs) const override;
  // The medial point as both ends.
  std::string baseline_name() const override { return "medial"; }
  double baseline_score(const NetworkSample& sample) const override;
};

}  // namespace sinew
#endif
