// SPDX-License-Identifier: MIT
// Cotangent edge weights from integer geometry; Pinkall and Polthier 1993, equation 2, averaged per edge.
#include "solve/laplacian.hpp"

#include <string.h>

#include "mesh/edge_index.hpp"

namespace sinew {
namespace {

// |n| of a cross product as length * 2^shift with components brought to 31 bits, so the sum of squares stays below
// 3 * 2^62. The same at all corners of a triangle.
struct Sine {
  int64_t length;
  int shift;
};

Sine sine_of(Vec3l n) {  // components below 2^41
  const uint64_t largest = static_cast<uint64_t>(abs64(n.x) | abs64(n.y) | abs64(n.z));
  const int shift = top_bit(largest) - 30;
  const auto scaled = [shift](int64_t value) {
    const int64_t magnitude = abs64(value);
    const uint64_t s = static_cast<uint64_t>(shift > 0 ? round_shift(magnitude, shift) : magnitude << -shift);
    return s * s;
  };
  return {isqrt64(scaled(n.x) + scaled(n.y) + scaled(n.z)), shift};
}

int32_t cotangent_of(const Sine& sine, int64_t cosine) {  // below 2^42
  const int64_t length = sine.length;
  const int shift = sine.shift;
  const int64_t limit = shift >= 0 ? (kCotangentLimit * length) << shift : (kCotangentLimit * length) >> -shift;
  if (abs64(cosine) > limit) return (cosine < 0 ? -kCotangentLimit : kCotangentLimit) * (1 << kEdgeWeightBits);
  // Below the limit |cosine| <= 50 * length * 2^shift, so the dividend is at most 50 * 2^(31 + 24).
  const int lift = kEdgeWeightBits - shift;
  const int64_t dividend = cosine * (static_cast<int64_t>(1) << lift);
  const int64_t half = length / 2;
  return static_cast<int32_t>((dividend < 0 ? dividend - half : dividend + half) / length);
}

// A triangle's contribution to its edges, each in both directions.
struct TriangleEdges {
  int32_t cotangents[3];  // of the corners
  uint32_t edges[3][2];   // opposite to the corners
};

struct LaplacianScratch {
  int64_t* sums = nullptr;             // [E2] of both directions
  uint32_t* faces = nullptr;           // [E2]
  TriangleEdges* triangles = nullptr;  // [round_size() of the triangles]

  bool allocate(Arena& arena, const Counts& counts) {
    const size_t entries = 6 * static_cast<size_t>(counts.triangles());
    sums = arena.alloc<int64_t>(entries);
    faces = arena.alloc<uint32_t>(entries);
    triangles = arena.alloc<TriangleEdges>(counts.threads.round_size(counts.triangles()));
    return arena.ok();
  }
};

// For a triangle so flat that a cotangent was cut to the limit: the obtuse corner's becomes what belongs to the other
// two, because products of the three in pairs sum to 1. Without it the triangle's part of the matrix is not positive.
void fit_obtuse_corner(int32_t* cotangents) {
  constexpr int32_t kLimit = static_cast<int32_t>(kCotangentLimit * (1 << kEdgeWeightBits));
  uint32_t least = 0;
  for (uint32_t k = 1; k < 3; ++k) least = cotangents[k] < cotangents[least] ? k : least;
  const int64_t a = cotangents[(least + 1) % 3], b = cotangents[(least + 2) % 3];
  if (a < kLimit && b < kLimit) return;
  constexpr int64_t kOne = static_cast<int64_t>(1) << (2 * kEdgeWeightBits);
  cotangents[least] = static_cast<int32_t>((kOne - a * b) / (a + b));  // both others are acute, and one is the limit
}

}  // namespace

int32_t cotangent_q24(Vec3i apex, Vec3i b, Vec3i c) {
  const Vec3i u = b - apex, v = c - apex;
  return cotangent_of(sine_of(cross(u, v)), dot(u, v));
}

bool EdgeWeights::allocate(Arena& arena, const Counts& counts) {
  weight = arena.alloc<int32_t>(6 * static_cast<size_t>(counts.triangles()));
  return arena.ok();
}

sinew_status weigh_edges(const Mesh& mesh, const Counts& counts, Arena& arena, EdgeWeights* out) {
  const ArenaScope scope(arena);
  LaplacianScratch scratch;
  if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  const size_t entries = mesh.row_offsets[mesh.welded_count];
  memset(scratch.sums, 0, entries * sizeof(scratch.sums[0]));
  memset(scratch.faces, 0, entries * sizeof(scratch.faces[0]));
  const bool reduced = kHasExtras && mesh.reduced;
  const auto measure = [&](uint32_t index, uint32_t slot) {
    const uint32_t* corner = mesh.triangles + 3 * static_cast<size_t>(index);
    TriangleEdges& own = scratch.triangles[slot];
    const Vec3i sides[3] = {mesh.positions[corner[1]] - mesh.positions[corner[0]],
                            mesh.positions[corner[2]] - mesh.positions[corner[1]],
                            mesh.positions[corner[0]] - mesh.positions[corner[2]]};
    const Sine sine = sine_of(cross(sides[0], sides[1]));
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t b = corner[(k + 1) % 3], c = corner[(k + 2) % 3];
      own.cotangents[k] = cotangent_of(sine, -dot(sides[k], sides[(k + 2) % 3]));
      own.edges[k][0] = edge_index(mesh, b, c);
      own.edges[k][1] = edge_index(mesh, c, b);
    }
    if (reduced) fit_obtuse_corner(own.cotangents);
  };
  const Threads& threads = counts.threads;
  threads.rounds(mesh.triangle_count, measure, [&](uint32_t, uint32_t slot) {
    const TriangleEdges& own = scratch.triangles[slot];
    for (uint32_t k = 0; k < 3; ++k) {
      for (const uint32_t e : own.edges[k]) {
        scratch.sums[e] += own.cotangents[k];
        ++scratch.faces[e];
      }
    }
  });
  const auto weigh = [&](size_t e) {
    const int64_t count = scratch.faces[e];
    if (reduced && count == 0) {  // an edge without a triangle, of a reduced mesh: about as an equilateral one's
      out->weight[e] = 1 << (kEdgeWeightBits - 1);
      return;
    }
    // Two triangles an edge make a positive matrix whatever their angles; with more or fewer, no less than half of the
    // sum does. The mean may be less: a caller's mesh keeps it all the same (engine/src/solve/README.md).
    const int64_t half = round_shift(scratch.sums[e], 1);
    if (reduced && count != 2 && half * count > scratch.sums[e]) {
      out->weight[e] = static_cast<int32_t>(half);
      return;
    }
    const int64_t doubled = 2 * scratch.sums[e] + count;  // round half up: floor((2 sum + count) / (2 count))
    const int64_t quotient = doubled / (2 * count);
    out->weight[e] = static_cast<int32_t>(doubled < 0 && quotient * 2 * count != doubled ? quotient - 1 : quotient);
  };
  constexpr uint32_t kEdgePiece = 2048;
  threads.ranges(static_cast<uint32_t>(entries), kEdgePiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    for (uint32_t e = begin; e < end; ++e) weigh(e);
  });
  return SINEW_OK;
}

}  // namespace sinew
