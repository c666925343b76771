// SPDX-License-Identifier: MIT
// Which point of the source represents a vertex of the target, and what rows and numbers of the source become there.
#ifndef SINEW_TRANSFER_MATCH_HPP
#define SINEW_TRANSFER_MATCH_HPP

#include "transfer/align.hpp"
#include "transfer/nearest.hpp"
#include "transfer/plan.hpp"
#include "weights/rows.hpp"

namespace sinew::transferring {

// Source and target on their grids, and what was found of both.
struct Pair {
  Mesh source, target;
  Skeleton source_joints, target_joints;
  JointCounterparts map;

  bool allocate(Arena& arena, const TransferPlan& plan);
  // Meshes and skeletons of an input, whose map and rows of the source are checked. Works with a measuring arena. Returns SINEW_OK,
  // what build_mesh_and_skeleton() refuses, or SINEW_ERROR_RANGE for a joint that does not exist.
  sinew_status build(const TransferPlan& plan, const TransferInput& input, Arena& arena);
};

// How far two rows are from each other: sum of the differences, 0 .. 2 * kWholeRow.
uint32_t row_distance(const Rows& a, uint32_t a_vertex, const Rows& b, uint32_t b_vertex);
// Whether a row has any weight.
bool has_weight(const Rows& rows, uint32_t vertex);
// Scales a row with weight to kWholeRow.
void make_whole(const Rows& rows, uint32_t vertex);

// Turns a row in the source's joints to one in the target's.
void map_row(const JointCounterparts& map, const Rows& rows, uint32_t vertex);

// A vertex of the target as points of the source: `points` with weights that sum to 1 belong to vertices of the source.
struct Match {
  MatchedPoint* points = nullptr;  // [target U]

  bool allocate(Arena& arena, const Counts& target) {
    points = arena.alloc<MatchedPoint>(target.vertices);
    return arena.ok();
  }
  // The source's row at the vertex, scaled to a whole one; empty where the source has none.
  void carry(const Rows& source_rows, uint32_t vertex, const Rows& out, uint32_t out_vertex) const;
  // The same of a number [source U].
  double carry(const double* values, uint32_t vertex) const {
    const MatchedPoint& p = points[vertex];
    return p.shares[0] * values[p.corners[0]] + p.shares[1] * values[p.corners[1]] + p.shares[2] * values[p.corners[2]];
  }
};

// Brings the source to the target (a garment's where it is, else bone by bone) and finds the nearest point of every vertex.
//   source_rows  in the source's joints; vertices without weight are no use
// Returns SINEW_OK, SINEW_ERROR_WORKSPACE, or SINEW_ERROR_RANGE where no vertex of the source has weight that a joint of the
// target takes.
sinew_status find_match(const TransferPlan& plan, const TransferInput& input, const Pair& pair, const Rows& source_rows,
                        Arena& arena, Match* match);

}  // namespace sinew::transferring
#endif
