// SPDX-License-Identifier: MIT
// What both networks of the published method are to make small together.
#ifndef SINEW_TRAINER_RUN_SLOT_LOSS_HPP
#define SINEW_TRAINER_RUN_SLOT_LOSS_HPP

#include <vector>

#include "data/slot_sample.hpp"

namespace sinew {

struct SlotLoss {
  double total = 0;   // balance * joints + (1 - balance) * connections
  double joints = 0;  // mean absolute error of the joint vectors: place and offset of the slots that hold a joint, and
                      // kPresenceShare times that of all slots' presence
  double connections =
      0;                // mean absolute error of the connection probabilities of every two slots that hold joints: half
                        // of it of those that hang together, half of the others, or nothing at all would be the best
                        // answer where one pair in ten hangs together
  double distance = 0;  // mean distance of the joints, longest sides
  double presence = 0;  // share of slots whose presence is on the wrong side of a half
};
constexpr double kPresenceShare = 0.2;

//   outputs    in   [kSlotOutputs] of the runner (network/slot_network.hpp)
//   d_outputs  out  gradient of the total; may be null
SlotLoss slot_loss(const SlotSample& sample, double balance, const std::vector<float>& outputs,
                   std::vector<float>* d_outputs);

}  // namespace sinew
#endif
