// SPDX-License-Identifier: MIT
// Fixed-point helpers shared by all stages: the only rounding, saturation, square root and 128-bit product in the
// engine.
#ifndef SINEW_CORE_FIXED_HPP
#define SINEW_CORE_FIXED_HPP

#include <stdint.h>

#include "core/build.hpp"

#if defined(__x86_64__) || defined(_M_X64)
#define SINEW_ROOT_SSE2
#include <emmintrin.h>
#elif defined(__aarch64__)
#define SINEW_ROOT_NEON
#include <arm_neon.h>
#endif

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
// The caller sees to it that the sum and its terms fit.
SINEW_ONCE inline int64_t dot(Vec3l a, Vec3i b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
SINEW_ONCE inline Vec3l cross(Vec3i a, Vec3i b) {
  return {static_cast<int64_t>(a.y) * b.z - static_cast<int64_t>(a.z) * b.y,
          static_cast<int64_t>(a.z) * b.x - static_cast<int64_t>(a.x) * b.z,
          static_cast<int64_t>(a.x) * b.y - static_cast<int64_t>(a.y) * b.x};
}

// Arithmetic shift right with rounding half up; the one rounding rule of the engine. shift 0..62.
SINEW_ONCE inline int64_t round_shift(int64_t value, int shift) {
  return shift == 0 ? value : (value + (static_cast<int64_t>(1) << (shift - 1))) >> shift;
}
SINEW_ONCE inline int32_t clamp32(int64_t v, int32_t lo, int32_t hi) {
  return v < lo ? lo : v > hi ? hi : static_cast<int32_t>(v);
}
inline int16_t clamp16(int64_t v, int32_t lo, int32_t hi) { return static_cast<int16_t>(clamp32(v, lo, hi)); }
SINEW_ONCE inline int64_t abs64(int64_t v) { return v < 0 ? -v : v; }

// Index of the highest set bit; 0 for 0.
SINEW_ONCE inline int top_bit(uint64_t v) {
#if defined(__GNUC__) && \
    (defined(__x86_64__) || defined(__aarch64__) || defined(__wasm__) || defined(__ARM_FEATURE_CLZ))
  return 63 - __builtin_clzll(v | 1);
#else
  int bit = 0;
  for (int step = 32; step > 0; step /= 2) {
    if (v >> step != 0) {
      v >>= step;
      bit += step;
    }
  }
  return bit;
#endif
}
// Index of the lowest set bit; v != 0.
inline int low_bit(uint32_t v) {
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__aarch64__) || defined(__wasm__) || defined(__thumb2__))
  return __builtin_ctz(v);
#else
  return top_bit(v & (0u - v));
#endif
}

// Square roots: isqrt64() is the one to call. On 64-bit processors it takes a root that may be off a little from
// near_root() and steps to the exact one. On others it is isqrt64_bitwise().

// floor(sqrt(v)), one bit a step. Needs no division, and compilers can make constants of it.
constexpr uint32_t isqrt64_bitwise(uint64_t v) {
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

// First guesses: q4[i] = sqrt(i + 64.5) in Q4, rounded down. That is the root of a number whose top byte is i + 64,
// with eight good bits.
struct RootTable {
  uint8_t q4[192];
  constexpr RootTable() : q4() {
    for (uint32_t i = 0; i < 192; ++i) q4[i] = static_cast<uint8_t>(isqrt64_bitwise((2 * i + 129) * 128));
  }
};

// sqrt(v), off by at most 4. v < 2^63.
inline uint64_t root_by_table(uint64_t v) {
  static constexpr RootTable kRoots;
  const int shift = (63 - top_bit(v)) & ~1;
  const uint64_t n = v << shift;  // 2^62 <= n but for v = 0
  // Each Newton step doubles the good bits: 8 of the table, then 16, then 32.
  uint64_t r = kRoots.q4[v == 0 ? 0 : (n >> 56) - 64];
  r = (r << 7) + (n >> 41) / r;
  return ((r << 15) + (n >> 17) / r) >> (shift / 2);
}

// The same, from the processor's root of a double where there is an instruction for it. IEEE 754 defines this root to
// the last bit, which depends on the rounding mode that the caller has set. isqrt64() gives the same root for all
// modes.
inline uint64_t near_root(uint64_t v) {
#if defined(SINEW_ROOT_SSE2)
  const __m128d d = _mm_cvtsi64_sd(_mm_setzero_pd(), static_cast<int64_t>(v));
  return static_cast<uint64_t>(_mm_cvttsd_si64(_mm_sqrt_sd(d, d)));
#elif defined(SINEW_ROOT_NEON)
  return static_cast<uint64_t>(vget_lane_f64(vsqrt_f64(vdup_n_f64(static_cast<double>(v))), 0));
#else
  return root_by_table(v);
#endif
}

// floor(sqrt(v)), exact on every processor.
inline uint32_t isqrt64(uint64_t v) {
#if UINTPTR_MAX > 0xFFFFFFFFu
  if (v >> 63 != 0) return isqrt64_bitwise(v);
  uint64_t r = near_root(v);
  while (r * r > v) --r;
  while ((r + 1) * (r + 1) <= v) ++r;
  return static_cast<uint32_t>(r);
#else
  return isqrt64_bitwise(v);
#endif
}

// (a * b) >> shift with floor, over the full 128-bit product; the result must fit int64. shift 0..63.
inline int64_t mul_shift(int64_t a, int64_t b, int shift) {
#if defined(__SIZEOF_INT128__) && !defined(SINEW_NO_INT128) && !defined(__wasm__)  // there it would be a call
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

// log2(1 + x) - x for x = i / 128 in Q19, digit by digit, made by the compiler.
struct LogTable {
  uint16_t q19[129];
  constexpr LogTable() : q19() {
    for (uint32_t i = 0; i < 128; ++i) {
      uint64_t m = (static_cast<uint64_t>(128) + i) << 24;  // Q31 in [1, 2)
      uint32_t digits = 0;
      for (int bit = 0; bit < 20; ++bit) {
        m = (m * m) >> 31;
        const uint32_t one = static_cast<uint32_t>(m >> 32);
        digits = 2 * digits + one;
        m >>= one;
      }
      q19[i] = static_cast<uint16_t>((digits + 1) / 2 - (i << 12));
    }
  }
};

// log2(v) in Q16 for v >= 1 (v is an integer), exact for powers of two; error below 2^-15: 128 straight pieces an
// octave are off by 1.1e-5 at most, rounding by 2^-17.
inline int32_t log2_q16(uint64_t v) {
  static constexpr LogTable kLogs;
  const int msb = top_bit(v);
  const uint32_t x = static_cast<uint32_t>(msb > 31 ? v >> (msb - 31) : v << (31 - msb)) & 0x7FFFFFFFu;  // Q31
  const uint16_t* const piece = kLogs.q19 + (x >> 24);
  const int32_t along = static_cast<int32_t>(x & 0xFFFFFFu) >> 10;  // Q14
  const int32_t above = piece[0] + (((piece[1] - piece[0]) * along) >> 14);
  return (msb << 16) + ((static_cast<int32_t>(x >> 12) + above + 4) >> 3);
}

// 2^-x for x >= 0 in Q16; Q30, error below 2^-15 of the value.
SINEW_ONCE inline int64_t exp2_negative(int64_t x_q16) {
  // round(2^(-2^-(i + 1)) * 2^31)
  static constexpr uint32_t kRoots[16] = {1518500250u, 1805811301u, 1969251188u, 2056437387u, 2101467502u, 2124350982u,
                                          2135885998u, 2141676973u, 2144578345u, 2146030505u, 2146756953u, 2147120270u,
                                          2147301951u, 2147392798u, 2147438222u, 2147460935u};
  const int64_t whole = x_q16 >> 16;
  if (whole > 40) return 0;
  uint64_t value = static_cast<uint64_t>(1) << 30;
  for (int bit = 0; bit < 16; ++bit) {
    if ((x_q16 >> (15 - bit) & 1) != 0) value = (value * kRoots[bit]) >> 31;
  }
  return static_cast<int64_t>(value >> whole);
}

}  // namespace sinew
#endif
