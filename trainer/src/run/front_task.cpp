// SPDX-License-Identifier: MIT
// What a training run asks about fronts.
#include "run/front_task.hpp"

#include "network/front_network.hpp"
#include "run/front_loss.hpp"
#include "run/sample_as.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

FloatNetwork FrontTask::make_network() const {
  return make_front_network({config_.width, config_.rounds}, config_.seed);
}

void FrontTask::check(const FloatNetwork& network, const std::string& source) const {
  check_network(network, source);
  if (network.task != kTaskRig || network.feature_set != rigging::kFrontFeatureSet)
    throw Error(source + ": not a network that says where a mesh faces");
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
