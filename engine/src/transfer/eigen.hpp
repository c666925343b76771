// SPDX-License-Identifier: MIT
// All eigenpairs of a small symmetric matrix, and the rotation that fits vectors best.
#ifndef SINEW_TRANSFER_EIGEN_HPP
#define SINEW_TRANSFER_EIGEN_HPP

#include "transfer/real.hpp"

namespace sinew {

// Cyclic Jacobi rotations (Golub and Van Loan, 8.5.5).
//   matrix   [n x n] in: symmetric; out: its eigenvalues on the diagonal, in no certain order
//   vectors  [n x n] out: an eigenvector in each column
void find_eigenpairs(uint32_t n, double* matrix, double* vectors);

// The rotation R that makes the sum of v . (R u) largest (Horn 1987).
//   sums  row-major sum of v u^T
//   gap   out, when not null: by how much the best is better than the second, 0..1; near 0 the vectors lie on a line
Mat3 best_rotation(const Mat3& sums, double* gap);
// The smallest rotation that turns u to v's direction; any about a half turn.
Mat3 rotation_between(Vec3d u, Vec3d v);

}  // namespace sinew
#endif
