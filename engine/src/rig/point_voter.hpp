// SPDX-License-Identifier: MIT
// A body's interior, sets of points, and what a network says of them: one memory for all sets of a mesh.
#ifndef SINEW_RIG_POINT_VOTER_HPP
#define SINEW_RIG_POINT_VOTER_HPP

#include "core/counts.hpp"
#include "network/network.hpp"
#include "rig/rig_points.hpp"
#include "rig/rig_task.hpp"

namespace sinew::rigging {

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
  //   neighbours  of each point; 0: none
  void fill(uint32_t neighbours) {
    part_offsets[0] = 0;
    part_offsets[1] = kSetPoints;
    for (uint32_t i = 0; i < kSetPoints; ++i) {
      joints[i] = kNoJoint;
      part[i] = 0;
      part_vertices[i] = i;
    }
    for (uint32_t i = 0; i <= kSetPoints; ++i) offsets[i] = i * neighbours;
  }
  // Of points without neighbours.
  NetworkInput input(const int16_t* features) const {
    NetworkInput input;
    input.vertex_count = kSetPoints;
    input.candidate_count = 1;
    input.inputs[0] = features;
    input.joints = joints;
    input.row_offsets = input.far_offsets = offsets;
    input.col_indices = input.far_indices = part_vertices;
    input.part = part;
    input.part_offsets = part_offsets;
    input.part_vertices = part_vertices;
    input.part_count = 1;
    input.joint_count = 1;
    return input;
  }
  NetworkInput input(const PointSet& set) const {
    NetworkInput input = this->input(set.features);
    input.col_indices = set.near_neighbours;
    input.far_indices = set.far_neighbours;
    return input;
  }
};

// Another network in the model's place, for measuring one in float: fills [kSetPoints x kRigOutputs] rows of a set.
struct OtherNetwork {
  sinew_status (*run)(void* user, const PointSet& set, int16_t* rows) = nullptr;
  void* user = nullptr;
};

struct PointVoter {
  Interior interior;
  PointSet set;
  PointRows rows = {};
  int16_t* outputs = nullptr;  // [kSetPoints x kRigOutputs] what the network said of the last set
  OtherNetwork other = {};

  bool allocate(Arena& arena) {
    (void)interior.allocate(arena);
    (void)set.allocate(arena);
    (void)rows.allocate(arena);
    outputs = arena.alloc<int16_t>(size_t{kSetPoints} * kRigOutputs);
    if (arena.ok() && !arena.measuring()) rows.fill(kNeighbours);
    return arena.ok();
  }
  // Makes set `index` of a mesh whose interior is built, and the network's rows for it.
  sinew_status run(const sinew_model& model, const NetworkOptions& options, const Kernels& kernels, const Mesh& mesh,
                   uint32_t index, const Progress& progress, Arena& arena) {
    constexpr uint64_t kFirstSeed = 7;
    if (!make_point_set(mesh, interior, kFirstSeed + index, arena, &set)) return SINEW_ERROR_WORKSPACE;
    if (other.run != nullptr && !arena.measuring()) return other.run(other.user, set, outputs);
    return run_network(model, rows.input(set), kernels, progress, arena, outputs, options);
  }
};

}  // namespace sinew::rigging
#endif
