// SPDX-License-Identifier: MIT
// Mesh to graph, target skeleton to slots.
#include "data/slot_sample.hpp"

#include <algorithm>
#include <cmath>

#include "data/point_sample.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

using namespace rigging;

NetworkSample slot_points(const PointSet& set) {
  NetworkSample s = point_sample(set);
  unfold_features(set, s.inputs[0].rows.data());
  s.candidate.assign(kSetPoints, 0);
  return s;
}

double skin_offset(const NetworkSample& sample, const std::array<double, 3>& position) {
  double least = 1e30;
  for (uint32_t v = 0; v < sample.vertices; ++v) {
    const int16_t* const row = &sample.inputs[0].rows[size_t{v} * kRigChannels];
    double squared = 0;
    for (size_t c = 0; c < 3; ++c) {
      const double d = position[c] - row[kRigPosition + c] / kPositionSteps;
      squared += d * d;
    }
    least = std::min(least, squared);
  }
  return std::sqrt(least);
}

SlotSample make_slot_sample(const RigSource& source, uint64_t seed, double strength) {
  const RigSource::PosedMesh posed_mesh = source.make_mesh(seed, {.strength = strength});
  SlotSample s;
  with_point_set(posed_mesh.engine, seed,
                 [&](const PointSet& set) { static_cast<NetworkSample&>(s) = slot_points(set); });
  s.name = source.name();
  s.family = source.family();
  const std::array<int, kSlots> held = assign_slots(source.target(), posed_mesh.joints);
  if (std::count_if(held.begin(), held.end(), [](int joint) { return joint >= 0; }) < 2)
    throw Error(source.name() + ": no two joints that there are slots for (trainer/README.md)");
  connected_slots(source.target(), held, &s.connected);
  s.joints.assign(size_t{kSlots} * 4, 0.0f);
  for (uint32_t slot = 0; slot < kSlots; ++slot) {
    if (held[slot] < 0) continue;
    s.present[slot] = 1;
    const Point3& position = posed_mesh.joints[static_cast<size_t>(held[slot])];
    for (uint32_t c = 0; c < 3; ++c) s.joints[4 * slot + c] = static_cast<float>(position[c]);
    s.joints[4 * slot + kSlotOffset] = static_cast<float>(skin_offset(s, position));
  }
  return s;
}

}  // namespace sinew
