// SPDX-License-Identifier: MIT
// All eigenpairs of a small symmetric matrix.
#ifndef SINEW_CORE_EIGENPAIRS_HPP
#define SINEW_CORE_EIGENPAIRS_HPP

#include <stdint.h>

namespace sinew {

// Cyclic Jacobi rotations (Golub and Van Loan, 8.5.5).
//   matrix   [n x n] in: symmetric; out: its eigenvalues on the diagonal, in no certain order
//   vectors  [n x n] out: an eigenvector in each column
void find_eigenpairs(uint32_t n, double* matrix, double* vectors);

}  // namespace sinew
#endif
