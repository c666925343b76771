// SPDX-License-Identifier: MIT
// The two inner loops of the heat stage's sparse factorisation, on dense columns of int32: what they read is described
// in heat/fronts.hpp. Sums are int64 and wrap, so that any order of addition gives the same bits.
#ifndef SINEW_KERNELS_FRONT_HPP
#define SINEW_KERNELS_FRONT_HPP

#include <stddef.h>
#include <stdint.h>

namespace sinew {

constexpr uint32_t kFrontColumns = 4;  // columns that a kernel works on together
constexpr uint32_t kFrontLanes = 16;   // right-hand sides solved together
constexpr int kFrontBits = 30;

// target[c][i] -= round(sum over k < pivots of g[k][i] * g[k][c] / 2^30) for c < columns <= kFrontColumns, i < rows.
//   g       [pivots] columns, `stride` apart
//   target  [columns] columns, `target_stride` apart; not among those of g
void front_update_ref(const int32_t* g, size_t stride, uint32_t pivots, uint32_t columns, uint32_t rows,
                      int32_t* target, size_t target_stride);

// sums[c][lane] = sum over t < terms of g[c * next + t * step] * lanes[t][lane] for c < kFrontColumns.
//   lanes  [terms x kFrontLanes],  sums [kFrontColumns x kFrontLanes]
void front_lanes_ref(const int32_t* g, size_t next, size_t step, uint32_t terms, const int32_t* lanes, int64_t* sums);

struct FrontKernels {
  decltype(&front_update_ref) update = front_update_ref;
  decltype(&front_lanes_ref) lanes = front_lanes_ref;
};

// False when the file was compiled without its instruction set.
bool add_front_s32_avx2(FrontKernels* kernels);
bool add_front_s32_simd128(FrontKernels* kernels);
bool add_front_s32_vnni(FrontKernels* kernels);  // AVX-512 F; named after the set of kernels that it belongs to

}  // namespace sinew
#endif
