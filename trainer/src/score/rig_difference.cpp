// SPDX-License-Identifier: MIT
// Runs both networks on the same points: votes, fronts, and the published method's slots.
#include "sinew_trainer/rig_difference.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "data/front_sample.hpp"
#include "data/hand_sample.hpp"
#include "data/slot_sample.hpp"
#include "network/slot_network.hpp"
#include "published/slots.hpp"
#include "run/rig_loss.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/engine_network.hpp"
#include "sinew_trainer/network.hpp"
#include "votes/rig_task.hpp"

namespace sinew {
namespace {

using namespace rigging;

// Calls `use` with characters of a folder, spread over its list, and their numbers in the order of the list.
//   limit  at most so many; 0 = all
//   use    true: something was made of it. An Error that it throws leaves the character out
// Throws Error, the last one, where nothing was made of any.
void each_of_some_characters(const std::string& folder, size_t limit,
                             const std::function<bool(const Character&, size_t)>& use) {
  const std::vector<std::string> paths = list_characters(folder);
  const size_t count = limit == 0 ? paths.size() : std::min(limit, paths.size());
  bool used = false;
  std::string last = folder + ": no characters (NAME.obj with NAME.rig.txt, or .glb)";
  for (size_t i = 0; i < count; ++i) {
    try {
      used = use(read_character(paths[i * paths.size() / count]), i) || used;
    } catch (const Error& error) {
      last = error.what();
    }
  }
  if (!used) throw Error(last);
}

std::vector<RigSample> vote_samples(const FloatNetwork& network, const std::string& folder, size_t limit) {
  std::vector<RigSample> samples;
  each_of_some_characters(folder, limit, [&](const Character& character, size_t i) {
    const size_t before = samples.size();
    if (network.feature_set != kHandsFeatureSet) {
      samples.push_back(RigSource(character).make(i, {}));
      return true;
    }
    for (const HandSource& hand : hand_sources(character)) {
      std::optional<RigSample> sample = hand.make(i, 0);
      if (sample) samples.push_back(std::move(*sample));
    }
    return samples.size() > before;
  });
  return samples;
}

template <class T>
uint32_t most_likely(const T* logits, uint32_t count) {
  return static_cast<uint32_t>(std::max_element(logits, logits + count) - logits);
}

std::vector<FrontSample> front_samples(const std::string& folder, size_t limit) {
  std::vector<FrontSample> samples;
  each_of_some_characters(folder, limit, [&](const Character& character, size_t i) {
    for (FrontSample& sample : FrontSource(character).make(i, {.strength = 1})) samples.push_back(std::move(sample));
    return true;
  });
  return samples;
}

}  // namespace

Calibration calibrate_rig(const FloatNetwork& network, const std::string& folder, size_t limit) {
  return calibrate(network, vote_samples(network, folder, limit));
}

VoteDifference compare_votes(const FloatNetwork& network, const sinew_model& model, const std::string& folder,
                             size_t limit) {
  VoteDifference difference;
  NetworkRunner runner;
  size_t votes = 0;
  for (const RigSample& sample : vote_samples(network, folder, limit)) {
    const std::vector<float>& exact = runner.forward(network, sample);
    const std::vector<int16_t> rows = engine_rows(model, sample, size_t{sample.vertices} * kRigOutputs);
    ++difference.characters;
    for (uint32_t i = 0; i < sample.vertices; ++i) {
      const float* const a = &exact[size_t{i} * kRigOutputs];
      const int16_t* const b = &rows[size_t{i} * kRigOutputs];
      for (const uint32_t end : {static_cast<uint32_t>(kRigStart), static_cast<uint32_t>(kRigEnd)}) {
        double squared = 0;
        for (uint32_t axis = 0; axis < 3; ++axis) {
          const double e = static_cast<double>(a[end + axis]) - b[end + axis] / 1024.0;
          squared += e * e;
        }
        const double distance = std::sqrt(squared) / kRigOffsetScale;
        difference.mean += distance;
        difference.most = std::max(difference.most, distance);
        ++votes;
      }
      difference.same_class +=
          most_likely(a + kRigStartClass, kJointClasses) == most_likely(b + kRigStartClass, kJointClasses);
      difference.same_class += most_likely(a + kRigEndClass, kEndClasses) == most_likely(b + kRigEndClass, kEndClasses);
    }
  }
  difference.mean /= static_cast<double>(votes);
  difference.same_class /= static_cast<double>(votes);
  return difference;
}

Calibration calibrate_front(const FloatNetwork& network, const std::string& folder, size_t limit) {
  return calibrate(network, front_samples(folder, limit));
}

FrontDifference compare_fronts(const FloatNetwork& network, const sinew_model& model, const std::string& folder,
                               size_t limit) {
  FrontDifference difference;
  NetworkRunner runner;
  size_t answers = 0;
  for (const FrontSample& sample : front_samples(folder, limit)) {
    const FrontLoss exact = front_loss(sample, runner.forward(network, sample), nullptr);
    std::vector<float> integers;
    for (const int16_t value : engine_rows(model, sample, size_t{sample.vertices} * rigging::kFrontOutputs))
      integers.push_back(static_cast<float>(value) / 1024.0f);
    const FrontLoss rounded = front_loss(sample, integers, nullptr);
    const double distance = std::hypot(exact.answer[0] - rounded.answer[0], exact.answer[1] - rounded.answer[1]);
    difference.mean += distance;
    difference.most = std::max(difference.most, distance);
    ++answers;
  }
  constexpr size_t kSamplesEach = 3;
  difference.characters = answers / kSamplesEach;
  difference.mean /= static_cast<double>(answers);
  return difference;
}

namespace {

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

// The float output for a set, as the second network reads it.
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
