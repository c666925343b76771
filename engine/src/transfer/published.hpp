// SPDX-License-Identifier: MIT
// Correspondences as published methods use them; the room `published` defines the functions.
#ifndef SINEW_TRANSFER_PUBLISHED_HPP
#define SINEW_TRANSFER_PUBLISHED_HPP

#include "transfer/match.hpp"

namespace sinew::transferring {

// A vertex of the target as a mean of vertices of the source.
struct DistanceMatch {
  static constexpr uint32_t kNearest = 5;
  uint32_t* vertices = nullptr;  // [target U x kNearest]
  double* shares = nullptr;      // [target U x kNearest] sum to 1
  uint32_t reference_count = 0;

  bool allocate(Arena& arena, const Counts& target) {
    vertices = arena.alloc<uint32_t>(size_t{kNearest} * target.vertices);
    shares = arena.alloc<double>(size_t{kNearest} * target.vertices);
    return arena.ok();
  }
  // The source's rows at the vertex, scaled to a whole one.
  void carry(const Rows& source_rows, uint32_t vertex, const Rows& out) const;
};

// By biharmonic distances (Lipman, Rustamov and Funkhouser 2010): finds reference points, their distances on both meshes, and for every vertex of the target the source's vertices whose
// distances are most like its own.
//   source_rows  in the source's joints; vertices without weight are no use
// Returns SINEW_OK, SINEW_ERROR_WORKSPACE, SINEW_ERROR_COUNT where the equations of a mesh are too dense, or SINEW_ERROR_RANGE where
// there are fewer than four reference points or a pair names a vertex that does not exist.
sinew_status match_by_distances(const TransferPlan& plan, const Pair& pair, const Rows& source_rows, Arena& arena,
                                DistanceMatch* match);

// Behind sinew_corresponding_points(), with a plan of SINEW_TRANSFER_NEAREST: that method's match by itself, in the caller's
// vertices. With a measuring arena only the memory is counted.
//   vertices, shares  out  [vertices of the target x 3]
sinew_status find_corresponding_points(const TransferPlan& plan, const TransferInput& input, Arena& arena,
                                       uint32_t* vertices, float* shares);

}  // namespace sinew::transferring
#endif
