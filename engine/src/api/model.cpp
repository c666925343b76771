// SPDX-License-Identifier: MIT
// The C API: model files for sinew_bind(), and weights packed beforehand for any model.
#include "sinew/model.h"

#include "api/arguments.hpp"
#include "bind/bind.hpp"
#include "model/reader.hpp"
#include "network/packed_layers.hpp"

// The library writes the whole struct: callers with an older header have no room for a longer one.
static_assert(sizeof(sinew_model) == (sizeof(void*) == 8 ? 128 : 116), "new members take their room from reserved");

extern "C" {

sinew_status sinew_model_open(const void* bytes, size_t size_bytes, sinew_model* model) {
  if (bytes == nullptr || model == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::ModelHeader header;
  const sinew_status status = sinew::read_header(bytes, size_bytes, &header);
  if (status != SINEW_OK) return status;
  sinew::ModelTask task;
  if (header.task != sinew::kTaskBind) return SINEW_ERROR_MODEL_TASK;
  if (!sinew::bind_task(header.feature_set, &task)) return SINEW_ERROR_MODEL_VERSION;
  return sinew::open_model(bytes, size_bytes, task, model);
}

sinew_status sinew_model_pack_workspace_size(const sinew_model* model, size_t* size_bytes) {
  if (model == nullptr || model->bytes == nullptr || size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = sinew::packed_bytes(*model);
  return SINEW_OK;
}

sinew_status sinew_model_pack(sinew_model* model, void* memory, size_t memory_bytes) {
  if (model == nullptr || model->bytes == nullptr || memory == nullptr) return SINEW_ERROR_ARGUMENT;
  const size_t bytes = sinew::packed_bytes(*model);
  if (memory_bytes < bytes || !sinew::is_aligned(memory)) return SINEW_ERROR_WORKSPACE;
  if (bytes == 0) return SINEW_OK;
  sinew::pack_model(*model, static_cast<uint8_t*>(memory));
  model->packed = memory;
  return SINEW_OK;
}

}  // extern "C"
