// SPDX-License-Identifier: MIT
// The kernels that one run uses, chosen once for the processor at hand.
#ifndef SINEW_KERNELS_SELECT_HPP
#define SINEW_KERNELS_SELECT_HPP

#include "kernels/variants.hpp"

namespace sinew {

// One operation each; what an instruction set has no variant of is the reference. Lives on the caller's stack: there is
// no table that several threads would have to agree on.
struct Kernels {
  uint32_t id = SINEW_KERNEL_REF;        // sinew_kernel
  LinearKernel linear = nullptr;         // reads the model's bytes
  LinearKernel linear_packed = nullptr;  // reads linear.packed; null = there is none, pack nothing
  decltype(&ring_mean_vertex_s16_ref) ring_mean_vertex = nullptr;
  decltype(&ring_max_vertex_s16_ref) ring_max_vertex = nullptr;
  decltype(&ring_mean_pair_s16_ref) ring_mean_pair = nullptr;
  decltype(&ring_max_pair_s16_ref) ring_max_pair = nullptr;
  decltype(&candidate_max_s16_ref) candidate_max = nullptr;
  decltype(&part_mean_vertex_s16_ref) part_mean_vertex = nullptr;
  decltype(&part_mean_pair_s16_ref) part_mean_pair = nullptr;
  decltype(&global_mean_s16_ref) global_mean = nullptr;
  decltype(&global_max_s16_ref) global_max = nullptr;
};

// Fills *kernels for a sinew_kernel. False when this library was built without it or this processor lacks it, or for a
// number that is none; *kernels is undefined then. AUTO and REF always succeed.
bool select_kernels(uint32_t wanted, Kernels* kernels);

// See sinew_kernel_name().
const char* kernel_name(uint32_t kernel);

}  // namespace sinew
#endif
