// SPDX-License-Identifier: MIT
// Cells of the lattice and their copies: one copy per connected component in a cell, and the connected copies of
// neighboring cells.
#ifndef SINEW_DEFORM_COPIES_HPP
#define SINEW_DEFORM_COPIES_HPP

#include "deform/lattice.hpp"

namespace sinew::deform {

// Rows that differ by less are one part of the body: 0.75 of 2. From 0.4 to 1.5 bends come out the same.
constexpr uint32_t kSameRows = 49151;

// The point of a triangle that is nearest to the center of a cell that it touches.
struct PairPoint {
  int16_t shares[3];    // Q14, of the triangle's corners
  int16_t position[3];  // Q14, in the cell
};

// A copy of a cell represents the triangles in it that belong together; a cell inside the body has one. Corner q of a cell is
// at x = q / 4, y = q / 2 % 2, z = q % 2.
struct Copies {
  uint32_t count = 0, surface_count = 0;  // those with triangles come first, by cell
  uint32_t split_cells = 0;
  uint32_t* cells = nullptr;           // [N]
  WeightRow* rows = nullptr;           // [N]
  Vec3i* points = nullptr;             // [N] on the surface, grid units
  Vec3i* normals = nullptr;            // [N] outward, Q14
  uint32_t* first_of_cell = nullptr;   // [cells]
  uint32_t* count_of_cell = nullptr;   // [cells]
  uint32_t* pair_offsets = nullptr;    // [cells + 1] CSR: triangles of a cell
  uint32_t* pair_triangles = nullptr;  // [P] ascending
  uint32_t* pair_copies = nullptr;     // [P]
  PairPoint* pair_points = nullptr;    // [P]
  uint32_t* corners = nullptr;         // [N x 8] the node of each corner
  uint32_t node_count = 0;

  bool allocate(Arena& arena, const LatticeBounds& bounds);
};

Vec3i cell_coordinates(const VoxelGrid& grid, uint32_t cell);

// Fills the copies, allocated beforehand; grid.states are those of `grid`, whose cells of triangles are not marked yet.
//   sum  scratch, cleared
// Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status find_copies(const LatticeInput& input, const LatticeBounds& bounds, VoxelGrid* grid, RowSum* sum,
                         Arena& arena, Copies* copies);
// Merges corners of connected copies and numbers the nodes by first appearance.
void join_corners(const VoxelGrid& grid, uint32_t most_nodes, Copies* copies);

}  // namespace sinew::deform
#endif
