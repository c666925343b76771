// SPDX-License-Identifier: MIT
// SINEW_WITH_ASAN where AddressSanitizer is on, which GCC and clang say in two ways.
#ifndef SINEW_TESTS_WITH_ASAN_HPP
#define SINEW_TESTS_WITH_ASAN_HPP

#if defined(__SANITIZE_ADDRESS__)
#define SINEW_WITH_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SINEW_WITH_ASAN 1
#endif
#endif

#endif
