// SPDX-License-Identifier: MIT
// Rounds of Jacobi over the one-ring.
#include "deform/rest.hpp"

namespace sinew::deform {

void find_borders(uint8_t* edge_triangles, DeformRest* rest) {
  const uint32_t* const offsets = rest->row_offsets;
  for (uint32_t r = 0; r < offsets[rest->welded_count]; ++r) edge_triangles[r] = 0;
  const auto count = [&](uint32_t from, uint32_t to) {
    uint32_t r = offsets[from];
    while (rest->col_indices[r] != to) ++r;  // there is one: neighbors are those of triangles
    if (edge_triangles[r] < 2) ++edge_triangles[r];
  };
  for (uint32_t i = 0; i < 3 * rest->triangle_count; ++i) {
    const uint32_t a = rest->triangles[i], b = rest->triangles[i % 3 == 2 ? i - 2 : i + 1];
    count(a, b);
    count(b, a);
  }
  for (uint32_t u = 0; u < rest->welded_count; ++u) {
    rest->border[u] = 0;
    for (uint32_t r = offsets[u]; r < offsets[u + 1]; ++r) {
      if (edge_triangles[r] < 2) rest->border[u] = 1;
    }
  }
}

void smooth(const DeformRest& rest, uint32_t rounds, const uint8_t* mask, Vec3d* scratch, Vec3d* positions) {
  for (uint32_t round = 0; round < rounds; ++round) {
    for (uint32_t u = 0; u < rest.welded_count; ++u) {
      Vec3d sum = {0, 0, 0};
      double count = 0;
      for (uint32_t r = rest.row_offsets[u]; r < rest.row_offsets[u + 1]; ++r) {
        const uint32_t other = rest.col_indices[r];
        if (rest.border[u] != 0 && rest.border[other] == 0) continue;
        sum = sum + positions[other];
        count += 1;
      }
      const bool stays = !(count > 0) || (mask != nullptr && mask[u] == 0);
      scratch[u] = stays ? positions[u] : positions[u] + 0.5 * ((1 / count) * sum - positions[u]);
    }
    for (uint32_t u = 0; u < rest.welded_count; ++u) positions[u] = scratch[u];
  }
}

void smooth_rest(DeformRest* rest) {
  for (uint32_t u = 0; u < rest->welded_count; ++u) rest->smooth[u] = rest->position(rest->first[u]);
  smooth(*rest, rest->options.round_count, nullptr, rest->smooth + rest->vertex_count, rest->smooth);
}

}  // namespace sinew::deform
