// SPDX-License-Identifier: MIT
// Dense symmetric problems of at most kSpectralModes rows in fixed point: orthonormal columns from a Gram matrix, and
// eigenpairs by Jacobi rotations.
#ifndef SINEW_SPECTRAL_SYMMETRIC_HPP
#define SINEW_SPECTRAL_SYMMETRIC_HPP

#include <stdint.h>

namespace sinew {

constexpr uint32_t kSpectralModes = 64;  // eigenpairs computed per part, the constant one included
constexpr int kGramBits = 60;
constexpr int kProjectedBits = 31;
constexpr int kRotationBits = 30;

// Gram matrix of columns whose norms are at most 1 -> what makes them orthonormal, one column after the other. A column
// that the ones before it span up to 2^-10 of itself, or shorter than 2^-20, is dropped: it comes out as 0.
struct Orthonormalizer {
  int64_t inverse_norm[kSpectralModes];           // Q20, 0 = dropped
  int64_t inverse_pivot[kSpectralModes];          // Q30
  int32_t upper[kSpectralModes][kSpectralModes];  // R of the columns brought to norm 1, Q30; row i holds j > i

  // gram [n][n] Q60, the lower triangle (j <= i) is read.
  void prepare(const int64_t (*gram)[kSpectralModes], uint32_t n);
  // One row of the columns, in place; kVectorBits in and out.
  void apply(int32_t* row, uint32_t n) const;
};

// Eigenpairs of a symmetric matrix by cyclic Jacobi rotations (Golub and Van Loan, section 8.5).
//   matrix   in/out [n][n] Q31, |values| <= 1; its diagonal becomes the eigenvalues
//   vectors  out [n][n] Q30, row k is the eigenvector of matrix[k][k]
void symmetric_eigenpairs(int64_t (*matrix)[kSpectralModes], int64_t (*vectors)[kSpectralModes], uint32_t n);

}  // namespace sinew
#endif
