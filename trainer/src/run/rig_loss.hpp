// SPDX-License-Identifier: MIT
// The loss of skeleton prediction with its analytic gradient.
#ifndef SINEW_TRAINER_RUN_RIG_LOSS_HPP
#define SINEW_TRAINER_RUN_RIG_LOSS_HPP

#include "data/rig_sample.hpp"

namespace sinew {

// Means over the points, weighted by theirs.
struct RigLoss {
  double total = 0;
  double start = 0, end = 0;                    // negative log likelihood: distance / spread + log spread
  double start_class = 0, end_class = 0;        // cross entropies
  double start_distance = 0, end_distance = 0;  // shares of the side
};
// total = start + end + 0.3 (start_class + end_class). Joints of class `other` teach no class: their names say nothing.
//   outputs    [N x kRigOutputs], as in votes/rig_task.hpp of the engine
//   d_outputs  the gradient, overwritten; null = not wanted
RigLoss rig_loss(const RigSample& sample, const std::vector<float>& outputs, std::vector<float>* d_outputs);

}  // namespace sinew
#endif
