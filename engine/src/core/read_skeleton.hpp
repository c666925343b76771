// SPDX-License-Identifier: MIT
// The caller's sinew_skeleton, of any version, which axis of it is up, and whether names of its joints are equal.
#ifndef SINEW_CORE_READ_SKELETON_HPP
#define SINEW_CORE_READ_SKELETON_HPP

#include <stddef.h>

#include "core/struct_size.hpp"
#include "sinew/skeleton.h"

namespace sinew {

// The struct of the first release, 0.1.
constexpr uint32_t kFirstSkeletonSize = offsetof(sinew_skeleton, reserved) + sizeof(uint32_t);
static_assert(sizeof(sinew_skeleton) == 4 * sizeof(uint32_t) + 6 * sizeof(void*), "a hole in sinew_skeleton");

// The caller's skeleton, of any version. Its arrays may be null.
inline sinew_status read_skeleton_counts(const sinew_skeleton* skeleton, sinew_skeleton* own) {
  if (skeleton == nullptr) return SINEW_ERROR_ARGUMENT;
  const sinew_status status = read_struct(skeleton, kFirstSkeletonSize, sizeof *own, own);
  if (status != SINEW_OK) return status;
  if (own->up > SINEW_UP_Z) return SINEW_ERROR_ARGUMENT;
  return own->reserved == 0 ? SINEW_OK : SINEW_ERROR_VERSION;
}
// The same with the arrays that every call reads.
inline sinew_status read_skeleton(const sinew_skeleton* skeleton, sinew_skeleton* own) {
  const sinew_status status = read_skeleton_counts(skeleton, own);
  if (status != SINEW_OK) return status;
  return own->positions != nullptr && own->parents != nullptr ? SINEW_OK : SINEW_ERROR_ARGUMENT;
}

// *up_axis is 0 for Y, which AUTO represents, and 1 for Z. SINEW_ERROR_ARGUMENT for all else.
inline sinew_status read_up_axis(uint32_t up, uint32_t* up_axis) {
  if (up != SINEW_UP_AUTO && up != SINEW_UP_Y && up != SINEW_UP_Z) return SINEW_ERROR_ARGUMENT;
  *up_axis = up == SINEW_UP_Z ? 1 : 0;
  return SINEW_OK;
}

// Equal strings; the engine calls memory routines alone.
inline bool same_text(const char* a, const char* b) {
  while (*a != 0 && *a == *b) {
    ++a;
    ++b;
  }
  return *a == *b;
}

}  // namespace sinew
#endif
