// SPDX-License-Identifier: MIT
// From the grid back to the caller's units.
#ifndef SINEW_GRID_CALLER_UNITS_HPP
#define SINEW_GRID_CALLER_UNITS_HPP

#include "grid/grid_quantizer.hpp"
#include "sinew/sinew.h"

namespace sinew {

// The grid in the caller's units, in doubles of one order of operations: no more than each product and sum rounds.
struct Units {
  double low[3], high[3];  // box, the caller's axes with y up
  double side;

  Units(const sinew_mesh& mesh, uint32_t up_axis) {
    for (int axis = 0; axis < 3; ++axis) low[axis] = high[axis] = along(mesh.positions, up_axis, axis);
    for (uint32_t v = 1; v < mesh.vertex_count; ++v) {
      for (int axis = 0; axis < 3; ++axis) {
        const double x = along(mesh.positions + size_t{3} * v, up_axis, axis);
        low[axis] = x < low[axis] ? x : low[axis];
        high[axis] = x > high[axis] ? x : high[axis];
      }
    }
    side = 0;
    for (int axis = 0; axis < 3; ++axis) side = high[axis] - low[axis] > side ? high[axis] - low[axis] : side;
    if (side == 0) side = 1;
  }
  static double along(const float* p, uint32_t up_axis, int axis) {
    if (up_axis == 0) return static_cast<double>(p[axis]);
    return axis == 0 ? static_cast<double>(p[0]) : axis == 1 ? static_cast<double>(p[2]) : -static_cast<double>(p[1]);
  }
  double zero(int axis) const { return axis == 1 ? low[1] : 0.5 * low[axis] + 0.5 * high[axis]; }
  double length(int32_t grid) const { return static_cast<double>(grid) * (side / kSide); }
};

// A coordinate of a point that the grid holds may lie a little outside the mesh, so beyond the largest float: that one then.
inline float to_float(double x) {
  constexpr double kMost = 3.4028234663852886e38;
  return static_cast<float>(x > kMost ? kMost : x < -kMost ? -kMost : x);
}

}  // namespace sinew
#endif
