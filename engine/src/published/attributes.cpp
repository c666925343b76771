// SPDX-License-Identifier: MIT
// Positions, normals, Laplacians, curvatures and distances to joints as rows.
#include "features/attributes.hpp"

#include <string.h>

#include "core/vector_math.hpp"
#include "features/channel_values.hpp"

namespace sinew {
namespace {

void write_vertex(const Mesh& mesh, uint32_t v, int16_t* row) {
  const Vec3i p = mesh.positions[v], n = mesh.normals[v];
  row[kAttributePosition] = features::side_ratio_q13(2 * int64_t{p.x});
  row[kAttributePosition + 1] = features::side_ratio_q13(2 * int64_t{p.y});
  row[kAttributePosition + 2] = features::side_ratio_q13(2 * int64_t{p.z});
  constexpr int kToQ13 = kNormalBits - kFeatureBits;
  row[kAttributeNormal] = features::q13(round_shift(n.x, kToQ13));
  row[kAttributeNormal + 1] = features::q13(round_shift(n.y, kToQ13));
  row[kAttributeNormal + 2] = features::q13(round_shift(n.z, kToQ13));
  row[kAttributeCurvature] = features::q13(mesh.mean_curvature[v]);
  row[kAttributeCurvature + 1] = features::q13(mesh.gauss_curvature[v]);
  Vec3l sum = {0, 0, 0};
  int64_t lengths = 0;
  for (uint32_t i = mesh.row_offsets[v]; i < mesh.row_offsets[v + 1]; ++i) {
    const Vec3i away = mesh.positions[mesh.col_indices[i]] - p;
    sum = {sum.x + away.x, sum.y + away.y, sum.z + away.z};
    lengths += isqrt64(static_cast<uint64_t>(dot(away, away)));
  }
  // The mean over the mean: the number of neighbors cancels.
  row[kAttributeLaplacian] = lengths == 0 ? int16_t{0} : features::ratio_q13(sum.x, lengths);
  row[kAttributeLaplacian + 1] = lengths == 0 ? int16_t{0} : features::ratio_q13(sum.y, lengths);
  row[kAttributeLaplacian + 2] = lengths == 0 ? int16_t{0} : features::ratio_q13(sum.z, lengths);
}

void write_pairs(const Mesh& mesh, const Skeleton& skeleton, const Candidates& candidates, uint32_t v, int16_t* rows) {
  const uint16_t* const joints = candidates.joints + size_t{v} * candidates.k;
  const uint32_t* const distances = candidates.distances + size_t{v} * candidates.k;
  memset(rows, 0, size_t{candidates.k} * kPairAttributes * sizeof(int16_t));
  const int32_t nearest = log2_q16(distances[0] + uint64_t{features::kSoftLength});
  for (uint32_t k = 0; k < candidates.k && joints[k] != kNoJoint; ++k) {
    int16_t* const row = rows + size_t{k} * kPairAttributes;
    const Vec3i away = skeleton.positions[joints[k]] - mesh.positions[v];
    const uint32_t straight = isqrt64(static_cast<uint64_t>(dot(away, away)));
    row[kAttributeThrough] = features::side_ratio_q13(2 * int64_t{distances[k]});
    row[kAttributeRatio] = features::log_q13(distances[k] + uint64_t{features::kSoftLength}, nearest, 2);
    row[kAttributeStraight] = features::side_ratio_q13(2 * int64_t{straight});
  }
}

}  // namespace

void build_attributes(const Mesh& mesh, const Skeleton& skeleton, const Candidates& candidates, Features* out) {
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    write_vertex(mesh, v, out->vertex + size_t{v} * out->vertex_channels);
    write_pairs(mesh, skeleton, candidates, v, out->pair + size_t{v} * candidates.k * kPairAttributes);
    memcpy(out->joints + size_t{v} * candidates.k, candidates.joints + size_t{v} * candidates.k,
           candidates.k * sizeof(uint16_t));
  }
}

}  // namespace sinew
