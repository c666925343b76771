// SPDX-License-Identifier: MIT
// The kernels that exist beside the reference, one function per file and instruction set. A file that was compiled
// without its instruction set (another processor, a plain `g++ src/*/*.cpp`) returns null.
#ifndef SINEW_KERNELS_VARIANTS_HPP
#define SINEW_KERNELS_VARIANTS_HPP

#include "kernels/kernels.hpp"

namespace sinew {

using LinearKernel = void (*)(const LinearView& linear, RowsView in, RowsView residual, const uint16_t* present,
                              uint32_t rows, int16_t* out, uint32_t out_stride);

// linear_s16_ref() over linear.packed.
LinearKernel find_linear_s16_avx2();
LinearKernel find_linear_s16_avxvnni();
LinearKernel find_linear_s16_vnni();

}  // namespace sinew
#endif
