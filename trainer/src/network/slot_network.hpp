// SPDX-License-Identifier: MIT
// The published method for skeletons, two networks as one: where joints are, and which of them are connected.
#ifndef SINEW_TRAINER_NETWORK_SLOT_NETWORK_HPP
#define SINEW_TRAINER_NETWORK_SLOT_NETWORK_HPP

#include <memory>
#include <string>
#include <vector>

#include "network/layer_runner.hpp"
#include "published/joint_slots.hpp"
#include "sinew_formats/float_network.hpp"

namespace sinew {

// The joint vector of a slot: position in the mirror frame (3) and offset from the skin, its length; all in longest sides. Then,
// of what a network says, how likely the slot holds a joint, 0 to 1.
constexpr uint32_t kSlotOffset = 3, kSlotPresence = 4, kSlotNumbers = 5;

// The runner's output: [kSlots x kSlotNumbers], then the probability of every pair to be connected
// [rigging::kSlotPairs].
constexpr uint32_t kSlotOutputs = rigging::kSlots * kSlotNumbers + rigging::kSlotPairs;

struct SlotNetworkOptions {
  uint32_t width = 48;  // of graph convolutions
  uint32_t rounds = 4;  // graph convolutions of the first network; the second has two of its own, of half the width
};

// Seeded initial weights. The layer list has both networks' graph part, over points of the surface; its output is written in
// the engine's published/joint_slots.hpp:
//   first network   h = relu(L [h, mean of h over near points, largest h of far ones]) per round; g = relu(L of the largest
//                   h of all rounds over all points); of every point L relu(L [h of the first and last round, g, its input])
//   second network  its own two rounds h = relu(L [h, mean of h over near points]); L of the largest h over all points
// A joint is the mean of all points and their offsets, by the slot's softmax over the points. Three blocks of parameters follow
// those of the list: for slots i < j, L relu(L relu(L [d, |d|, i, j, mesh's row])), d the offset vector from joint i to
// joint j, i and j as 1 among kSlots zeros.
FloatNetwork make_slot_network(const SlotNetworkOptions& options, uint64_t seed);

// The layer list alone, and the blocks behind it as a list, each a network that the quantizer takes.
FloatNetwork joint_network(const FloatNetwork& both);
FloatNetwork connection_network(const FloatNetwork& both);

// Throws Error unless the list is sound and the blocks behind it fit together.
void check_slot_network(const FloatNetwork& network, const std::string& source);

// Both networks on one sample; gradients of the second flow on through the joints' positions. `shape` has passed
// check_slot_network(). Dropout is the layer list's.
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
