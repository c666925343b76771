// SPDX-License-Identifier: MIT
// One function per operation: the kernels that a run uses.
#ifndef SINEW_KERNELS_TABLE_HPP
#define SINEW_KERNELS_TABLE_HPP

#include "kernels/boxes.hpp"
#include "kernels/front.hpp"
#include "kernels/kernels.hpp"
#include "kernels/softmax.hpp"

namespace sinew {

using LinearKernel = void (*)(const LinearView& linear, RowsView in, RowsView residual, const uint16_t* present,
                              uint32_t rows, int16_t* out, uint32_t out_stride);

// sums[r][n] = bias[n] + products of linear.packed.ranges' columns, n below padded_outputs(); class N only.
using LinearSumsKernel = void (*)(const LinearView& linear, RowsView in, uint32_t rows, int32_t* sums);

// Entries without a variant for an instruction set are the reference. Lives on the caller's stack: there is no table
// that several threads would have to agree on.
struct Kernels {
  uint32_t id = SINEW_KERNEL_REF;          // sinew_kernel
  LinearKernel linear = nullptr;           // reads the model's bytes
  LinearKernel linear_packed = nullptr;    // reads linear.packed; null = there is none, pack nothing
  LinearSumsKernel linear_sums = nullptr;  // null with linear_packed
  decltype(&ring_mean_vertex_s16_ref) ring_mean_vertex = nullptr;
  decltype(&ring_max_vertex_s16_ref) ring_max_vertex = nullptr;
  decltype(&ring_mean_pair_s16_ref) ring_mean_pair = nullptr;
  decltype(&ring_max_pair_s16_ref) ring_max_pair = nullptr;
  decltype(&candidate_max_s16_ref) candidate_max = nullptr;
  decltype(&part_mean_vertex_s16_ref) part_mean_vertex = nullptr;
  decltype(&part_mean_pair_s16_ref) part_mean_pair = nullptr;
  decltype(&global_mean_s16_ref) global_mean = nullptr;
  decltype(&global_max_s16_ref) global_max = nullptr;
  SoftmaxKernel softmax = softmax_s16_ref;
  FrontKernels front;                   // of the heat stage
  BoxKernel boxes_met = boxes_met_ref;  // of its visibility
};

}  // namespace sinew
#endif
