// SPDX-License-Identifier: MIT
// Reference points: points of the body that are known on both surfaces.
#ifndef SINEW_PUBLISHED_REFERENCES_HPP
#define SINEW_PUBLISHED_REFERENCES_HPP

#include "transfer/match.hpp"

namespace sinew::transferring {

// A point on a triangle of welded vertices, or on one vertex.
struct TrianglePosition {
  uint32_t corners[3];
  double shares[3];
};
// The mean of values of its corners.
template <class Value>
Value mean_at(const TrianglePosition& p, const Value* values) {
  return p.shares[0] * values[p.corners[0]] + p.shares[1] * values[p.corners[1]] + p.shares[2] * values[p.corners[2]];
}
struct Reference {
  TrianglePosition source, target;
};

struct References {
  Reference* points = nullptr;  // [most]
  uint32_t count = 0;

  // As many as the caller gives; else at most 1200, and so few that distances of the larger mesh take no more than 128 MiB.
  static uint32_t most(const TransferPlan& plan);
  bool allocate(Arena& arena, const TransferPlan& plan) {
    points = arena.alloc<Reference>(most(plan));
    return arena.ok();
  }
  // The caller's pairs. Or, with the source's surface brought to the target's by the skeletons (align.hpp), of
  //   what four rays across every mapped bone hit first at its beginning and at its middle on both surfaces (joints' surface
  //   points; beyond a leaf half of its parent's bone is the end of the limb), where the two hits come to lie together, and
  //   all vertices of both surfaces whose nearest point of the other surface leads back to them or to a layer above or below,
  // always the one that is farthest from those chosen: up to eight in every larger part of the target, then anywhere. Both meshes are asked alike, so that both directions are.
  //   source_rows, of_use  [source U] in the source's joints; which vertices have weight
  // Returns SINEW_OK, SINEW_ERROR_WORKSPACE or SINEW_ERROR_RANGE for a pair of vertices that do not exist.
  sinew_status find(const TransferPlan& plan, const Pair& pair, const Rows& source_rows, const uint8_t* of_use,
                    Arena& arena);
};

}  // namespace sinew::transferring
#endif
