// SPDX-License-Identifier: MIT
// Input channels that a configuration does without, by name.
#ifndef SINEW_TRAINER_NETWORK_ABSENT_CHANNELS_HPP
#define SINEW_TRAINER_NETWORK_ABSENT_CHANNELS_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew_formats/float_network.hpp"

namespace sinew {

struct AbsentChannels {
  std::vector<uint32_t> vertex, pair;  // ascending
};
// Of TrainConfig::without. Throws Error naming `source`: no channel has the name, or it is the heat prior's.
AbsentChannels absent_channels(const std::vector<std::string>& names, const std::string& source);
// Sets the weights that read them to 0.
void clear_weights(const AbsentChannels& absent, FloatNetwork* network);

}  // namespace sinew
#endif
