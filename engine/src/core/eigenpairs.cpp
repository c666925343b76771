// SPDX-License-Identifier: MIT
// Jacobi rotations in doubles of one order.
#include "core/eigenpairs.hpp"

#include "core/vec3d.hpp"

namespace sinew {

void find_eigenpairs(uint32_t n, double* a, double* vectors) {
  constexpr int kMostSweeps = 40;
  for (uint32_t i = 0; i < n; ++i)
    for (uint32_t j = 0; j < n; ++j) vectors[i * n + j] = i == j ? 1 : 0;
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double off = 0, whole = 0;
    for (uint32_t i = 0; i < n; ++i)
      for (uint32_t j = 0; j < n; ++j) (i == j ? whole : off) += a[i * n + j] * a[i * n + j];
    if (off <= 1e-30 * whole) return;
    for (uint32_t p = 0; p + 1 < n; ++p) {
      for (uint32_t q = p + 1; q < n; ++q) {
        const double apq = a[p * n + q];
        if (apq == 0) continue;
        const double theta = (a[q * n + q] - a[p * n + p]) / (2 * apq);
        const double size = theta < 0 ? -theta : theta;
        const double t = (theta < 0 ? -1.0 : 1.0) / (size > 1e8 ? 2 * size : size + root(theta * theta + 1));
        const double c = 1 / root(t * t + 1), s = t * c;
        for (uint32_t k = 0; k < n; ++k) {
          const double kp = a[k * n + p], kq = a[k * n + q];
          a[k * n + p] = c * kp - s * kq;
          a[k * n + q] = s * kp + c * kq;
        }
        for (uint32_t k = 0; k < n; ++k) {
          const double pk = a[p * n + k], qk = a[q * n + k];
          a[p * n + k] = c * pk - s * qk;
          a[q * n + k] = s * pk + c * qk;
        }
        for (uint32_t k = 0; k < n; ++k) {
          const double kp = vectors[k * n + p], kq = vectors[k * n + q];
          vectors[k * n + p] = c * kp - s * kq;
          vectors[k * n + q] = s * kp + c * kq;
        }
      }
    }
  }
}

}  // namespace sinew
