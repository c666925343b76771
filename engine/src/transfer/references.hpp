// SPDX-License-Identifier: MIT
// Reference points: places of the body that are known on both surfaces.
#ifndef SINEW_TRANSFER_REFERENCES_HPP
#define SINEW_TRANSFER_REFERENCES_HPP

#include "transfer/match.hpp"

namespace sinew {

// Most of those that are found around bones; a caller may give SINEW_MAX_TRANSFER_PAIRS.
constexpr uint32_t kFoundReferences = 80;

// A place on a triangle of welded vertices, or on one vertex.
struct TrianglePosition {
  uint32_t corners[3];
  double shares[3];
};
struct Reference {
  TrianglePosition source, target;
};

struct References {
  Reference* points = nullptr;  // [capacity]
  uint32_t count = 0;

  static uint32_t capacity(const TransferPlan& plan);
  bool allocate(Arena& arena, const TransferPlan& plan);
  // The caller's pairs; or, for every mapped bone, what four rays across it hit first at its beginning and at its middle on
  // both surfaces, in directions that the skeletons' alignment turns into each other. Rays of unlike lengths are left out; of too
  // many those stay that lie farthest apart.
  // Returns SINEW_OK, SINEW_ERROR_WORKSPACE or SINEW_ERROR_RANGE for a pair of vertices that do not exist.
  sinew_status find(const TransferPlan& plan, const Pair& pair, Arena& arena);
};

}  // namespace sinew
#endif
