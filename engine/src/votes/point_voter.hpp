// SPDX-License-Identifier: MIT
// A body's interior, sets of points, and what a network says of them: one memory for all sets of a mesh.
#ifndef SINEW_VOTES_POINT_VOTER_HPP
#define SINEW_VOTES_POINT_VOTER_HPP

#include "front/point_rows.hpp"
#include "votes/rig_points.hpp"
#include "votes/rig_task.hpp"

namespace sinew::rigging {

// Another network instead of the model's, for measuring one in float: fills [kSetPoints x kRigOutputs] rows of a set.
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
    if (arena.ok() && !arena.measuring()) rows.fill(kNeighbors);
    return arena.ok();
  }
  // Makes set `index` of a mesh whose interior is built, and the network's rows for it.
  sinew_status run(const sinew_model& model, const NetworkOptions& options, const Kernels& kernels, const Mesh& mesh,
                   uint32_t index, const Progress& progress, Arena& arena) {
    constexpr uint64_t kFirstSeed = 7;
    if (!make_point_set(mesh, interior, kFirstSeed + index, arena, &set)) return SINEW_ERROR_WORKSPACE;
    if (other.run != nullptr && !arena.measuring()) return other.run(other.user, set, outputs);
    return run_network(model, rows.input(set.features, set.near_neighbors, set.far_neighbors), kernels, progress, arena,
                       outputs, options);
  }
};

}  // namespace sinew::rigging
#endif
