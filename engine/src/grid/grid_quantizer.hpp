// SPDX-License-Identifier: MIT
// Stage 1 of a bind: float positions to the integer grid. Exact integer arithmetic on the IEEE-754 words, no float
// operation, so neither compiler flags nor a platform without an FPU can change a bit.
#ifndef SINEW_GRID_GRID_QUANTIZER_HPP
#define SINEW_GRID_GRID_QUANTIZER_HPP

#include <stddef.h>
#include <stdint.h>

#include "core/fixed.hpp"
#include "sinew/sinew.h"

namespace sinew {

// The grid. Vertices and joints have integer coordinates; the longest side of the mesh's box is 2^20 units long. The up
// axis is rotated to y. y is 0 at the lowest vertex, x and z are 0 in the middle of the box. Joints may lie outside the
// box: their coordinates are clamped to +-2^22.
constexpr int kGridBits = 20;
constexpr int32_t kSide = 1 << kGridBits;  // longest side of the mesh, in units

// 320-bit two's complement integer. Every finite float is an integer below 2^277 in units of 2^-149; sums, twenty more
// bits for the grid and three for the clamp need 303.
struct WideInt {
  uint64_t limb[5];
};

// Maps floats to the grid: round_half_up((2 value - sum) * 2^20 / (2 side)) per axis, where sum is low + high of the
// mesh's box for x and z (centered) and twice the low for y (floor at 0); clamped to +-2^22. Exact for every finite
// input.
struct GridQuantizer {
  uint32_t up_axis;
  WideInt side;  // longest side of the box in units of 2^-149; 1.0 for a box without extent
  WideInt sum[3];
  // The fast path for almost all values: the same numbers in 64 bits, floored to units of 2^(unit - 149).
  int unit;
  int64_t short_side;
  int64_t short_sum[3];
  bool short_ok[3];     // the axis fits the fast path
  bool short_exact[3];  // and nothing was cut off, side included
};

// Takes the box of all vertices. positions [count x 3]. Returns SINEW_OK or SINEW_ERROR_NOT_FINITE.
sinew_status make_grid_quantizer(const float* positions, size_t count, uint32_t up_axis, GridQuantizer* quantizer);
// Grid position of one point [3]; the point must be finite. up_axis 1 rotates (x, y, z) to (x, z, -y).
Vec3i quantize_point(const GridQuantizer& quantizer, const float* position);
// Whether all three coordinates are finite.
bool is_finite_point(const float* position);

}  // namespace sinew
#endif
