// SPDX-License-Identifier: MIT
// Weights of a position of the lattice: a few joints with unorm16 weights, and the sums that they are made of.
#ifndef SINEW_DEFORM_WEIGHT_ROW_HPP
#define SINEW_DEFORM_WEIGHT_ROW_HPP

#include "core/arena.hpp"
#include "core/fixed.hpp"

namespace sinew::deform {

constexpr uint32_t kNodeSlots = 8;

// By descending weight, ties by joint; weights sum to 65535, or are all 0. Slots that are not used have weight 0.
struct WeightRow {
  uint16_t joints[kNodeSlots];
  uint16_t weights[kNodeSlots];

  uint32_t of(uint32_t joint) const {
    for (uint32_t s = 0; s < kNodeSlots && weights[s] != 0; ++s) {
      if (joints[s] == joint) return weights[s];
    }
    return 0;
  }
  bool empty() const { return weights[0] == 0; }
};

// Weight that a row shares with `count` influences, which may have any order: the lesser of both, summed over joints.
inline uint32_t common_weight(const WeightRow& row, const uint16_t* joints, const uint16_t* weights, size_t count) {
  uint32_t common = 0;
  for (size_t i = 0; i < count; ++i) {
    if (weights[i] == 0) continue;
    const uint32_t other = row.of(joints[i]);
    common += other < weights[i] ? other : weights[i];
  }
  return common;
}

// Sum over all joints of how far two rows are apart, 0..131070.
inline uint32_t row_distance(const WeightRow& a, const WeightRow& b) {
  uint32_t whole = 0;
  for (uint32_t s = 0; s < kNodeSlots; ++s) whole += static_cast<uint32_t>(a.weights[s]) + b.weights[s];
  return whole - 2 * common_weight(b, a.joints, a.weights, kNodeSlots);
}

// Adds up weights of many rows, then gives the largest as a row and is empty again.
class RowSum {
 public:
  bool allocate(Arena& arena, uint32_t joint_count) {
    sums_ = arena.alloc<int64_t>(joint_count);
    touched_ = arena.alloc<uint16_t>(joint_count);
    return arena.ok();
  }
  void clear(uint32_t joint_count) {
    for (uint32_t j = 0; j < joint_count; ++j) sums_[j] = 0;
    count_ = 0;
  }
  // amount >= 0; all amounts of a row stay below 2^62 in sum.
  void add(uint32_t joint, int64_t amount) {
    if (amount == 0) return;
    if (sums_[joint] == 0) touched_[count_++] = static_cast<uint16_t>(joint);
    sums_[joint] += amount;
  }
  void add(const WeightRow& row, int64_t factor) {
    for (uint32_t s = 0; s < kNodeSlots && row.weights[s] != 0; ++s) add(row.joints[s], factor * row.weights[s]);
  }
  // The row of the largest sums. Rounding's remainder goes to the first.
  WeightRow take() {
    WeightRow row = {};
    int64_t kept[kNodeSlots] = {};
    uint32_t used = 0;
    for (uint32_t i = 0; i < count_; ++i) {
      const uint16_t joint = touched_[i];
      const int64_t sum = sums_[joint];
      sums_[joint] = 0;
      uint32_t at = used;
      for (; at > 0 && (kept[at - 1] < sum || (kept[at - 1] == sum && row.joints[at - 1] > joint)); --at) {
        if (at == kNodeSlots) continue;
        kept[at] = kept[at - 1];
        row.joints[at] = row.joints[at - 1];
      }
      if (at == kNodeSlots) continue;
      kept[at] = sum;
      row.joints[at] = joint;
      if (used < kNodeSlots) ++used;
    }
    count_ = 0;
    int64_t total = 0;
    for (uint32_t s = 0; s < used; ++s) total += kept[s];
    if (total == 0) return {};
    const int top = top_bit(static_cast<uint64_t>(total)), shift = top > 45 ? top - 45 : 0;
    int64_t rest = 65535;
    for (uint32_t s = 0; s < used; ++s) {
      row.weights[s] = static_cast<uint16_t>((kept[s] >> shift) * 65535 / (total >> shift));
      rest -= row.weights[s];
    }
    row.weights[0] = static_cast<uint16_t>(row.weights[0] + rest);
    for (uint32_t s = 0; s < kNodeSlots; ++s) {
      if (row.weights[s] == 0) row.joints[s] = 0;
    }
    return row;
  }

 private:
  int64_t* sums_ = nullptr;      // [J]
  uint16_t* touched_ = nullptr;  // [J] joints whose sum is not 0
  uint32_t count_ = 0;
};

}  // namespace sinew::deform
#endif
