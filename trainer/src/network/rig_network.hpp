// SPDX-License-Identifier: MIT
// The network that lets surface points vote for bones.
#ifndef SINEW_TRAINER_NETWORK_RIG_NETWORK_HPP
#define SINEW_TRAINER_NETWORK_RIG_NETWORK_HPP

#include "sinew_formats/float_network.hpp"

namespace sinew {

struct RigNetworkOptions {
  uint32_t width = 64;
  uint32_t rounds = 4;  // of neighbours
  bool hands = false;   // for hands' crops, not bodies
};
// Seeded initial weights. Every point of a set gets kRigOutputs numbers (votes/rig_task.hpp of the engine):
//   h = relu(L x); per round u = relu(L h), z = relu(L [h, max of near u, max of far u, max of all u]), h = z (+ h from the
//   second on); at the end relu(L [h, h after two rounds, max and mean of all h]), relu(L), L.
FloatNetwork make_rig_network(const RigNetworkOptions& options, uint64_t seed);

// Of the front: every point alone, and what all of them say together.
struct FrontNetworkOptions {
  uint32_t width = 64;  // channels
  uint32_t rounds = 2;  // of all points' largest and mean values
};
FloatNetwork make_front_network(const FrontNetworkOptions& options, uint64_t seed);

}  // namespace sinew
#endif
