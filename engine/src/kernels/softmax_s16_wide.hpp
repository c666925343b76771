// SPDX-License-Identifier: MIT
// Softmax of one vertex, once for all registers. A file that is compiled with an instruction set's flags includes
// this and defines the register types and operations:
//   Int32, kWidth                  int32 of a register
//   load(from, n), store(to, a, n) n <= kWidth int16, sign-extended and -1 behind them; n of the int32
//   all(int32), subtract(Int32, Int32), larger(Int32, Int32), largest(Int32) of its numbers
//   present(logits, joints)        logits, kAbsentLogit where the joint is -1
//   Reals, add(Reals, Reals), sum(Reals)     kWidth doubles
//   powers(Int32)                  2^(-d / 1024) in Q30 as the reference has it, 0 for d / 1024 in 32..127
//   quotients(Reals, double offset, double factor)   (65536 x + offset) * factor, without its fraction
//   at_least(Int32, uint32)        0 where it is less
#ifndef SINEW_KERNELS_SOFTMAX_S16_WIDE_HPP
#define SINEW_KERNELS_SOFTMAX_S16_WIDE_HPP

#include "kernels/isolated.hpp"
#include "kernels/softmax.hpp"
#include "kernels/softmax_s16_powers.hpp"

namespace sinew {
namespace {

// So far below any logit that its power is 0: 65536..131071 below the largest.
constexpr int32_t kAbsentLogit = -3 * 32768;

template <class Isa, uint32_t kRegisters>
SINEW_INLINE void softmax_in(const int16_t* logits, const uint16_t* joints, uint32_t count, uint32_t smallest,
                             uint32_t* out) {
  uint32_t first[kRegisters], n[kRegisters];
  typename Isa::Int32 x[kRegisters];
  SINEW_UNROLL for (uint32_t r = 0; r < kRegisters; ++r) {
    first[r] = r * Isa::kWidth < count ? r * Isa::kWidth : count;
    n[r] = count - first[r] < Isa::kWidth ? count - first[r] : Isa::kWidth;
    x[r] = Isa::present(Isa::load(logits + first[r], n[r]), Isa::load(joints + first[r], n[r]));
  }
  typename Isa::Int32 most = x[0];
  SINEW_UNROLL for (uint32_t r = 1; r < kRegisters; ++r) most = Isa::larger(most, x[r]);
  const int32_t largest = Isa::largest(most);
  if (largest == kAbsentLogit) {  // nothing is present
    for (uint32_t i = 0; i < count; ++i) out[i] = 0;
    return;
  }
  typename Isa::Reals powers[kRegisters];
  SINEW_UNROLL for (uint32_t r = 0; r < kRegisters; ++r) powers[r] =
      Isa::powers(Isa::subtract(Isa::all(largest), x[r]));
  typename Isa::Reals total = powers[0];
  SINEW_UNROLL for (uint32_t r = 1; r < kRegisters; ++r) total = Isa::add(total, powers[r]);
  // floor((65536 p + floor(sum / 2)) / sum) in doubles. Up to 65536 p + sum / 2 + 1/4 < 2^47 all numbers are exact, and
  // that one's quotient is at least 1 / (4 sum) from a whole number; the two roundings behind it move the quotient by
  // less than 2^47 / sum * 2^-51 = 1 / (16 sum), whatever the rounding mode.
  const double sum = Isa::sum(total), offset = 0.5 * sum + 0.25, factor = 1.0 / sum;
  SINEW_UNROLL for (uint32_t r = 0; r < kRegisters; ++r) {
    Isa::store(out + first[r], Isa::at_least(Isa::quotients(powers[r], offset, factor), smallest), n[r]);
  }
}

template <class Isa>
void softmax(const int16_t* logits, const uint16_t* joints, uint32_t count, uint32_t smallest, uint32_t* out) {
  static_assert(SINEW_MAX_CANDIDATES <= 16, "a row fits the registers");
  if constexpr (Isa::kWidth < 16) {
    if (count <= 8) return softmax_in<Isa, 8 / Isa::kWidth>(logits, joints, count, smallest, out);
  }
  softmax_in<Isa, 16 / Isa::kWidth>(logits, joints, count, smallest, out);
}

}  // namespace
}  // namespace sinew
#endif
