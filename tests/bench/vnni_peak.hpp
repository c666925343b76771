// SPDX-License-Identifier: MIT
// Measures the processor: the rate that the linear kernel is compared with.
#ifndef SINEW_TESTS_BENCH_VNNI_PEAK_HPP
#define SINEW_TESTS_BENCH_VNNI_PEAK_HPP

#include <cstdint>

constexpr double kPeakMacsPerRound = 12 * 32;  // 12 independent vpdpwssd of 32 multiply-adds
int run_vnni_peak(uint64_t rounds);            // returns something, so that nothing is left out

#endif
