// SPDX-License-Identifier: MIT
// The two networks for any number of input features; make_field() and make_classic() call these with the engine's.
#ifndef SINEW_TRAINER_NETWORK_NETWORKS_HPP
#define SINEW_TRAINER_NETWORK_NETWORKS_HPP

#include "sinew_trainer/network.hpp"

namespace sinew {

struct InputShape {
  uint32_t vertex_features = 0, pair_features = 0;
  uint32_t log_rule = 0;  // pair channel of the heat prior
  uint32_t feature_flags = 0;
};
FloatNetwork build_field(const FieldOptions& options, const InputShape& inputs, uint64_t seed);
FloatNetwork build_classic(uint32_t candidates, uint32_t grid, const InputShape& inputs, uint64_t seed,
                           uint32_t block_layers = 1);

// The network whose logits are prior + strength * (logits - prior), where prior is the untrained `field`, the heat
// binder. Other architectures have no prior: they are returned as they are.
FloatNetwork shrink_correction(const FloatNetwork& network, double strength, uint32_t log_rule);

}  // namespace sinew
#endif
