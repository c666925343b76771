// SPDX-License-Identifier: MIT
// Sparse L D L^T of a symmetric matrix in fixed point: one symbolic analysis, one numeric factorisation for each set of
// values, then triangular solves for kBatch right-hand sides at a time.
//
// The matrix is M = L + D over the vertices of one part: the Laplacian L of its edges and a diagonal D >= 0, the pulls.
// Its row sums are the pulls. It need not be positive definite: the Laplacian counts a boundary edge in full and limits
// cotangents, so obtuse triangles at a border, or needles, can make pivots negative.
//
// Number formats:
//   entries of M, what elimination leaves of them, right-hand sides   int64, Q matrix_bits
//   L during the factorisation                                        int64, Q40, saturated at 2^20
//   L in the solves                                                   int32, one exponent per column (short_bits)
//   solution                                                          int32, Q24, saturated at 2^7
// matrix_bits is chosen so that the largest diagonal entry is below 2^56. The seven bits above it are room for what an
// elimination of an indefinite matrix adds. A column's exponent is chosen so that the sum of its absolute entries is
// below 2^31: a dot product of the column with a 32-bit solution then stays below 2^62. The solution of a definite
// matrix for a right-hand side between 0 and the pulls is in 0 .. 1; that of an indefinite one can be anything.
// A matrix that breaks these bounds makes numbers wrap or saturate. Both are defined, the same on every platform, and
// can be seen in the solution: for the pulls as right-hand side it must be 1 in every row.
#ifndef SINEW_SOLVE_FACTOR_HPP
#define SINEW_SOLVE_FACTOR_HPP

#include <string.h>

#include "solve/laplacian.hpp"
#include "solve/ordering.hpp"

namespace sinew {

constexpr uint32_t kBatch = 8;  // right-hand sides solved together: the factor is read once for all of them
// State of a joint in a batch, besides a number below kBatch: not in it; listed, to be in one.
constexpr uint8_t kNoMember = 0xFF, kListed = 0xFE;
constexpr int kSolutionBits = 24;
constexpr int kFactorDiagonalBits = 56;  // bound of the diagonal, as a power of two

// Sums that cannot overflow on a matrix that is what it should be; wrapping keeps them defined on any other.
inline int64_t wrapping_add(int64_t a, int64_t b) {
  return static_cast<int64_t>(static_cast<uint64_t>(a) + static_cast<uint64_t>(b));
}
inline int64_t wrapping_subtract(int64_t a, int64_t b) {
  return static_cast<int64_t>(static_cast<uint64_t>(a) - static_cast<uint64_t>(b));
}

// The matrix M of one part, rows in elimination order.
struct SparseMatrix {
  const Mesh* mesh = nullptr;
  const EdgeWeights* edges = nullptr;
  const Ordering* ordering = nullptr;
  uint32_t rows = 0;
  int matrix_bits = 0;
  int64_t* diagonal = nullptr;  // [U] Q matrix_bits
  bool positive = false;        // negative edge weights count as 0: M is definite then, whatever the triangles are

  // rhs -= M x for kBatch columns; x in Q24.
  void subtract_image(const int32_t* x, int64_t* rhs) const;
  // Off-diagonal entry of CSR edge e.
  SINEW_ONCE int64_t entry(uint32_t e) const {
    return -weight(e) * (static_cast<int64_t>(1) << (matrix_bits - kEdgeWeightBits));
  }
  int64_t weight(uint32_t e) const { return positive && edges->weight[e] < 0 ? 0 : edges->weight[e]; }
  // Sets the diagonal from the edges and pull_q40 [rows], and matrix_bits (24 .. 50) so that the diagonal stays below
  // 2^diagonal_bits. to_matrix() brings other Q40 values to the same format.
  void assemble(const int64_t* pull_q40, int diagonal_bits);
  int64_t to_matrix(int64_t value_q40) const;
};

// 1 / d for d != 0 as value * 2^-(exponent + 62), |value| in (2^61, 2^62], accurate to 2^-58.
struct Reciprocal {
  int64_t value;
  uint64_t magnitude;  // |d|
  int exponent;        // floor(log2 |d|)
};
Reciprocal reciprocal(int64_t d);
// n / d in Q bits (bits <= 40), saturated at +-2^headroom (headroom + bits <= 61).
inline int64_t divide(int64_t n, const Reciprocal& r, int bits, int headroom) {
  const uint64_t magnitude = n < 0 ? 0 - static_cast<uint64_t>(n) : static_cast<uint64_t>(n);
  if (magnitude >> headroom >= r.magnitude) {
    const int64_t limit = static_cast<int64_t>(1) << (bits + headroom);
    return (n < 0) != (r.value < 0) ? -limit : limit;
  }
  const int shift = r.exponent + 62 - bits;
  return shift <= 63 ? mul_shift(n, r.value, shift) : mul_shift(n, r.value, 63) >> (shift - 63);
}

struct Factor {
  size_t capacity = 0;               // entries that fit
  uint32_t* parent = nullptr;        // [U] elimination tree
  uint32_t* mark = nullptr;          // [U]
  uint32_t* pattern = nullptr;       // [U]
  uint32_t* column_start = nullptr;  // [U + 1]; 2^22 vertices have less than 2^29 entries
  uint32_t* column_fill = nullptr;   // [U]
  int64_t* work = nullptr;           // [U]
  Reciprocal* inverse = nullptr;     // [U] 1 / D
  uint32_t* row = nullptr;           // [capacity] row of each entry, ascending inside a column
  int64_t* value = nullptr;          // [capacity] Q40; after factorise() the lower half is the entries' short values
  uint8_t* short_bits = nullptr;     // [U]
  int smallest_bits = 31;            // of short_bits: 30 or 31 for an M-matrix, less where pivots nearly cancelled

  // Entries reserved: 10 + log2(V)^2 / 5 per vertex, at most 12 + 4 log2 V. Nested dissection of closed surfaces needs
  // 22 per vertex at 1k vertices, 36 at 10k, 61 at 400k; characters of 200 to 4000 vertices need at most 31. A tangle
  // of faces that needs more goes to the iterative solver.
  static size_t capacity_for(const Counts& counts);
  // Memory of solves may overlap the upper half of `value` and mark, pattern, column_fill and work behind it,
  // which factorise() fills anew: allocated after arena.release(solve_mark).
  bool allocate(Arena& arena, const Counts& counts, size_t* solve_mark = nullptr);
  // Elimination tree and column counts. False when the factor would not fit.
  bool analyze(const SparseMatrix& matrix);
  void factorise(const SparseMatrix& matrix);
  // Entry p of L as the solves take it: Q short_bits of its column.
  int32_t short_value(uint32_t p) const {
    int32_t out;
    memcpy(&out, reinterpret_cast<const uint8_t*>(value) + size_t{p} * sizeof(out), sizeof(out));
    return out;
  }
  // Solves for kBatch right-hand sides. rhs [rows x kBatch] Q matrix_bits, destroyed; out [rows x kBatch] Q24.
  void solve(uint32_t rows, int64_t* rhs, int32_t* out) const;
};

}  // namespace sinew
#endif
