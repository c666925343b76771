// SPDX-License-Identifier: MIT
// The linear layer with AVX-VNNI, for processors that have vpdpwssd but no AVX-512.
#include "kernels/variants.hpp"

#if defined(__AVXVNNI__)
#include "kernels/linear_s16_256.hpp"

namespace sinew {
namespace {

struct MultiplyAdd {
  static SINEW_INLINE __m256i dot(__m256i sum, __m256i weights, __m256i input) {
#if defined(__GNUC__)
    __asm__("%{vex%} vpdpwssd %2, %1, %0" : "+x"(sum) : "x"(weights), "x"(input));  // see linear_s16_vnni.cpp
    return sum;
#else
    return _mm256_dpwssd_avx_epi32(sum, weights, input);
#endif
  }
};

void linear_s16_avxvnni(const LinearView& linear, RowsView in, RowsView residual, const uint16_t* present,
                        uint32_t rows, int16_t* out, uint32_t out_stride) {
  linear_tiled<Registers256<MultiplyAdd>>(linear, in.data, in.stride, residual.data, residual.stride, present, rows,
                                          out, out_stride);
}

void linear_sums_s16_avxvnni(const LinearView& linear, RowsView in, uint32_t rows, int32_t* sums) {
  linear_sums_tiled<Registers256<MultiplyAdd>>(linear, in.data, in.stride, rows, sums);
}

}  // namespace

bool add_linear_s16_avxvnni(Kernels* kernels) {
  kernels->linear_packed = linear_s16_avxvnni;
  kernels->linear_sums = linear_sums_s16_avxvnni;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_linear_s16_avxvnni(Kernels*) { return false; }
}  // namespace sinew
#endif
