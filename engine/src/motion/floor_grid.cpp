// SPDX-License-Identifier: MIT
// Cells are found without rounding modes: a clamped coordinate, cut to an integer.
#include "motion/floor_grid.hpp"

#include "motion/motion_rig.hpp"

namespace sinew::motion {

sinew_status FloorGrid::take(const sinew_floor* floor) {
  if (floor == nullptr) return SINEW_OK;
  if (floor->heights == nullptr || floor->columns == 0 || floor->rows == 0) return SINEW_ERROR_ARGUMENT;
  if (floor->columns > SINEW_MAX_FLOOR_SIDE || floor->rows > SINEW_MAX_FLOOR_SIDE) return SINEW_ERROR_COUNT;
  step = static_cast<double>(floor->step);
  for (int i = 0; i < 2; ++i) first[i] = static_cast<double>(floor->first[i]);
  if (!is_finite(step + first[0] + first[1])) return SINEW_ERROR_NOT_FINITE;
  if (!(step > 0)) return SINEW_ERROR_ARGUMENT;
  for (size_t i = 0; i < size_t{floor->columns} * floor->rows; ++i) {
    if (!is_finite(static_cast<double>(floor->heights[i]))) return SINEW_ERROR_NOT_FINITE;
  }
  heights = floor->heights;
  columns = floor->columns;
  rows = floor->rows;
  return SINEW_OK;
}

double FloorGrid::height(Vec3d up, Vec3d p) const {
  if (heights == nullptr) return 0;
  const bool x_up = absolute(up.x) > 0.5, z_up = absolute(up.z) > 0.5;
  const double at[2] = {x_up ? p.y : p.x, z_up ? p.y : p.z};
  const uint32_t counts[2] = {columns, rows};
  uint32_t low[2], high[2];
  double share[2];
  for (int i = 0; i < 2; ++i) {
    const double cell = clamped((at[i] - first[i]) / step, 0, static_cast<double>(counts[i] - 1));
    low[i] = static_cast<uint32_t>(cell);
    high[i] = low[i] + 1 < counts[i] ? low[i] + 1 : low[i];
    share[i] = cell - static_cast<double>(low[i]);
  }
  const auto value = [&](uint32_t column, uint32_t row) {
    return static_cast<double>(heights[size_t{row} * columns + column]);
  };
  const double near = value(low[0], low[1]) + share[0] * (value(high[0], low[1]) - value(low[0], low[1]));
  const double far = value(low[0], high[1]) + share[0] * (value(high[0], high[1]) - value(low[0], high[1]));
  return near + share[1] * (far - near);
}

}  // namespace sinew::motion
