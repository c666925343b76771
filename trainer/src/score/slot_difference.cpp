// SPDX-License-Identifier: MIT
// Runs both networks of the published method, in float and in integers, on the same points.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "data/slot_sample.hpp"
#include "data/some_characters.hpp"
#include "network/slot_network.hpp"
#include "published/slots.hpp"
#include "sinew_trainer/calibrate.hpp"
#include "sinew_trainer/network_input.hpp"
#include "sinew_trainer/rig_difference.hpp"

namespace sinew {
namespace {

using namespace rigging;

// Calls `use` with the points of each character.
void each_set(const std::string& folder, size_t limit, const std::function<void(const PointSet&)>& use) {
  each_of_some_characters(folder, limit, [&](const Character& character, size_t i) {
    with_point_set(RigSource(character).make_mesh(i, {}).engine, i, use);
    return true;
  });
}

NetworkSample pair_sample(const SlotJoints& joints) {
  NetworkSample s;
  s.vertices = kSlotPairs;
  s.candidates = s.part_count = s.joints = 1;
  s.inputs = {{kPairChannels, std::vector<int16_t>(size_t{kSlotPairs} * kPairChannels)}};
  pair_rows(joints, s.inputs[0].rows.data());
  s.candidate.assign(kSlotPairs, 0);
  s.part.assign(kSlotPairs, 0);
  s.part_offsets = {0, kSlotPairs};
  for (uint32_t i = 0; i < kSlotPairs; ++i) s.part_vertices.push_back(i);
  s.row_offsets.assign(kSlotPairs + 1, 0);
  s.far_offsets = s.row_offsets;
  return s;
}

// What float says of a set, as the second network reads it.
SlotJoints float_joints(const std::vector<float>& outputs, const std::vector<float>& rows) {
  SlotJoints joints = {};
  const auto grid = [&](uint32_t slot, uint32_t axis) {
    return static_cast<int32_t>(std::lround(static_cast<double>(outputs[slot * kSlotNumbers + axis]) * kSide));
  };
  for (uint32_t slot = 0; slot < kSlots; ++slot) joints.positions[slot] = {grid(slot, 0), grid(slot, 1), grid(slot, 2)};
  for (uint32_t c = 0; c < kMeshChannels; ++c)
    joints.mesh[c] = static_cast<int32_t>(std::lround(static_cast<double>(rows[kMeshRow + c]) * 1024));
  return joints;
}

SlotJoints engine_joints(const sinew_model& model, const sinew_model& connections, const PointSet& set) {
  const std::vector<int16_t> rows = engine_rows(model, slot_points(set), size_t{kSetPoints} * kSlotRow);
  std::vector<int64_t> attention(kSetPoints);
  SlotJoints joints = {};
  add_slot_joints(set.points, rows.data(), attention.data(), &joints);
  const std::vector<int16_t> logits = engine_rows(connections, pair_sample(joints), kSlotPairs);
  std::copy(logits.begin(), logits.end(), joints.connection);
  return joints;
}

}  // namespace

SlotNetworks calibrate_slots(const FloatNetwork& both, const std::string& folder, size_t limit) {
  check_slot_network(both, folder);
  SlotNetworks networks{joint_network(both), connection_network(both), {}, {}};
  std::vector<NetworkSample> points, pairs;
  SlotRunner<float> runner;
  LayerRunner<float> list;
  const auto parameters = copy_blocks<float>(both);
  each_set(folder, limit, [&](const PointSet& set) {
    points.push_back(slot_points(set));
    const std::vector<float> outputs = runner.forward(both, parameters, points.back(), {});
    pairs.push_back(pair_sample(float_joints(outputs, list.forward(both, parameters, points.back(), {}))));
  });
  networks.joint_ranges = calibrate(networks.joints, points);
  networks.connection_ranges = calibrate(networks.connections, pairs);
  return networks;
}

SlotDifference compare_slots(const FloatNetwork& both, const sinew_model& model, const std::string& folder,
                             size_t limit) {
  SlotDifference difference;
  const sinew_model connections = connections_of(model);
  SlotRunner<float> runner;
  const auto parameters = copy_blocks<float>(both);
  size_t joints = 0, pairs = 0;
  each_set(folder, limit, [&](const PointSet& set) {
    const std::vector<float>& exact = runner.forward(both, parameters, slot_points(set), {});
    const SlotJoints integers = engine_joints(model, connections, set);
    ++difference.characters;
    const auto there = [&](uint32_t slot) { return exact[slot * kSlotNumbers + kSlotPresence] > 0.5f; };
    for (uint32_t i = 0; i < kSlots; ++i) {
      difference.same_presence += there(i) == (integers.presence[i] > 0) ? 1.0 : 0.0;
      if (!there(i)) continue;
      const double p[3] = {static_cast<double>(integers.positions[i].x), static_cast<double>(integers.positions[i].y),
                           static_cast<double>(integers.positions[i].z)};
      double squared = 0;
      for (uint32_t c = 0; c < 3; ++c) {
        const double e = static_cast<double>(exact[i * kSlotNumbers + c]) - p[c] / kSide;
        squared += e * e;
      }
      difference.mean += std::sqrt(squared);
      difference.most = std::max(difference.most, std::sqrt(squared));
      ++joints;
      for (uint32_t j = i + 1; j < kSlots; ++j) {
        if (!there(j)) continue;
        const bool hang = exact[kSlots * kSlotNumbers + slot_pair(i, j)] > 0.5f;
        difference.same_connections += hang == (integers.connection[slot_pair(i, j)] > 0) ? 1.0 : 0.0;
        ++pairs;
      }
    }
  });
  difference.mean /= static_cast<double>(std::max<size_t>(joints, 1));
  difference.same_presence /= static_cast<double>(difference.characters * kSlots);
  difference.same_connections /= static_cast<double>(std::max<size_t>(pairs, 1));
  return difference;
}

}  // namespace sinew
