// SPDX-License-Identifier: MIT
// Triangles by vertex, parts of one joint, and the vertex nearest to every node.
#include "deform/skin_surface.hpp"

#include <string.h>

#include "core/triangle.hpp"

namespace sinew::deform {
namespace {

constexpr uint32_t kMostSteps = 64;   // from vertex to vertex
constexpr uint32_t kMostSweeps = 64;  // over the lattice's edges; some eight are enough

int64_t square_apart(Vec3i a, Vec3i b) {
  const Vec3i d = a - b;
  return dot(d, d);
}

void list_corners(SkinSurface* surface, uint32_t welded_count) {
  uint32_t* const offsets = surface->corner_offsets;
  const uint32_t corners = 3 * surface->triangle_count;
  for (uint32_t u = 0; u <= welded_count; ++u) offsets[u] = 0;
  for (uint32_t c = 0; c < corners; ++c) ++offsets[surface->triangles[c]];
  uint32_t total = 0;
  for (uint32_t u = 0; u <= welded_count; ++u) {
    total += offsets[u];
    offsets[u] = total;
  }
  for (uint32_t c = corners; c-- > 0;) surface->corner_triangles[--offsets[surface->triangles[c]]] = c / 3;
}

// Vertices tell the nodes around them, and nodes their neighbors, so that what is near in space but another copy stays apart.
void find_nearest_vertices(const Lattice& lattice, uint32_t welded_count, SkinSurface* surface) {
  for (uint32_t n = 0; n < lattice.node_count; ++n) surface->nearest[n] = welded_count;
  const auto offer = [&](uint32_t node, uint32_t vertex) {
    uint32_t& best = surface->nearest[node];
    if (vertex == welded_count || vertex == best) return false;
    if (best != welded_count && square_apart(lattice.nodes[node], surface->positions[vertex]) >=
                                    square_apart(lattice.nodes[node], surface->positions[best])) {
      return false;
    }
    best = vertex;
    return true;
  };
  for (uint32_t u = 0; u < welded_count; ++u) {
    const uint32_t t = lattice.vertices[u].tetrahedron;
    if (t == kNoTetrahedron) continue;
    for (size_t k = 0; k < 4; ++k) (void)offer(lattice.tetrahedra[4 * static_cast<size_t>(t) + k], u);
  }
  bool more = true;
  for (uint32_t sweep = 0; more && sweep < kMostSweeps; ++sweep) {
    more = false;
    for (uint32_t i = 0; i < lattice.edge_count; ++i) {
      const LatticeEdge& edge = lattice.edges[sweep % 2 == 0 ? i : lattice.edge_count - 1 - i];
      more |= offer(edge.b, surface->nearest[edge.a]);
      more |= offer(edge.a, surface->nearest[edge.b]);
    }
  }
}

}  // namespace

bool SkinSurface::allocate(Arena& arena, size_t vertices, size_t triangle_bound, size_t nodes) {
  triangles = arena.alloc<uint32_t>(3 * triangle_bound);
  corner_offsets = arena.alloc<uint32_t>(vertices + 1);
  corner_triangles = arena.alloc<uint32_t>(3 * triangle_bound);
  positions = arena.alloc<Vec3i>(vertices);
  normals = arena.alloc<Vec3i>(vertices);
  yields = arena.alloc<uint16_t>(vertices);
  nearest = arena.alloc<uint32_t>(nodes);
  return arena.ok();
}

SurfacePoint SkinSurface::find_nearest(uint32_t start, Vec3d position) const {
  const auto square_to = [&](uint32_t u) {
    const Vec3d d = to_double(positions[u]) - position;
    return dot(d, d);
  };
  uint32_t vertex = start;
  double least = square_to(vertex);
  for (uint32_t step = 0; step < kMostSteps; ++step) {
    uint32_t next = vertex;
    for (uint32_t c = corner_offsets[vertex]; c < corners_end(vertex); ++c) {
      for (size_t k = 0; k < 3; ++k) {
        const uint32_t other = triangles[3 * static_cast<size_t>(corner_triangles[c]) + k];
        const double square = square_to(other);
        if (square >= least) continue;
        least = square;
        next = other;
      }
    }
    if (next == vertex) break;
    vertex = next;
  }
  SurfacePoint best = {0, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  double nearest_square = 1e300;
  for (uint32_t c = corner_offsets[vertex]; c < corners_end(vertex); ++c) {
    const uint32_t* const at = triangles + 3 * static_cast<size_t>(corner_triangles[c]);
    double shares[3];
    const Vec3d corners[3] = {to_double(positions[at[0]]), to_double(positions[at[1]]), to_double(positions[at[2]])};
    nearest_on_triangle(position, corners[0], corners[1], corners[2], shares);
    const Vec3d on = shares[0] * corners[0] + shares[1] * corners[1] + shares[2] * corners[2];
    const double square = dot(on - position, on - position);
    if (square >= nearest_square) continue;
    nearest_square = square;
    best = {corner_triangles[c], {shares[0], shares[1], shares[2]}, on, {0, 0, 0}};
  }
  const uint32_t* const at = triangles + 3 * static_cast<size_t>(best.triangle);
  for (size_t k = 0; k < 3; ++k) best.outward = best.outward + best.shares[k] * to_double(normals[at[k]]);
  return best;
}

void fill_surface(const Mesh& mesh, const Lattice& lattice, SkinSurface* surface) {
  surface->triangle_count = mesh.triangle_count;
  memcpy(surface->triangles, mesh.triangles, 3 * sizeof(uint32_t) * static_cast<size_t>(mesh.triangle_count));
  memcpy(surface->normals, mesh.normals, sizeof(Vec3i) * static_cast<size_t>(mesh.welded_count));
  list_corners(surface, mesh.welded_count);
  find_nearest_vertices(lattice, mesh.welded_count, surface);
}

void fill_yields(const Lattice& lattice, const uint8_t* node_flags, uint8_t pinned, const uint8_t* rigid,
                 uint32_t welded_count, SkinSurface* surface) {
  for (uint32_t u = 0; u < welded_count; ++u) {
    const Embedding& position = lattice.vertices[u];
    int32_t sum = 0;
    for (size_t k = 0; k < 4 && position.tetrahedron != kNoTetrahedron && rigid[u] == 0; ++k) {
      const uint32_t node = lattice.tetrahedra[4 * static_cast<size_t>(position.tetrahedron) + k];
      if ((node_flags[node] & pinned) == 0) sum += position.shares[k];
    }
    surface->yields[u] = static_cast<uint16_t>(sum < 0 ? 0 : sum);
  }
}

}  // namespace sinew::deform
