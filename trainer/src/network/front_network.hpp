// SPDX-License-Identifier: MIT
// The network of the front: every point alone, and what all of them say together.
#ifndef SINEW_TRAINER_NETWORK_FRONT_NETWORK_HPP
#define SINEW_TRAINER_NETWORK_FRONT_NETWORK_HPP

#include <cstdint>

#include "sinew_formats/float_network.hpp"

namespace sinew {

struct FrontNetworkOptions {
  uint32_t width = 64;  // channels
  uint32_t rounds = 2;  // of all points' largest and mean values
};
FloatNetwork make_front_network(const FrontNetworkOptions& options, uint64_t seed);

}  // namespace sinew
#endif
