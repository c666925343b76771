// SPDX-License-Identifier: MIT
// Common checks of the functions of the C API, and their size queries.
#ifndef SINEW_API_ARGUMENTS_HPP
#define SINEW_API_ARGUMENTS_HPP

#include "core/arena.hpp"
#include "core/read_skeleton.hpp"

namespace sinew {

inline bool is_mesh(const sinew_mesh* mesh) {
  return mesh != nullptr && mesh->positions != nullptr && (mesh->face_count == 0 || mesh->face_vertices != nullptr);
}
inline bool is_aligned(const void* memory) {
  return reinterpret_cast<uintptr_t>(memory) % SINEW_WORKSPACE_ALIGNMENT == 0;
}

// The bytes that run(Arena&) needs; it only allocates in an arena without memory. SINEW_ERROR_COUNT where that is
// more than a size can say, else what it returns.
template <class Run>
sinew_status measure(size_t* size_bytes, Run run) {
  Arena arena;
  const sinew_status status = run(arena);
  if (status == SINEW_ERROR_WORKSPACE || !arena.ok()) return SINEW_ERROR_COUNT;
  if (status == SINEW_OK) *size_bytes = arena.high_water();
  return status;
}

}  // namespace sinew
#endif
