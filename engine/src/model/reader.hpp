// SPDX-License-Identifier: MIT
// Opens a model file in place: every byte is checked here, before the first run, and nothing after.
#ifndef SINEW_MODEL_READER_HPP
#define SINEW_MODEL_READER_HPP

#include "sinew/sinew.h"

namespace sinew {

// What sinew_model_open() promises; see sinew.h. `bytes` is not null.
//   SINEW_ERROR_MODEL_ALIGNMENT  the address is no multiple of 8
//   SINEW_ERROR_MODEL_MAGIC, _VERSION, _TRUNCATED, _CHECKSUM  as in sinew.h; _VERSION also for another feature set or
//   other
//                                numbers of input channels than this library computes
//   SINEW_ERROR_MODEL_LAYOUT     a table contradicts itself: shapes, domains, order, offsets, shifts, reserved bytes
//   SINEW_ERROR_MODEL_OVERFLOW   an accumulator could leave its type for some input
sinew_status open_model(const void* bytes, size_t size_bytes, sinew_model* model);

}  // namespace sinew
#endif
