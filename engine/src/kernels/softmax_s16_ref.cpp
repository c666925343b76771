// SPDX-License-Identifier: MIT
// The definition of softmax in plain C++.
#include "kernels/softmax.hpp"
#include "kernels/softmax_s16_powers.hpp"

namespace sinew {
namespace {

// 2^(-d / 1024) in Q30.
uint32_t power_q30(uint32_t d_q10) {
  const uint32_t whole = d_q10 >> 10;
  if (whole > 30) return 0;
  const uint32_t step = (d_q10 & 1023u) >> kFineBits;
  const uint32_t fine = d_q10 & ((1u << kFineBits) - 1u);
  const uint32_t drop = kPowers.q30[step] - kPowers.q30[step + 1];
  return (kPowers.q30[step] - ((drop * fine) >> kFineBits)) >> whole;
}

}  // namespace

void softmax_s16_ref(const int16_t* logits, const uint16_t* joints, uint32_t count, uint32_t smallest, uint32_t* out) {
  int32_t largest = INT32_MIN;
  for (uint32_t i = 0; i < count; ++i) {
    if (joints[i] != kNoJoint && logits[i] > largest) largest = logits[i];
  }
  uint64_t sum = 0;
  for (uint32_t i = 0; i < count; ++i) {
    out[i] = joints[i] == kNoJoint ? 0 : power_q30(static_cast<uint32_t>(largest - logits[i]));
    sum += out[i];
  }
  for (uint32_t i = 0; i < count; ++i) {
    // out < 2^31: the product stays below 2^47. sum is 0 only when nothing is present.
    if (out[i] != 0) out[i] = static_cast<uint32_t>(((static_cast<uint64_t>(out[i]) << 16) + sum / 2) / sum);
    if (out[i] < smallest) out[i] = 0;
  }
}

}  // namespace sinew
