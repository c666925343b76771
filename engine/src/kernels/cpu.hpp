// SPDX-License-Identifier: MIT
// What the processor and its operating system let a program use, as far as kernels ask.
#ifndef SINEW_KERNELS_CPU_HPP
#define SINEW_KERNELS_CPU_HPP

namespace sinew {

struct Cpu {
  bool avx2 = false;
  bool avxvnni = false;
  bool vnni = false;  // AVX-512 F, BW, DQ, VL and VNNI
};

// Asks the processor itself (some hundred cycles; more in a virtual machine). Remembers nothing, so it needs no lock.
Cpu detect_cpu();

}  // namespace sinew
#endif
