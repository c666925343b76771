// SPDX-License-Identifier: MIT
// Chooses the kernels for the processor at hand. sinew_bind() does so once a call and hands them down to its stages.
#ifndef SINEW_KERNELS_SELECT_HPP
#define SINEW_KERNELS_SELECT_HPP

#include "kernels/table.hpp"

namespace sinew {

// Fills *kernels for a sinew_kernel. False when this library was built without it or this processor lacks it, or for a
// number that is none; *kernels is undefined then. AUTO and REF always succeed.
bool select_kernels(uint32_t wanted, Kernels* kernels);

// What SINEW_KERNEL_AUTO chooses.
inline Kernels fastest_kernels() {
  Kernels kernels;
  (void)select_kernels(SINEW_KERNEL_AUTO, &kernels);
  return kernels;
}

// See sinew_kernel_name().
const char* kernel_name(uint32_t kernel);

struct Cpu {
  bool avx2 = false;
  bool avxvnni = false;
  bool vnni = false;  // AVX-512 F, BW, DQ, VL and VNNI
};

// Asks the processor itself (some hundred cycles; more in a virtual machine). Remembers nothing, so it needs no lock.
Cpu detect_cpu();

}  // namespace sinew
#endif
