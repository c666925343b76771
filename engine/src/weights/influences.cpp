// SPDX-License-Identifier: MIT
// Logits to probabilities and probabilities to influence rows with exact sums; the last integer stage of a bind.
#include "weights/influences.hpp"

#include "core/counts.hpp"

namespace sinew {
namespace {

constexpr uint32_t kStepBits = 6;  // 64 table steps per octave: linear interpolation is off by at most 1.5e-5
constexpr uint32_t kSteps = 1u << kStepBits;

constexpr uint64_t sqrt_floor(uint64_t v) {
  uint64_t root = 0;
  for (uint64_t bit = static_cast<uint64_t>(1) << 31; bit != 0; bit >>= 1) {
    if ((root | bit) * (root | bit) <= v) root |= bit;
  }
  return root;
}

// 2^(-i / 64) in Q30, i = 0..64, made by the compiler: 2^(-1/2), 2^(-1/4) ... are repeated square roots of 1/2 in Q31,
// and the entry for i is the product of those whose bit is set in i.
struct PowerTable {
  uint32_t q30[kSteps + 1];
  constexpr PowerTable() : q30() {
    uint64_t roots[kStepBits] = {};
    uint64_t root = static_cast<uint64_t>(1) << 30;  // 1/2
    for (uint32_t b = kStepBits; b-- > 0;) {
      root = sqrt_floor(root << 31);
      roots[b] = root;
    }
    for (uint32_t i = 0; i < kSteps; ++i) {
      uint64_t value = static_cast<uint64_t>(1) << 31;
      for (uint32_t b = 0; b < kStepBits; ++b) {
        if ((i >> b) & 1u) value = (value * roots[b] + (1u << 30)) >> 31;
      }
      q30[i] = static_cast<uint32_t>((value + 1) >> 1);
    }
    q30[kSteps] = 1u << 29;
  }
};
constexpr PowerTable kPowers;

// 2^(-d / 1024) in Q30.
uint32_t power_q30(uint32_t d_q10) {
  constexpr uint32_t kFineBits = 10 - kStepBits;
  const uint32_t whole = d_q10 >> 10;
  if (whole > 30) return 0;
  const uint32_t step = (d_q10 & 1023u) >> kFineBits;
  const uint32_t fine = d_q10 & ((1u << kFineBits) - 1u);
  const uint32_t drop = kPowers.q30[step] - kPowers.q30[step + 1];
  return (kPowers.q30[step] - ((drop * fine) >> kFineBits)) >> whole;
}

}  // namespace

void softmax_q16(const int16_t* logits, const uint16_t* joints, uint32_t count, uint32_t* out) {
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
  }
}

void prune_q16(uint32_t* probabilities, uint32_t count) {
  constexpr uint32_t kSmallest = 655;  // 1 % of 65536
  for (uint32_t i = 0; i < count; ++i) {
    if (probabilities[i] < kSmallest) probabilities[i] = 0;
  }
}

void keep_largest(const uint16_t* joints, const uint32_t* weights, uint32_t count, uint32_t keep, uint32_t total,
                  uint16_t* out_joints, uint16_t* out_weights) {
  // Selection in place of a sort: each round takes the first entry behind the last one taken, in the order (falling
  // weight, rising joint). No scratch, at most keep * count steps.
  uint32_t kept = 0, last = count;
  uint64_t sum = 0;
  uint32_t chosen[16];
  for (; kept < keep && kept < 16; ++kept) {
    uint32_t best = count;
    for (uint32_t i = 0; i < count; ++i) {
      if (joints[i] == kNoJoint || weights[i] == 0) continue;
      const bool behind =
          last == count || weights[i] < weights[last] || (weights[i] == weights[last] && joints[i] > joints[last]);
      if (!behind) continue;
      if (best == count || weights[i] > weights[best] || (weights[i] == weights[best] && joints[i] < joints[best]))
        best = i;
    }
    if (best == count) break;
    chosen[kept] = last = best;
    sum += weights[best];
  }

  uint32_t given = 0, used = 0;
  for (uint32_t i = 0; i < kept; ++i) {
    const uint32_t share = static_cast<uint32_t>(static_cast<uint64_t>(weights[chosen[i]]) * total / sum);
    given += share;
    if (share == 0 && i > 0) continue;  // the first takes the remainder, it is never empty
    out_joints[used] = joints[chosen[i]];
    out_weights[used] = static_cast<uint16_t>(share);
    ++used;
  }
  if (used > 0) out_weights[0] = static_cast<uint16_t>(out_weights[0] + (total - given));
  for (uint32_t i = used; i < keep; ++i) out_joints[i] = out_weights[i] = 0;

  // Different weights may have become equal: ties go to the lower joint in what is handed out, too.
  for (uint32_t i = 1; i < used; ++i) {
    for (uint32_t j = i; j > 0 && out_weights[j] == out_weights[j - 1] && out_joints[j] < out_joints[j - 1]; --j) {
      const uint16_t joint = out_joints[j];
      out_joints[j] = out_joints[j - 1];
      out_joints[j - 1] = joint;
    }
  }
}

}  // namespace sinew
