// SPDX-License-Identifier: MIT
// Samples of the published method: a mesh as a graph of points of its surface, with joints in slots.
#ifndef SINEW_TRAINER_DATA_SLOT_SAMPLE_HPP
#define SINEW_TRAINER_DATA_SLOT_SAMPLE_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "data/rig_sample.hpp"
#include "sinew_trainer/joint_slots.hpp"
#include "sinew_trainer/network_sample.hpp"

namespace sinew {

// Steps of a point's position in its row (kRigPosition) in a longest side: twice the position, Q13.
constexpr double kPositionSteps = 16384;

// What the first network is to say of each slot, and the second of each two.
struct SlotSample : NetworkSample {
  std::vector<float> joints;  // [kSlots x 4] position in the mirror frame, offset from the skin; longest sides
  std::array<uint8_t, rigging::kSlots> present{};  // 1: the slot holds a joint; without one its joint is 0
  std::array<uint8_t, rigging::kSlotPairs> connected{};
};

// A set of points as both networks' sample: rows are not folded, and every point has one slot, which is present.
NetworkSample slot_points(const rigging::PointSet& set);
// Distance from a position to the nearest point of a sample of slot_points(), longest sides.
double skin_offset(const NetworkSample& sample, const std::array<double, 3>& position);
// As RigSource::make(). Throws Error for a skeleton without two joints that slots are for.
SlotSample make_slot_sample(const RigSource& source, uint64_t seed, double strength);

}  // namespace sinew
#endif
