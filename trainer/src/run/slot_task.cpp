// SPDX-License-Identifier: MIT
// What a training run asks about slots.
#include "run/slot_task.hpp"

#include "network/slot_network.hpp"
#include "run/sample_as.hpp"
#include "run/slot_loss.hpp"

namespace sinew {

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

}  // namespace sinew
