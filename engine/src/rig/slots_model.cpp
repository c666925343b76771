// SPDX-License-Identifier: MIT
// Opens the network of connections behind that of joints.
#include "rig/slots_model.hpp"

#include "rig/joint_slots.hpp"

namespace sinew::rigging {

sinew_status prove_connections(const sinew_model& model) {
  const size_t second = second_network(model);
  if (second == 0) return SINEW_ERROR_MODEL_LAYOUT;
  const size_t size = model.size_bytes - second;
  ModelHeader header;
  const sinew_status status = read_header(model.bytes + second, size, &header);
  if (status != SINEW_OK) return status;
  ModelTask task;
  if (header.task != kTaskRig || header.feature_set != kConnectionsFeatureSet || !slots_task(header.feature_set, &task))
    return SINEW_ERROR_MODEL_TASK;
  sinew_model connections;
  return open_model(model.bytes + second, size, task, &connections);
}

sinew_model connections_of(const sinew_model& model) {
  ModelTask task;
  (void)slots_task(kConnectionsFeatureSet, &task);
  const size_t second = second_network(model);
  return proven_model(model.bytes + second, model.size_bytes - second, task);
}

}  // namespace sinew::rigging
