// SPDX-License-Identifier: MIT
// SINEW_WITH_ASAN where AddressSanitizer is on, which GCC and clang say in two ways; kEveryWithAsan for loops that compare with all of something.
#ifndef SINEW_TESTS_WITH_ASAN_HPP
#define SINEW_TESTS_WITH_ASAN_HPP

#if defined(__SANITIZE_ADDRESS__)
#define SINEW_WITH_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SINEW_WITH_ASAN 1
#endif
#endif

namespace sinew_test {
// There one case of so many is enough: what the code does wrong with memory it does in each, and the comparisons themselves, unoptimized, take the time.
#if defined(SINEW_WITH_ASAN)
constexpr unsigned kEveryWithAsan = 4;
#else
constexpr unsigned kEveryWithAsan = 1;
#endif
}  // namespace sinew_test

#endif
