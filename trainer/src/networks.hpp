// SPDX-License-Identifier: MIT
// The two networks for any number of input features; make_field() and make_classic() call these with the engine's.
#ifndef SINEW_TRAINER_NETWORKS_HPP
#define SINEW_TRAINER_NETWORKS_HPP

#include "sinew_trainer/network.hpp"

namespace sinew {

struct InputShape {
  uint32_t vertex_features = 0, pair_features = 0;
  uint32_t log_rule = 0;  // pair channel of the heat prior
};
FloatNetwork build_field(const FieldOptions& options, const InputShape& inputs, uint64_t seed);
FloatNetwork build_classic(uint32_t candidates, uint32_t grid, const InputShape& inputs, uint64_t seed);

}  // namespace sinew
#endif
