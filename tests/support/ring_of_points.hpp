// SPDX-License-Identifier: MIT
// Points in a ring with random rows, as networks of skeletons see a surface.
#ifndef SINEW_TESTS_SUPPORT_RING_OF_POINTS_HPP
#define SINEW_TESTS_SUPPORT_RING_OF_POINTS_HPP

#include <cstdint>
#include <random>

#include "sinew_trainer/sample.hpp"
#include "votes/rig_task.hpp"

namespace sinew {

inline NetworkSample ring_of_points(uint32_t vertices, uint64_t seed) {
  std::mt19937_64 random(seed);
  NetworkSample s;
  s.name = "ring";
  s.vertices = vertices;
  s.candidates = s.part_count = s.joints = 1;
  s.inputs = {{rigging::kRigChannels, {}}};
  s.row_offsets = {0};
  s.part_offsets = {0, vertices};
  for (uint32_t v = 0; v < vertices; ++v) {
    for (uint32_t c = 0; c < rigging::kRigChannels; ++c)
      s.inputs[0].rows.push_back(static_cast<int16_t>(static_cast<int>(random() % 16001) - 8000));
    s.col_indices.insert(s.col_indices.end(), {(v + 1) % vertices, (v + vertices - 1) % vertices});
    s.row_offsets.push_back(static_cast<uint32_t>(s.col_indices.size()));
    s.candidate.push_back(0);
    s.far_indices.insert(s.far_indices.end(), {(v + 5) % vertices, (v + 9) % vertices});
    s.part.push_back(0);
    s.part_vertices.push_back(v);
  }
  s.far_offsets = s.row_offsets;
  return s;
}

}  // namespace sinew
#endif
