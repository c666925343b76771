// SPDX-License-Identifier: MIT
// Cells and their copies: one for what belongs together, more where parts with other weights pass through a cell.
#include "deform/copies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "core/vec3d.hpp"
#include "mesh_scene.hpp"

namespace sinew::deform {
namespace {

constexpr uint32_t kBoxVertices = 8, kTwoBoxesCells = 10;

sinew_test::MeshScene one_box() {
  sinew_test::MeshScene scene;
  sinew_test::add_cube(&scene, 0, 0, 0);
  scene.add_joint(0, 0, 0, -1);
  return scene;
}

// Side by side along x with a gap of a tenth of a cell.
sinew_test::MeshScene two_boxes() {
  sinew_test::MeshScene scene = one_box();
  sinew_test::add_cube(&scene, 1.02f, 0, 0);
  return scene;
}

// Copies of the cells of a mesh. Vertices of the second box have `second` of their weight for joint 1, all else is for
// joint 0.
struct CellCopies {
  CellCopies(const sinew_test::MeshScene& scene, uint32_t cells, double second, size_t missing = 0)
      : run(scene), memory(1) {
    GridQuantizer quantizer;
    EXPECT_EQ(make_grid_quantizer(scene.positions.data(), scene.vertex_count(), 0, &quantizer), SINEW_OK);
    EXPECT_EQ(find_lattice_bounds(scene.mesh_view(), quantizer, cells, &bounds, &grid), SINEW_OK);
    bounds.influences = bounds.joints = 2;
    const auto other = static_cast<uint16_t>(std::lround(65535 * second));
    for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
      joints.insert(joints.end(), {0, 1});
      const uint16_t own = v < kBoxVertices ? uint16_t{0} : other;
      weights.insert(weights.end(), {static_cast<uint16_t>(65535 - own), own});
    }
    first_vertices.assign(run.mesh.welded_count, 0);
    for (uint32_t v = scene.vertex_count(); v-- > 0;) first_vertices[run.mesh.vertex_to_welded[v]] = v;
    Arena measuring;
    EXPECT_EQ(fill(measuring), SINEW_OK);
    bytes = measuring.high_water();
    memory = Workspace(bytes);
    Arena arena(memory.data(), bytes - missing);
    status = fill(arena);
    if (missing == 0) {
      EXPECT_EQ(arena.used(), kept) << "scratch is given back";
    }
  }
  sinew_status fill(Arena& arena) {
    const LatticeInput input = {&run.mesh, first_vertices.data(), joints.data(), weights.data()};
    grid.states = arena.alloc<uint8_t>(bounds.cells);
    RowSum sum;
    if (!copies.allocate(arena, bounds) || !sum.allocate(arena, bounds.joints)) return SINEW_ERROR_WORKSPACE;
    if (!arena.measuring()) sum.clear(bounds.joints);
    kept = arena.used();
    return find_copies(input, bounds, &grid, &sum, arena, &copies);
  }
  // Position of a copy's corner in the grid of corners.
  std::array<int32_t, 3> corner(uint32_t copy, uint32_t q) const {
    const Vec3i at = cell_coordinates(grid, copies.cells[copy]);
    return {at.x + static_cast<int32_t>(q / 4), at.y + static_cast<int32_t>(q / 2 % 2),
            at.z + static_cast<int32_t>(q % 2)};
  }
  size_t corner_positions() const {
    std::set<std::array<int32_t, 3>> positions;
    for (uint32_t c = 0; c < copies.count; ++c)
      for (uint32_t q = 0; q < 8; ++q) positions.insert(corner(c, q));
    return positions.size();
  }
  bool is_of_first_box(uint32_t triangle) const {
    return first_vertices[run.mesh.triangles[3 * size_t{triangle}]] < kBoxVertices;
  }
  // Cells that triangles of both boxes touch.
  uint32_t shared_cells() const {
    uint32_t shared = 0;
    for (uint32_t cell = 0; cell < grid.cell_count; ++cell) {
      bool touched[2] = {false, false};
      for (uint32_t p = copies.pair_offsets[cell]; p < copies.pair_offsets[cell + 1]; ++p)
        touched[is_of_first_box(copies.pair_triangles[p]) ? 0 : 1] = true;
      shared += touched[0] && touched[1] ? 1 : 0;
    }
    return shared;
  }
  Vec3d position_of(uint32_t welded) const {
    const Vec3i p = run.mesh.positions[welded];
    return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
  }

  sinew_test::MeshRun run;
  LatticeBounds bounds;
  VoxelGrid grid;
  std::vector<uint16_t> joints, weights;
  std::vector<uint32_t> first_vertices;
  Copies copies;
  Workspace memory;
  size_t bytes = 0, kept = 0;
  sinew_status status = SINEW_OK;
};

TEST(Copies, CellCoordinatesAreTheInverseOfTheIndex) {
  VoxelGrid grid;
  grid.size[0] = 5;
  grid.size[1] = 3;
  grid.size[2] = 4;
  for (int32_t x = 0; x < 5; ++x)
    for (int32_t y = 0; y < 3; ++y)
      for (int32_t z = 0; z < 4; ++z) EXPECT_EQ(cell_coordinates(grid, grid.index(x, y, z)), (Vec3i{x, y, z}));
}

TEST(Copies, ABodyOfOneJointHasOneCopyACell) {
  CellCopies box(one_box(), 6, 0);
  ASSERT_EQ(box.status, SINEW_OK);
  const Copies& copies = box.copies;
  EXPECT_EQ(copies.split_cells, 0u);
  ASSERT_LE(copies.count, box.bounds.copies);
  std::set<uint32_t> cells;
  for (uint32_t c = 0; c < copies.count; ++c) {
    EXPECT_TRUE(cells.insert(copies.cells[c]).second) << c;
    EXPECT_EQ(copies.rows[c].of(0), 65535u);
    EXPECT_EQ(copies.count_of_cell[copies.cells[c]], 1u);
    EXPECT_EQ(copies.first_of_cell[copies.cells[c]], c);
    const bool has_triangles = copies.pair_offsets[copies.cells[c]] < copies.pair_offsets[copies.cells[c] + 1];
    EXPECT_EQ(has_triangles, c < copies.surface_count) << "those with triangles come first";
    if (c > 0 && c < copies.surface_count) {
      EXPECT_LT(copies.cells[c - 1], copies.cells[c]) << "by cell";
    }
  }
  // Every cell whose middle lies in the box, of a side of 2^20 with its floor at 0, has one.
  uint32_t inside = 0;
  for (uint32_t cell = 0; cell < box.grid.cell_count; ++cell) {
    const Vec3i at = box.grid.center(cell);
    const int32_t half = kSide / 2;
    if (std::abs(at.x) >= half || std::abs(at.y - half) >= half || std::abs(at.z) >= half) continue;
    ++inside;
    EXPECT_EQ(cells.count(cell), 1u) << cell;
  }
  EXPECT_GT(inside, 100u);
  join_corners(box.grid, box.bounds.nodes, &box.copies);
  EXPECT_EQ(box.copies.node_count, box.corner_positions()) << "all hangs together: a node for each corner";
}

TEST(Copies, PairsAreTheTrianglesOfACellInAscendingOrder) {
  const CellCopies box(two_boxes(), kTwoBoxesCells, 1);
  const Copies& copies = box.copies;
  EXPECT_EQ(copies.pair_offsets[0], 0u);
  for (uint32_t cell = 0; cell < box.grid.cell_count; ++cell) {
    ASSERT_LE(copies.pair_offsets[cell], copies.pair_offsets[cell + 1]);
    for (uint32_t p = copies.pair_offsets[cell]; p < copies.pair_offsets[cell + 1]; ++p) {
      ASSERT_LT(copies.pair_triangles[p], box.run.mesh.triangle_count);
      ASSERT_LT(copies.pair_copies[p], copies.surface_count);
      EXPECT_EQ(copies.cells[copies.pair_copies[p]], cell) << "a copy of this cell";
      if (p > copies.pair_offsets[cell]) {
        EXPECT_LT(copies.pair_triangles[p - 1], copies.pair_triangles[p]);
      }
    }
  }
  EXPECT_LE(copies.pair_offsets[box.grid.cell_count], box.bounds.pairs);
}

// No point of the triangle, on a fine raster, is nearer to the middle of the cell.
TEST(Copies, PairPointsAreNearestToTheMiddleOfTheirCell) {
  const CellCopies box(one_box(), 5, 0);
  const Copies& copies = box.copies;
  const double cell_size = box.grid.cell_size;
  for (uint32_t cell = 0; cell < box.grid.cell_count; ++cell) {
    const Vec3i at = box.grid.center(cell);
    const Vec3d center = {static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z)};
    for (uint32_t p = copies.pair_offsets[cell]; p < copies.pair_offsets[cell + 1]; ++p) {
      const PairPoint& point = copies.pair_points[p];
      const uint32_t* const corners = box.run.mesh.triangles + 3 * size_t{copies.pair_triangles[p]};
      const auto distance_at = [&](double u, double v) {
        const Vec3d d = u * box.position_of(corners[0]) + v * box.position_of(corners[1]) +
                        (1 - u - v) * box.position_of(corners[2]) - center;
        return std::sqrt(dot(d, d)) / cell_size;
      };
      double sum = 0;
      for (const int16_t share : point.shares) {
        ASSERT_GE(share, 0);
        sum += share;
      }
      EXPECT_NEAR(sum, 16384, 2);
      const double own = distance_at(point.shares[0] / 16384.0, point.shares[1] / 16384.0);
      for (int u = 0; u <= 40; ++u)
        for (int v = 0; u + v <= 40; ++v) ASSERT_GE(distance_at(u / 40.0, v / 40.0), own - 1e-3) << p;
      for (const int16_t x : point.position) {
        ASSERT_GE(x, 0);
        ASSERT_LE(x, 16384) << "in the cell";
      }
    }
  }
}

TEST(Copies, PartsOfTwoJointsThatShareACellAreKeptApart) {
  CellCopies boxes(two_boxes(), kTwoBoxesCells, 1);
  ASSERT_EQ(boxes.status, SINEW_OK);
  const Copies& copies = boxes.copies;
  ASSERT_GT(boxes.shared_cells(), 25u) << "a layer of five by five cells at least";
  EXPECT_EQ(copies.split_cells, boxes.shared_cells());
  uint32_t split = 0;
  for (uint32_t cell = 0; cell < boxes.grid.cell_count; ++cell) {
    if (copies.count_of_cell[cell] < 2) continue;
    ++split;
    ASSERT_EQ(copies.count_of_cell[cell], 2u);
    const uint32_t a = copies.first_of_cell[cell], b = a + 1;
    EXPECT_EQ(copies.rows[a].of(0) + copies.rows[b].of(0), 65535u);
    EXPECT_TRUE(copies.rows[a].of(0) == 0 || copies.rows[b].of(0) == 0) << "each is of one joint alone";
    EXPECT_EQ(copies.cells[a], cell);
    EXPECT_EQ(copies.cells[b], cell);
  }
  EXPECT_EQ(split, copies.split_cells);
  for (uint32_t cell = 0; cell < boxes.grid.cell_count; ++cell) {
    for (uint32_t p = copies.pair_offsets[cell]; p < copies.pair_offsets[cell + 1]; ++p) {
      const uint32_t joint = boxes.is_of_first_box(copies.pair_triangles[p]) ? 0 : 1;
      EXPECT_EQ(copies.rows[copies.pair_copies[p]].of(joint), 65535u) << "the copy of its own box";
    }
  }
  join_corners(boxes.grid, boxes.bounds.nodes, &boxes.copies);
  std::map<uint32_t, uint32_t> joint_of_node;
  for (uint32_t c = 0; c < copies.count; ++c) {
    const uint32_t joint = copies.rows[c].of(1) > 32767 ? 1 : 0;
    for (uint32_t q = 0; q < 8; ++q) {
      const auto [known, added] = joint_of_node.emplace(copies.corners[8 * c + q], joint);
      ASSERT_EQ(known->second, joint) << "no node of both boxes";
    }
  }
}

TEST(Copies, PartsWithNearlyTheSameWeightsAreOne) {
  // Rows of joint 0 alone and of `second` for joint 1 differ by twice that.
  const CellCopies same(two_boxes(), kTwoBoxesCells, 0), below(two_boxes(), kTwoBoxesCells, 0.37),
      above(two_boxes(), kTwoBoxesCells, 0.38);
  EXPECT_EQ(same.copies.split_cells, 0u);
  EXPECT_EQ(below.copies.split_cells, 0u);
  EXPECT_EQ(above.copies.split_cells, above.shared_cells());
}

TEST(Copies, NodesAreNumberedByFirstAppearanceAndAreAtOneCorner) {
  CellCopies boxes(two_boxes(), kTwoBoxesCells, 1);
  join_corners(boxes.grid, boxes.bounds.nodes, &boxes.copies);
  std::vector<std::array<int32_t, 3>> nodes;
  for (uint32_t c = 0; c < boxes.copies.count; ++c) {
    for (uint32_t q = 0; q < 8; ++q) {
      const uint32_t node = boxes.copies.corners[8 * c + q];
      ASSERT_LE(node, nodes.size());
      if (node == nodes.size()) nodes.push_back(boxes.corner(c, q));
      ASSERT_EQ(nodes[node], boxes.corner(c, q)) << "corners of a node lie in one position";
    }
  }
  EXPECT_EQ(nodes.size(), boxes.copies.node_count);
  EXPECT_GT(nodes.size(), boxes.corner_positions()) << "two in the gap";
}

TEST(Copies, WithoutRoomForMoreNodesEveryCornerIsOne) {
  CellCopies boxes(two_boxes(), kTwoBoxesCells, 1);
  const auto positions = static_cast<uint32_t>(boxes.corner_positions());
  join_corners(boxes.grid, positions, &boxes.copies);
  EXPECT_EQ(boxes.copies.node_count, positions);
}

TEST(Copies, NormalsPointOutOfTheirBoxAndPointsLieOnIt) {
  const CellCopies boxes(two_boxes(), kTwoBoxesCells, 1);
  const Copies& copies = boxes.copies;
  for (uint32_t c = 0; c < copies.surface_count; ++c) {
    if (copies.count_of_cell[copies.cells[c]] < 2) continue;
    // In the gap: the first box, of joint 0, looks to +x, the second one to -x.
    const bool first = copies.rows[c].of(0) > 0;
    EXPECT_GT((first ? 1 : -1) * copies.normals[c].x, 0);
    EXPECT_NEAR(std::sqrt(static_cast<double>(dot(copies.normals[c], copies.normals[c]))), 1 << kNormalBits, 2);
    EXPECT_LT((first ? 1 : -1) * copies.points[c].x, 0) << "the gap is in the middle of both";
  }
}

TEST(Copies, ATooSmallBlockIsAStatus) { EXPECT_EQ(CellCopies(one_box(), 6, 0, 64).status, SINEW_ERROR_WORKSPACE); }

}  // namespace
}  // namespace sinew::deform
