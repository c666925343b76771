// SPDX-License-Identifier: MIT
// Points in cells, for the nearest of them to a position.
#ifndef SINEW_FRONT_POINT_GRID_HPP
#define SINEW_FRONT_POINT_GRID_HPP

#include <string.h>

#include "core/arena.hpp"
#include "grid/grid_quantizer.hpp"

namespace sinew::rigging {

// Points in cells of a coarse grid, for the nearest of them. Cells along x follow each other, so that a row of them is one
// run of points.
constexpr int kCells = 32, kCellBits = kGridBits - 5;
constexpr int32_t kReach = 2;  // cells around; farther is as good as nothing

// At most 2^16 points.
struct PointGrid {
  uint32_t count = 0;
  Vec3i low = {0, 0, 0};
  uint32_t* starts = nullptr;  // [kCells^3 + 1]
  uint16_t* order = nullptr;   // [count] points by cell
  Vec3i* positions = nullptr;  // [count] where they are, in that order

  bool allocate(Arena& arena, uint32_t most) {
    starts = arena.alloc<uint32_t>(kCells * kCells * kCells + 1);
    order = arena.alloc<uint16_t>(most);
    positions = arena.alloc<Vec3i>(most);
    return arena.ok();
  }

  static int32_t cell(int32_t offset) { return clamp32(offset >> kCellBits, 0, kCells - 1); }
  uint32_t cell_of(Vec3i p) const {
    return static_cast<uint32_t>((cell(p.z - low.z) * kCells + cell(p.y - low.y)) * kCells + cell(p.x - low.x));
  }
  //   at  position of point i, 0 <= i < points
  template <class At>
  void build(uint32_t points, At&& at) {
    count = points;
    low = at(0);
    for (uint32_t i = 1; i < count; ++i) {
      const Vec3i p = at(i);
      low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y, p.z < low.z ? p.z : low.z};
    }
    memset(starts, 0, (kCells * kCells * kCells + 1) * sizeof(uint32_t));
    for (uint32_t i = 0; i < count; ++i) ++starts[cell_of(at(i)) + 1];
    for (uint32_t c = 0; c < kCells * kCells * kCells; ++c) starts[c + 1] += starts[c];
    for (uint32_t i = count; i-- > 0;) order[--starts[cell_of(at(i)) + 1]] = static_cast<uint16_t>(i);
    // Every start has moved to the cell before it.
    for (uint32_t c = 0; c < kCells * kCells * kCells; ++c) starts[c] = starts[c + 1];
    starts[kCells * kCells * kCells] = count;
    for (uint32_t e = 0; e < count; ++e) positions[e] = at(order[e]);
  }
  // How far an offset from `low` is beyond cells first..last of an axis, 0 within them.
  static int64_t beyond(int32_t offset, int32_t first, int32_t last) {
    const int64_t from = int64_t{first} << kCellBits, to = (int64_t{last} + 1) << kCellBits;
    return offset < from ? from - offset : offset > to ? offset - to : 0;
  }
  // Nearest point within kReach cells, the lowest of several, and the squared distance; false when there is none.
  bool nearest(Vec3i p, uint32_t* index, uint64_t* squared) const {
    *squared = UINT64_MAX;
    const int32_t off[3] = {p.x - low.x, p.y - low.y, p.z - low.z};
    const int32_t home[3] = {cell(off[0]), cell(off[1]), cell(off[2])};
    for (int32_t reach = 1; reach <= kReach; ++reach) {
      int32_t first[3], last[3];
      int64_t inside = INT64_MAX;  // no point beyond these cells is nearer
      for (int axis = 0; axis < 3; ++axis) {
        first[axis] = home[axis] > reach ? home[axis] - reach : 0;
        last[axis] = home[axis] + reach < kCells ? home[axis] + reach : kCells - 1;
        const int64_t below = off[axis] - (int64_t{first[axis]} << kCellBits);
        const int64_t above = ((int64_t{last[axis]} + 1) << kCellBits) - off[axis];
        if (first[axis] > 0 && below < inside) inside = below;
        if (last[axis] < kCells - 1 && above < inside) inside = above;
      }
      for (int32_t z = first[2]; z <= last[2]; ++z) {
        const int64_t dz = beyond(off[2], z, z);
        for (int32_t y = first[1]; y <= last[1]; ++y) {
          const int64_t dy = beyond(off[1], y, y);
          if (static_cast<uint64_t>(dz * dz + dy * dy) > *squared) continue;
          const uint32_t row = static_cast<uint32_t>((z * kCells + y) * kCells);
          const uint32_t end = starts[row + static_cast<uint32_t>(last[0]) + 1];
          for (uint32_t e = starts[row + static_cast<uint32_t>(first[0])]; e < end; ++e) {
            const Vec3i d = positions[e] - p;
            const uint64_t own = static_cast<uint64_t>(dot(d, d));
            if (own < *squared || (own == *squared && order[e] < *index)) {
              *squared = own;
              *index = order[e];
            }
          }
        }
      }
      if (inside > 0 && *squared < static_cast<uint64_t>(inside) * static_cast<uint64_t>(inside)) break;
    }
    return *squared != UINT64_MAX;
  }
};

}  // namespace sinew::rigging
#endif
