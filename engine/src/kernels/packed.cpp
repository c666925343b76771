// SPDX-License-Identifier: MIT
// Packs a linear layer's parameters for the vector kernels.
#include "kernels/packed.hpp"

#include "kernels/kernels.hpp"

namespace sinew {
namespace {

uint32_t pair_count(uint32_t in, uint32_t block) { return in / block * ((block + 1) / 2) + (in % block + 1) / 2; }

}  // namespace

uint64_t packed_linear_bytes(uint32_t in, uint32_t out, uint32_t block) {
  const uint64_t outputs = padded_outputs(out);
  return outputs * (sizeof(int64_t) + 2 * sizeof(int32_t)) + outputs * pair_count(in, block) * 2 * sizeof(int16_t);
}

PackedLinear packed_view(const LinearView& linear, const void* memory) {
  const uint32_t outputs = padded_outputs(linear.out);
  PackedLinear view;
  view.wide_bias = static_cast<const int64_t*>(memory);
  view.bias = static_cast<const int32_t*>(memory);  // one of the two is there
  view.residual = static_cast<const int32_t*>(static_cast<const void*>(view.wide_bias + outputs));
  view.shifts = view.residual + outputs;
  view.weights = static_cast<const int16_t*>(static_cast<const void*>(view.shifts + outputs));
  view.pairs = pair_count(linear.in, linear.block);
  return view;
}

void pack_linear(const LinearView& linear, void* memory) {
  const uint32_t outputs = padded_outputs(linear.out);
  int64_t* const wide_bias = static_cast<int64_t*>(memory);
  int32_t* const bias = static_cast<int32_t*>(memory);
  int32_t* const residual = static_cast<int32_t*>(static_cast<void*>(wide_bias + outputs));
  int32_t* const shifts = residual + outputs;
  int16_t* to = static_cast<int16_t*>(static_cast<void*>(shifts + outputs));
  for (uint32_t n = 0; n < outputs; ++n) {
    const bool real = n < linear.out;
    const int64_t value = real ? load_i64(linear.bias + 8u * n) : 0;
    if (linear.wide) {
      wide_bias[n] = value;
    } else {
      bias[n] = static_cast<int32_t>(value);  // proven: the whole sum fits, and every product's range includes 0
    }
    residual[n] = real && linear.residual != nullptr ? file_int16(linear.residual, n) : 0;
    shifts[n] = real ? linear.shifts[n] : 0;
  }
  for (uint32_t group = 0; group < outputs; group += kPackOutputs) {
    for (uint32_t first = 0; first < linear.in; first += linear.block) {
      const uint32_t rest = linear.in - first;
      const uint32_t count = rest < linear.block ? rest : linear.block;
      for (uint32_t k = 0; k < count; k += 2) {
        for (uint32_t n = group; n < group + kPackOutputs; ++n, to += 2) {
          const size_t at = static_cast<size_t>(n) * linear.in + first + k;
          to[0] = n < linear.out ? file_int16(linear.weights, at) : static_cast<int16_t>(0);
          to[1] = n < linear.out && k + 1 < count ? file_int16(linear.weights, at + 1) : static_cast<int16_t>(0);
        }
      }
    }
  }
}

}  // namespace sinew
