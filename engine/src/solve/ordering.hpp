// SPDX-License-Identifier: MIT
// Elimination order with little fill: geometric nested dissection (George 1973; Miller, Teng, Thurston and Vavasis 1997
// for the idea of cutting by coordinates).
#ifndef SINEW_SOLVE_ORDERING_HPP
#define SINEW_SOLVE_ORDERING_HPP

#include "mesh/mesh.hpp"

namespace sinew {

constexpr uint32_t kSmallestRegion = 4;  // for a sparse factor
constexpr uint32_t kSmallestFront = 24;  // for one of dense fronts

struct Ordering {
  uint32_t* order = nullptr;     // [U] vertex at each position of the elimination, for the part ordered last
  uint32_t* position = nullptr;  // [U] and back; only the vertices of that part are valid
  uint32_t* mark = nullptr;      // [U] scratch: the last region a vertex was cut in, and on which side of its cuts
  uint32_t* scratch = nullptr;   // [U]
  // Separators and regions that were not cut further: at the position of each one's first vertex its length and the position
  // where its subtree begins; length 0 elsewhere.
  uint32_t* region_size = nullptr;   // [U]
  uint32_t* region_begin = nullptr;  // [U]

  bool allocate(Arena& arena, const Counts& counts);
  // The same in two parts: the scratch may be given back after dissect().
  bool allocate_result(Arena& arena, const Counts& counts);
  bool allocate_scratch(Arena& arena, const Counts& counts);
  // Orders the vertices of one part: halves first, the vertices that separate them last, again inside the halves
  // until they have at most `smallest` vertices.
  void dissect(const Mesh& mesh, uint32_t part, uint32_t smallest = kSmallestRegion);
};

}  // namespace sinew
#endif
