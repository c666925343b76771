// SPDX-License-Identifier: MIT
// The definition of the factorisation's inner loops (solve/fronts.cpp) in plain C++.
#include "kernels/front.hpp"
#include "kernels/front_s32_rows.hpp"

namespace sinew {

void front_update_ref(const int32_t* g, size_t stride, uint32_t pivots, uint32_t columns, uint32_t rows,
                      int32_t* target, size_t target_stride) {
  constexpr uint32_t kBlock = 8;
  for (uint32_t first = 0; first < rows; first += kBlock) {
    const uint32_t count = rows - first < kBlock ? rows - first : kBlock;
    for (uint32_t c = 0; c < columns; ++c) {
      uint64_t sums[kBlock] = {};
      for (uint32_t k = 0; k < pivots; ++k) {
        const int32_t* column = g + k * stride;
        const int64_t factor = column[c];
        for (uint32_t i = 0; i < count; ++i) sums[i] += static_cast<uint64_t>(column[first + i] * factor);
      }
      int32_t* out = target + c * target_stride + first;
      for (uint32_t i = 0; i < count; ++i) {
        const int64_t rounded = static_cast<int64_t>(sums[i] + (1u << (kFrontBits - 1))) >> kFrontBits;
        out[i] = static_cast<int32_t>(static_cast<uint32_t>(out[i]) - static_cast<uint32_t>(rounded));
      }
    }
  }
}

void front_multiply_ref(const int32_t* g, size_t next, size_t step, uint32_t terms, const int32_t* scaled,
                        int64_t* sums) {
  for (uint32_t c = 0; c < kFrontColumns; ++c) {
    uint64_t sum[kFrontBatch] = {};
    for (uint32_t t = 0; t < terms; ++t) {
      const int64_t factor = g[c * next + t * step];
      for (uint32_t member = 0; member < kFrontBatch; ++member)
        sum[member] += static_cast<uint64_t>(factor * scaled[t * kFrontBatch + member]);
    }
    for (uint32_t member = 0; member < kFrontBatch; ++member)
      sums[c * kFrontBatch + member] = static_cast<int64_t>(sum[member]);
  }
}

void front_solve_ref(const FrontRows& rows, const int32_t* g, size_t height, uint32_t position, uint32_t count,
                     bool forward, int64_t* sums, int32_t* scaled) {
  front_solve_rows(rows, g, height, position, count, forward, sums, scaled);
}

void front_subtract_ref(const FrontRows& rows, const uint32_t* positions, uint32_t count, const int64_t* sums) {
  front_subtract_rows(rows, positions, count, sums);
}

void front_load_ref(const FrontRows& rows, const uint32_t* positions, uint32_t count, int32_t* scaled) {
  front_load_rows(rows, positions, count, scaled);
}

uint32_t front_above_ref(const int32_t* x, int32_t below, int64_t* sum, int32_t* range) {
  return front_above_in_row(x, below, sum, range);
}

}  // namespace sinew
