// SPDX-License-Identifier: MIT
// Mesh to graph, target skeleton to slots.
#include "data/slot_sample.hpp"

#include <algorithm>
#include <cmath>

#include "features/features.hpp"
#include "sinew_datasets/dataset.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

Character for_slots(const Character& character) {
  const size_t vertices = character.vertices.size();
  if (vertices <= kSlotVertices || character.face_count() == 0) return character;
  return decimate(character, static_cast<double>(kSlotVertices) / static_cast<double>(vertices));
}

void fill_slot_graph(const Mesh& mesh, NetworkSample* sample) {
  NetworkSample& s = *sample;
  const uint32_t n = mesh.welded_count;
  s.vertices = n;
  s.candidates = 1;
  s.part_count = 1;
  s.joints = 1;
  s.inputs.resize(1);
  s.inputs[0].channels = kSlotChannels;
  const auto put = [&](double value) {
    s.inputs[0].rows.push_back(
        static_cast<int16_t>(std::clamp(std::lround(value * (1 << kFeatureBits)), -32767L, 32767L)));
  };
  for (uint32_t v = 0; v < n; ++v) {
    const Vec3i p = mesh.positions[v], normal = mesh.normals[v];
    for (const int32_t x : {p.x, p.y, p.z}) put(2.0 * x / kSide);
    for (const int32_t x : {normal.x, normal.y, normal.z}) put(static_cast<double>(x) / (1 << kNormalBits));
    s.part_vertices.push_back(v);
  }
  s.candidate.assign(n, 0xFFFF);
  s.part.assign(n, 0);
  s.part_offsets = {0, n};
  s.row_offsets.assign(mesh.row_offsets, mesh.row_offsets + n + 1);
  s.col_indices.assign(mesh.col_indices, mesh.col_indices + mesh.row_offsets[n]);
}

double skin_offset(const Mesh& mesh, const std::array<double, 3>& position) {
  double least = 1e30;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    const Vec3i p = mesh.positions[v];
    const double x = position[0] - static_cast<double>(p.x) / kSide, y = position[1] - static_cast<double>(p.y) / kSide,
                 z = position[2] - static_cast<double>(p.z) / kSide;
    least = std::min(least, x * x + y * y + z * z);
  }
  return std::sqrt(least);
}

SlotSample make_slot_sample(const RigSource& source, uint64_t seed, double strength) {
  const RigSource::Placed placed = source.make_mesh(seed, strength);
  SlotSample s;
  s.name = source.name();
  s.family = source.family();
  fill_slot_graph(placed.engine.mesh, &s);
  const std::array<int, kSlots> held = assign_slots(source.target(), placed.joints);
  if (std::count_if(held.begin(), held.end(), [](int joint) { return joint >= 0; }) < 2)
    throw Error(source.name() + ": no two joints that there are slots for (trainer/README.md)");
  connected_slots(source.target(), held, &s.connected);
  s.joints.assign(size_t{kSlots} * 4, 0.0f);
  for (uint32_t slot = 0; slot < kSlots; ++slot) {
    if (held[slot] < 0) continue;
    s.present[slot] = 1;
    const RigSource::Point& position = placed.joints[static_cast<size_t>(held[slot])];
    for (uint32_t c = 0; c < 3; ++c) s.joints[4 * slot + c] = static_cast<float>(position[c]);
    s.joints[4 * slot + kSlotOffset] = static_cast<float>(skin_offset(placed.engine.mesh, position));
  }
  return s;
}

}  // namespace sinew
