// SPDX-License-Identifier: MIT
// The loss of training: distance of the predicted weights from the reference, per vertex and per part, and its
// gradient.
#ifndef SINEW_TRAINER_RUN_LOSS_HPP
#define SINEW_TRAINER_RUN_LOSS_HPP

#include <cstdint>
#include <vector>

#include "sinew_trainer/sample.hpp"

namespace sinew {

struct LossWeights {
  double kl = 0.5, l1 = 1.0, regret = 2.0, part = 0.5, deformation = 0;
};
// Unweighted terms and their weighted sum. Means over vertices by Sample::importance.
struct LossTerms {
  double total = 0;
  double kl = 0;      // sum_j t log(t / p)
  double l1 = 0;      // sum_j |p - t| + missing
  double regret = 0;  // max(0, L1 of the network - L1 of heat)
  double part = 0;    // per part: sum_j |mean p - mean t|, parts weighted by their vertices' importance
  // Root mean square position error of a vertex when every joint rotates by an independent random rotation of one
  // radian: sqrt(sum over joints a of (sum of p - t over a's subtree)^2 |vertex - a|^2), sides of the grid.
  double deformation = 0;
};

// Candidates that fold to the same joint (Sample::fold: end joints) count as one: their weights are summed before they
// are compared. logits [U x K] in natural log units; d_logits [U x K] is overwritten (may be null), absent slots get 0.
// Throws Error when no vertex has a reference.
template <class Scalar>
LossTerms weight_loss(const Sample& sample, const LossWeights& weights, const std::vector<Scalar>& logits,
                      std::vector<Scalar>* d_logits);

// L1 of the yardstick from probabilities [U x K]: the `keep` largest candidates of a vertex, normalized, folded.
double sample_l1(const Sample& sample, const std::vector<float>& probabilities, uint32_t keep);

}  // namespace sinew
#endif
