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
  const sinew_status status = open_model(model.bytes, model.size_bytes, task, &again, &second);
  return status == SINEW_OK ? open_connections(model, second, connections) : status;
}

sinew_status open_connections(const sinew_model& model, size_t second, sinew_model* connections) {
  if (second == 0) return SINEW_ERROR_MODEL_LAYOUT;
  ModelHeader header;
  const size_t size = model.size_bytes - second;
  const sinew_status status = read_header(model.bytes + second, size, &header);
  if (status != SINEW_OK) return status;
  if (header.task != kTaskRig || header.feature_set != kConnectionsFeatureSet) return SINEW_ERROR_MODEL_TASK;
  ModelTask task;
  if (!slots_task(kConnectionsFeatureSet, &task)) return SINEW_ERROR_MODEL_TASK;
  return open_model(model.bytes + second, size, task, connections);
}

}  // namespace sinew
