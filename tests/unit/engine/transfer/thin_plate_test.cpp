// SPDX-License-Identifier: MIT
// L and L + L A^-1 L row by row: constants cost nothing, both are symmetric, and a bump costs something.
#include "transfer/thin_plate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "arena_block.hpp"
#include "mesh_scene.hpp"

namespace sinew::transferring {
namespace {

struct Plate {
  sinew_test::MeshRun run = sinew_test::MeshRun(sinew_test::cube_sphere(4));
  sinew_test::Block block = sinew_test::Block(size_t{1} << 20);
  ThinPlate plate;

  Plate() {
    EXPECT_TRUE(plate.allocate(block.arena, run.counts));
    plate.fill(run.mesh);
  }
  uint32_t count() const { return run.mesh.welded_count; }
  template <class Row>
  std::vector<double> dense(const Row& row) const {
    std::vector<double> out(size_t{count()} * count(), 0);
    for (uint32_t v = 0; v < count(); ++v)
      row(v, [&](uint32_t w, double value) { out[size_t{v} * count() + w] += value; });
    return out;
  }
};

TEST(ThinPlate, ConstantsCostNothingAndRowsAreSymmetric) {
  const Plate p;
  const auto laplacian = p.dense([&](uint32_t v, const auto& visit) { p.plate.laplacian(v, visit); });
  const auto plate = p.dense([&](uint32_t v, const auto& visit) { p.plate.plate(v, visit); });
  for (const std::vector<double>& matrix : {laplacian, plate}) {
    for (uint32_t v = 0; v < p.count(); ++v) {
      double sum = 0;
      for (uint32_t w = 0; w < p.count(); ++w) {
        sum += matrix[size_t{v} * p.count() + w];
        ASSERT_NEAR(matrix[size_t{v} * p.count() + w], matrix[size_t{w} * p.count() + v], 1e-9);
      }
      ASSERT_NEAR(sum, 0, 1e-9) << v;
      ASSERT_GT(matrix[size_t{v} * p.count() + v], 0) << v;
    }
  }
  // The plate bends over two rings, the Laplacian over one.
  EXPECT_GT(plate[0], laplacian[0]);
}

TEST(ThinPlate, AreasAreInMeans) {
  const Plate p;
  double sum = 0;
  for (uint32_t v = 0; v < p.count(); ++v) sum += p.plate.area[v];
  EXPECT_NEAR(sum / p.count(), 1, 1e-9);
}

}  // namespace
}  // namespace sinew::transferring
