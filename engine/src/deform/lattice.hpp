// SPDX-License-Identifier: MIT
// A lattice of tetrahedra around a bound mesh: what poses of the volume and the published method are solved on.
#ifndef SINEW_DEFORM_LATTICE_HPP
#define SINEW_DEFORM_LATTICE_HPP

#include "deform/weight_row.hpp"
#include "grid/grid_quantizer.hpp"
#include "kernels/constraints.hpp"
#include "mesh/mesh.hpp"
#include "voxels/voxels.hpp"

namespace sinew::deform {

constexpr uint32_t kNoTetrahedron = 0xFFFFFFFFu;
constexpr int kShareBits = 14;  // barycentric coordinates are Q14

// Bounds that every allocation is a function of.
struct LatticeBounds {
  int32_t size[3] = {0, 0, 0};  // cells per axis, border included
  uint32_t cells = 0;           // of the grid
  uint32_t pairs = 0;           // P, of a cell and a triangle that touches it
  uint32_t copies = 0;          // N: a cell has a copy for each part of the body in it
  uint32_t nodes = 0;
  uint32_t vertices = 0, influences = 0, joints = 0;
};

constexpr uint32_t kColors = 8;
constexpr uint32_t kPieceCopies = 32;  // a piece has at least so many, but for the last of a color

struct LatticeEdge {
  uint32_t a, b;  // nodes, a < b
};

// A vertex in a tetrahedron.
struct Embedding {
  uint32_t tetrahedron;  // kNoTetrahedron for a vertex without a triangle
  int16_t shares[4];     // Q14, sum exactly 1
};

// n nodes, t tetrahedra, 5 a copy of a cell, in the order of copies. Lattice units: the cell's edge is 2^14.
struct Lattice {
  uint32_t node_count = 0, tetrahedron_count = 0, edge_count = 0, split_cells = 0;
  Vec3i* nodes = nullptr;          // [n] rest positions, lattice units from the grid's corner
  WeightRow* rows = nullptr;       // [n]
  uint32_t* tetrahedra = nullptr;  // [t x 4] nodes, positive volume; the fifth of a copy is its large middle one
  // Copies by the parity of their cells' coordinates, their color, and cut into pieces: pieces of one color have no node in
  // common, so that threads may take them side by side.
  uint32_t* copy_order = nullptr;    // [N]
  uint32_t* piece_copies = nullptr;  // [pieces + 1] of copy_order
  uint32_t* piece_edges = nullptr;   // [pieces + 1] of edges
  uint32_t color_pieces[kColors + 1] = {};
  LatticeEdge* edges = nullptr;   // each once, of the first copy in that order that has it
  Embedding* vertices = nullptr;  // [U] by welded vertex

  bool allocate(Arena& arena, const LatticeBounds& bounds);
  uint32_t piece_count() const { return color_pieces[kColors]; }
};

// The grid of a mesh and the bounds of its lattice. The grid's corner lies a little more than a cell below the mesh, uneven parts of a cell on each axis, so that
// flat sides of a model do not fall on sides of cells.
// Walks the caller's mesh once. Indices are checked. Returns SINEW_OK, SINEW_ERROR_INDEX, or SINEW_ERROR_COUNT where the
// lattice would be too large.
sinew_status find_lattice_bounds(const sinew_mesh& mesh, const GridQuantizer& quantizer, uint32_t cells_along,
                                 LatticeBounds* bounds, VoxelGrid* grid);

// Input of a lattice. Rows of welded vertices are those of the first vertex at their position.
struct LatticeInput {
  const Mesh* mesh;
  const uint32_t* first_vertices;  // [U] the caller's first vertex at the position
  const uint16_t* joints;          // [V x influences]
  const uint16_t* weights;
};

// Fills a lattice, allocated beforehand. Scratch is taken from `arena` and released. Works with a measuring arena.
// Copies of cells are the virtual nodes of N. Molino, Z. Bao and R. Fedkiw, 2004; here the weights decide what is kept apart.
sinew_status build_lattice(const LatticeInput& input, const LatticeBounds& bounds, const VoxelGrid& grid, Arena& arena,
                           Lattice* lattice);

}  // namespace sinew::deform
#endif
