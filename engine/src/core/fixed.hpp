// SPDX-License-Identifier: MIT
// Fixed-point helpers shared by all stages: the only rounding, saturation, square root and 128-bit product in the
// engine.
#ifndef SINEW_CORE_FIXED_HPP
#define SINEW_CORE_FIXED_HPP

#include <stdint.h>

namespace sinew {

struct Vec3i {
  int32_t x, y, z;
};
inline Vec3i operator-(Vec3i a, Vec3i b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3i operator+(Vec3i a, Vec3i b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline bool operator==(Vec3i a, Vec3i b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
struct Vec3l {
  int64_t x, y, z;
};
inline int64_t dot(Vec3i a, Vec3i b) {
  return static_cast<int64_t>(a.x) * b.x + static_cast<int64_t>(a.y) * b.y + static_cast<int64_t>(a.z) * b.z;
}
inline Vec3l cross(Vec3i a, Vec3i b) {
  return {static_cast<int64_t>(a.y) * b.z - static_cast<int64_t>(a.z) * b.y,
          static_cast<int64_t>(a.z) * b.x - static_cast<int64_t>(a.x) * b.z,
          static_cast<int64_t>(a.x) * b.y - static_cast<int64_t>(a.y) * b.x};
}

// Arithmetic shift right with rounding half up; the one rounding rule of the engine. shift 0..62.
inline int64_t round_shift(int64_t value, int shift) {
  return shift == 0 ? value : (value + (static_cast<int64_t>(1) << (shift - 1))) >> shift;
}
inline int32_t clamp32(int64_t v, int32_t lo, int32_t hi) {
  return v < lo ? lo : v > hi ? hi : static_cast<int32_t>(v);
}
inline int16_t clamp16(int64_t v, int32_t lo, int32_t hi) { return static_cast<int16_t>(clamp32(v, lo, hi)); }
inline int64_t abs64(int64_t v) { return v < 0 ? -v : v; }

// Index of the highest set bit; 0 for 0.
inline int top_bit(uint64_t v) {
  int bit = 0;
  for (int step = 32; step > 0; step /= 2) {
    if (v >> step != 0) {
      v >>= step;
      bit += step;
    }
  }
  return bit;
}

// floor(sqrt(v)), exact.
inline uint32_t isqrt64(uint64_t v) {
  uint64_t r = 0;
  uint64_t bit = static_cast<uint64_t>(1) << 62;
  while (bit > v) bit >>= 2;
  while (bit != 0) {
    if (v >= r + bit) {
      v -= r + bit;
      r = (r >> 1) + bit;
    } else {
      r >>= 1;
    }
    bit >>= 2;
  }
  return static_cast<uint32_t>(r);
}

// (a * b) >> shift with floor, over the full 128-bit product; the result must fit int64. shift 0..63.
inline int64_t mul_shift(int64_t a, int64_t b, int shift) {
#if defined(__SIZEOF_INT128__) && !defined(SINEW_NO_INT128)
  __extension__ typedef __int128 int128;
  return static_cast<int64_t>((static_cast<int128>(a) * b) >> shift);
#else
  // 64x64 -> 128 in 32-bit pieces, two's complement.
  const uint64_t ua = static_cast<uint64_t>(a), ub = static_cast<uint64_t>(b);
  const uint64_t al = ua & 0xFFFFFFFFu, ah = ua >> 32, bl = ub & 0xFFFFFFFFu, bh = ub >> 32;
  const uint64_t ll = al * bl, lh = al * bh, hl = ah * bl;
  const uint64_t mid = (ll >> 32) + (lh & 0xFFFFFFFFu) + (hl & 0xFFFFFFFFu);
  const uint64_t lo = (mid << 32) | (ll & 0xFFFFFFFFu);
  uint64_t hi = ah * bh + (lh >> 32) + (hl >> 32) + (mid >> 32);
  if (a < 0) hi -= ub;
  if (b < 0) hi -= ua;
  if (shift == 0) return static_cast<int64_t>(lo);
  return static_cast<int64_t>((hi << (64 - shift)) | (lo >> shift));
#endif
}

// log2(v) in Q16 for v >= 1 (v is an integer); error below 2^-15. Digit by digit, no table.
inline int32_t log2_q16(uint64_t v) {
  const int msb = top_bit(v);
  uint64_t m = msb > 31 ? v >> (msb - 31) : v << (31 - msb);  // Q31 in [1, 2)
  int32_t out = msb << 16;
  for (int bit = 15; bit >= 0; --bit) {
    m = (m * m) >> 31;
    if (m >> 32) {
      out += 1 << bit;
      m >>= 1;
    }
  }
  return out;
}

}  // namespace sinew
#endif
