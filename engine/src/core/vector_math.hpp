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

// v / |v| in Q`bits`, rounded half up; (0,0,0) for the zero vector. Components below 2^62, bits <= 28.
inline Vec3i unit_vector(Vec3l v, int bits) {
  const uint64_t top =
      static_cast<uint64_t>(abs64(v.x)) | static_cast<uint64_t>(abs64(v.y)) | static_cast<uint64_t>(abs64(v.z));
  if (top == 0) return {0, 0, 0};
  // Brings the largest component to 30 bits, so that a one-unit triangle gets as good a normal as a large one.
  const int shift = top_bit(top) - 29;
  const int64_t x = shift > 0 ? v.x >> shift : v.x * (static_cast<int64_t>(1) << -shift);
  const int64_t y = shift > 0 ? v.y >> shift : v.y * (static_cast<int64_t>(1) << -shift);
  const int64_t z = shift > 0 ? v.z >> shift : v.z * (static_cast<int64_t>(1) << -shift);
  const int64_t norm = isqrt64(static_cast<uint64_t>(x * x + y * y + z * z));
  const int64_t one = static_cast<int64_t>(1) << bits;
  return {static_cast<int32_t>(round_div(x * one, norm)), static_cast<int32_t>(round_div(y * one, norm)),
          static_cast<int32_t>(round_div(z * one, norm))};
}

// atan2(y, x) / pi in Q30 of three x, for y >= 0, x of any sign, both below 2^60 in size; 0 for (0, 0). Error below
// 2^-24. Three, because each step waits for the one before and leaves the processor room for others.
void angles_q30(int64_t y, const int64_t (&x)[3], int32_t (&angles)[3]);

}  // namespace sinew
#endif
