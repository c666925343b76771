// SPDX-License-Identifier: MIT
// Reference linear layer on int16 rows: bias, residual, requantization and clamp fused. What every variant must equal.
#include "kernels/kernels.hpp"

namespace sinew {
namespace {

// Sum of count products, each partial sum proven inside int32 when added to `acc`.
inline int32_t dot_s16(const int16_t* in, const int16_t* weights, size_t first, uint32_t count, int32_t acc) {
  for (uint32_t k = 0; k < count; ++k) acc += static_cast<int32_t>(in[k]) * file_int16(weights, first + k);
  return acc;
}

inline int16_t requantize(int64_t acc, uint32_t shift, int32_t low, int32_t high) {
  const int64_t value = acc >> shift;
  return static_cast<int16_t>(value < low ? low : value > high ? high : value);
}

}  // namespace

void linear_s16_ref(const LinearView& linear, RowsView in, RowsView residual, const uint16_t* present, uint32_t rows,
                    int16_t* out, uint32_t out_stride) {
  for (uint32_t r = 0; r < rows; ++r) {
    const int16_t* x = in.data + static_cast<size_t>(r) * in.stride;
    int16_t* y = out + static_cast<size_t>(r) * out_stride;
    if (present != nullptr && present[r] == kNoJoint) {
      for (uint32_t n = 0; n < linear.out; ++n) y[n] = 0;
      continue;
    }
    for (uint32_t n = 0; n < linear.out; ++n) {
      const size_t row = static_cast<size_t>(n) * linear.in;
      int64_t acc = load_i64(linear.bias + 8u * n);
      if (linear.wide) {
        for (uint32_t k = 0; k < linear.in; k += linear.block) {
          const uint32_t count = linear.in - k < linear.block ? linear.in - k : linear.block;
          acc += dot_s16(x + k, linear.weights, row + k, count, 0);
        }
      } else {
        acc = dot_s16(x, linear.weights, row, linear.in, static_cast<int32_t>(acc));
      }
      if (linear.residual != nullptr) {
        const int16_t value = residual.data[static_cast<size_t>(r) * residual.stride + n];
        acc += static_cast<int32_t>(value) * file_int16(linear.residual, n);
      }
      y[n] = requantize(acc, linear.shifts[n], linear.low, linear.high);
    }
  }
}

}  // namespace sinew
