// SPDX-License-Identifier: MIT
// Operations of the factorization's solves on rows of kFrontBatch numbers, in plain loops that a compiler turns into
// whatever registers the including file is compiled for. Included by the reference and by every instruction set's file.
#ifndef SINEW_KERNELS_FRONT_S32_ROWS_HPP
#define SINEW_KERNELS_FRONT_S32_ROWS_HPP

#include "kernels/front.hpp"
#include "kernels/isolated.hpp"

namespace sinew {
namespace {

SINEW_INLINE int64_t front_rounded(int64_t value, int shift) {
  const uint64_t half = (static_cast<uint64_t>(1) << shift) >> 1;
  return static_cast<int64_t>(static_cast<uint64_t>(value) + half) >> shift;
}

SINEW_INLINE int32_t front_clamped(int64_t value, int32_t limit) {
  const int64_t low = value < -limit ? -limit : value;
  return static_cast<int32_t>(low > limit ? limit : low);
}

// x = (x - sum) / pivot of one position, and the same scaled.
SINEW_INLINE void front_solve_row(const int64_t* sums, int shift, int64_t inverse, int lift, int32_t limit, int32_t* x,
                                  int32_t* scaled) {
  const uint64_t half = static_cast<uint64_t>(1) << (kFrontBits - 1);
  for (uint32_t member = 0; member < kFrontBatch; ++member) {
    const uint64_t left = static_cast<uint64_t>(x[member]) - static_cast<uint64_t>(front_rounded(sums[member], shift));
    const int64_t value = static_cast<int64_t>(left * static_cast<uint64_t>(inverse) + half) >> kFrontBits;
    x[member] = front_clamped(value, limit);
    scaled[member] = static_cast<int32_t>(front_rounded(x[member], lift));
  }
}

void front_solve_rows(const FrontRows& rows, const int32_t* g, size_t height, uint32_t position, uint32_t count,
                      bool forward, int64_t* sums, int32_t* scaled) {
  for (uint32_t step = 0; step < count; ++step) {
    const uint32_t c = forward ? step : count - 1 - step;
    int64_t* const sum = sums + c * kFrontBatch;
    for (uint32_t before = 0; before < step; ++before) {
      const uint32_t q = forward ? before : count - 1 - before;
      const int64_t factor = forward ? g[q * height + c] : g[c * height + q];
      const int32_t* const known = scaled + q * kFrontBatch;
      for (uint32_t member = 0; member < kFrontBatch; ++member)
        sum[member] =
            static_cast<int64_t>(static_cast<uint64_t>(sum[member]) + static_cast<uint64_t>(factor * known[member]));
    }
    const int lift = rows.exponent - rows.exponents[position + c];
    front_solve_row(sum, kFrontBits - lift, rows.inverse[position + c], lift, forward ? 0x7FFFFFFF : kFrontLargest,
                    rows.x + static_cast<size_t>(position + c) * kFrontBatch, scaled + c * kFrontBatch);
  }
}

void front_subtract_rows(const FrontRows& rows, const uint32_t* positions, uint32_t count, const int64_t* sums) {
  for (uint32_t c = 0; c < count; ++c, sums += kFrontBatch) {
    const int shift = kFrontBits - (rows.exponent - rows.exponents[positions[c]]);
    int32_t* const x = rows.x + static_cast<size_t>(positions[c]) * kFrontBatch;
    for (uint32_t member = 0; member < kFrontBatch; ++member) {
      const uint64_t left =
          static_cast<uint64_t>(x[member]) - static_cast<uint64_t>(front_rounded(sums[member], shift));
      x[member] = front_clamped(static_cast<int64_t>(left), 0x7FFFFFFF);
    }
  }
}

void front_load_rows(const FrontRows& rows, const uint32_t* positions, uint32_t count, int32_t* scaled) {
  for (uint32_t r = 0; r < count; ++r, scaled += kFrontBatch) {
    const int lift = rows.exponent - rows.exponents[positions[r]];
    const int32_t* const x = rows.x + static_cast<size_t>(positions[r]) * kFrontBatch;
    for (uint32_t member = 0; member < kFrontBatch; ++member)
      scaled[member] = static_cast<int32_t>(front_rounded(x[member], lift));
  }
}

uint32_t front_above_in_row(const int32_t* x, int32_t below, int64_t* sum, int32_t* range) {
  int64_t total = 0;
  uint32_t above = 0;
  int32_t outside = 0;
  for (uint32_t member = 0; member < kFrontBatch; ++member) {
    total += x[member];
    above |= x[member] > below ? 1u << member : 0u;
    outside |= (x[member] + kFrontOne) | (2 * kFrontOne - x[member]);
  }
  *sum += total;
  *range |= outside;
  return above;
}

}  // namespace
}  // namespace sinew
#endif
