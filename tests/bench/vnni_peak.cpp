// SPDX-License-Identifier: MIT
// What the processor's vpdpwssd could do at most: sums in registers, no memory. Compiled with AVX-512 VNNI.
#include "vnni_peak.hpp"

#include <immintrin.h>

#define SINEW_DOT(sum) __asm__ volatile("vpdpwssd %2, %1, %0" : "+v"(sum) : "v"(w), "v"(x));

int run_vnni_peak(uint64_t rounds) {
  const __m512i w = _mm512_set1_epi32(3), x = _mm512_set1_epi32(5);
  __m512i a = w, b = w, c = w, d = w, e = w, f = w, g = w, h = w, i = w, j = w, k = w, l = w;
  for (uint64_t round = 0; round < rounds; ++round) {
    SINEW_DOT(a)
    SINEW_DOT(b)
    SINEW_DOT(c)
    SINEW_DOT(d) SINEW_DOT(e) SINEW_DOT(f) SINEW_DOT(g) SINEW_DOT(h) SINEW_DOT(i) SINEW_DOT(j) SINEW_DOT(k) SINEW_DOT(l)
  }
  const __m512i all =
      _mm512_add_epi32(_mm512_add_epi32(_mm512_add_epi32(a, b), _mm512_add_epi32(c, d)),
                       _mm512_add_epi32(_mm512_add_epi32(_mm512_add_epi32(e, f), _mm512_add_epi32(g, h)),
                                        _mm512_add_epi32(_mm512_add_epi32(i, j), _mm512_add_epi32(k, l))));
  return _mm512_reduce_add_epi32(all);
}
