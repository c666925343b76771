// SPDX-License-Identifier: MIT
// What a training run asks about skeletons.
#include "run/rig_task.hpp"

#include "network/rig_network.hpp"
#include "run/rig_loss.hpp"
#include "run/sample_as.hpp"
#include "sinew_formats/error.hpp"
#include "votes/rig_task.hpp"

namespace sinew {

FloatNetwork RigTask::make_network() const {
  return make_rig_network({config_.width, config_.rounds, is_hands(config_)}, config_.seed);
}

void RigTask::check(const FloatNetwork& network, const std::string& source) const {
  check_network(network, source);
  if (network.task != kTaskRig) throw Error(source + ": not a network that predicts skeletons");
  const bool hands = network.feature_set == rigging::kHandsFeatureSet;
  if (hands != is_hands(config_))
    throw Error(source + ": a network of " + (hands ? "hands" : "bodies") + ", expected one of " + config_.part);
}

std::vector<std::string> RigTask::loss_names() const {
  return {"loss", "start", "end", "start_class", "end_class", "start_distance", "end_distance"};
}

std::vector<double> RigTask::loss(const NetworkSample& sample, const std::vector<float>& outputs,
                                  std::vector<float>* d_outputs) const {
  const RigLoss l = rig_loss(sample_as<RigSample>(sample), outputs, d_outputs);
  return {l.total, l.start, l.end, l.start_class, l.end_class, l.start_distance, l.end_distance};
}

double RigTask::score(const NetworkSample& sample, const std::vector<float>& outputs) const {
  const RigLoss l = rig_loss(sample_as<RigSample>(sample), outputs, nullptr);
  return 0.5 * (l.start_distance + l.end_distance);
}

double RigTask::baseline_score(const NetworkSample& sample) const {
  return score(sample, std::vector<float>(size_t{sample.vertices} * rigging::kRigOutputs, 0.0f));
}

}  // namespace sinew
