// SPDX-License-Identifier: MIT
// Rows of a transfer in the caller's order and format, how sure they are, and what became of every part.
#ifndef SINEW_TRANSFER_REPORT_HPP
#define SINEW_TRANSFER_REPORT_HPP

#include "transfer/balance.hpp"

namespace sinew::transferring {

struct TransferOutcome {
  const TransferPlan& plan;
  const Pair& pair;
  const Rows& rows;
  const Match& match;  // of plans that match
  const Balance& balance;
  uint32_t bound_by;
  uint32_t reference_count;
};

// Sums over the vertices of each part.
struct PartReport {
  struct Sums {
    double carried, style, mismatch, distance;
    uint32_t welded, matched, vertices, locked, first;
  };
  Sums* parts = nullptr;  // [parts of the target <= U]

  bool allocate(Arena& arena, const Counts& target) {
    parts = arena.alloc<Sums>(target.vertices);
    return arena.ok();
  }
};

// Writes all outputs, after the last step that can fail.
void write_transfer(const TransferOutcome& result, const PartReport& report, sinew_transfer_outputs* outputs);

}  // namespace sinew::transferring
#endif
