// SPDX-License-Identifier: MIT
// Cotangent weights and masses of the spectral stage; Pinkall and Polthier 1993, equation 2.
#include "spectral/operator.hpp"

#include <string.h>

#include "mesh/edge_index.hpp"
#include "solve/factor.hpp"

namespace sinew {
namespace {

constexpr int kSmallestMassBits = 10;  // below the mean
constexpr int32_t kLargestWeight = 1 << 30;

void add_to_edge(const Mesh& mesh, uint32_t from, uint32_t to, int32_t value, int32_t* weight) {
  int32_t& sum = weight[edge_index(mesh, from, to)];
  sum = clamp32(static_cast<int64_t>(sum) + value, -kLargestWeight, kLargestWeight);
}

}  // namespace

bool SpectralOperator::allocate(Arena& arena, const Counts& counts) {
  edges.allocate(arena, counts);
  mass = arena.alloc<int64_t>(counts.vertices);
  root_mass = arena.alloc<int32_t>(counts.vertices);
  return arena.ok();
}

void SpectralOperator::weigh_vertices(const Mesh& mesh, uint32_t part) {
  const uint32_t* vertices = mesh.part_vertices + mesh.part_offsets[part];
  const uint32_t count = mesh.part_sizes[part];
  uint64_t area = 0;
  for (uint32_t i = 0; i < count; ++i) area += mesh.areas[vertices[i]];
  const uint64_t least = area / count >> kSmallestMassBits;
  uint64_t total = 0;
  for (uint32_t i = 0; i < count; ++i) total += mesh.areas[vertices[i]] > least ? mesh.areas[vertices[i]] : least;
  const Reciprocal inverse = reciprocal(static_cast<int64_t>(total > 0 ? total : 1));
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t v = vertices[i];
    const uint64_t share = mesh.areas[v] > least ? mesh.areas[v] : least;
    const int64_t q40 = divide(static_cast<int64_t>(share), inverse, kMassBits, 1);
    mass[v] = q40 > 0 ? q40 : 1;
    root_mass[v] = static_cast<int32_t>(isqrt64(static_cast<uint64_t>(mass[v]) << (2 * kRootMassBits - kMassBits)));
  }
}

void sum_cotangents(const Mesh& mesh, EdgeWeights* out) {
  memset(out->weight, 0, mesh.row_offsets[mesh.welded_count] * sizeof(out->weight[0]));
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
    const uint32_t* corner = mesh.triangles + 3 * static_cast<size_t>(t);
    int64_t cotangent[3];
    uint32_t smallest = 0;
    for (uint32_t k = 0; k < 3; ++k) {
      cotangent[k] = cotangent_q24(mesh.positions[corner[k]], mesh.positions[corner[(k + 1) % 3]],
                                   mesh.positions[corner[(k + 2) % 3]]);
      if (cotangent[k] < cotangent[smallest]) smallest = k;
    }
    // Two angles of a triangle are acute, and a b + b c + c a = 1 for its cotangents; the limit may have broken that.
    const int64_t a = cotangent[(smallest + 1) % 3], b = cotangent[(smallest + 2) % 3];
    if (a + b > 0) {
      const int64_t least = -((a * b + (a + b) / 2) / (a + b));  // below 2^60
      if (cotangent[smallest] < least) cotangent[smallest] = least;
    }
    for (uint32_t k = 0; k < 3; ++k) {
      const int32_t half_q20 = static_cast<int32_t>(round_shift(cotangent[k], kEdgeWeightBits - 20 + 1));
      add_to_edge(mesh, corner[(k + 1) % 3], corner[(k + 2) % 3], half_q20, out->weight);
      add_to_edge(mesh, corner[(k + 2) % 3], corner[(k + 1) % 3], half_q20, out->weight);
    }
  }
}

}  // namespace sinew
