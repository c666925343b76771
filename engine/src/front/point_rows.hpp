// SPDX-License-Identifier: MIT
// The rows of a set of points for a network, beside their features.
#ifndef SINEW_FRONT_POINT_ROWS_HPP
#define SINEW_FRONT_POINT_ROWS_HPP

#include "core/counts.hpp"
#include "front/surface_points.hpp"
#include "network/network.hpp"

namespace sinew::rigging {

// Other inputs of the network: one part, no candidates.
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
  //   neighbors  of each point; 0: none
  void fill(uint32_t neighbors) {
    part_offsets[0] = 0;
    part_offsets[1] = kSetPoints;
    for (uint32_t i = 0; i < kSetPoints; ++i) {
      joints[i] = kNoJoint;
      part[i] = 0;
      part_vertices[i] = i;
    }
    for (uint32_t i = 0; i <= kSetPoints; ++i) offsets[i] = i * neighbors;
  }
  // The input for points without neighbors.
  NetworkInput input(const int16_t* features) const { return input(features, part_vertices, part_vertices); }
  NetworkInput input(const int16_t* features, const uint32_t* near_neighbors, const uint32_t* far_neighbors) const {
    NetworkInput input;
    input.vertex_count = kSetPoints;
    input.candidate_count = 1;
    input.inputs[0] = features;
    input.joints = joints;
    input.row_offsets = input.far_offsets = offsets;
    input.col_indices = near_neighbors;
    input.far_indices = far_neighbors;
    input.part = part;
    input.part_offsets = part_offsets;
    input.part_vertices = part_vertices;
    input.part_count = 1;
    input.joint_count = 1;
    return input;
  }
};

}  // namespace sinew::rigging
#endif
