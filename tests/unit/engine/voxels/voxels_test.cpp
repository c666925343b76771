// SPDX-License-Identifier: MIT
// Voxel states: the rasterizer marks exactly the touched cells, the flood stays outside.
#include "voxels/voxels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "mesh_scene.hpp"
#include "voxels/triangle_cells.hpp"
#include "with_asan.hpp"

namespace {

using sinew::Vec3i;
using sinew_test::MeshRun;
using sinew_test::MeshScene;

struct Voxels {
  explicit Voxels(const MeshRun& run) {
    states.resize(sinew::VoxelGrid::max_cells(run.counts));
    queue.resize(states.size());
    grid.states = states.data();
    sinew::voxelise(run.mesh, run.counts, queue.data(), &grid);
  }
  std::vector<uint8_t> states;
  std::vector<uint32_t> queue;
  sinew::VoxelGrid grid;
};

// Whether the triangle has a point in the box grown by `margin` on all sides: clips it by the six planes, in double.
bool meets_box(const Vec3i* corners, Vec3i low, int32_t size, double margin) {
  std::vector<std::array<double, 3>> polygon;
  for (int i = 0; i < 3; ++i) {
    polygon.push_back({double(corners[i].x), double(corners[i].y), double(corners[i].z)});
  }
  const double lows[3] = {double(low.x), double(low.y), double(low.z)};
  for (size_t plane = 0; plane < 6; ++plane) {
    const size_t axis = plane / 2;
    const double sign = plane % 2 == 0 ? 1 : -1;
    const double bound = plane % 2 == 0 ? lows[axis] - margin : -(lows[axis] + size + margin);
    std::vector<std::array<double, 3>> next;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double da = sign * a[axis] - bound, db = sign * b[axis] - bound;
      if (da >= 0) next.push_back(a);
      if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
        const double t = da / (da - db);
        next.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
      }
    }
    polygon = next;
  }
  return !polygon.empty();
}

TEST(Voxels, MarksExactlyTheTouchedCells) {
  std::mt19937 random(5);
  for (int round = 0; round < 30 / static_cast<int>(sinew_test::kEveryWithAsan); ++round) {
    MeshScene scene;
    const uint32_t triangles = 1 + random() % 4;
    for (uint32_t i = 0; i < 3 * triangles; ++i) {
      // Coarse coordinates put corners, edges and faces on cell sides; flat axes make axis-parallel triangles.
      const auto value = [&] { return static_cast<float>(random() % (round % 2 ? 1000 : 9)); };
      const float x = value(), y = round % 3 == 0 ? 4.0f : value(), z = value();
      scene.add_vertex(x, y, z);
    }
    for (uint32_t i = 0; i < triangles; ++i) scene.add_face({3 * i, 3 * i + 1, 3 * i + 2});
    scene.add_joint(0, 0, 0, -1);
    const MeshRun run(scene, 0, 8, 16 + static_cast<uint32_t>(random() % 8));
    ASSERT_EQ(run.status, SINEW_OK);
    const Voxels v(run);
    const sinew::VoxelGrid& g = v.grid;
    for (int32_t z = 1; z < g.size[2] - 1; ++z) {
      for (int32_t y = 1; y < g.size[1] - 1; ++y) {
        for (int32_t x = 1; x < g.size[0] - 1; ++x) {
          const Vec3i low = {g.low.x + x * g.cell_size, g.low.y + y * g.cell_size, g.low.z + z * g.cell_size};
          bool touched = false, nearly = false;
          for (uint32_t t = 0; t < run.mesh.triangle_count; ++t) {
            const uint32_t* c = run.mesh.triangles + 3 * t;
            const Vec3i corners[3] = {run.mesh.positions[c[0]], run.mesh.positions[c[1]], run.mesh.positions[c[2]]};
            touched = touched || meets_box(corners, low, g.cell_size, -1e-3);
            nearly = nearly || meets_box(corners, low, g.cell_size, 1e-3);
          }
          for (uint32_t i = 0; i < run.mesh.welded_count; ++i) {
            if (g.cell_of(run.mesh.positions[i]) == g.index(x, y, z))
              touched = nearly = true;  // vertices without a face too
          }
          const bool marked = g.states[g.index(x, y, z)] == sinew::kCellSurface;
          ASSERT_TRUE(marked || !touched)
              << "round " << round << " cell " << x << " " << y << " " << z << " was missed";
          ASSERT_TRUE(!marked || nearly) << "round " << round << " cell " << x << " " << y << " " << z << " is marked";
        }
      }
    }
  }
}

// As a cut out and turned mesh may have them: three points in a line, farther apart than a few cells.
TEST(Voxels, ATriangleWithoutAreaTouchesWhatItsLineDoes) {
  sinew::VoxelGrid grid;
  grid.low = {0, 0, 0};
  grid.cell_size = 10;
  for (int32_t& cells : grid.size) cells = 40;
  const Vec3i corners[3] = {{25, 25, 25}, {95, 60, 165}, {165, 95, 305}};
  std::set<uint32_t> touched;
  sinew::each_touched_cell(corners, grid, [&](uint32_t cell) { touched.insert(cell); });
  for (const Vec3i& corner : corners) EXPECT_EQ(touched.count(grid.cell_of(corner)), 1u);
  for (int32_t z = 0; z < 40; ++z)
    for (int32_t y = 0; y < 40; ++y)
      for (int32_t x = 0; x < 40; ++x) {
        const Vec3i low = {10 * x, 10 * y, 10 * z};
        const bool marked = touched.count(grid.index(x, y, z)) != 0;
        ASSERT_TRUE(marked || !meets_box(corners, low, 10, -1e-3)) << x << " " << y << " " << z << " was missed";
      }
  EXPECT_LT(touched.size(), 120u);
}

// The arrays have room for what the caller's vertices ask for, the grid is that of the welded ones.
TEST(Voxels, CellsFollowTheWeldedVertices) {
  MeshScene scene;
  for (uint32_t i = 0; i < 5000; ++i) scene.add_vertex(static_cast<float>(i / 2 % 50), static_cast<float>(i / 100), 0);
  scene.add_joint(0, 0, 0, -1);
  const MeshRun run(scene, 0, 8, 0);
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_EQ(run.mesh.welded_count, 2500u);
  const Voxels v(run);
  EXPECT_EQ(sinew::VoxelGrid::max_cells(run.counts), 41u * 41 * 41);
  EXPECT_EQ(v.grid.cell_size, (sinew::kSide + 31) / 32);
}

TEST(Voxels, ASphereIsSolidAndItsCornersAreOutside) {
  const MeshRun run(sinew_test::cube_sphere(20));
  const Voxels v(run);
  const double radius = sinew::kSide / 2.0, cell = v.grid.cell_size;
  ASSERT_EQ(v.grid.size[0], 66);
  for (uint32_t c = 0; c < v.grid.cell_count; ++c) {
    if (v.states[c] == sinew::kCellBorder) continue;
    const Vec3i p = v.grid.center(c);
    const double r = std::sqrt(double(p.x) * p.x + (p.y - radius) * (p.y - radius) + double(p.z) * p.z);
    if (r < radius - 2 * cell) {
      ASSERT_EQ(v.states[c], sinew::kCellInside);
    } else if (r > radius + cell) {
      ASSERT_EQ(v.states[c], sinew::kCellOutside);
    }
  }
}

TEST(Voxels, AHoleLetsTheOutsideIn) {
  MeshScene scene = sinew_test::cube_sphere(20);
  scene.offsets.resize(scene.offsets.size() - 200);  // the last half of a side
  scene.corners.resize(scene.offsets.back());
  const MeshRun run(scene);
  const Voxels v(run);
  EXPECT_EQ(v.grid.states[v.grid.cell_of({0, sinew::kSide / 2, 0})], sinew::kCellOutside);
}

TEST(Voxels, APointIsOneCell) {
  MeshScene scene;
  scene.add_vertex(3, 3, 3);
  scene.add_joint(0, 0, 0, -1);
  const MeshRun run(scene);
  const Voxels v(run);
  EXPECT_EQ(v.grid.cell_count, 27u);
  EXPECT_EQ(v.grid.states[v.grid.cell_of({0, 0, 0})], sinew::kCellSurface);
}

}  // namespace
