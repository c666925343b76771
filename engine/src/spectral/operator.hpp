// SPDX-License-Identifier: MIT
// The operator of the spectral stage: cotangent Laplacian and lumped masses of the welded mesh, in integers.
#ifndef SINEW_SPECTRAL_OPERATOR_HPP
#define SINEW_SPECTRAL_OPERATOR_HPP

#include "mesh/mesh.hpp"
#include "solve/laplacian.hpp"

namespace sinew {

constexpr int kMassBits = 40;
constexpr int kRootMassBits = 30;

// Masses are shares of a part's area: a third of the adjacent triangles' area over the whole, at least 2^-10 of
// the part's mean (a vertex of slivers would otherwise be worth an eigenpair of its own), scaled to a sum of 1.
struct SpectralOperator {
  EdgeWeights edges;             // half the sum of the cotangents opposite to the edge, read as Q24 they are 1 / 16
  int64_t* mass = nullptr;       // [U] Q40, at least 1
  int32_t* root_mass = nullptr;  // [U] Q30
  bool allocate(Arena& arena, const Counts& counts);
  void weigh_vertices(const Mesh& mesh, uint32_t part);
};

// Edge weights of the positive semi-definite form: half the sum of the cotangents over the faces at an edge, whatever
// their number, Q20. Cotangents are limited to 50; the smallest of a triangle is raised until the triangle's own matrix
// is semi-definite with the limited others, so that the sum is, too.
void sum_cotangents(const Mesh& mesh, EdgeWeights* out);

}  // namespace sinew
#endif
