// SPDX-License-Identifier: MIT
// A linear layer's parameters as the vector kernels read them: made from the model's bytes, in memory that the caller
// gave for the model or, per network run, in the workspace. The same bytes for every instruction set, so that the
// workspace is the same on every host.
#ifndef SINEW_KERNELS_PACKED_HPP
#define SINEW_KERNELS_PACKED_HPP

#include <stddef.h>
#include <stdint.h>

namespace sinew {

struct LinearView;

// Outputs come in groups of 16: one AVX-512 register of int32 sums, two of AVX2, four of 128 bits. Group g, pair p:
//   weights[((g * pairs + p) * 16 + n) * 2 + {0, 1}] = w[16 g + n][first column of the pair + {0, 1}]
// so that one multiply-add of int16 pairs (vpdpwssd, vpmaddwd, i32x4.dot_i16x8_s) against a broadcast pair of inputs
// moves all 16 sums on. Every block of columns (class W) starts a new pair; an odd block's last pair, and outputs
// behind the last, are filled with 0.
constexpr uint32_t kPackOutputs = 16;

// Columns [first, first + count) of a layer's input; first is even.
struct ColumnRange {
  uint16_t first = 0, count = 0;
};
constexpr uint32_t kMaxRanges = 4;

struct PackedLinear {
  const int16_t* weights = nullptr;    // 64-byte aligned; null = not packed, the kernels read the model's bytes
  const int32_t* bias = nullptr;       // [outputs] class N; for LinearSumsKernel null = 0
  const int64_t* wide_bias = nullptr;  // [outputs] class W
  const int32_t* residual = nullptr;   // [outputs] factors, 0 without a residual
  const int32_t* shifts = nullptr;     // [outputs]
  uint32_t pairs = 0;                  // of all blocks
  // Class N may be computed in two steps. Columns that several rows share are multiplied once (LinearSumsKernel); the
  // rows then start from those sums and add the columns of `ranges` alone. The sums are the same: int32 wraps, so
  // order is free. Without `starts` rows start from the bias, without both kinds of sums they add all columns.
  const int32_t* starts = nullptr;        // [rows / rows_per_start][padded outputs] bias included
  const int32_t* joint_starts = nullptr;  // [joints][padded outputs] added to the rows of each joint in `present`
  uint32_t rows_per_start = 1;
  ColumnRange ranges[kMaxRanges];
  uint32_t range_count = 0;
};
constexpr uint32_t padded_outputs(uint32_t out) { return (out + kPackOutputs - 1) / kPackOutputs * kPackOutputs; }

// Bytes of one packed layer, a multiple of 64. A function of the shape alone.
uint64_t packed_linear_bytes(uint32_t in, uint32_t out, uint32_t block);

// Fills `memory` (packed_linear_bytes(), 64-byte aligned) from the model's bytes.
void pack_linear(const LinearView& linear, void* memory);
// The parts of what pack_linear() filled. Shifts lie before weights, so that 16 values behind the last shift or factor
// may be read (and mean nothing).
PackedLinear packed_view(const LinearView& linear, const void* memory);

}  // namespace sinew
#endif
