// SPDX-License-Identifier: MIT
// Binds inside a transfer: what binders make of source and target, as rows of welded vertices.
#ifndef SINEW_TRANSFER_REBIND_HPP
#define SINEW_TRANSFER_REBIND_HPP

#include "transfer/plan.hpp"
#include "weights/rows.hpp"

namespace sinew::transferring {

// Rows of welded vertices; those without weight stay empty.
struct OwnRows {
  GivenRows given;
  uint8_t* ones = nullptr;  // [V] scratch: all rows are given

  bool allocate(Arena& arena, const Counts& counts) {
    ones = arena.alloc<uint8_t>(counts.vertices);
    return given.allocate(arena, counts);
  }
  const Rows& rows() const { return given.rows; }
  // From rows of the caller's vertices.
  void gather(const Mesh& mesh, const uint16_t* joints, const void* weights, uint32_t format, uint32_t influence_count);
};

// Binds a mesh and gathers its rows on welded vertices.
//   welded       the mesh, or for two meshes in one its first vertices
//   also         the second one, whose vertices follow the first's, or null
//   out, other   allocated; rows of the first and the second
// Returns what sinew_bind() does.
sinew_status bind_rows(const BindPlan& plan, const Progress& progress, const sinew_mesh& mesh,
                       const sinew_skeleton& skeleton, const Mesh& welded, const Mesh* also, Arena& arena, OwnRows* out,
                       OwnRows* other);

// A body and what it wears as one mesh.
struct DressedMesh {
  sinew_mesh mesh = {};
  bool allocate(Arena& arena, const Counts& counts);
  void join(const sinew_mesh& body, const sinew_mesh& garment);

 private:
  float* positions_ = nullptr;
  uint32_t *offsets_ = nullptr, *corners_ = nullptr;
};

}  // namespace sinew::transferring
#endif
