// SPDX-License-Identifier: MIT
// Runs binds in the transfer's own workspace.
#include "transfer/rebind.hpp"

#include <string.h>

#include "bind/bind.hpp"
#include "weights/users_say.hpp"

namespace sinew::transferring {

void OwnRows::gather(const Mesh& mesh, const uint16_t* joints, const void* weights, uint32_t format,
                     uint32_t influence_count) {
  memset(ones, 1, mesh.vertex_count);
  gather_given_rows(mesh, ones, nullptr, joints, weights, format, influence_count, &given);
}

sinew_status bind_rows(const BindPlan& plan, const Progress& progress, const sinew_mesh& mesh,
                       const sinew_skeleton& skeleton, const Mesh& welded, const Mesh* also, Arena& arena, OwnRows* out,
                       OwnRows* other) {
  const ArenaScope scope(arena);
  const uint32_t n = plan.rows.influence_count;
  const size_t slots = static_cast<size_t>(plan.counts.vertices) * n;
  uint16_t* const joints = arena.alloc<uint16_t>(slots);
  uint16_t* const weights = arena.alloc<uint16_t>(slots);
  Arena size;
  measure_bind(size, plan);
  uint8_t* const workspace = arena.alloc<uint8_t>(size.high_water());
  if (!size.ok() || !arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = joints;
  outputs.weights = weights;
  BindPlan own = plan;
  own.progress = progress;
  const sinew_status status = run_bind(own, mesh, skeleton, workspace, size.high_water(), &outputs);
  if (status != SINEW_OK) return status;
  out->gather(welded, joints, weights, SINEW_WEIGHT_UNORM16, n);
  if (also != nullptr) {
    const size_t first = static_cast<size_t>(welded.vertex_count) * n;
    other->gather(*also, joints + first, weights + first, SINEW_WEIGHT_UNORM16, n);
  }
  return SINEW_OK;
}

bool DressedMesh::allocate(Arena& arena, const Counts& counts) {
  positions_ = arena.alloc<float>(3 * static_cast<size_t>(counts.vertices));
  offsets_ = arena.alloc<uint32_t>(static_cast<size_t>(counts.faces) + 1);
  corners_ = arena.alloc<uint32_t>(counts.corners);
  return arena.ok();
}

void DressedMesh::join(const sinew_mesh& body, const sinew_mesh& garment) {
  uint32_t faces = 0, corners = 0, vertices = 0;
  offsets_[0] = 0;
  const sinew_mesh* const both[] = {&body, &garment};
  for (const sinew_mesh* one : both) {
    memcpy(positions_ + size_t{3} * vertices, one->positions, size_t{3} * one->vertex_count * sizeof(float));
    for (uint32_t c = 0; c < one->corner_count; ++c) corners_[corners + c] = one->face_vertices[c] + vertices;
    for (uint32_t f = 0; f < one->face_count; ++f)
      offsets_[++faces] = corners + (one->face_offsets != nullptr ? one->face_offsets[f + 1] : 3 * (f + 1));
    vertices += one->vertex_count;
    corners += one->corner_count;
  }
  mesh = {positions_, vertices, offsets_, corners_, faces, corners};
}

}  // namespace sinew::transferring
