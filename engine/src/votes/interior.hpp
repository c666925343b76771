// SPDX-License-Identifier: MIT
// A body in voxels: which cells are solid, how deep they lie, and how far they are from the middle through the body.
#ifndef SINEW_VOTES_INTERIOR_HPP
#define SINEW_VOTES_INTERIOR_HPP

#include "voxels/voxels.hpp"

namespace sinew::rigging {

constexpr uint32_t kRigCells = 64;      // along the longest side
constexpr uint16_t kDepthUnits = 3;     // of a cell: chamfer distance 3-4-5
constexpr uint16_t kDistanceUnits = 5;  // of a cell: steps of 5, 7, 9
constexpr uint32_t kOutsideCost = 4;    // a step that leaves or enters a cell outside costs so many times
constexpr uint16_t kNoDistance = 0xFFFF;

struct Interior {
  VoxelGrid grid;
  uint16_t* depth = nullptr;     // [cells] to the nearest cell outside, thirds of a cell; 0 outside
  uint16_t* distance = nullptr;  // [cells] from the body's middle, fifths of a cell

  static bool solid(uint8_t state) { return state == kCellInside || state == kCellSurface; }
  // Whether a point lies in a solid cell. Points outside the grid do not.
  bool solid_at(Vec3i p) const {
    const int64_t x = int64_t{p.x} - grid.low.x, y = int64_t{p.y} - grid.low.y, z = int64_t{p.z} - grid.low.z;
    if (x < 0 || y < 0 || z < 0) return false;
    const int64_t cx = x / grid.cell_size, cy = y / grid.cell_size, cz = z / grid.cell_size;
    if (cx >= grid.size[0] || cy >= grid.size[1] || cz >= grid.size[2]) return false;
    return solid(grid.states[grid.index(static_cast<int32_t>(cx), static_cast<int32_t>(cy), static_cast<int32_t>(cz))]);
  }
  // How far one can go from p along a direction (Q14) in steps of half a cell before the second step in a row that lies
  // outside, in half cells; at most `most`.
  uint32_t march(Vec3i p, Vec3i direction, uint32_t most) const;

  // The cell of a point, or the nearest solid one within six cells: the first of the least distance. Where there is none, the point's.
  uint32_t solid_near(Vec3i p) const;

  bool allocate(Arena& arena);
  static size_t max_cells();
};

// A cell that distances through a body are measured from. It is solid, or lies in the air where no solid cell is near.
struct WayStart {
  uint32_t cell = 0;
  uint8_t owner = 0;
};
constexpr uint8_t kNoOwner = 0xFF;

// Divides the body among starts. Every solid cell gets its distance through the body to the nearest start, which replaces the
// distance from the middle, and the owner of that start. Of two starts in one cell the first counts.
//   owner  out  [cells] kNoOwner where no path was needed
// Scratch is taken from the arena and released. Returns arena.ok().
bool divide_body(const WayStart* starts, uint32_t count, Arena& arena, Interior* interior, uint8_t* owner);

// Calls visit(a, b, distance) for neighboring cells that two owners have, with the path length from start to start
// over them.
template <class Visit>
void each_border(const Interior& interior, const uint8_t* owner, Visit&& visit);

// Fills an interior, allocated beforehand. Scratch is taken from the arena and released. Returns arena.ok().
bool build_interior(const Mesh& mesh, Arena& arena, Interior* interior);

template <class Visit>
void each_border(const Interior& interior, const uint8_t* owner, Visit&& visit) {
  const VoxelGrid& grid = interior.grid;
  const int32_t steps[3] = {1, grid.size[0], grid.size[0] * grid.size[1]};
  for (uint32_t c = 0; c < grid.cell_count; ++c) {
    if (owner[c] == kNoOwner || interior.depth[c] == 0) continue;
    for (const int32_t step : steps) {
      const uint32_t other = c + static_cast<uint32_t>(step);
      if (owner[other] == kNoOwner || owner[other] == owner[c] || interior.depth[other] == 0) continue;
      visit(owner[c], owner[other], uint32_t{interior.distance[c]} + interior.distance[other] + kDistanceUnits);
    }
  }
}

}  // namespace sinew::rigging
#endif
