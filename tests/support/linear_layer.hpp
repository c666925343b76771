// SPDX-License-Identifier: MIT
// A linear layer's parameters in memory of their own, and the view of them that kernels take.
#ifndef SINEW_TESTS_SUPPORT_LINEAR_LAYER_HPP
#define SINEW_TESTS_SUPPORT_LINEAR_LAYER_HPP

#include <cstdint>
#include <vector>

#include "kernels/kernels.hpp"
#include "model/layout.hpp"

namespace sinew::test {

// Rounds down; b > 0.
inline int64_t floor_divide(int64_t a, int64_t b) { return a / b - (a % b != 0 && a < 0); }

struct LinearLayer {
  uint32_t in, out;
  uint32_t block;     // class W: columns whose products sum inside int32
  bool wide = false;  // class W
  bool has_residual = false;
  int32_t low = -32767, high = 32767;
  std::vector<int16_t> weights;   // [out x in]
  std::vector<int16_t> residual;  // [out]
  std::vector<uint8_t> shifts;    // [out]

  LinearLayer(uint32_t inputs, uint32_t outputs, uint8_t shift = 9)
      : in(inputs),
        out(outputs),
        block(inputs),
        weights(size_t{inputs} * outputs),
        residual(outputs),
        shifts(outputs, shift),
        bias_(8 * size_t{outputs}) {}

  int64_t bias(uint32_t n) const { return load_i64(bias_.data() + 8 * size_t{n}); }
  void set_bias(uint32_t n, int64_t value) { store_u64(bias_.data() + 8 * size_t{n}, static_cast<uint64_t>(value)); }
  void set_range(ValueRange range) {
    low = range_low(range);
    high = range_high(range);
  }

  // Nothing is packed. The layer must outlive the view.
  LinearView view() const {
    LinearView view;
    view.weights = weights.data();
    view.bias = bias_.data();
    view.residual = has_residual ? residual.data() : nullptr;
    view.shifts = shifts.data();
    view.in = in;
    view.out = out;
    view.block = block;
    view.wide = wide;
    view.low = low;
    view.high = high;
    return view;
  }

 private:
  std::vector<uint8_t> bias_;  // [out] int64 as in a model's bytes
};

}  // namespace sinew::test
#endif
