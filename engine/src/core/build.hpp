// SPDX-License-Identifier: MIT
// Optional parts of a build. -DSINEW_PUBLISHED_METHODS=OFF leaves out the methods of sinew/published.h: calls that
// ask for one return SINEW_ERROR_NOT_BUILT. -DSINEW_SMALL_CODE=ON leaves out, for microcontrollers: these; spectral features
// (a model that asks for them is refused as of an unknown version), hints, symmetry, rigid_parts and surface_vertices
// (SINEW_ERROR_NOT_BUILT; no mesh is reduced); threads (any thread_count works as 1 does, parallel_for is never called);
// and kernels that want weights packed (weights_in_place is always on). Some computations take less code and more
// time: quantization, Morton order, visibility. What is left gives the same bytes.
#ifndef SINEW_CORE_BUILD_HPP
#define SINEW_CORE_BUILD_HPP

namespace sinew {

#if defined(SINEW_SMALL_CODE)
constexpr bool kSmallCode = true;
#else
constexpr bool kSmallCode = false;
#endif
constexpr bool kHasExtras = !kSmallCode;
constexpr bool kHasThreads = !kSmallCode;
constexpr bool kHasPackedWeights = !kSmallCode;
// Whether the library holds the methods of the room `published`, or the room's stub none.cpp. Not with SINEW_SMALL_CODE, which
// has neither.
bool has_published_methods();

}  // namespace sinew

// A small function that is used in many places, and is there once where code is to be small: 64-bit arithmetic on a
// 32-bit processor is longer than a call.
#if defined(SINEW_SMALL_CODE) && defined(__GNUC__)
#define SINEW_ONCE [[gnu::noinline]]
#else
#define SINEW_ONCE
#endif

// A function for size instead of speed: what a bind does at most once, and only where it was asked to.
#if defined(__GNUC__)
#define SINEW_RARE [[gnu::noinline, gnu::cold]]
#else
#define SINEW_RARE
#endif

#endif
