// SPDX-License-Identifier: MIT
// The operations of a network on int16 rows, as the executor calls them. Each has one exact integer definition; faster
// variants must give the same bytes.
#ifndef SINEW_KERNELS_KERNELS_HPP
#define SINEW_KERNELS_KERNELS_HPP

#include "core/bytes.hpp"
#include "core/counts.hpp"
#include "kernels/packed.hpp"

namespace sinew {

// Read-only rows: row i starts at data + i * stride.
struct RowsView {
  const int16_t* data = nullptr;
  uint32_t stride = 0;
};

// One linear layer's parameters, in place in the model file. Arrays are read through file_int16() and load_i64().
struct LinearView {
  const int16_t* weights = nullptr;   // [out x in]
  const uint8_t* bias = nullptr;      // [out] int64 little-endian, holding the rounding constant
  const int16_t* residual = nullptr;  // [out] or null
  const uint8_t* shifts = nullptr;    // [out] 1..31 (class N), 1..47 (class W)
  uint32_t in = 0, out = 0;
  uint32_t block = 0;         // columns whose products sum inside int32
  bool wide = false;          // class W
  int32_t low = 0, high = 0;  // clamp
  PackedLinear packed;        // the same parameters for the vector kernels; see pack_linear()
};

// acc = bias[n] + sum_k in[r][k] * weights[n][k] (+ residual[r][n] * factor[n]);  out[r][n] = clamp(acc >> shift[n],
// low, high).
//   present  [rows] joint of each row, kNoJoint rows become 0; null = every row is present
// The reader proved that no sum leaves its type, in any order of summation. `out` must not overlap the inputs.
void linear_s16_ref(const LinearView& linear, RowsView in, RowsView residual, const uint16_t* present, uint32_t rows,
                    int16_t* out, uint32_t out_stride);

// Means round half up: floor((2 * sum + n) / (2 * n)), n >= 1, n < 2^31, |sum| <= 32768 * n.
inline int16_t round_mean(int64_t sum, uint32_t n) {
  // Adding 32768 to every value makes the dividend non-negative, so that / is floor; below 2^15 values it fits 32 bits.
  const uint64_t dividend = 2 * static_cast<uint64_t>(sum + static_cast<int64_t>(n) * 32768) + static_cast<uint64_t>(n);
  if (n < (1u << 15)) {
    return static_cast<int16_t>(static_cast<int32_t>(static_cast<uint32_t>(dividend) / (2 * n)) - 32768);
  }
  return static_cast<int16_t>(static_cast<int64_t>(dividend / (2 * static_cast<uint64_t>(n))) - 32768);
}

// One-ring of one vertex: mean (or largest value) over its neighbors' rows; 0 without neighbors. out [channels].
void ring_mean_vertex_s16_ref(RowsView values, uint32_t channels, const uint32_t* neighbors, uint32_t count,
                              int16_t* out);
void ring_max_vertex_s16_ref(RowsView values, uint32_t channels, const uint32_t* neighbors, uint32_t count,
                             int16_t* out);

// One-ring of one pair: over the neighbors that have `joint` among their k candidates, the row of that slot; 0 when
// none has.
//   values  [U * k] rows,  joints [U x k]
void ring_mean_pair_s16_ref(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k, uint16_t joint,
                            const uint32_t* neighbors, uint32_t count, int16_t* out);
void ring_max_pair_s16_ref(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k, uint16_t joint,
                           const uint32_t* neighbors, uint32_t count, int16_t* out);

// Largest value over the present slots of one vertex, handed to each of the first out_slots; absent ones become 0.
//   values  k rows; with `by_joint` a row per joint,  out  out_slots <= k rows
void candidate_max_s16_ref(RowsView values, bool by_joint, uint32_t channels, const uint16_t* joints, uint32_t k,
                           int16_t* out, uint32_t out_stride, uint32_t out_slots);

// Mean over a part's vertices. sums [channels] scratch, out [channels]. count >= 1.
void part_mean_vertex_s16_ref(RowsView values, uint32_t channels, const uint32_t* vertices, uint32_t count,
                              int64_t* sums, int16_t* out);
// For every joint that is a candidate of one of the part's vertices: sum over those pairs, divided by `count`, the
// part's vertices. Rows of other joints are left as they are, so the cost does not grow with the joint count.
//   sums [joint_count x channels] scratch, out [joint_count x channels]
void part_mean_pair_s16_ref(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k,
                            const uint32_t* vertices, uint32_t count, int64_t* sums, int16_t* out);

// Mean (largest value) over all present rows; 0 without any. present [rows] or null. sums, out [channels].
void global_mean_s16_ref(RowsView values, uint32_t channels, const uint16_t* present, size_t rows, int64_t* sums,
                         int16_t* out);
void global_max_s16_ref(RowsView values, uint32_t channels, const uint16_t* present, size_t rows, int16_t* out);

}  // namespace sinew
#endif
