// SPDX-License-Identifier: MIT
// Logits of one vertex to probabilities, the operation behind a network's last layer.
#ifndef SINEW_KERNELS_SOFTMAX_HPP
#define SINEW_KERNELS_SOFTMAX_HPP

#include "core/counts.hpp"

namespace sinew {

// Fixed-point softmax over the present candidates. logits in log2 units, Q10. joints[k] == kNoJoint is absent.
//   count     1..SINEW_MAX_CANDIDATES
//   smallest  probabilities below this become 0; at most 65536
//   out       [count] Q16 probabilities (65536 = 1), absent = 0. 2^x by a constant table with linear interpolation.
void softmax_s16_ref(const int16_t* logits, const uint16_t* joints, uint32_t count, uint32_t smallest, uint32_t* out);

using SoftmaxKernel = decltype(&softmax_s16_ref);

// False when the file was compiled without its instruction set.
bool add_softmax_s16_avx2(SoftmaxKernel* kernel);
bool add_softmax_s16_avx512(SoftmaxKernel* kernel);  // AVX-512 F, BW and VL
bool add_softmax_s16_simd128(SoftmaxKernel* kernel);
bool add_softmax_s16_neon(SoftmaxKernel* kernel);

}  // namespace sinew
#endif
