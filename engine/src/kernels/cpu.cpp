// SPDX-License-Identifier: MIT
// x86: cpuid for what the processor has, xgetbv for which registers the operating system saves. Elsewhere: nothing.
#include <stdint.h>

#include "kernels/select.hpp"

// MinGW's headers define _M_X64 too, so the compiler is asked first.
#if defined(__x86_64__) && defined(__GNUC__)
#include <cpuid.h>
#elif defined(_M_X64)
#include <intrin.h>
#endif

namespace sinew {

#if (defined(__x86_64__) && defined(__GNUC__)) || defined(_M_X64)
namespace {

struct CpuidLeaf {
  uint32_t a = 0, b = 0, c = 0, d = 0;
};

// All zero when the processor does not know the leaf.
CpuidLeaf cpuid(uint32_t leaf, uint32_t subleaf) {
  CpuidLeaf r;
#if !defined(__GNUC__)
  int words[4];
  __cpuid(words, 0);
  if (static_cast<uint32_t>(words[0]) < leaf) return r;
  __cpuidex(words, static_cast<int>(leaf), static_cast<int>(subleaf));
  r = {static_cast<uint32_t>(words[0]), static_cast<uint32_t>(words[1]), static_cast<uint32_t>(words[2]),
       static_cast<uint32_t>(words[3])};
#else
  __get_cpuid_count(leaf, subleaf, &r.a, &r.b, &r.c, &r.d);
#endif
  return r;
}

uint64_t saved_registers() {
#if !defined(__GNUC__)
  return _xgetbv(0);
#else
  uint32_t low, high;
  __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return (static_cast<uint64_t>(high) << 32) | low;
#endif
}

bool has(uint32_t word, int bit) { return ((word >> bit) & 1u) != 0; }

}  // namespace

Cpu detect_cpu() {
  Cpu cpu;
  const CpuidLeaf basic = cpuid(1, 0);
  if (!has(basic.c, 27) || !has(basic.c, 28)) return cpu;  // OSXSAVE, AVX
  const uint64_t saved = saved_registers();
  if ((saved & 0x6u) != 0x6u) return cpu;  // XMM, YMM
  const CpuidLeaf extended = cpuid(7, 0), more = cpuid(7, extended.a >= 1 ? 1 : 0);
  cpu.avx2 = has(extended.b, 5);
  cpu.avxvnni = cpu.avx2 && extended.a >= 1 && has(more.a, 4);
  const bool avx512 = (saved & 0xE0u) == 0xE0u && has(extended.b, 16) && has(extended.b, 17) && has(extended.b, 30) &&
                      has(extended.b, 31);  // mask and ZMM registers; F, DQ, BW, VL
  cpu.vnni = cpu.avx2 && avx512 && has(extended.c, 11);
  return cpu;
}
#else
Cpu detect_cpu() { return Cpu(); }
#endif

}  // namespace sinew
