// SPDX-License-Identifier: MIT
// Samples of the published method: a mesh as the graph of its own vertices and edges, with joints in slots.
#ifndef SINEW_TRAINER_DATA_SLOT_SAMPLE_HPP
#define SINEW_TRAINER_DATA_SLOT_SAMPLE_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "data/engine_mesh.hpp"
#include "data/rig_sample.hpp"
#include "sinew_trainer/joint_slots.hpp"
#include "sinew_trainer/network_sample.hpp"

namespace sinew {

// Meshes of more vertices are decimated to about as many: how far a graph convolution reaches hangs on the density.
constexpr uint32_t kSlotVertices = 800;

// Inputs of a vertex: twice its place in the mirror frame, longest sides (3), and its normal (3).
constexpr uint32_t kSlotChannels = 6;

// What the first network is to say of each slot, and the second of each two.
struct SlotSample : NetworkSample {
  std::vector<float> joints;              // [kSlots x 4] place in the mirror frame, offset from the skin; longest sides
  std::array<uint8_t, kSlots> present{};  // 1: the slot holds a joint; without one its joint is 0
  std::array<uint8_t, kSlotPairs> connected{};
};

// Decimated if there are more than kSlotVertices.
Character for_slots(const Character& character);
// Rows and neighbours of a mesh that is in its mirror frame, one row for every welded vertex.
void fill_slot_graph(const Mesh& mesh, NetworkSample* sample);
// Distance from a place to the nearest vertex, longest sides.
double skin_offset(const Mesh& mesh, const std::array<double, 3>& position);
// As RigSource::make(). Throws Error for a skeleton without two joints that slots are for.
SlotSample make_slot_sample(const RigSource& source, uint64_t seed, double strength);

}  // namespace sinew
#endif
