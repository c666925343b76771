// SPDX-License-Identifier: MIT
// A mesh in voxels: which cells hold surface, which lie inside, which outside the body.
#ifndef SINEW_VOXELS_VOXELS_HPP
#define SINEW_VOXELS_VOXELS_HPP

#include "mesh/mesh.hpp"

namespace sinew {

enum CellState : uint8_t {
  kCellInside = 0,
  kCellSurface = 1,  // a triangle or a vertex touches the cell
  kCellOutside = 2,  // reached from the border through cells without surface, over faces
  kCellBorder = 3    // the outermost layer: outside, and never walked
};

// Cubic cells, counts.cells_along() of them along the mesh's longest side, with one border cell around; the grid is centered on the
// mesh's box, so that a symmetric mesh gets symmetric cells.
struct VoxelGrid {
  Vec3i low = {0, 0, 0};        // corner of cell (0, 0, 0), a border cell, grid units
  int32_t cell_size = 1;        // grid units
  int32_t size[3] = {0, 0, 0};  // cells per axis, border included; at most grid + 2
  uint32_t cell_count = 0;
  uint8_t* states = nullptr;  // [cell_count] CellState

  bool allocate(Arena& arena, const Counts& counts);  // for the largest grid: (grid + 2)^3 cells
  static size_t max_cells(const Counts& counts) {
    const size_t side = size_t{counts.cells_along(counts.vertices)} + 2;
    return side * side * side;
  }

  // Coordinate along an axis (0, 1, 2) of the cell that holds the value; values outside the mesh's box go to its first
  // or last cell.
  int32_t coordinate(int axis, int32_t value) const {
    const int32_t origin = axis == 0 ? low.x : axis == 1 ? low.y : low.z;
    const int32_t at = value < origin ? 0 : (value - origin) / cell_size;
    return at < 1 ? 1 : at > size[axis] - 2 ? size[axis] - 2 : at;
  }
  uint32_t index(int32_t x, int32_t y, int32_t z) const {
    return static_cast<uint32_t>((z * size[1] + y) * size[0] + x);
  }
  // Calls visit(cell) for the 26 neighbors of a cell that is not in the border, in the order of cells.
  template <class Visit>
  void each_neighbor(uint32_t cell, Visit&& visit) const {
    for (int32_t z = -1; z <= 1; ++z) {
      for (int32_t y = -1; y <= 1; ++y) {
        for (int32_t x = -1; x <= 1; ++x) {
          if (x != 0 || y != 0 || z != 0) visit(cell + static_cast<uint32_t>((z * size[1] + y) * size[0] + x));
        }
      }
    }
  }
  uint32_t cell_of(Vec3i p) const { return index(coordinate(0, p.x), coordinate(1, p.y), coordinate(2, p.z)); }
  Vec3i center(uint32_t cell) const {
    const int32_t x = static_cast<int32_t>(cell) % size[0], yz = static_cast<int32_t>(cell) / size[0];
    return {low.x + x * cell_size + cell_size / 2, low.y + (yz % size[1]) * cell_size + cell_size / 2,
            low.z + (yz / size[1]) * cell_size + cell_size / 2};
  }
};

// Makes the outermost layer border cells and all others inside ones. The grid is laid.
void clear_cells(VoxelGrid* grid);
// Outside are the inside cells that can be reached from the border over faces. `queue` is scratch of [cell_count].
void flood_outside(uint32_t* queue, VoxelGrid* grid);

// Lays the grid over the mesh and fills the states. `queue` is scratch of [max_cells]. Surface cells are exactly the
// closed cells that a triangle or vertex touches (separating axes, Akenine-Moeller 2001), so a face-connected flood
// cannot slip through.
void voxelise(const Mesh& mesh, const Counts& counts, uint32_t* queue, VoxelGrid* grid);

}  // namespace sinew
#endif
