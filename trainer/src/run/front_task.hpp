// SPDX-License-Identifier: MIT
// Where meshes face as a task of a training run.
#ifndef SINEW_TRAINER_RUN_FRONT_TASK_HPP
#define SINEW_TRAINER_RUN_FRONT_TASK_HPP

#include "run/rig_config_task.hpp"

namespace sinew {

class FrontTask : public RigConfigTask {
 public:
  using RigConfigTask::RigConfigTask;

  FloatNetwork make_network() const override;
  void check(const FloatNetwork& network, const std::string& source) const override;
  std::vector<std::string> loss_names() const override;
  std::vector<double> loss(const NetworkSample& sample, const std::vector<float>& outputs,
                           std::vector<float>* d_outputs) const override;
  // (1 - cosine) / 2 of the angle that one frame's answer is off.
  std::string score_name() const override { return "angle"; }
  double score(const NetworkSample& sample, const std::vector<float>& outputs) const override;
  // Any direction.
  std::string baseline_name() const override { return "chance"; }
  double baseline_score(const NetworkSample& /*sample*/) const override { return 0.5; }
};

}  // namespace sinew
#endif
