// SPDX-License-Identifier: MIT
// The linear layer with AVX2: vpmaddwd and vpaddd on 8 outputs at a time.
#include "kernels/variants.hpp"

#if defined(__AVX2__)
#include "kernels/linear_s16_256.hpp"

namespace sinew {
namespace {

struct MultiplyAdd {
  static SINEW_INLINE __m256i dot(__m256i sum, __m256i weights, __m256i input) {
    // No product of two int16 pairs leaves int32: the reader refuses the weight -32768.
#if defined(__GNUC__)
    // As intrinsics GCC 12 computes all products of a step first and spills the sums; this keeps the two together.
    __m256i products;
    __asm__("vpmaddwd %3, %2, %1\n\tvpaddd %1, %0, %0" : "+x"(sum), "=&x"(products) : "x"(weights), "x"(input));
    return sum;
#else
    return _mm256_add_epi32(sum, _mm256_madd_epi16(weights, input));
#endif
  }
};

void linear_s16_avx2(const LinearView& linear, RowsView in, RowsView residual, const uint16_t* present, uint32_t rows,
                     int16_t* out, uint32_t out_stride) {
  linear_tiled<Registers256<MultiplyAdd>>(linear, in.data, in.stride, residual.data, residual.stride, present, rows,
                                          out, out_stride);
}

void linear_sums_s16_avx2(const LinearView& linear, RowsView in, uint32_t rows, int32_t* sums) {
  linear_sums_tiled<Registers256<MultiplyAdd>>(linear, in.data, in.stride, rows, sums);
}

}  // namespace

bool add_linear_s16_avx2(Kernels* kernels) {
  kernels->linear_packed = linear_s16_avx2;
  kernels->linear_sums = linear_sums_s16_avx2;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_linear_s16_avx2(Kernels*) { return false; }
}  // namespace sinew
#endif
