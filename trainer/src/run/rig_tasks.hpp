// SPDX-License-Identifier: MIT
// Skeletons as tasks of a training run: votes, the published method's slots, and where a mesh faces.
#ifndef SINEW_TRAINER_RUN_RIG_TASKS_HPP
#define SINEW_TRAINER_RUN_RIG_TASKS_HPP

#include <memory>
#include <string>
#include <vector>

#include "run/task.hpp"
#include "sinew_trainer/rig_train.hpp"

namespace sinew {

class RigConfigTask : public TrainingTask {
 public:
  explicit RigConfigTask(const RigTrainConfig& config) : config_(config) {}
  std::string config_text() const override { return rig_config_json(config_); }
  std::string normalized_config(const std::string& saved, const std::string& source) const override {
    return rig_config_json(parse_rig_config(saved, source));
  }

 protected:
  const RigTrainConfig config_;
};

// Skeletons by votes.
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

// The published method, both networks at once.
class SlotTask : public RigConfigTask {
 public:
  using RigConfigTask::RigConfigTask;

  FloatNetwork make_network() const override;
  void check(const FloatNetwork& network, const std::string& source) const override;
  std::unique_ptr<SampleRunner<float>> make_runner() const override;
  std::vector<std::string> loss_names() const override;
  std::vector<double> loss(const NetworkSample& sample, const std::vector<float>& outputs,
                           std::vector<float>* d_outputs) const override;
  // The total, as drawn: training stops when it stops falling.
  std::string score_name() const override { return "total"; }
  double score(const NetworkSample& sample, const std::vector<float>& outputs) const override;
  // Every joint at the middle of the floor, nothing present, nothing connected.
  std::string baseline_name() const override { return "nothing"; }
  double baseline_score(const NetworkSample& sample) const override;
};

// Where meshes face.
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
