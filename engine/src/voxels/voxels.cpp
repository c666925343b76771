// SPDX-License-Identifier: MIT
// Conservative rasterization of the mesh into cells, and the flood that finds what is outside.
#include "voxels/voxels.hpp"

#include <string.h>

#include "voxels/triangle_cells.hpp"

namespace sinew {
namespace {

using triangle_cells::component_of;
using triangle_cells::max2;
using triangle_cells::min2;

void lay_grid(const Mesh& mesh, const Counts& counts, VoxelGrid* grid) {
  Vec3i low = mesh.positions[0], high = low;
  for (uint32_t v = 1; v < mesh.welded_count; ++v) {
    const Vec3i p = mesh.positions[v];
    low = {min2(low.x, p.x), min2(low.y, p.y), min2(low.z, p.z)};
    high = {max2(high.x, p.x), max2(high.y, p.y), max2(high.z, p.z)};
  }
  const int32_t most = static_cast<int32_t>(counts.cells_along(mesh.welded_count));
  grid->cell_size = (kSide + most - 1) / most;
  int32_t corner[3];
  for (int axis = 0; axis < 3; ++axis) {
    const int32_t extent = component_of(high, axis) - component_of(low, axis);
    const int32_t cells = min2(extent / grid->cell_size + 1, most);
    grid->size[axis] = cells + 2;
    corner[axis] = component_of(low, axis) - (cells * grid->cell_size - extent) / 2 - grid->cell_size;
  }
  grid->low = {corner[0], corner[1], corner[2]};
  grid->cell_count = static_cast<uint32_t>(grid->size[0] * grid->size[1] * grid->size[2]);
}

}  // namespace

void clear_cells(VoxelGrid* grid) {
  memset(grid->states, kCellBorder, grid->cell_count);
  for (int32_t z = 1; z < grid->size[2] - 1; ++z) {
    for (int32_t y = 1; y < grid->size[1] - 1; ++y) {
      memset(grid->states + grid->index(1, y, z), kCellInside, static_cast<size_t>(grid->size[0] - 2));
    }
  }
}

void flood_outside(uint32_t* queue, VoxelGrid* grid) {
  const int32_t nx = grid->size[0], ny = grid->size[1], nz = grid->size[2];
  const int32_t steps[6] = {1, -1, nx, -nx, nx * ny, -nx * ny};
  uint32_t tail = 0;
  // The border is one connected shell; its cells only start the flood and are never entered.
  for (int32_t z = 1; z < nz - 1; ++z) {
    for (int32_t y = 1; y < ny - 1; ++y) {
      for (int32_t x = 1; x < nx - 1; ++x) {
        const bool rim = x == 1 || x == nx - 2 || y == 1 || y == ny - 2 || z == 1 || z == nz - 2;
        const uint32_t cell = grid->index(x, y, z);
        if (!rim || grid->states[cell] != kCellInside) continue;
        grid->states[cell] = kCellOutside;
        queue[tail++] = cell;
      }
    }
  }
  for (uint32_t head = 0; head < tail; ++head) {
    for (const int32_t step : steps) {
      const uint32_t cell = static_cast<uint32_t>(static_cast<int32_t>(queue[head]) + step);
      if (grid->states[cell] != kCellInside) continue;
      grid->states[cell] = kCellOutside;
      queue[tail++] = cell;
    }
  }
}

bool VoxelGrid::allocate(Arena& arena, const Counts& counts) {
  states = arena.alloc<uint8_t>(max_cells(counts));
  return arena.ok();
}

void voxelise(const Mesh& mesh, const Counts& counts, uint32_t* queue, VoxelGrid* grid) {
  lay_grid(mesh, counts, grid);
  clear_cells(grid);
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
    const uint32_t* const corners = mesh.triangles + 3 * static_cast<size_t>(t);
    const Vec3i points[3] = {mesh.positions[corners[0]], mesh.positions[corners[1]], mesh.positions[corners[2]]};
    each_touched_cell(points, *grid, [&](uint32_t cell) { grid->states[cell] = kCellSurface; });
  }
  for (uint32_t v = 0; v < mesh.welded_count; ++v) grid->states[grid->cell_of(mesh.positions[v])] = kCellSurface;
  flood_outside(queue, grid);
}

}  // namespace sinew
