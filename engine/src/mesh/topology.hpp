// SPDX-License-Identifier: MIT
// From a list of triangles to the rest of a mesh in canonical order: for the caller's mesh and for the reduced one.
#ifndef SINEW_MESH_TOPOLOGY_HPP
#define SINEW_MESH_TOPOLOGY_HPP

#include "core/sort.hpp"
#include "mesh/mesh.hpp"
#include "mesh/shape.hpp"

namespace sinew {

struct TriangleScratch {
  uint64_t* keys;     // [T] the two other corners of a triangle, grouped by its smallest
  uint32_t* offsets;  // [U + 1]
  bool allocate(Arena& arena, const Counts& counts) {
    keys = arena.alloc<uint64_t>(counts.triangles());
    offsets = arena.alloc<uint32_t>(static_cast<size_t>(counts.vertices) + 1);
    return arena.ok();
  }
};

struct TopologyScratch {
  ShapeScratch shape;
  uint64_t* part_keys;  // [U]
  uint32_t* labels;     // [U]
  bool allocate(Arena& arena, const Counts& counts) {
    shape.boundary = arena.alloc<uint8_t>(counts.vertices);
    shape.normal_sums = arena.alloc<Vec3l>(counts.vertices);
    shape.angle_sums = arena.alloc<int64_t>(counts.vertices);
    shape.triangles = arena.alloc<TriangleShape>(counts.threads.round_size(counts.triangles()));
    part_keys = arena.alloc<uint64_t>(counts.vertices);
    labels = arena.alloc<uint32_t>(counts.vertices);
    return arena.ok();
  }
};

// Sizes of groups to the end of each: counted down to the begin while the groups are filled.
inline void sum_up(uint32_t* sizes, uint32_t count) {
  uint32_t total = 0;
  for (uint32_t i = 0; i < count; ++i) {
    total += sizes[i];
    sizes[i] = total;
  }
}

inline uint64_t pack_pair(uint32_t high, uint32_t low) { return (static_cast<uint64_t>(high) << 32) | low; }

// Whether three points span an area.
bool has_area(const Vec3i* positions, uint32_t a, uint32_t b, uint32_t c);
// The corners with the smallest first, orientation kept.
inline void turn_smallest_first(uint32_t a, uint32_t b, uint32_t c, uint32_t* triangle) {
  const int rotation = a < b ? (a < c ? 0 : 2) : (b < c ? 1 : 2);
  triangle[0] = rotation == 0 ? a : rotation == 1 ? b : c;
  triangle[1] = rotation == 0 ? b : rotation == 1 ? c : a;
  triangle[2] = rotation == 0 ? c : rotation == 1 ? a : b;
}
// Sorts the triangles of the groups in scratch, drops all but the first of every vertex set and fills mesh->triangles.
void finish_triangles(const TriangleScratch& scratch, Mesh* mesh);

// Fills mesh->triangles from a walk that gives them one by one (bool next(uint32_t triangle[3]), smallest corner first,
// with area); the walk is copied and gone through twice. mesh->welded_count is set.
template <class Walk>
void collect_triangles(const Walk& start, const TriangleScratch& scratch, Mesh* mesh) {
  const uint32_t count = mesh->welded_count;
  for (uint32_t v = 0; v <= count; ++v) scratch.offsets[v] = 0;
  uint32_t t[3];
  for (Walk walk = start; walk.next(t);) ++scratch.offsets[t[0]];
  sum_up(scratch.offsets, count + 1);
  for (Walk walk = start; walk.next(t);) {
    // Sorted by vertex set first: (smaller, larger), the orientation in the lowest bit. Indices stay below 2^22.
    const bool swapped = t[1] > t[2];
    scratch.keys[--scratch.offsets[t[0]]] =
        (pack_pair(swapped ? t[2] : t[1], swapped ? t[1] : t[2]) << 1) | (swapped ? 1u : 0u);
  }
  finish_triangles(scratch, mesh);
}

// Fills row_offsets and col_indices from the triangles, and scratch.shape.boundary. loose [loose_count x 2]: pairs of
// vertices to be neighbors without a triangle, none twice.
void connect(const uint32_t* loose, uint32_t loose_count, const TopologyScratch& scratch, Mesh* mesh);
// Fills the parts from the CSR.
void label_parts(const TopologyScratch& scratch, Mesh* mesh);

}  // namespace sinew
#endif
