// SPDX-License-Identifier: MIT
// Stage 2 of a bind: weld, Morton order, triangles, one-ring and parts. Every order is an order of values, never
// of the caller's numbering, so renumbered input gives the same mesh.
#include "mesh/mesh.hpp"

#include "mesh/morton.hpp"
#include "mesh/shape.hpp"
#include "mesh/topology.hpp"

namespace sinew {
namespace {

void weld(const sinew_mesh& input, const GridQuantizer& quantizer, const MortonScratch& scratch, Mesh* mesh) {
  const uint32_t count = input.vertex_count;
  for (uint32_t v = 0; v < count; ++v) {
    scratch.keys[v] = morton_key(quantize_point(quantizer, input.positions + 3 * static_cast<size_t>(v)));
    scratch.order[v] = v;
  }
  mesh->welded_count = weld_keys(scratch, count, mesh->positions, mesh->vertex_to_welded);
  mesh->vertex_count = count;
}

sinew_status check_faces(const sinew_mesh& input) {
  if (input.face_offsets == nullptr) {
    if (static_cast<uint64_t>(input.face_count) * 3 != input.corner_count) return SINEW_ERROR_INDEX;
  } else if (input.face_count > 0) {
    if (input.face_offsets[0] != 0 || input.face_offsets[input.face_count] != input.corner_count)
      return SINEW_ERROR_INDEX;
    for (uint32_t f = 0; f < input.face_count; ++f) {
      if (input.face_offsets[f] > input.face_offsets[f + 1]) return SINEW_ERROR_INDEX;
      if (input.face_offsets[f + 1] - input.face_offsets[f] < 2) return SINEW_ERROR_INDEX;
    }
  } else if (input.corner_count != 0) {
    return SINEW_ERROR_INDEX;
  }
  for (uint32_t c = 0; c < input.corner_count; ++c) {
    if (input.face_vertices[c] >= input.vertex_count) return SINEW_ERROR_INDEX;
  }
  return SINEW_OK;
}

// Walks the fan triangles of a polygon mesh in welded indices, smallest first, degenerate ones left out.
class FanWalk {
 public:
  FanWalk(const sinew_mesh& input, const Mesh& mesh) : input_(input), mesh_(mesh) { open_face(); }

  // False at the end. triangle [3] out.
  bool next(uint32_t* triangle) {
    while (face_ < input_.face_count) {
      if (corner_ + 2 > last_) {  // corner_ + 1 is the triangle's last corner
        ++face_;
        open_face();
        continue;
      }
      const uint32_t a = welded(first_), b = welded(corner_), c = welded(corner_ + 1);
      ++corner_;
      if (!has_area(mesh_.positions, a, b, c)) continue;  // a repeated vertex too
      turn_smallest_first(a, b, c, triangle);
      return true;
    }
    return false;
  }

 private:
  void open_face() {
    if (face_ >= input_.face_count) return;
    first_ = input_.face_offsets != nullptr ? input_.face_offsets[face_] : static_cast<uint64_t>(face_) * 3;
    last_ = input_.face_offsets != nullptr ? input_.face_offsets[face_ + 1] : first_ + 3;
    corner_ = first_ + 1;
  }
  uint32_t welded(uint64_t corner) const { return mesh_.vertex_to_welded[input_.face_vertices[corner]]; }

  const sinew_mesh& input_;
  const Mesh& mesh_;
  uint32_t face_ = 0;
  uint64_t first_ = 0, last_ = 0, corner_ = 0;
};

}  // namespace

bool Mesh::allocate(Arena& arena, const Counts& counts) {
  const size_t v = counts.vertices, t = counts.triangles();
  vertex_to_welded = arena.alloc<uint32_t>(v);
  positions = arena.alloc<Vec3i>(v);
  triangles = arena.alloc<uint32_t>(3 * t);
  row_offsets = arena.alloc<uint32_t>(v + 1);
  col_indices = arena.alloc<uint32_t>(6 * t);
  normals = arena.alloc<Vec3i>(v);
  areas = arena.alloc<uint64_t>(v);
  mean_curvature = arena.alloc<int32_t>(v);
  gauss_curvature = arena.alloc<int32_t>(v);
  edge_length = arena.alloc<uint32_t>(v);
  part = arena.alloc<uint32_t>(v);
  part_sizes = arena.alloc<uint32_t>(v);
  part_offsets = arena.alloc<uint32_t>(v + 1);
  part_vertices = arena.alloc<uint32_t>(v);
  return arena.ok();
}

sinew_status build_mesh(const sinew_mesh& input, const GridQuantizer& quantizer, const Counts& counts, Arena& arena,
                        Mesh* mesh) {
  if (!arena.measuring()) {
    const sinew_status status = check_faces(input);
    if (status != SINEW_OK) return status;
  }
  // The scratch of the three phases does not overlap in time, so each starts at the same place.
  {
    const ArenaScope scope(arena);
    MortonScratch scratch;
    if (!scratch.allocate(arena, counts.vertices)) return SINEW_ERROR_WORKSPACE;
    if (!arena.measuring()) weld(input, quantizer, scratch, mesh);
  }
  {
    const ArenaScope scope(arena);
    TriangleScratch scratch;
    if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
    if (!arena.measuring()) collect_triangles(FanWalk(input, *mesh), scratch, mesh);
  }
  const ArenaScope scope(arena);
  TopologyScratch scratch;
  if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  connect(nullptr, 0, scratch, mesh);
  label_parts(scratch, mesh);
  find_shape(scratch.shape, counts.threads, mesh);
  return SINEW_OK;
}

}  // namespace sinew
