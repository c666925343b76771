// SPDX-License-Identifier: MIT
// How much of each row is transferred, and how much is rebound.
#ifndef SINEW_TRANSFER_BALANCE_HPP
#define SINEW_TRANSFER_BALANCE_HPP

#include "transfer/match.hpp"

namespace sinew::transferring {

// Numbers of the target's welded vertices that decide; differences of rows are sums over joints, 0..2.
struct Balance {
  double* style = nullptr;     // [target U] how far the source's weights are from a bind's, transferred
  double* mismatch = nullptr;  // [target U] how far the target's bind is from the source's, transferred
  double* carried = nullptr;   // [target U] share that is transferred, 0..1
  uint8_t* matched = nullptr;  // [target U] 1: there was something to carry over
  double* scratch = nullptr;   // [target U]

  bool allocate(Arena& arena, const Counts& target);
  // Shares from style and mismatch: locally the larger the style is beside the mismatch, times the same for the whole.
  void weigh(const Mesh& mesh);
  // Shares of a garment: less with distance from the body.
  void weigh_by_distance(const Mesh& mesh, const Match& match);

 private:
  void smooth(const Mesh& mesh, double* values) const;
};

// Divides what each joint of a carried row gets among it and the joints below it that the source lacks (JointCounterparts::head), as the
// bound row of the vertex does.
void share_with_new_joints(const JointCounterparts& map, const Rows& bound, uint32_t vertex, const Rows& carried);
// The bound row with every joint that the source lacks counted as its head.
void fold_new_joints(const JointCounterparts& map, const Rows& bound, uint32_t vertex, const Rows& out,
                     uint32_t out_vertex);
// share * carried + (1 - share) * bound, into `carried`.
void mix_rows(const Rows& bound, double share, uint32_t vertex, const Rows& carried);

}  // namespace sinew::transferring
#endif
