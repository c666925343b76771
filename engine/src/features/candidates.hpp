// SPDX-License-Identifier: MIT
// Stage 3 of a bind: which K joints may influence a vertex. Multi-source label propagation over a voxel grid.
#ifndef SINEW_FEATURES_CANDIDATES_HPP
#define SINEW_FEATURES_CANDIDATES_HPP

#include "mesh/mesh.hpp"

namespace sinew {

// Result. Distances are chamfer distances in grid units (2^20 = longest side), so that they do not depend on the grid size.
struct Candidates {
  uint32_t k = 0;
  uint16_t* joints = nullptr;     // [U x K] sorted by (distance, joint); kNoJoint = slot unused (always at the end)
  uint32_t* distances = nullptr;  // [U x K]
  Vec3i* tips = nullptr;          // [J] where the joint's bones end for the network's features: for a leaf the found tip, else
                                  // bone_tail. See DESIGN.md 3.3 "Tips"
  uint32_t* territory = nullptr;  // [J] Q16 share of the surface vertices nearest to the joint (first propagation, K = 1)

  bool allocate(Arena& arena, const Counts& counts);
};

// Runs both propagations. Only usable joints are labels. A vertex whose cell was never reached gets the Euclid-nearest usable
// joints, so that every vertex has at least one candidate.
// Returns SINEW_OK, SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status find_candidates(const Mesh& mesh, const Skeleton& skeleton, const Counts& counts, const Progress& progress,
                             Arena& arena, Candidates* candidates);
void measure_find_candidates(Arena& arena, const Counts& counts);

}  // namespace sinew
#endif
