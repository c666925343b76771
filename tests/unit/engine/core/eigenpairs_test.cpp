// SPDX-License-Identifier: MIT
// Eigenpairs of symmetric matrices: they are those of the matrix, orthonormal, and degenerate matrices have some as well.
#include "core/eigenpairs.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace sinew {
namespace {

// A v = lambda v for every pair, and the vectors are orthonormal.
void expect_pairs(uint32_t n, const std::vector<double>& matrix, double tolerance) {
  std::vector<double> values = matrix, vectors(size_t{n} * n);
  find_eigenpairs(n, values.data(), vectors.data());
  for (uint32_t k = 0; k < n; ++k) {
    for (uint32_t i = 0; i < n; ++i) {
      double image = 0;
      for (uint32_t j = 0; j < n; ++j) image += matrix[i * n + j] * vectors[j * n + k];
      EXPECT_NEAR(image, values[k * n + k] * vectors[i * n + k], tolerance) << n << " " << k;
    }
    for (uint32_t other = 0; other <= k; ++other) {
      double along = 0;
      for (uint32_t i = 0; i < n; ++i) along += vectors[i * n + k] * vectors[i * n + other];
      EXPECT_NEAR(along, k == other ? 1 : 0, 1e-13) << n << " " << k << " " << other;
    }
  }
}

TEST(Eigenpairs, OfAnySymmetricMatrix) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> draw(-1, 1);
  for (const uint32_t n : {1u, 2u, 3u, 4u, 9u, 30u}) {
    std::vector<double> matrix(size_t{n} * n);
    for (uint32_t i = 0; i < n; ++i)
      for (uint32_t j = i; j < n; ++j) matrix[i * n + j] = matrix[j * n + i] = draw(random);
    expect_pairs(n, matrix, 1e-12);
    for (double& x : matrix) x *= 1e12;
    expect_pairs(n, matrix, 1);
  }
}

TEST(Eigenpairs, OfMatricesThatHaveManyOrNone) {
  expect_pairs(3, {0, 0, 0, 0, 0, 0, 0, 0, 0}, 0);
  expect_pairs(3, {2, 0, 0, 0, 2, 0, 0, 0, 2}, 0);
  expect_pairs(3, {1, 1, 1, 1, 1, 1, 1, 1, 1}, 1e-15);
  expect_pairs(2, {1, 1e-200, 1e-200, 1}, 1e-15);
  expect_pairs(3, {1e18, 1, 0, 1, 1e-18, 0, 0, 0, 1}, 1e3);
}

}  // namespace
}  // namespace sinew
