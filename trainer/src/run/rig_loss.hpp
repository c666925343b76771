// SPDX-License-Identifier: MIT
// Losses of skeleton networks, with analytic gradients: of votes, of the published method's slots, of the front.
#ifndef SINEW_TRAINER_RUN_RIG_LOSS_HPP
#define SINEW_TRAINER_RUN_RIG_LOSS_HPP

#include <array>
#include <vector>

#include "data/front_sample.hpp"
#include "data/rig_sample.hpp"
#include "data/slot_sample.hpp"

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

struct SlotLossOptions {
  double balance = 0.7;  // what the error of joints counts; that of connections counts the rest
  // False, as published: plain means. True, ours: presences count kPresenceShare in all beside the other numbers, and of the
  // connections' error half is of connected pairs and half of the others.
  bool balanced = false;
};

struct SlotLoss {
  double total = 0;  // balance * joints + (1 - balance) * connections
  double joints =
      0;  // mean absolute error of the joint vectors: position and offset of the slots that hold a joint, and
          // all slots' presence
  double connections = 0;  // mean absolute error of the connection probabilities of every two slots that hold joints
  double distance = 0;     // mean distance of the joints, longest sides
  double presence = 0;     // share of slots whose presence is on the wrong side of a half
};
constexpr double kPresenceShare = 0.2;

//   outputs    in   [kSlotOutputs] of the runner (network/slot_network.hpp)
//   d_outputs  out  gradient of the total; may be null
SlotLoss slot_loss(const SlotSample& sample, const SlotLossOptions& options, const std::vector<float>& outputs,
                   std::vector<float>* d_outputs);

struct FrontLoss {
  double total = 0;    // of an upright sample front, and kUprightShare upright
  double front = 0;    // squared distance of the answer, cut to the length kLongestFront, from the true front
  double upright = 0;  // cross entropy
  double angle = 0;  // (1 - cosine) / 2 of the answer, 1 where it is exactly behind; 0 of samples that are not upright
  std::array<double, 2> answer{};
};
constexpr double kUprightShare = 0.3, kLongestFront = 1.5;

//   outputs    in   [N x kFrontOutputs]
//   d_outputs  out  gradient of the total; may be null
FrontLoss front_loss(const FrontSample& sample, const std::vector<float>& outputs, std::vector<float>* d_outputs);

}  // namespace sinew
#endif
