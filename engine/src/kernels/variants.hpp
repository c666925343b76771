// SPDX-License-Identifier: MIT
// The kernels that exist beside the reference, one function per file and instruction set. A file that was compiled
// without its instruction set (another processor, a plain `g++ src/*/*.cpp`) returns false.
#ifndef SINEW_KERNELS_VARIANTS_HPP
#define SINEW_KERNELS_VARIANTS_HPP

#include "kernels/table.hpp"

namespace sinew {

// linear_s16_ref() over linear.packed, whole or in two steps: linear_packed and linear_sums.
bool add_linear_s16_avx2(Kernels* kernels);
bool add_linear_s16_avxvnni(Kernels* kernels);
bool add_linear_s16_vnni(Kernels* kernels);
bool add_linear_s16_simd128(Kernels* kernels);
bool add_linear_s16_neon(Kernels* kernels);
// The same instead of the reference: reads the model's bytes, packs nothing.
bool add_linear_s16_dsp(Kernels* kernels);
// linear_s16_ref() on the model's bytes for x86-64: `linear`.
bool add_linear_in_place_s16_avx2(Kernels* kernels);

// Puts the aggregations that the instruction set speeds up into *kernels.
bool add_aggregates_s16_avx2(Kernels* kernels);
bool add_means_s16_avx512(Kernels* kernels);  // AVX-512 BW and VL
bool add_aggregates_s16_simd128(Kernels* kernels);
bool add_aggregates_s16_neon(Kernels* kernels);

}  // namespace sinew
#endif
