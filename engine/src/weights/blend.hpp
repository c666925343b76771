// SPDX-License-Identifier: MIT
// The weighted sum of a few rows, for vertices between those that rows were predicted for.
#ifndef SINEW_WEIGHTS_BLEND_HPP
#define SINEW_WEIGHTS_BLEND_HPP

#include "weights/rows.hpp"

namespace sinew {

// Adds up to three rows of kRowSlots slots.
class RowBlend {
 public:
  // joints, weights [kRowSlots], weights up to kWholeRow; share in Q15
  void add(const uint16_t* joints, const uint32_t* weights, uint32_t share) {
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      if (joints[i] == kNoJoint || weights[i] == 0) continue;
      uint32_t at = 0;
      while (at < count_ && joints_[at] != joints[i]) ++at;
      if (at == count_) {
        joints_[count_] = joints[i];
        sums_[count_++] = 0;
      }
      sums_[at] += weights[i] * share;  // the shares of a blend sum to 2^15: at most 2^31
    }
  }
  // The kRowSlots largest sums (ties: the lower joint), back in the unit of the rows; unused slots kNoJoint.
  void take(uint16_t* joints, uint32_t* weights) {
    for (uint32_t slot = 0; slot < kRowSlots; ++slot) {
      joints[slot] = kNoJoint;
      weights[slot] = 0;
    }
    if (count_ <= kRowSlots) {
      for (uint32_t i = 0; i < count_; ++i) set(i, joints + i, weights + i);
      return;
    }
    for (uint32_t slot = 0; slot < kRowSlots; ++slot) {
      uint32_t best = 0;
      for (uint32_t i = 1; i < count_; ++i) {
        if (sums_[i] > sums_[best] || (sums_[i] == sums_[best] && joints_[i] < joints_[best])) best = i;
      }
      set(best, joints + slot, weights + slot);
      joints_[best] = joints_[--count_];
      sums_[best] = sums_[count_];
    }
  }

 private:
  void set(uint32_t i, uint16_t* joint, uint32_t* weight) const {
    *joint = joints_[i];
    *weight = (sums_[i] + (1u << 14)) >> 15;
  }
  uint16_t joints_[3 * kRowSlots];
  uint32_t sums_[3 * kRowSlots];
  uint32_t count_ = 0;
};

}  // namespace sinew
#endif
