// SPDX-License-Identifier: MIT
// Cholesky factor and Jacobi rotations on small dense matrices (spectral stage).
#include "spectral/symmetric.hpp"

#include "core/fixed.hpp"
#include "spectral/eigenpairs.hpp"

namespace sinew {
namespace {

constexpr int64_t kOneQ30 = static_cast<int64_t>(1) << 30;
constexpr int64_t kShortest = 1 << 10;        // norm, Q30
constexpr int64_t kSmallestSquare = 1 << 10;  // squared, Q30
constexpr uint32_t kSweeps = 12;
constexpr int64_t kNegligible = 16;  // Q31: off-diagonal entries below rounding noise

struct Rotation {
  int64_t c, s;  // Q30
};

// The rotation that makes entry (p, q) 0: tan = h / (d + sign(d) sqrt(d^2 + h^2)), h = 2 a_pq, d = a_qq - a_pp.
Rotation annihilate(int64_t a_pp, int64_t a_qq, int64_t a_pq) {
  int64_t d = a_qq - a_pp, h = 2 * a_pq;
  const int64_t largest = abs64(d) | abs64(h);  // below 2^33
  const int shift = top_bit(static_cast<uint64_t>(largest)) - 29;
  if (shift > 0) {
    d >>= shift;
    h >>= shift;
  } else {
    d *= static_cast<int64_t>(1) << -shift;
    h *= static_cast<int64_t>(1) << -shift;
  }
  const int64_t root = isqrt64(static_cast<uint64_t>(d * d + h * h));
  const int64_t tangent = (h * kOneQ30) / (d < 0 ? d - root : d + root);
  const int64_t secant = isqrt64(static_cast<uint64_t>(kOneQ30 * kOneQ30 + tangent * tangent));
  const int64_t c = kOneQ30 * kOneQ30 / secant;
  return {c, round_shift(tangent * c, 30)};
}

}  // namespace

void Orthonormalizer::prepare(const int64_t (*gram)[kSpectralModes], uint32_t n) {
  int64_t norm[kSpectralModes];
  for (uint32_t i = 0; i < n; ++i) norm[i] = gram[i][i] > 0 ? isqrt64(static_cast<uint64_t>(gram[i][i])) : 0;
  for (uint32_t j = 0; j < n; ++j) {
    inverse_norm[j] = 0;
    inverse_pivot[j] = 0;
    for (uint32_t k = 0; k < n; ++k) upper[j][k] = 0;
    if (norm[j] < kShortest) continue;
    int64_t rest = kOneQ30 * kOneQ30;
    for (uint32_t i = 0; i < j; ++i) {
      if (inverse_norm[i] == 0) continue;
      int64_t sum = (gram[j][i] / norm[i] * kOneQ30) / norm[j] * kOneQ30;  // |cosine| <= 1, Q60
      for (uint32_t k = 0; k < i; ++k) sum -= static_cast<int64_t>(upper[k][i]) * upper[k][j];
      upper[i][j] = clamp32(mul_shift(round_shift(sum, 30), inverse_pivot[i], 30), -(1 << 30), 1 << 30);
      rest -= static_cast<int64_t>(upper[i][j]) * upper[i][j];
    }
    if (rest >> 30 < kSmallestSquare) continue;
    inverse_norm[j] = (static_cast<int64_t>(1) << 50) / norm[j];
    inverse_pivot[j] = kOneQ30 * kOneQ30 / isqrt64(static_cast<uint64_t>(rest));
  }
}

void Orthonormalizer::apply(int32_t* row, uint32_t n) const {
  uint64_t sum[kSpectralModes] = {};  // two's complement, Q20 + 30
  for (uint32_t j = 0; j < n; ++j) {
    if (inverse_norm[j] == 0) {
      row[j] = 0;
      continue;
    }
    const int64_t unit = mul_shift(row[j], inverse_norm[j], 20);
    const int64_t rest = unit - round_shift(static_cast<int64_t>(sum[j]), 30);
    const int32_t x = clamp32(mul_shift(rest, inverse_pivot[j], 30), -kVectorLimit, kVectorLimit);
    row[j] = x;
    for (uint32_t k = j + 1; k < n; ++k) sum[k] += static_cast<uint64_t>(static_cast<int64_t>(x) * upper[j][k]);
  }
}

void symmetric_eigenpairs(int64_t (*matrix)[kSpectralModes], int64_t (*vectors)[kSpectralModes], uint32_t n) {
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = 0; j < n; ++j) vectors[i][j] = i == j ? kOneQ30 : 0;
  }
  bool rotated = true;
  for (uint32_t sweep = 0; sweep < kSweeps && rotated; ++sweep) {
    rotated = false;
    for (uint32_t p = 0; p + 1 < n; ++p) {
      for (uint32_t q = p + 1; q < n; ++q) {
        if (abs64(matrix[p][q]) < kNegligible) continue;
        rotated = true;
        const Rotation r = annihilate(matrix[p][p], matrix[q][q], matrix[p][q]);
        // Rows p and q, then the same columns from them, so that the matrix stays symmetric to the last bit.
        const int64_t a_pp = matrix[p][p], a_qq = matrix[q][q], a_pq = matrix[p][q];
        for (uint32_t k = 0; k < n; ++k) {
          const int64_t x = matrix[p][k], y = matrix[q][k];
          matrix[p][k] = round_shift(r.c * x - r.s * y, kRotationBits);
          matrix[q][k] = round_shift(r.s * x + r.c * y, kRotationBits);
          const int64_t u = vectors[p][k], v = vectors[q][k];
          vectors[p][k] = round_shift(r.c * u - r.s * v, kRotationBits);
          vectors[q][k] = round_shift(r.s * u + r.c * v, kRotationBits);
        }
        const int64_t cc = r.c * r.c >> 30, ss = r.s * r.s >> 30, cs = r.c * r.s >> 30;
        matrix[p][p] = round_shift(cc * a_pp - 2 * cs * a_pq + ss * a_qq, 30);
        matrix[q][q] = round_shift(ss * a_pp + 2 * cs * a_pq + cc * a_qq, 30);
        matrix[p][q] = matrix[q][p] = 0;
        for (uint32_t k = 0; k < n; ++k) {
          if (k == p || k == q) continue;
          matrix[k][p] = matrix[p][k];
          matrix[k][q] = matrix[q][k];
        }
      }
    }
  }
}

}  // namespace sinew
