// SPDX-License-Identifier: MIT
// What the tasks that predict skeletons have in common: their configuration.
#ifndef SINEW_TRAINER_RUN_RIG_CONFIG_TASK_HPP
#define SINEW_TRAINER_RUN_RIG_CONFIG_TASK_HPP

#include "run/task.hpp"
#include "sinew_trainer/rig_train.hpp"

namespace sinew {

class RigConfigTask : public TrainingTask {
 public:
  explicit RigConfigTask(const RigTrainConfig& config) : config_(config) {}
  std::string config_text() const override { return rig_config_json(config_); }
  std::string normalised_config(const std::string& saved, const std::string& source) const override {
    return rig_config_json(parse_rig_config(saved, source));
  }

 protected:
  const RigTrainConfig config_;
};

}  // namespace sinew
#endif
