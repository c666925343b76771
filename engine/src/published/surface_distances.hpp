// SPDX-License-Identifier: MIT
// Biharmonic distances of one mesh's vertices to reference points (Lipman, Rustamov and Funkhouser 2010), exactly.
#ifndef SINEW_PUBLISHED_SURFACE_DISTANCES_HPP
#define SINEW_PUBLISHED_SURFACE_DISTANCES_HPP

#include "published/references.hpp"
#include "solve/ordering.hpp"
#include "transfer/sparse_ldl.hpp"
#include "transfer/thin_plate.hpp"

namespace sinew::transferring {

// L is the cotangent Laplacian with ties: each part is tied by the quarter of its vertices that is nearest to larger
// parts, at most 24, on its hosts there. One vertex is held, and L is factorised once. d(x, i)^2 = g(x, x) + g(i, i)
// - 2 g(x, i) where g is the pseudo-inverse of L A^-1 L, which is the inverse of L, its means by area taken off,
// twice with A between. A reference point costs two solves, and all g(x, x) come from the factor and its rate. Which
// vertex is held does not matter to d.
class SurfaceDistances {
 public:
  bool allocate(Arena& arena, const Counts& counts);
  //   out  [references.count x U] in mean distances between reference points
  // Returns SINEW_OK, SINEW_ERROR_WORKSPACE, or SINEW_ERROR_COUNT where the factor takes more than is reserved.
  sinew_status find(const Mesh& mesh, const References& references, bool on_source, const Counts& counts, Arena& arena,
                    double* out);

 private:
  // A tie between two parts, listed at both of its vertices.
  struct Ties {
    uint32_t* next = nullptr;   // [2 x U] the next entry of the same vertex, or kNoVertex
    uint32_t* other = nullptr;  // [2 x U]
    uint32_t* first = nullptr;  // [U]
    uint32_t count = 0;

    void add(uint32_t a, uint32_t b);
  };
  void tie_parts(const Mesh& mesh);
  void order_vertices(const Mesh& mesh);
  bool factorise(const Mesh& mesh);
  void center(uint32_t count);
  void find_diagonal(uint32_t count);
  void solve_columns(const Mesh& mesh, const References& references, bool on_source, uint32_t first, double* out);
  void turn_to_distances(const Mesh& mesh, const References& references, bool on_source, double* g) const;

  ThinPlate plate_;
  Ordering ordering_;
  Ties ties_;
  SparseLdl ldl_;
  uint32_t *position_ = nullptr, *order_ = nullptr;      // [U] position in the elimination, and back
  uint32_t *host_ = nullptr, *host_distance_ = nullptr;  // [U]
  uint64_t* keys_ = nullptr;                             // [U]
  double* x_ = nullptr;                                  // [U x kBatch]
  double *diagonal_ = nullptr, *area_ = nullptr;         // [U] g(x, x), and the vertex' area, by position
  double area_sum_ = 0;
};

}  // namespace sinew::transferring
#endif
