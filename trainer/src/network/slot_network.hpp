// SPDX-License-Identifier: MIT
// The published method for skeletons, two networks as one: where joints are, and which of them hang together.
#ifndef SINEW_TRAINER_NETWORK_SLOT_NETWORK_HPP
#define SINEW_TRAINER_NETWORK_SLOT_NETWORK_HPP

#include <memory>
#include <string>
#include <vector>

#include "network/layer_runner.hpp"
#include "sinew_formats/float_network.hpp"
#include "sinew_trainer/joint_slots.hpp"

namespace sinew {

constexpr uint32_t kSlotFeatureSet = 2;  // of the rig task; 1 is that of votes
// What the runner returns: [kSlots x kSlotNumbers], then the probability of every pair to hang together [kSlotPairs].
constexpr uint32_t kSlotOutputs = kSlots * kSlotNumbers + kSlotPairs;

struct SlotNetworkOptions {
  uint32_t width = 24;  // of the first graph convolution; the next has twice as many channels, the others four times
  uint32_t rounds = 4;  // graph convolutions
};

// Seeded initial weights. The layer list is the graph part alone, over a mesh's vertices and edges:
//   h = relu(L [h, mean of h over neighbours]) per round; output: the largest of each round's h over all vertices, side by
//   side, g, the same row for every vertex.
// Five blocks of parameters follow those of the list:
//   first network   joint vectors = L relu(L g)
//   second network  for slots i < j: L relu(L relu(L [d, |d|, i, j, g])), d the offset vector from joint i to joint j, i and
//                   j as 1 among kSlots zeros
FloatNetwork make_slot_network(const SlotNetworkOptions& options, uint64_t seed);

// Throws Error unless the list is sound and the blocks behind it fit together.
void check_slot_network(const FloatNetwork& network, const std::string& source);

// Both networks on one sample; gradients of the second flow on through the joints' places. `shape` has passed
// check_slot_network(). Dropout is for the hidden row of the first network alone.
template <class Scalar>
class SlotRunner : public SampleRunner<Scalar> {
 public:
  SlotRunner();
  ~SlotRunner() override;

  void set_team(Team* team) override;
  // [kSlotOutputs]
  const std::vector<Scalar>& forward(const FloatNetwork& shape, const std::vector<LinearBlock<Scalar>>& parameters,
                                     const NetworkSample& sample, const DropoutOptions& dropout) override;
  void backward(const FloatNetwork& shape, const std::vector<LinearBlock<Scalar>>& parameters,
                const std::vector<Scalar>& d_outputs, std::vector<LinearBlock<Scalar>>* gradients) override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

extern template class SlotRunner<float>;
extern template class SlotRunner<double>;

}  // namespace sinew
#endif
