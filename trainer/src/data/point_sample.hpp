// SPDX-License-Identifier: MIT
// A set of points as a network's sample: what it reads, without what it should say.
#ifndef SINEW_TRAINER_DATA_POINT_SAMPLE_HPP
#define SINEW_TRAINER_DATA_POINT_SAMPLE_HPP

#include "data/rig_sample.hpp"
#include "votes/rig_points.hpp"

namespace sinew {

inline RigSample point_sample(const rigging::PointSet& set) {
  using namespace rigging;
  RigSample s;
  s.vertices = kSetPoints;
  s.candidates = 1;
  s.part_count = 1;
  s.joints = 1;
  s.inputs.resize(1);
  s.inputs[0].channels = kRigChannels;
  s.inputs[0].rows.assign(set.features, set.features + size_t{kSetPoints} * kRigChannels);
  s.candidate.assign(kSetPoints, 0xFFFF);
  s.part.assign(kSetPoints, 0);
  s.part_offsets = {0, kSetPoints};
  for (uint32_t i = 0; i <= kSetPoints; ++i) {
    if (i < kSetPoints) s.part_vertices.push_back(i);
    s.row_offsets.push_back(i * kNeighbours);
  }
  s.far_offsets = s.row_offsets;
  s.col_indices.assign(set.near_neighbours, set.near_neighbours + size_t{kSetPoints} * kNeighbours);
  s.far_indices.assign(set.far_neighbours, set.far_neighbours + size_t{kSetPoints} * kNeighbours);
  return s;
}

}  // namespace sinew
#endif
