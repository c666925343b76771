// SPDX-License-Identifier: MIT
// The linear layer with the DSP instructions of Cortex-M4, M7, M33 and M55, and of 32-bit Cortex-A: smlad on pairs of
// int16, read from the model's own bytes. Such devices have no memory to pack weights in.
#include "kernels/variants.hpp"

#if defined(__ARM_FEATURE_SIMD32) && !defined(__aarch64__) && !defined(__ARM_BIG_ENDIAN)
#include <arm_acle.h>
#include <string.h>

#include "kernels/isolated.hpp"
#include "kernels/kernels.hpp"

namespace sinew {
namespace {

SINEW_INLINE int16x2_t pair_at(const int16_t* x) {
  int16x2_t pair;
  memcpy(&pair, x, sizeof(pair));
  return pair;
}

// Inputs and weights of a tile: two rows of each, `count` columns.
struct LinearTile {
  const int16_t *x0, *x1, *w0, *w1;
  uint32_t count;
};

#if defined(__thumb2__) && defined(__GNUC__) && defined(__OPTIMIZE__)
// Whole groups of eight columns: 32 products in 27 instructions, where GCC 12 needs 45. ldrd wants addresses divisible
// by 4. Every register is taken, so the end lies in memory. Steps the pointers and returns the columns done.
SINEW_INLINE uint32_t add_eights(LinearTile& t, int32_t (&s)[2][2]) {
  const uint32_t columns = t.count & ~7u;
  const uintptr_t all = reinterpret_cast<uintptr_t>(t.x0) | reinterpret_cast<uintptr_t>(t.x1) |
                        reinterpret_cast<uintptr_t>(t.w0) | reinterpret_cast<uintptr_t>(t.w1);
  if ((all & 3u) != 0 || columns == 0) return 0;
  const int16_t* const end = t.x0 + columns;
  uint32_t a, b, c, d, e, f;
#define SINEW_FOUR_COLUMNS               \
  "ldrd %[a], %[b], [%[x0]], #8\n\t"     \
  "ldrd %[c], %[d], [%[x1]], #8\n\t"     \
  "ldrd %[e], %[f], [%[w0]], #8\n\t"     \
  "smlad %[s00], %[a], %[e], %[s00]\n\t" \
  "smlad %[s10], %[c], %[e], %[s10]\n\t" \
  "smlad %[s00], %[b], %[f], %[s00]\n\t" \
  "smlad %[s10], %[d], %[f], %[s10]\n\t" \
  "ldrd %[e], %[f], [%[w1]], #8\n\t"     \
  "smlad %[s01], %[a], %[e], %[s01]\n\t" \
  "smlad %[s11], %[c], %[e], %[s11]\n\t" \
  "smlad %[s01], %[b], %[f], %[s01]\n\t" \
  "smlad %[s11], %[d], %[f], %[s11]\n\t"
  __asm__("0:\n\t" SINEW_FOUR_COLUMNS SINEW_FOUR_COLUMNS
          "ldr %[a], %[end]\n\t"
          "cmp %[x0], %[a]\n\t"
          "bne 0b"
          : [x0] "+r"(t.x0), [x1] "+r"(t.x1), [w0] "+r"(t.w0), [w1] "+r"(t.w1), [s00] "+r"(s[0][0]),
            [s01] "+r"(s[0][1]), [s10] "+r"(s[1][0]), [s11] "+r"(s[1][1]), [a] "=&r"(a), [b] "=&r"(b), [c] "=&r"(c),
            [d] "=&r"(d), [e] "=&r"(e), [f] "=&r"(f)
          : [end] "m"(end)
          : "cc", "memory");
#undef SINEW_FOUR_COLUMNS
  return columns;
}
#else
SINEW_INLINE uint32_t add_eights(LinearTile&, int32_t (&)[2][2]) { return 0; }
#endif

// Adds all products to s[row][output]. int32 wraps, so any order is exact where the reader proved the whole.
SINEW_INLINE void add_products(LinearTile t, int32_t (&s)[2][2]) {
  for (uint32_t k = add_eights(t, s); k < t.count; k += 2) {
    int16x2_t x0, x1, w0, w1;
    if (k + 1 < t.count) {
      x0 = pair_at(t.x0), x1 = pair_at(t.x1), w0 = pair_at(t.w0), w1 = pair_at(t.w1);
    } else {  // the last of an odd count: behind it there may be no memory
      x0 = static_cast<uint16_t>(*t.x0), x1 = static_cast<uint16_t>(*t.x1);
      w0 = static_cast<uint16_t>(*t.w0), w1 = static_cast<uint16_t>(*t.w1);
    }
    s[0][0] = __smlad(x0, w0, s[0][0]);
    s[0][1] = __smlad(x0, w1, s[0][1]);
    s[1][0] = __smlad(x1, w0, s[1][0]);
    s[1][1] = __smlad(x1, w1, s[1][1]);
    t.x0 += 2, t.x1 += 2, t.w0 += 2, t.w1 += 2;
  }
}

// Class W: smlald adds into 64 bits, where the sum of the proven blocks fits.
SINEW_INLINE int64_t wide_sum(const int16_t* x, const int16_t* w, uint32_t count, int64_t sum) {
  uint32_t k = 0;
  for (; k + 2 <= count; k += 2) sum = __smlald(pair_at(x + k), pair_at(w + k), sum);
  return k < count ? sum + x[k] * w[k] : sum;
}

SINEW_INLINE int16_t clamp(int32_t value, int32_t low, int32_t high) {
  return static_cast<int16_t>(value < low ? low : value > high ? high : value);
}

struct LinearRows {
  const int16_t* x[2];
  const int16_t* residual[2];
  int16_t* out[2];
};

// Outputs n and n + 1 of two rows; a single row or output stands twice and is written twice.
SINEW_INLINE void narrow_tile(const LinearView& linear, const LinearRows& rows, uint32_t n0, uint32_t n1) {
  int32_t sums[2][2];
  sums[0][0] = sums[1][0] = static_cast<int32_t>(load_u32(linear.bias + 8u * n0));
  sums[0][1] = sums[1][1] = static_cast<int32_t>(load_u32(linear.bias + 8u * n1));
  add_products({rows.x[0], rows.x[1], linear.weights + static_cast<size_t>(n0) * linear.in,
                linear.weights + static_cast<size_t>(n1) * linear.in, linear.in},
               sums);
  for (int i = 0; i < 2; ++i) {
    const uint32_t n = i == 0 ? n0 : n1;
    if (linear.residual != nullptr) {
      sums[0][i] += rows.residual[0][n] * linear.residual[n];
      sums[1][i] += rows.residual[1][n] * linear.residual[n];
    }
    const uint32_t shift = linear.shifts[n];
    rows.out[0][n] = clamp(sums[0][i] >> shift, linear.low, linear.high);
    rows.out[1][n] = clamp(sums[1][i] >> shift, linear.low, linear.high);
  }
}

SINEW_INLINE void wide_row(const LinearView& linear, const int16_t* x, const int16_t* residual, int16_t* out) {
  for (uint32_t n = 0; n < linear.out; ++n) {
    int64_t sum = load_i64(linear.bias + 8u * n);
    if (linear.residual != nullptr) sum += residual[n] * linear.residual[n];
    sum = wide_sum(x, linear.weights + static_cast<size_t>(n) * linear.in, linear.in, sum) >> linear.shifts[n];
    out[n] = static_cast<int16_t>(sum < linear.low ? linear.low : sum > linear.high ? linear.high : sum);
  }
}

void linear_s16_dsp(const LinearView& linear, RowsView in, RowsView residual, const uint16_t* present, uint32_t rows,
                    int16_t* out, uint32_t out_stride) {
  for (uint32_t r = 0; r < rows;) {
    // The next present row and the one behind it that is to be computed, if any.
    uint32_t taken[2];
    uint32_t count = 0;
    for (; r < rows && count < 2; ++r) {
      if (present == nullptr || present[r] != kNoJoint) {
        taken[count++] = r;
      } else {
        memset(out + static_cast<size_t>(r) * out_stride, 0, linear.out * sizeof(int16_t));
      }
    }
    if (count == 0) return;
    if (count == 1) taken[1] = taken[0];
    LinearRows both;
    for (int i = 0; i < 2; ++i) {
      both.x[i] = in.data + static_cast<size_t>(taken[i]) * in.stride;
      both.residual[i] = residual.data + static_cast<size_t>(taken[i]) * residual.stride;
      both.out[i] = out + static_cast<size_t>(taken[i]) * out_stride;
    }
    if (linear.wide) {
      for (uint32_t i = 0; i < count; ++i) wide_row(linear, both.x[i], both.residual[i], both.out[i]);
      continue;
    }
    for (uint32_t n = 0; n < linear.out; n += 2) narrow_tile(linear, both, n, n + 1 < linear.out ? n + 1 : n);
  }
}

}  // namespace

bool add_linear_s16_dsp(Kernels* kernels) {
  kernels->linear = linear_s16_dsp;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_linear_s16_dsp(Kernels*) { return false; }
}  // namespace sinew
#endif
