// SPDX-License-Identifier: MIT
// Which parts of a mesh have the same shape, and which joint is to one of them what a joint is to another.
#ifndef SINEW_WEIGHTS_ALIKE_PARTS_HPP
#define SINEW_WEIGHTS_ALIKE_PARTS_HPP

#include "mesh/mesh.hpp"
#include "skeleton/skeleton.hpp"

namespace sinew {

// Parts are alike when they have as many vertices and triangles, and the mean distance of their vertices from their
// center differs by at most kSide / 256: copies that were moved, rotated or mirrored.
struct AlikeParts {
  uint32_t* first = nullptr;   // [parts] the first of the parts alike, by number; itself where it is that
  uint32_t* next = nullptr;    // [parts] the next of them in no certain order, kNoPart behind the last
  Vec3i* center = nullptr;     // [parts] mean of the vertices, grid units
  uint32_t* radius = nullptr;  // [parts] mean distance from it

  static constexpr uint32_t kNoPart = 0xFFFFFFFFu;
  bool allocate(Arena& arena, const Counts& counts);
};

// Scratch is taken from the arena and released. Returns SINEW_OK or SINEW_ERROR_WORKSPACE.
sinew_status find_alike_parts(const Mesh& mesh, const Counts& counts, Arena& arena, AlikeParts* alike);

// The joint that is to part `to` what `joint` is to part `from`, by its distance from the center: `joint` itself
// where that is nearly the same, else the joint that lies best, those as deep in the hierarchy and with as many children
// as `joint` before favorites[to] before others; `joint` again where none lies clearly better.
//   favorites  [parts] the joint with most of a part's weight, or kNoJoint
uint16_t counterpart(const Skeleton& skeleton, const AlikeParts& alike, const uint16_t* favorites, uint16_t joint,
                     uint32_t from, uint32_t to);

}  // namespace sinew
#endif
