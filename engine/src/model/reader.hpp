// SPDX-License-Identifier: MIT
// Opens a model file in place: every byte is checked here, before the first run, and nothing after.
#ifndef SINEW_MODEL_READER_HPP
#define SINEW_MODEL_READER_HPP

#include "model/task.hpp"
#include "sinew/sinew.h"

namespace sinew {

// The part of a file that does not depend on its task.
struct ModelHeader {
  uint32_t task = 0;         // model/task.hpp
  uint32_t feature_set = 0;  // version and flags of the features that it was trained with
};

// Checks what is the same for all tasks and proves the file whole. `bytes` is not null. Returns SINEW_OK or
//   SINEW_ERROR_MODEL_ALIGNMENT  the address is no multiple of 8
//   SINEW_ERROR_MODEL_TRUNCATED  fewer bytes than a header, or another number of bytes than the header says
//   SINEW_ERROR_MODEL_MAGIC      it does not begin as a model file does
//   SINEW_ERROR_MODEL_VERSION    a format that this library does not know
//   SINEW_ERROR_MODEL_CHECKSUM   bytes changed since the file was written
sinew_status read_header(const void* bytes, size_t size_bytes, ModelHeader* header);

// Checks the rest of a file that read_header() accepted and fills *model, which is untouched on failure. The task is that
// of the header. Returns SINEW_OK or
//   SINEW_ERROR_MODEL_VERSION   the inputs have other names, domains or channels than the task's
//   SINEW_ERROR_MODEL_LAYOUT    a table contradicts itself: shapes, domains, order, offsets, shifts, reserved bytes; or the
//                               last layer does not write the task's output
//   SINEW_ERROR_MODEL_OVERFLOW  an accumulator could leave its type for some input
//   with_second  the file may contain a second network, which is ignored
sinew_status open_model(const void* bytes, size_t size_bytes, const ModelTask& task, sinew_model* model,
                        bool with_second = false);

// As open_model(), for bytes that it has accepted; skips all checks.
sinew_model proven_model(const uint8_t* bytes, size_t size_bytes, const ModelTask& task);

// Where the file of a second network begins in an opened model's bytes; 0: none.
size_t second_network(const sinew_model& model);

}  // namespace sinew
#endif
