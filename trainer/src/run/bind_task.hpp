// SPDX-License-Identifier: MIT
// Skin weights as a training task: networks over candidates, distance of the weights, heat as the baseline.
#ifndef SINEW_TRAINER_RUN_BIND_TASK_HPP
#define SINEW_TRAINER_RUN_BIND_TASK_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "run/loss.hpp"
#include "run/task.hpp"
#include "sinew_formats/float_network.hpp"
#include "sinew_trainer/train.hpp"

namespace sinew {

// Input channels that a configuration does without.
struct AbsentChannels {
  std::vector<uint32_t> vertex, pair;  // ascending
};
// Of TrainConfig::without. Throws Error naming `source`: no channel has the name, or it is the heat prior's.
AbsentChannels absent_channels(const std::vector<std::string>& names, const std::string& source);
// Sets the weights that read them to 0.
void clear_weights(const AbsentChannels& absent, FloatNetwork* network);

// Its samples are of type Sample.
class BindTask : public TrainingTask {
 public:
  // Throws Error for a configuration that a file could not hold either, naming the key.
  explicit BindTask(const TrainConfig& config);

  FloatNetwork make_network() const override;
  void check(const FloatNetwork& network, const std::string& source) const override;
  void prepare(FloatNetwork* network) const override;
  FloatNetwork finished(const FloatNetwork& trained) const override;
  DropoutOptions channels() const override;
  std::vector<std::string> loss_names() const override;
  std::vector<double> loss(const NetworkSample& sample, const std::vector<float>& outputs,
                           std::vector<float>* d_outputs) const override;
  std::string score_name() const override { return "l1"; }
  double score(const NetworkSample& sample, const std::vector<float>& outputs) const override;
  std::string baseline_name() const override { return "heat"; }
  double baseline_score(const NetworkSample& sample) const override;
  std::string config_text() const override;
  std::string normalized_config(const std::string& saved, const std::string& source) const override;

 private:
  const TrainConfig config_;
  const LossWeights loss_;
  const AbsentChannels absent_;
};

}  // namespace sinew
#endif
