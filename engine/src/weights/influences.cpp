// SPDX-License-Identifier: MIT
// Probabilities to influence rows with exact sums; the last integer stage of a bind.
#include "weights/influences.hpp"

#include "core/counts.hpp"

namespace sinew {
void prune_q16(uint32_t* probabilities, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    if (probabilities[i] < kSmallestKept) probabilities[i] = 0;
  }
}

void keep_largest(const uint16_t* joints, const uint32_t* weights, uint32_t count, uint32_t keep, uint32_t total,
                  uint16_t* out_joints, uint16_t* out_weights) {
  // Selection instead of a sort: each round takes the first entry behind the last one taken, in the order (descending
  // weight, ascending joint). No scratch, at most keep * count steps.
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

void store_weights(const uint16_t* row, uint32_t count, uint32_t format, size_t first, void* weights) {
  for (uint32_t i = 0; i < count; ++i) {
    switch (format) {
      case SINEW_WEIGHT_UNORM8:
        static_cast<uint8_t*>(weights)[first + i] = static_cast<uint8_t>(row[i]);
        break;
      case SINEW_WEIGHT_UNORM16:
        static_cast<uint16_t*>(weights)[first + i] = row[i];
        break;
      // One correctly rounded IEEE division: the same on every target.
      default:
        static_cast<float*>(weights)[first + i] = static_cast<float>(row[i]) / 65535.0f;
        break;
    }
  }
}

}  // namespace sinew
