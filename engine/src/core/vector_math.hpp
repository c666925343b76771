// SPDX-License-Identifier: MIT
// Integer vector helpers of the geometry stages: rounding division, lengths and unit vectors without floating point.
#ifndef SINEW_CORE_VECTOR_MATH_HPP
#define SINEW_CORE_VECTOR_MATH_HPP

#include "core/fixed.hpp"

namespace sinew {

// floor(a / b), b > 0.
SINEW_ONCE inline int64_t floor_div(int64_t a, int64_t b) {
  const int64_t q = a / b;
  return q * b > a ? q - 1 : q;
}
// a / b rounded half up, b > 0. |a| < 2^61, b < 2^61.
SINEW_ONCE inline int64_t round_div(int64_t a, int64_t b) { return floor_div(2 * a + b, 2 * b); }

// Length of an integer vector with components below 2^62, relative error below 2^-28 (exact floor while components are
// below 2^30).
inline uint64_t length(Vec3l v) {
  uint64_t x = static_cast<uint64_t>(abs64(v.x)), y = static_cast<uint64_t>(abs64(v.y)),
           z = static_cast<uint64_t>(abs64(v.z));
  const int top = top_bit(x | y | z), shift = top > 29 ? top - 29 : 0;
  x >>= shift;
  y >>= shift;
  z >>= shift;
  return static_cast<uint64_t>(isqrt64(x * x + y * y + z * z)) << shift;  // the sum is below 3 * 2^60
}
inline uint64_t length(Vec3i v) { return length(Vec3l{v.x, v.y, v.z}); }

// Each component of v over b, rounded half up, b > 0. Components below 2^61, what comes out fits 32 bits.
SINEW_ONCE inline Vec3i round_div(Vec3l v, int64_t b) {
  return {static_cast<int32_t>(round_div(v.x, b)), static_cast<int32_t>(round_div(v.y, b)),
          static_cast<int32_t>(round_div(v.z, b))};
}

// v / 2^shift with floor; a negative shift is a product, which must fit.
SINEW_ONCE inline int64_t shifted(int64_t v, int shift) {
  return shift > 0 ? v >> shift : v * (static_cast<int64_t>(1) << -shift);
}

// A box grows until it holds p.
SINEW_ONCE inline void grow(Vec3i p, Vec3i* lo, Vec3i* hi) {
  lo->x = p.x < lo->x ? p.x : lo->x;
  lo->y = p.y < lo->y ? p.y : lo->y;
  lo->z = p.z < lo->z ? p.z : lo->z;
  hi->x = p.x > hi->x ? p.x : hi->x;
  hi->y = p.y > hi->y ? p.y : hi->y;
  hi->z = p.z > hi->z ? p.z : hi->z;
}

// The largest coordinate without its sign.
SINEW_ONCE inline int32_t extent(Vec3i v) {
  const int32_t x = v.x < 0 ? -v.x : v.x, y = v.y < 0 ? -v.y : v.y, z = v.z < 0 ? -v.z : v.z;
  return x > y ? (x > z ? x : z) : (y > z ? y : z);
}

// v / |v| in Q`bits`, rounded half up; (0,0,0) for the zero vector. Components below 2^62, bits <= 28.
inline Vec3i unit_vector(Vec3l v, int bits) {
  const uint64_t top =
      static_cast<uint64_t>(abs64(v.x)) | static_cast<uint64_t>(abs64(v.y)) | static_cast<uint64_t>(abs64(v.z));
  if (top == 0) return {0, 0, 0};
  // Brings the largest component to 30 bits, so that a one-unit triangle gets as good a normal as a large one.
  const int shift = top_bit(top) - 29;
  const int64_t x = shifted(v.x, shift), y = shifted(v.y, shift), z = shifted(v.z, shift);
  const int64_t norm = isqrt64(static_cast<uint64_t>(x * x + y * y + z * z));
  const int64_t one = static_cast<int64_t>(1) << bits;
  return round_div(Vec3l{x * one, y * one, z * one}, norm);
}

// atan2(y, x) / pi in Q30 of three x, for y >= 0, x of any sign, both below 2^60 in size; 0 for (0, 0). Error below
// 2^-24. Three, because each step waits for the one before and leaves the processor room for others.
void angles_q30(int64_t y, const int64_t (&x)[3], int32_t (&angles)[3]);

}  // namespace sinew
#endif
