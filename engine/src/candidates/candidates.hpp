// SPDX-License-Identifier: MIT
// Stage 3 of a bind: which K joints may influence a vertex. Multi-source label propagation over a voxel grid.
#ifndef SINEW_CANDIDATES_CANDIDATES_HPP
#define SINEW_CANDIDATES_CANDIDATES_HPP

#include "candidates/propagation.hpp"
#include "mesh/mesh.hpp"
#include "skeleton/skeleton.hpp"

namespace sinew {

// Result, allocated by the caller before find_candidates(). Distances are chamfer distances (Borgefors 1986, steps
// 5/7/9) in grid units (2^20 = longest side), so that they do not depend on the grid size.
struct Candidates {
  uint32_t k = 0;
  uint16_t* joints = nullptr;     // [U x K] sorted by (distance, joint); kNoJoint = slot unused (always at the end,
                                  // distance 0; only where fewer than K joints are usable)
  uint32_t* distances = nullptr;  // [U x K]
  // [J] Where the bone of a leaf ends (each_bone() in skeleton/bones.hpp). A leaf with vertices of its own has a tip
  // that was found: it lies in the mean direction from the joint to the vertices nearest to it, at 85 % of their
  // extent. The tip of any other joint is its bone_tail.
  Vec3i* tips = nullptr;
  // [J] Q16 share of the surface vertices nearest to the joint (first propagation, K = 1).
  uint32_t* territory = nullptr;

  bool allocate(Arena& arena, const Counts& counts);
};

// The search in two steps, for those who have something else to do beside the first one, which is one thread's.
struct CandidateSearch {
  Propagation propagation;
  // Sums for the tips and starts, one per joint.
  Vec3l* sums = nullptr;        // [J] vertices nearest to the joint, relative to it
  int64_t* extents = nullptr;   // [J] farthest of them along their mean direction; then bone lengths
  uint32_t* counts = nullptr;   // [J]
  uint32_t* starts = nullptr;   // [J] label distance at the bone itself
  uint16_t* nearest = nullptr;  // [U]

  bool allocate(Arena& arena, const Counts& counts_of_bind);
  // Both propagations, tips and territories. False when cancelled.
  bool run(const Mesh& mesh, const Skeleton& skeleton, const Counts& counts_of_bind, const Progress& progress,
           Candidates* candidates);
  // The rows of all vertices.
  void write(const Mesh& mesh, const Threads& threads, Candidates* candidates) const;
};

// Runs the search. Only usable joints are labels. Cells outside the body are walked too, at four times the cost,
// so every vertex gets min(K, usable joints) candidates, whether or not its part touches the body. Returns SINEW_OK,
// SINEW_ERROR_WORKSPACE or SINEW_ERROR_CANCELLED.
sinew_status find_candidates(const Mesh& mesh, const Skeleton& skeleton, const Counts& counts, const Progress& progress,
                             Arena& arena, Candidates* candidates);

}  // namespace sinew
#endif
