// SPDX-License-Identifier: MIT
// What surface points look like to a network.
#include "votes/rig_task.hpp"

namespace sinew::rigging {

bool rig_task(uint32_t feature_set, ModelTask* task) {
  if (feature_set != kRigFeatureSet && feature_set != kHandsFeatureSet) return false;
  *task = ModelTask();
  task->id = kTaskRig;
  task->input_count = 1;
  task->inputs[0] = {input_name("pnts"), {Domain::kVertex, static_cast<uint16_t>(kRigChannels)}};
  task->output = {Domain::kVertex, static_cast<uint16_t>(kRigOutputs)};
  task->far_neighbours = true;
  return true;
}

}  // namespace sinew::rigging
