// SPDX-License-Identifier: MIT
// Networks with seeded initial weights: skin weights' for any number of input features (make_field() and make_classic() call these
// with the engine's), the votes', the front's; and what changes a network's weights as a whole.
#ifndef SINEW_TRAINER_NETWORK_NETWORKS_HPP
#define SINEW_TRAINER_NETWORK_NETWORKS_HPP

#include <string>

#include "sinew_formats/float_network.hpp"
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

struct RigNetworkOptions {
  uint32_t width = 64;
  uint32_t rounds = 4;  // of neighbors
  bool hands = false;   // for hands' crops, not bodies
};
// Seeded initial weights. Every point of a set gets kRigOutputs numbers (votes/rig_task.hpp of the engine):
//   h = relu(L x); per round u = relu(L h), z = relu(L [h, max of near u, max of far u, max of all u]), h = z (+ h from the
//   second on); at the end relu(L [h, h after two rounds, max and mean of all h]), relu(L), L.
FloatNetwork make_rig_network(const RigNetworkOptions& options, uint64_t seed);

// A network of the front: every point alone, and the sum over all points.
struct FrontNetworkOptions {
  uint32_t width = 64;  // channels
  uint32_t rounds = 2;  // of all points' largest and mean values
};
FloatNetwork make_front_network(const FrontNetworkOptions& options, uint64_t seed);

// The same architecture with as many channels in hidden buffers or more, and the same inputs and outputs.
bool is_wider(const FloatNetwork& wide, const FloatNetwork& narrow);

// Puts the narrow network's weights into the wide one, which then computes the same: added channels keep the weights that they are
// made of (random ones) and are read with zeros by the others, as in growing networks (Chen, Goodfellow, Shlens 2016, "Net2Net", with
// random channels instead of copies: they differ from the start). Throws Error unless is_wider().
//   source  begins the message: the narrow network's file
void widen(const FloatNetwork& narrow, const std::string& source, FloatNetwork* wide);

}  // namespace sinew
#endif
