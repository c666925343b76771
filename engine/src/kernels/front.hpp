// SPDX-License-Identifier: MIT
// The inner loops of the sparse factorisation by fronts and of its solves, on dense columns of int32: what they read is
// described in solve/fronts.hpp. Sums are int64 and wrap, so that any order of addition gives the same bits.
#ifndef SINEW_KERNELS_FRONT_HPP
#define SINEW_KERNELS_FRONT_HPP

#include <stddef.h>
#include <stdint.h>

namespace sinew {

constexpr uint32_t kFrontColumns = 4;  // columns that a kernel works on together
constexpr uint32_t kFrontBatch = 16;   // right-hand sides solved together
constexpr int kFrontBits = 30;
constexpr int kFrontSolutionBits = 28;
constexpr int32_t kFrontOne = 1 << kFrontSolutionBits;
constexpr int32_t kFrontLargest = 1 << 30;  // of solutions; reached only where the matrix is not what it should be

// target[c][i] -= round(sum over k < pivots of g[k][i] * g[k][c] / 2^30) for c < columns <= kFrontColumns, i < rows.
//   g       [pivots] columns, `stride` apart
//   target  [columns] columns, `target_stride` apart; not among those of g
void front_update_ref(const int32_t* g, size_t stride, uint32_t pivots, uint32_t columns, uint32_t rows,
                      int32_t* target, size_t target_stride);

// sums[c][member] = sum over t < terms of g[c * next + t * step] * scaled[t][member] for c < kFrontColumns.
//   scaled  [terms x kFrontBatch],  sums [kFrontColumns x kFrontBatch]
void front_multiply_ref(const int32_t* g, size_t next, size_t step, uint32_t terms, const int32_t* scaled,
                        int64_t* sums);

// Inputs and outputs of the solves of one front, all by position. A row of the front holds x scaled, by
// 2^(exponents[position] - exponent).
struct FrontRows {
  int exponent;             // the largest of the front's positions; at most 24 above the others
  const int8_t* exponents;  // [positions]
  const int64_t* inverse;   // [positions] 1 / the pivot, Q30
  int32_t* x;               // [positions x kFrontBatch]
};

// The triangle of `count` <= kFrontColumns pivots that stand at `position` and on: x = (x - sums - the others' share) /
// pivot, and the same, scaled, as a row of the front. forward: from the first to the last with the factor, limited to
// +-(2^31 - 1); else back with its transpose, limited to +-kFrontLargest.
//   g      the pivots' columns from the first one's diagonal on, `height` apart
//   sums   [count x kFrontBatch] what the front's other rows bring, Q30 of rows; destroyed
//   scaled  out [count x kFrontBatch]
void front_solve_ref(const FrontRows& rows, const int32_t* g, size_t height, uint32_t position, uint32_t count,
                     bool forward, int64_t* sums, int32_t* scaled);

// x -= sums for the positions [count].
//   sums  [count x kFrontBatch] Q30 of rows
void front_subtract_ref(const FrontRows& rows, const uint32_t* positions, uint32_t count, const int64_t* sums);

// Rows of the front for the positions [count].
//   scaled  out [count x kFrontBatch]
void front_load_ref(const FrontRows& rows, const uint32_t* positions, uint32_t count, int32_t* scaled);

// Which of x [kFrontBatch], each within +-kFrontLargest, are above `below`, as bits. Adds all of them to *sum, and
// makes *range negative where one is outside [-1, 2] (Q28).
uint32_t front_above_ref(const int32_t* x, int32_t below, int64_t* sum, int32_t* range);

struct FrontKernels {
  decltype(&front_update_ref) update = front_update_ref;
  decltype(&front_multiply_ref) multiply = front_multiply_ref;
  decltype(&front_solve_ref) solve = front_solve_ref;
  decltype(&front_subtract_ref) subtract = front_subtract_ref;
  decltype(&front_load_ref) load = front_load_ref;
  decltype(&front_above_ref) above = front_above_ref;
};

// False when the file was compiled without its instruction set.
bool add_front_s32_avx2(FrontKernels* kernels);
bool add_front_s32_simd128(FrontKernels* kernels);
bool add_front_s32_neon(FrontKernels* kernels);
bool add_front_s32_avx512(FrontKernels* kernels);

}  // namespace sinew
#endif
