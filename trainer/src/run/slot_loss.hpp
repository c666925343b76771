// SPDX-License-Identifier: MIT
// What both networks of the published method are to make small together.
#ifndef SINEW_TRAINER_RUN_SLOT_LOSS_HPP
#define SINEW_TRAINER_RUN_SLOT_LOSS_HPP

#include <vector>

#include "data/slot_sample.hpp"

namespace sinew {

struct SlotLossOptions {
  double balance = 0.7;  // what the error of joints counts; that of connections counts the rest
  // False, as published: plain means. True, ours: presences count kPresenceShare in all beside the other numbers, and of the
  // connections' error half is of pairs that hang together and half of the others.
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

}  // namespace sinew
#endif
