// SPDX-License-Identifier: MIT
// Opens the network of connections behind that of joints.
#include "rig/slots_model.hpp"

#include "rig/joint_slots.hpp"

namespace sinew {

sinew_status open_connections(const sinew_model& model, sinew_model* connections) {
  ModelTask task;
  sinew_model again;
  size_t second = 0;
  if (!slots_task(kSlotsFeatureSet, &task)) return SINEW_ERROR_MODEL_TASK;
  sinew_status status = open_model(model.bytes, model.size_bytes, task, &again, &second);
  if (status != SINEW_OK) return status;
  if (second == 0) return SINEW_ERROR_MODEL_LAYOUT;
  ModelHeader header;
  const size_t size = model.size_bytes - second;
  status = read_header(model.bytes + second, size, &header);
  if (status != SINEW_OK) return status;
  if (header.task != kTaskRig || header.feature_set != kConnectionsFeatureSet) return SINEW_ERROR_MODEL_TASK;
  if (!slots_task(kConnectionsFeatureSet, &task)) return SINEW_ERROR_MODEL_TASK;
  return open_model(model.bytes + second, size, task, connections);
}

}  // namespace sinew
