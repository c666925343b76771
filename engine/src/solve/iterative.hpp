// SPDX-License-Identifier: MIT
// Conjugate gradients in fixed point, for a matrix whose factor would not fit the workspace.
#ifndef SINEW_SOLVE_ITERATIVE_HPP
#define SINEW_SOLVE_ITERATIVE_HPP

#include "solve/factor.hpp"

namespace sinew {

// Less than for the factor: a correction may be 2^16 times as large as the solution (see solve_iteratively), and the
// product of both must fit.
constexpr int kIterativeDiagonalBits = 44;

// Solves for kBatch right-hand sides one after the other with Jacobi-preconditioned conjugate gradients (Hestenes and
// Stiefel 1952) inside iterative refinement: each round solves for what the exact residual still asks for, scaled up by
// a power of two, so that fixed point loses nothing when the residual gets small. The matrix must be positive definite
// (SparseMatrix::positive).
//   rhs      [rows x kBatch] Q matrix_bits
//   scratch  [5 x rows] int64
//   inverse  [rows]
//   out      [rows x kBatch] Q24
// Meshes whose separators are large mix fast, so the bound on the rounds is not met in practice; it keeps time finite.
void solve_iteratively(const SparseMatrix& matrix, const int64_t* rhs, int64_t* scratch, Reciprocal* inverse,
                       int32_t* out);

}  // namespace sinew
#endif
