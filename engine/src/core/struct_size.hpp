// SPDX-License-Identifier: MIT
// Structs of the interface that grow (sinew/types.h): a caller's header may be older or newer than the library, so its
// struct is read into the library's own first, and what the library wrote is copied back.
#ifndef SINEW_CORE_STRUCT_SIZE_HPP
#define SINEW_CORE_STRUCT_SIZE_HPP

#include <string.h>

#include "sinew/types.h"

namespace sinew {

// No struct will ever be larger. A larger struct_size was never set, so nothing is read behind it.
constexpr uint32_t kLargestStruct = 4096;

// Copies the caller's struct, which begins with its struct_size, into `own` of `size` bytes. Members that the caller's
// header lacks are 0. Returns SINEW_OK; SINEW_ERROR_ARGUMENT for a struct_size below `first_size`, that of the first
// release, or above kLargestStruct; SINEW_ERROR_VERSION when a byte behind `size` is not 0. `own` is untouched then.
inline sinew_status read_struct(const void* caller, uint32_t first_size, uint32_t size, void* own) {
  uint32_t given;
  memcpy(&given, caller, sizeof given);
  if (given < first_size || given > kLargestStruct) return SINEW_ERROR_ARGUMENT;
  for (uint32_t i = size; i < given; ++i) {
    if (static_cast<const uint8_t*>(caller)[i] != 0) return SINEW_ERROR_VERSION;
  }
  memset(own, 0, size);
  memcpy(own, caller, given < size ? given : size);
  return SINEW_OK;
}

// Copies `own`, filled by read_struct(), back: as many of its `size` bytes as the caller's struct has.
inline void write_struct(const void* own, uint32_t size, void* caller) {
  uint32_t given;
  memcpy(&given, own, sizeof given);
  memcpy(caller, own, given < size ? given : size);
}

}  // namespace sinew
#endif
