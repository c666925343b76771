// SPDX-License-Identifier: MIT
// Multifrontal Cholesky factorisation of a sparse matrix in int32 (Duff and Reid 1983 for the method). It is fast where
// the matrix is definite and not too badly conditioned, and says so where it is not. Sixteen right-hand sides are
// solved at a time, and only where they matter.
//
// A front is a dense symmetric matrix. Its rows are the vertices of one region of the nested dissection (a separator,
// or a small region as a whole), which are its pivots, and the later vertices that the region's subtree touches, which
// are its border. Fronts come in elimination order, which is a postorder of the dissection's tree. What a front leaves
// of its border waits on a stack for its parent.
//
// Number formats. Row i of the matrix M is scaled by 2^-e[i], so that its diagonal is in [1/4, 1).
//   G, the Cholesky factor of the scaled matrix   int32, Q30
//   solution x                                    int32, Q28, saturated at 2^2
//   right-hand sides b, as 4^-e b                 int32, Q28
//   v = G^-1 of the scaled b, as 2^-e v           int32, Q28
// The squares of a row of G sum to the diagonal, so entries of G are below 1 and sums of their products below 2^60.
// Every entry of a front is rounded once for all of its pivots. Where a definite matrix gives x in 0 .. 1, b and v are
// at most the diagonal times x; negative edge weights let x leave that range a little.
// A matrix that is not definite makes all of this wrap. That is defined and shows in the pivots, or in rows of the
// solution that do not sum to what they must.
#ifndef SINEW_SOLVE_FRONTS_HPP
#define SINEW_SOLVE_FRONTS_HPP

#include "kernels/front.hpp"
#include "solve/factor.hpp"

namespace sinew {

// Memory for one batch of right-hand sides. Batches that have one each may be solved at the same time.
struct FrontSolve {
  int32_t* rows = nullptr;    // [height_capacity_ x kFrontBatch] right-hand sides of a front's rows
  int32_t* x = nullptr;       // [U x kFrontBatch] right-hand sides, then v, then the solution
  uint8_t* active = nullptr;  // [front_capacity_] 1: some right-hand side is not 0 in its subtree; kTaken: substituted
  static constexpr uint8_t kTaken = 2;
};

class FrontFactor {
 public:
  bool allocate(Arena& arena, const Counts& counts);
  // Memory for one more batch; the factor has some for one itself, free until the next factorise().
  bool allocate_solve(Arena& arena, const Counts& counts, FrontSolve* solve) const;
  const FrontSolve& own_solve() const { return own_; }
  // Fronts of the part that the matrix's ordering was made for. False when they would not fit.
  bool analyze(const SparseMatrix& matrix);
  // False when a pivot is too small. The matrix must have been assembled.
  bool factorise(const SparseMatrix& matrix, const FrontKernels& kernels);

  // One batch: begin(), add() for every entry of the right-hand sides, eliminate(), then substitute() front by front.
  void begin(const FrontSolve& solve) const;
  void add(const FrontSolve& solve, uint32_t position, uint32_t member, int64_t value_q40) const;
  void eliminate(const FrontKernels& kernels, const FrontSolve& solve) const;
  // Calls take(first, count, x) with the solution x [count x kFrontBatch] of the vertices at positions [first, first +
  // count), for every front where it may be larger than 2^-18. Without negative edge weights it never is elsewhere
  // (maximum principle: the right-hand sides are 0 there, and the solution is smaller on the border).
  template <class Take>
  void substitute(const FrontKernels& kernels, const FrontSolve& solve, Take take) const;

  uint32_t front_count() const { return front_count_; }
  // Calls take(first, count, x) as substitute() did, for the fronts [begin, end) alone, from the last to the first.
  template <class Take>
  void each_taken(const FrontSolve& solve, uint32_t begin, uint32_t end, Take take) const {
    for (uint32_t index = end; index-- > begin;) {
      if (solve.active[index] == FrontSolve::kTaken) take_front(solve, index, take);
    }
  }

  // For tests: pretends that no more than this fits.
  void limit(size_t entries) {
    if (entries < factor_capacity_) factor_capacity_ = entries;
  }
  uint64_t factor_entries() const { return front_count_ == 0 ? 0 : fronts_[front_count_].factor; }

 private:
  static constexpr uint32_t kNoFront = 0xFFFFFFFFu;
  static constexpr int32_t kNegligible = 1 << (kFrontSolutionBits - 18);

  struct Front {
    uint32_t first, pivots;  // its own vertices, at positions [first, first + pivots)
    uint32_t rows;           // where its border is in rows_; ends where the next front's begins
    uint32_t subtree;        // the subtree is the fronts [subtree, this one]
    uint32_t parent;         // kNoFront at the root
    uint64_t factor;         // where its columns are in factor_
    int8_t exponent;         // largest exponent of its vertices and border
  };

  uint32_t border(uint32_t front) const { return fronts_[front + 1].rows - fronts_[front].rows; }
  bool find_border(const SparseMatrix& matrix, uint32_t index, const uint32_t* children, uint32_t child_count);
  template <class Take>
  void take_front(const FrontSolve& solve, uint32_t index, Take take) const {
    const Front& front = fronts_[index];
    take(front.first, front.pivots, solve.x + static_cast<size_t>(front.first) * kFrontBatch);
  }
  static void clear(const FrontSolve& solve, const Front& front);
  void wake(const FrontSolve& solve, uint32_t index) const;
  bool scale_rows(const SparseMatrix& matrix);
  void fill(const SparseMatrix& matrix, const Front& front, uint32_t height, int32_t* columns);
  void add_child(uint32_t child, const Front& front, uint32_t height, const int32_t* rest, int32_t* columns,
                 int32_t* corner);
  bool eliminate_pivots(const FrontKernels& kernels, const Front& front, uint32_t height, int32_t* columns);
  void eliminate_front(const FrontKernels& kernels, const FrontSolve& solve, uint32_t index) const;
  void substitute_front(const FrontKernels& kernels, const FrontSolve& solve, uint32_t index) const;
  bool border_is_negligible(const FrontSolve& solve, uint32_t index) const;
  FrontRows rows_of(const FrontSolve& solve, const Front& front) const {
    return {front.exponent, exponent_, inverse_, solve.x};
  }

  uint32_t front_count_ = 0;
  // Reserved: what characters of 100 to 8000 vertices, bodies of up to a million and tubes of regular rings need, and a
  // ninth more at least. What needs more is no case for fronts.
  uint32_t front_capacity_ = 0;
  size_t row_capacity_ = 0, factor_capacity_ = 0, stack_capacity_ = 0, height_capacity_ = 0;
  Front* fronts_ = nullptr;       // [front_capacity_ + 1]
  uint32_t* rows_ = nullptr;      // [row_capacity_] positions on the fronts' borders, ascending
  uint32_t* waiting_ = nullptr;   // [front_capacity_] fronts whose parent is still to come
  uint32_t* mark_ = nullptr;      // [U] by position
  uint32_t* front_of_ = nullptr;  // [U] by position
  int8_t* exponent_ = nullptr;    // [U] by position
  int64_t* inverse_ = nullptr;    // [U] by position: 1 / the factor's diagonal, Q30
  int32_t* factor_ = nullptr;     // [factor_capacity_] of each front: its pivots' columns over all of its rows, G
  int32_t* stack_ = nullptr;      // [stack_capacity_] lower triangles by columns, and the corner of the front at hand
  FrontSolve own_;
};

template <class Take>
void FrontFactor::substitute(const FrontKernels& kernels, const FrontSolve& solve, Take take) const {
  for (uint32_t index = front_count_; index-- > 0;) {
    const Front& front = fronts_[index];
    if (solve.active[index] == 0 && border_is_negligible(solve, index)) {
      index = front.subtree;
      continue;
    }
    substitute_front(kernels, solve, index);
    solve.active[index] = FrontSolve::kTaken;
    take_front(solve, index, take);
  }
}

}  // namespace sinew
#endif
