// SPDX-License-Identifier: MIT
// An uneven floor: heights on a regular grid, between them by bilinear interpolation, beyond its edges as at them.
#ifndef SINEW_MOTION_FLOOR_GRID_HPP
#define SINEW_MOTION_FLOOR_GRID_HPP

#include "core/vec3d.hpp"
#include "sinew/motion.h"

namespace sinew::motion {

struct FloorGrid {
  const float* heights = nullptr;  // [rows x columns]; null: level
  uint32_t columns = 0, rows = 0;
  double first[2] = {}, step = 1;  // along the two axes that are not up

  // SINEW_OK, SINEW_ERROR_ARGUMENT, SINEW_ERROR_COUNT or SINEW_ERROR_NOT_FINITE. floor null: level.
  sinew_status take(const sinew_floor* floor);
  // Over the level floor, under a point.
  double height(Vec3d up, Vec3d p) const;
};

}  // namespace sinew::motion
#endif
