// SPDX-License-Identifier: MIT
// The training tasks of votes, slots and fronts.
#include "run/rig_tasks.hpp"

#include "network/networks.hpp"
#include "network/slot_network.hpp"
#include "run/rig_loss.hpp"
#include "sinew_formats/error.hpp"
#include "votes/rig_task.hpp"

namespace sinew {

FloatNetwork RigTask::make_network() const {
  return make_rig_network({config_.width, config_.rounds, is_hands(config_)}, config_.seed);
}

void RigTask::check(const FloatNetwork& network, const std::string& source) const {
  check_network(network, source);
  if (network.task != kTaskRig) throw Error(source + ": expected a network that predicts skeletons");
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

FloatNetwork SlotTask::make_network() const { return make_slot_network({config_.width, config_.rounds}, config_.seed); }

void SlotTask::check(const FloatNetwork& network, const std::string& source) const {
  check_slot_network(network, source);
}

std::unique_ptr<SampleRunner<float>> SlotTask::make_runner() const { return std::make_unique<SlotRunner<float>>(); }

std::vector<std::string> SlotTask::loss_names() const {
  return {"total", "joints", "connections", "distance", "presence"};
}

std::vector<double> SlotTask::loss(const NetworkSample& sample, const std::vector<float>& outputs,
                                   std::vector<float>* d_outputs) const {
  const SlotLoss l =
      slot_loss(sample_as<SlotSample>(sample), {config_.balance, config_.losses == "balanced"}, outputs, d_outputs);
  return {l.total, l.joints, l.connections, l.distance, l.presence};
}

double SlotTask::score(const NetworkSample& sample, const std::vector<float>& outputs) const {
  return slot_loss(sample_as<SlotSample>(sample), {config_.balance, config_.losses == "balanced"}, outputs, nullptr)
      .total;
}

double SlotTask::baseline_score(const NetworkSample& sample) const {
  return score(sample, std::vector<float>(kSlotOutputs, 0.0f));
}

FloatNetwork FrontTask::make_network() const {
  return make_front_network({config_.width, config_.rounds}, config_.seed);
}

void FrontTask::check(const FloatNetwork& network, const std::string& source) const {
  check_network(network, source);
  if (network.task != kTaskRig || network.feature_set != rigging::kFrontFeatureSet)
    throw Error(source + ": expected a network that predicts the front of a mesh");
}

std::vector<std::string> FrontTask::loss_names() const { return {"loss", "front", "upright", "angle"}; }

std::vector<double> FrontTask::loss(const NetworkSample& sample, const std::vector<float>& outputs,
                                    std::vector<float>* d_outputs) const {
  const FrontLoss l = front_loss(sample_as<FrontSample>(sample), outputs, d_outputs);
  return {l.total, l.front, l.upright, l.angle};
}

double FrontTask::score(const NetworkSample& sample, const std::vector<float>& outputs) const {
  return front_loss(sample_as<FrontSample>(sample), outputs, nullptr).angle;
}

}  // namespace sinew
