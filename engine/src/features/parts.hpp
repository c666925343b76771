// SPDX-License-Identifier: MIT
// Stage 5 of a bind: classifies each part and finds its parent.
#ifndef SINEW_FEATURES_PARTS_HPP
#define SINEW_FEATURES_PARTS_HPP

#include "heat/heat.hpp"
#include "mesh/mesh.hpp"

namespace sinew {

constexpr uint32_t kNoVertex = 0xFFFFFFFFu;

struct Parts {
  uint32_t* host_vertex = nullptr;     // [U] nearest vertex of a part with more vertices (a smaller part id),
                                       // ties: lower index; kNoVertex in the first part
  uint32_t* host_distance = nullptr;   // [U] Euclid, grid units; 0 where there is no host vertex
  uint32_t* source_count = nullptr;    // [parts] vertices that are heat sources in the rule field
  uint32_t* boundary_count = nullptr;  // [parts] vertices on an open boundary
  Vec3i* box_min = nullptr;            // [parts] bounding box, grid units
  Vec3i* box_max = nullptr;

  bool allocate(Arena& arena, const Counts& counts);
};

// The nearest vertex of a larger part for every vertex, see Parts. Scratch is taken from the arena and released.
//   host_vertex, host_distance  out [U]
// Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status find_hosts(const Mesh& mesh, const Counts& counts, Arena& arena, uint32_t* host_vertex,
                        uint32_t* host_distance);

// All of it. Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status find_parts(const Mesh& mesh, const HeatFields& heat, const Counts& counts, Arena& arena, Parts* parts);

}  // namespace sinew
#endif
