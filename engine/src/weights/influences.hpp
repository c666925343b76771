// SPDX-License-Identifier: MIT
// Stage 9 of a bind: probabilities (kernels/softmax.hpp) or heat rows become influences with exact integer sums.
#ifndef SINEW_WEIGHTS_INFLUENCES_HPP
#define SINEW_WEIGHTS_INFLUENCES_HPP

#include <stddef.h>
#include <stdint.h>

namespace sinew {

// Probabilities under 1 % (Q16) become 0: a softmax leaves them on every candidate and no artist paints them. Measured
// on val: precision of influences 53 % without, 81 % with it, L1 a little lower. At least one of up to 99 entries
// always stays.
constexpr uint32_t kSmallestKept = 655;
// For probabilities that no softmax kernel has made.
void prune_q16(uint32_t* probabilities, uint32_t count);

// Keeps the `keep` largest of `count` (joint, weight) entries (weights any non-negative integer scale up to 2^20, at
// least one > 0), sorts by descending weight then joint, and renormalizes so that the row sums to exactly `total` (65535
// or 255): each is floor(w * total / sum), the remainder goes to the largest. Entries that round to 0 are dropped
// (joint 0, weight 0).
//   out_joints, out_weights [keep]
void keep_largest(const uint16_t* joints, const uint32_t* weights, uint32_t count, uint32_t keep, uint32_t total,
                  uint16_t* out_joints, uint16_t* out_weights);

// A finished row as the caller's weights (sinew_weight_format) from index `first` on.
void store_weights(const uint16_t* row, uint32_t count, uint32_t format, size_t first, void* weights);

}  // namespace sinew
#endif
