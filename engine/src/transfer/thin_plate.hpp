// SPDX-License-Identifier: MIT
// The cotangent Laplacian L of a mesh with the areas A of its vertices in doubles, and the thin plate L + L A^-1 L.
#ifndef SINEW_TRANSFER_THIN_PLATE_HPP
#define SINEW_TRANSFER_THIN_PLATE_HPP

#include "mesh/mesh.hpp"
#include "solve/laplacian.hpp"
#include "spectral/operator.hpp"

namespace sinew::transferring {

struct ThinPlate {
  const Mesh* mesh = nullptr;
  EdgeWeights edges;        // of sum_cotangents(): half the sum of the cotangents, Q20
  double* area = nullptr;   // [U] in mean areas, at least 1e-6
  double* whole = nullptr;  // [U] L's diagonal

  static constexpr double kEdgeUnit = 1.0 / (1 << 20);

  bool allocate(Arena& arena, const Counts& counts) {
    (void)edges.allocate(arena, counts);
    area = arena.alloc<double>(counts.vertices);
    whole = arena.alloc<double>(counts.vertices);
    return arena.ok();
  }
  void fill(const Mesh& of) {
    mesh = &of;
    sum_cotangents(of, &edges);
    double sum = 0;
    for (uint32_t v = 0; v < of.welded_count; ++v) sum += static_cast<double>(of.areas[v]);
    const double unit = sum > 0 ? of.welded_count / sum : 0;
    for (uint32_t v = 0; v < of.welded_count; ++v) {
      const double own = unit * static_cast<double>(of.areas[v]);
      area[v] = own > 1e-6 ? own : 1e-6;
      double row = 0;
      for (uint32_t e = of.row_offsets[v]; e < of.row_offsets[v + 1]; ++e) row += weight(e);
      whole[v] = row;
    }
  }
  double weight(uint32_t edge) const { return edges.weight[edge] * kEdgeUnit; }

  // Row of L: visit(vertex, value).
  template <class Visit>
  void laplacian(uint32_t v, const Visit& visit) const {
    visit(v, whole[v]);
    for (uint32_t e = mesh->row_offsets[v]; e < mesh->row_offsets[v + 1]; ++e) visit(mesh->col_indices[e], -weight(e));
  }
  // Row of L + L A^-1 L; a vertex comes more than once.
  template <class Visit>
  void plate(uint32_t v, const Visit& visit) const {
    laplacian(v, visit);
    laplacian(v, [&](uint32_t k, double first) {
      const double scaled = first / area[k];
      laplacian(k, [&](uint32_t w, double second) { visit(w, scaled * second); });
    });
  }
};

}  // namespace sinew::transferring
#endif
