// SPDX-License-Identifier: MIT
// The surface around a lattice at rest, for measuring the depth of a lattice position inside the body.
#ifndef SINEW_DEFORM_SKIN_SURFACE_HPP
#define SINEW_DEFORM_SKIN_SURFACE_HPP

#include "core/vec3d.hpp"
#include "deform/lattice.hpp"

namespace sinew::deform {

constexpr uint32_t kMostCorners = 256;

// The point of the surface that is nearest to a position.
struct SurfacePoint {
  uint32_t triangle;
  double shares[3];  // of its corners
  Vec3d position;    // lattice units
  Vec3d outward;     // the corners' normals, blended; not a unit vector
};

// U welded vertices, T triangles, n nodes.
struct SkinSurface {
  uint32_t triangle_count = 0;
  uint32_t* triangles = nullptr;         // [T x 3], as in Mesh
  uint32_t* corner_offsets = nullptr;    // [U + 1] into corner_triangles
  uint32_t* corner_triangles = nullptr;  // [3 T] triangles of every vertex, ascending
  Vec3i* positions = nullptr;            // [U] lattice units from the grid's corner
  Vec3i* normals = nullptr;              // [U] Q14
  uint16_t* yields = nullptr;   // [U] Q14: how much of a vertex's nodes lie at no bone, 0 in a part of one joint
  uint32_t* nearest = nullptr;  // [n] vertex that is nearest to a node, along edges of the lattice; U for none

  bool allocate(Arena& arena, size_t vertices, size_t triangles, size_t nodes);
  // Only the first triangles of a larger hub are used.
  uint32_t corners_end(uint32_t vertex) const {
    const uint32_t begin = corner_offsets[vertex], end = corner_offsets[vertex + 1];
    return end - begin > kMostCorners ? begin + kMostCorners : end;
  }
  // The nearest point around `start`, downhill from vertex to vertex.
  SurfacePoint find_nearest(uint32_t start, Vec3d position) const;
};

// Fills a surface, allocated beforehand, whose positions were filled, but for `yields`.
void fill_surface(const Mesh& mesh, const Lattice& lattice, SkinSurface* surface);
// Fills `yields`. pinned: flag of nodes that lie at a bone; rigid [U]: vertices that do not yield at all.
void fill_yields(const Lattice& lattice, const uint8_t* node_flags, uint8_t pinned, const uint8_t* rigid,
                 uint32_t welded_count, SkinSurface* surface);

}  // namespace sinew::deform
#endif
