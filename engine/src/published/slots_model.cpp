// SPDX-License-Identifier: MIT
// Opens the network of joints and that of connections behind it.
#include "model/reader.hpp"
#include "published/slots.hpp"

namespace sinew::rigging {
namespace {

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

}  // namespace

sinew_status open_slots_model(const void* bytes, size_t size_bytes, sinew_model* model) {
  ModelTask task;
  (void)slots_task(kSlotsFeatureSet, &task);
  sinew_model opened;
  sinew_status status = open_model(bytes, size_bytes, task, &opened, true);
  if (status == SINEW_OK) status = prove_connections(opened);
  if (status == SINEW_OK) *model = opened;
  return status;
}

sinew_status plan_slots(const sinew_model* model, SlotsPlan* plan) {
  if (model == nullptr || model->bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  if (model->task != kTaskRig || model->feature_set != kSlotsFeatureSet) return SINEW_ERROR_MODEL_TASK;
  plan->joints = *model;
  plan->connections = connections_of(*model);
  return SINEW_OK;
}

sinew_model connections_of(const sinew_model& model) {
  ModelTask task;
  (void)slots_task(kConnectionsFeatureSet, &task);
  const size_t second = second_network(model);
  return proven_model(model.bytes + second, model.size_bytes - second, task);
}

}  // namespace sinew::rigging
