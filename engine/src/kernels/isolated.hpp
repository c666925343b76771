// SPDX-License-Identifier: MIT
// For files that are compiled with an instruction set's flags. Everything in them has internal linkage and they call no
// inline function that other files share: the linker must never choose their copy of one for a plain processor.
// tests/kernels/object_code_test.cpp looks for such symbols.
#ifndef SINEW_KERNELS_ISOLATED_HPP
#define SINEW_KERNELS_ISOLATED_HPP

#if defined(_MSC_VER)
#define SINEW_INLINE __forceinline
#define SINEW_NOINLINE __declspec(noinline)
#define SINEW_UNROLL
#elif defined(__clang__)
#define SINEW_INLINE __attribute__((always_inline)) inline
#define SINEW_NOINLINE __attribute__((noinline))
#define SINEW_UNROLL _Pragma("clang loop unroll(full)")
#else
#define SINEW_INLINE __attribute__((always_inline)) inline
#define SINEW_NOINLINE __attribute__((noinline))
#define SINEW_UNROLL _Pragma("GCC unroll 32")
#endif

#endif
