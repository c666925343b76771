// SPDX-License-Identifier: MIT
// Normals, areas and curvatures of the welded mesh.
#include "mesh/shape.hpp"

#include "core/vector_math.hpp"

namespace sinew {
namespace {

// round(atan(2^-i) / pi * 2^30), python3: [round(atan(2.0**-i) / pi * 2**30) for i in range(28)]
constexpr int kAngleSteps = 28;
constexpr int32_t kAngles[kAngleSteps] = {268435456, 158466703, 83729454, 42502378, 21333666, 10677233, 5339919,
                                          2670123,   1335082,   667543,   333772,   166886,   83443,    41722,
                                          20861,     10430,     5215,     2608,     1304,     652,      326,
                                          163,       81,        41,       20,       10,       5,        3};
constexpr int64_t kHalfTurn = 1 << 30;  // pi in the format of angles_q30

constexpr uint64_t kAreaCap = static_cast<uint64_t>(1) << 62;
constexpr int kCurvatureBits = 13;
constexpr int32_t kCurvatureLimit = 2 << kCurvatureBits;

Vec3l& operator+=(Vec3l& a, Vec3l b) {
  a.x += b.x;
  a.y += b.y;
  a.z += b.z;
  return a;
}

// Twice the vector area. Mesh coordinates span at most 2^20, so every component is at most 2^40.
Vec3l corner_cross(const Mesh& mesh, const uint32_t* t) {
  return cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
}

// Sums over the triangles of a vertex. Unit normals in Q24, so that 2^38 faces could meet without overflow.
void add_triangles(const ShapeScratch& scratch, const Threads& threads, Mesh* mesh) {
  for (uint32_t v = 0; v < mesh->welded_count; ++v) {
    scratch.normal_sums[v] = {0, 0, 0};
    scratch.angle_sums[v] = 0;
    mesh->areas[v] = 0;
  }
  const auto measure = [&](uint32_t index, uint32_t slot) {
    const uint32_t* t = mesh->triangles + 3 * static_cast<size_t>(index);
    TriangleShape& out = scratch.triangles[slot];
    const Vec3l normal = corner_cross(*mesh, t);
    out.twice_area = static_cast<int64_t>(length(normal));
    out.normal = unit_vector(normal, 24);
    int64_t cosines[3];
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3i at = mesh->positions[t[corner]];
      cosines[corner] = dot(mesh->positions[t[(corner + 1) % 3]] - at, mesh->positions[t[(corner + 2) % 3]] - at);
    }
    angles_q30(out.twice_area, cosines, out.angles);
  };
  threads.rounds(mesh->triangle_count, measure, [&](uint32_t index, uint32_t slot) {
    const uint32_t* t = mesh->triangles + 3 * static_cast<size_t>(index);
    const TriangleShape& own = scratch.triangles[slot];
    for (int corner = 0; corner < 3; ++corner) {
      const uint32_t v = t[corner];
      // 2^40.8 at most each: only a vertex of two million side-wide triangles can reach the cap.
      const uint64_t area = mesh->areas[v] + static_cast<uint64_t>(own.twice_area);
      mesh->areas[v] = area < kAreaCap ? area : kAreaCap;
      scratch.normal_sums[v] += Vec3l{own.normal.x, own.normal.y, own.normal.z};
      scratch.angle_sums[v] += own.angles[corner];
    }
  });
}

void finish_vertex(const ShapeScratch& scratch, uint32_t v, Mesh* mesh) {
  mesh->normals[v] = unit_vector(scratch.normal_sums[v], kNormalBits);
  // A sixth of the sum of |cross|; a vertex with a triangle never gets 0, so that it can be divided by.
  if (mesh->areas[v] != 0) {
    const uint64_t area = (mesh->areas[v] + 3) / 6;
    mesh->areas[v] = area != 0 ? area : 1;
  }
  const uint32_t begin = mesh->row_offsets[v], end = mesh->row_offsets[v + 1];
  mesh->mean_curvature[v] = 0;
  mesh->gauss_curvature[v] = 0;
  mesh->edge_length[v] = 0;
  if (begin == end) return;

  // Valence < 2^22, an edge is shorter than 2^21: lengths in Q10 sum below 2^53, dot products with the Q14 normal below
  // 2^58.
  uint64_t length_sum = 0;
  int64_t along_normal = 0;
  for (uint32_t e = begin; e < end; ++e) {
    const Vec3i edge = mesh->positions[mesh->col_indices[e]] - mesh->positions[v];
    length_sum += isqrt64(static_cast<uint64_t>(dot(edge, edge)) << 20);  // 3 * 2^40 << 20 < 2^62
    along_normal += dot(edge, mesh->normals[v]);
  }
  const uint64_t valence = end - begin;
  mesh->edge_length[v] = static_cast<uint32_t>((length_sum + (valence << 9)) / (valence << 10));
  // mean(edge) . n / mean(|edge|) = sum / sum: Q14 over Q10 and 2^9 more gives Q13. Both are halved alike until the
  // product fits.
  int64_t numerator = along_normal;
  int64_t denominator = static_cast<int64_t>(length_sum);
  while (abs64(numerator) >= static_cast<int64_t>(1) << 51) {
    numerator >>= 1;
    denominator >>= 1;
  }
  mesh->mean_curvature[v] = clamp32(round_div(numerator * 512, denominator), -kCurvatureLimit, kCurvatureLimit);
  if (scratch.boundary[v] == 0) {
    mesh->gauss_curvature[v] = clamp32(round_shift(2 * kHalfTurn - scratch.angle_sums[v], 30 - kCurvatureBits),
                                       -kCurvatureLimit, kCurvatureLimit);
  }
}

}  // namespace

void angles_q30(int64_t given_y, const int64_t (&given_x)[3], int32_t (&angles)[3]) {
  int64_t x[3], y[3], angle[3];
  for (int k = 0; k < 3; ++k) {
    // Brings the vector to 60 bits, so that small triangles are measured as finely as large ones.
    const int lift = 59 - top_bit(static_cast<uint64_t>(given_y) | static_cast<uint64_t>(abs64(given_x[k])));
    const int64_t factor = static_cast<int64_t>(1) << (lift > 0 ? lift : 0);
    x[k] = given_x[k] * factor;
    y[k] = given_y * factor;
    angle[k] = 0;
    if (x[k] < 0) {  // a rotation by 90 degrees back brings the vector to the right half plane
      const int64_t t = x[k];
      x[k] = y[k];
      y[k] = -t;
      angle[k] = kHalfTurn / 2;
    }
  }
  // CORDIC in vectoring mode (Volder 1959): rotates the vector onto the x axis, its length grows by at most 1.65.
  for (int i = 0; i < kAngleSteps; ++i) {
    for (int k = 0; k < 3; ++k) {
      // Both senses of rotation are equally likely: no branch.
      const int64_t back = y[k] > 0 ? 0 : -1;  // v ^ back - back is v or -v
      const int64_t shifted_x = x[k] >> i, shifted_y = y[k] >> i;
      x[k] += (shifted_y ^ back) - back;
      y[k] -= (shifted_x ^ back) - back;
      angle[k] += (kAngles[i] ^ back) - back;
    }
  }
  for (int k = 0; k < 3; ++k) {
    const bool zero = given_y == 0 && given_x[k] == 0;
    angles[k] = zero ? 0 : clamp32(angle[k], 0, static_cast<int32_t>(kHalfTurn));
  }
}

void find_shape(const ShapeScratch& scratch, const Threads& threads, Mesh* mesh) {
  constexpr uint32_t kVertexPiece = 256;  // vertices that a lane takes at a time
  add_triangles(scratch, threads, mesh);
  threads.ranges(mesh->welded_count, kVertexPiece, [&](uint32_t begin, uint32_t end, uint32_t) {
    for (uint32_t v = begin; v < end; ++v) finish_vertex(scratch, v, mesh);
  });
}

}  // namespace sinew
