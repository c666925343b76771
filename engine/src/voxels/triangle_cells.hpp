// SPDX-License-Identifier: MIT
// Which cells of a voxel grid a triangle touches: for the voxels of the candidates and for the lattice of poses.
#ifndef SINEW_VOXELS_TRIANGLE_CELLS_HPP
#define SINEW_VOXELS_TRIANGLE_CELLS_HPP

#include "core/build.hpp"
#include "core/vector_math.hpp"
#include "voxels/voxels.hpp"

namespace sinew {
namespace triangle_cells {

inline int32_t component_of(Vec3i v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
inline int64_t component_of(Vec3l v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
inline int32_t min2(int32_t a, int32_t b) { return a < b ? a : b; }
inline int32_t max2(int32_t a, int32_t b) { return a > b ? a : b; }

// Half plane of a projected triangle's edge, widened by the cell: normal . center + offset >= 0 for the cells that
// touch it.
struct EdgeTest {
  int32_t normal_u, normal_v;
  int64_t offset;
};

// Separating axes of a triangle and the cells of the grid. Lengths are relative to the first corner and doubled, so
// that cell centers and half cells are integers. Inside the mesh's box: normals are at most 2^40 (twice a projected
// area), doubled centers below 2^21.1, so a plane value of three terms stays below 2^62.8; edge values are far smaller.
struct TriangleTest {
  Vec3i corners[3];  // relative to the first
  int32_t cell_size;
  int32_t start[3];      // doubled center of the grid's cell 0
  EdgeTest edges[3][3];  // [axis seen along][edge]
};

inline void set_up(const Vec3i* corners, const VoxelGrid& grid, TriangleTest* test) {
  test->corners[0] = {0, 0, 0};
  test->corners[1] = corners[1] - corners[0];
  test->corners[2] = corners[2] - corners[0];
  test->cell_size = grid.cell_size;
  for (int axis = 0; axis < 3; ++axis) {
    test->start[axis] = 2 * (component_of(grid.low, axis) - component_of(corners[0], axis)) + grid.cell_size;
  }
}

// The edges seen along an axis, on which the triangle's normal is `normal`.
inline void set_up_edges(int axis, int64_t normal, TriangleTest* test) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const int32_t sign = normal < 0 ? -1 : 1;  // seen from the front the corners turn left
  for (int edge = 0; edge < 3; ++edge) {
    const Vec3i a = test->corners[edge], along = test->corners[(edge + 1) % 3] - a;
    EdgeTest& e = test->edges[axis][edge];
    e.normal_u = -sign * component_of(along, v);
    e.normal_v = sign * component_of(along, u);
    e.offset = (abs64(e.normal_u) + abs64(e.normal_v)) * test->cell_size -
               2 * (static_cast<int64_t>(e.normal_u) * component_of(a, u) +
                    static_cast<int64_t>(e.normal_v) * component_of(a, v));
  }
}

inline bool inside_edges(const TriangleTest& test, int axis, const int32_t* center) {
  const int64_t u = center[(axis + 1) % 3], v = center[(axis + 2) % 3];
  int64_t least = 0;
  for (const EdgeTest& edge : test.edges[axis]) least |= edge.normal_u * u + edge.normal_v * v + edge.offset;
  return least >= 0;
}

struct CellBox {
  int32_t first[3], last[3];
};

// A triangle within one layer of cells across `w`: what its projection touches, it touches.
template <class Visit>
void visit_flat(const Vec3i* corners, const CellBox& box, int w, const VoxelGrid& grid, const Visit& visit) {
  const int u = (w + 1) % 3, v = (w + 2) % 3;
  TriangleTest test;
  set_up(corners, grid, &test);
  set_up_edges(w, component_of(cross(test.corners[1], test.corners[2]), w), &test);
  int32_t at[3];
  int32_t center[3] = {0, 0, 0};
  at[w] = box.first[w];
  for (at[u] = box.first[u]; at[u] <= box.last[u]; ++at[u]) {
    center[u] = test.start[u] + 2 * grid.cell_size * at[u];
    for (at[v] = box.first[v]; at[v] <= box.last[v]; ++at[v]) {
      center[v] = test.start[v] + 2 * grid.cell_size * at[v];
      if (inside_edges(test, w, center)) visit(grid.index(at[0], at[1], at[2]));
    }
  }
}

// Columns along the normal's main axis, so that a large slanted triangle costs its area in cells, not its box.
template <class Visit>
void visit_columns(const Vec3i* corners, const CellBox& box, const VoxelGrid& grid, const Visit& visit) {
  TriangleTest test;
  set_up(corners, grid, &test);
  const Vec3l cross_product = cross(test.corners[1], test.corners[2]);
  const int64_t normal[3] = {cross_product.x, cross_product.y, cross_product.z};
  // Half a cell, projected on the normal.
  const int64_t slack = (abs64(normal[0]) + abs64(normal[1]) + abs64(normal[2])) * grid.cell_size;
  int w = 0;
  for (int axis = 0; axis < 3; ++axis) {
    set_up_edges(axis, normal[axis], &test);
    if (abs64(normal[axis]) > abs64(normal[w])) w = axis;
  }
  const int u = (w + 1) % 3, v = (w + 2) % 3;
  const int64_t sign = normal[w] < 0 ? -1 : 1;
  const int32_t step = 2 * grid.cell_size;
  constexpr int32_t kShortColumn = 4;  // cells that are faster to test than to find by divisions
  // A triangle without area, as those of a hand that was cut out and turned may be, has no plane: its edges alone decide.
  const bool is_short = kSmallCode || normal[w] == 0 || box.last[w] - box.first[w] < kShortColumn;
  int32_t at[3];
  int32_t center[3];
  for (at[u] = box.first[u]; at[u] <= box.last[u]; ++at[u]) {
    center[u] = test.start[u] + at[u] * step;
    for (at[v] = box.first[v]; at[v] <= box.last[v]; ++at[v]) {
      center[v] = test.start[v] + at[v] * step;
      if (!inside_edges(test, w, center)) continue;
      const int64_t rest = sign * (normal[u] * center[u] + normal[v] * center[v]);
      const int64_t main = sign * normal[w];
      int32_t from = box.first[w], to = box.last[w];
      if (!is_short) {
        // The plane passes the column between these doubled heights; the normal's main component bounds the quotient.
        const int64_t low = -floor_div(slack + rest, main);  // ceil of the lower end
        const int64_t high = floor_div(slack - rest, main);
        const int64_t least = -floor_div(test.start[w] - low, step), most = floor_div(high - test.start[w], step);
        if (least > from) from = static_cast<int32_t>(least);
        if (most < to) to = static_cast<int32_t>(most);
      }
      for (at[w] = from; at[w] <= to; ++at[w]) {
        center[w] = test.start[w] + at[w] * step;
        if ((!is_short || abs64(rest + main * center[w]) <= slack) && inside_edges(test, u, center) &&
            inside_edges(test, v, center)) {
          visit(grid.index(at[0], at[1], at[2]));
        }
      }
    }
  }
}

}  // namespace triangle_cells

// Calls visit(cell) for every cell that a triangle touches, each once. corners [3] in grid units.
template <class Visit>
void each_touched_cell(const Vec3i* corners, const VoxelGrid& grid, const Visit& visit) {
  using namespace triangle_cells;
  CellBox box;
  int wide = 0, flat = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int32_t a = component_of(corners[0], axis), b = component_of(corners[1], axis),
                  c = component_of(corners[2], axis);
    box.first[axis] =
        grid.coordinate(axis, min2(a, min2(b, c)) - 1);  // - 1: cells are closed, a shared side belongs to both
    box.last[axis] = grid.coordinate(axis, max2(a, max2(b, c)));
    if (box.first[axis] < box.last[axis]) {
      ++wide;
    } else {
      flat = axis;
    }
  }
  if (wide == 3 || kSmallCode) {
    visit_columns(corners, box, grid, visit);
  } else if (wide == 2) {
    visit_flat(corners, box, flat, grid, visit);
  } else {  // a row of cells, which the triangle passes from end to end
    for (int32_t z = box.first[2]; z <= box.last[2]; ++z) {
      for (int32_t y = box.first[1]; y <= box.last[1]; ++y) {
        for (int32_t x = box.first[0]; x <= box.last[0]; ++x) visit(grid.index(x, y, z));
      }
    }
  }
}

}  // namespace sinew
#endif
