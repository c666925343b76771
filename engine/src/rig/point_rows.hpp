// SPDX-License-Identifier: MIT
// A set of points as the input of a network.
#ifndef SINEW_RIG_POINT_ROWS_HPP
#define SINEW_RIG_POINT_ROWS_HPP

#include "core/counts.hpp"
#include "network/network.hpp"
#include "rig/rig_points.hpp"

namespace sinew {

// What the network wants beside the points: one part, no candidates.
struct PointRows {
  uint16_t* joints;  // [kSetPoints]
  uint32_t *part, *part_offsets, *part_vertices, *offsets;

  bool allocate(Arena& arena) {
    joints = arena.alloc<uint16_t>(kSetPoints);
    part = arena.alloc<uint32_t>(kSetPoints);
    part_offsets = arena.alloc<uint32_t>(2);
    part_vertices = arena.alloc<uint32_t>(kSetPoints);
    offsets = arena.alloc<uint32_t>(kSetPoints + 1);
    return arena.ok();
  }
  void fill() {
    part_offsets[0] = 0;
    part_offsets[1] = kSetPoints;
    for (uint32_t i = 0; i < kSetPoints; ++i) {
      joints[i] = kNoJoint;
      part[i] = 0;
      part_vertices[i] = i;
    }
    for (uint32_t i = 0; i <= kSetPoints; ++i) offsets[i] = i * kNeighbours;
  }
  NetworkInput input(const PointSet& set) const {
    NetworkInput input;
    input.vertex_count = kSetPoints;
    input.candidate_count = 1;
    input.inputs[0] = set.features;
    input.joints = joints;
    input.row_offsets = input.far_offsets = offsets;
    input.col_indices = set.near_neighbours;
    input.far_indices = set.far_neighbours;
    input.part = part;
    input.part_offsets = part_offsets;
    input.part_vertices = part_vertices;
    input.part_count = 1;
    input.joint_count = 1;
    return input;
  }
};

}  // namespace sinew
#endif
