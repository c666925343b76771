// SPDX-License-Identifier: MIT
// Morton keys of grid positions: the order of vertices in everything after the weld.
#ifndef SINEW_MESH_MORTON_HPP
#define SINEW_MESH_MORTON_HPP

#include "core/sort.hpp"
#include "mesh/mesh.hpp"

namespace sinew {

// 21-bit coordinate to every third bit and back.
inline uint64_t spread_bits(uint32_t value) {
  uint64_t v = value;
  if (kSmallCode) {
    v = 0;
    for (int bit = 0; bit <= kGridBits; ++bit) v |= static_cast<uint64_t>(value >> bit & 1) << (3 * bit);
    return v;
  }
  v = (v | (v << 32)) & 0x001F00000000FFFFull;
  v = (v | (v << 16)) & 0x001F0000FF0000FFull;
  v = (v | (v << 8)) & 0x100F00F00F00F00Full;
  v = (v | (v << 4)) & 0x10C30C30C30C30C3ull;
  v = (v | (v << 2)) & 0x1249249249249249ull;
  return v;
}
inline uint32_t gather_bits(uint64_t key) {
  if (kSmallCode) {
    uint32_t value = 0;
    for (int bit = kGridBits; bit >= 0; --bit) value = 2 * value + (static_cast<uint32_t>(key >> (3 * bit)) & 1);
    return value;
  }
  uint64_t v = key & 0x1249249249249249ull;
  v = (v | (v >> 2)) & 0x10C30C30C30C30C3ull;
  v = (v | (v >> 4)) & 0x100F00F00F00F00Full;
  v = (v | (v >> 8)) & 0x001F0000FF0000FFull;
  v = (v | (v >> 16)) & 0x001F00000000FFFFull;
  v = (v | (v >> 32)) & 0x00000000001FFFFFull;
  return static_cast<uint32_t>(v);
}
// Mesh coordinates are x, z in [-2^19, 2^19] and y in [0, 2^20]; the shift makes all of them non-negative. A third of the side more
// keeps the planes in the middle of a mesh away from the borders of all cells of the order, so that vertices on them
// keep their positions when the mesh is rotated and comes back a grid step off.
constexpr int32_t kMortonShift = kSide / 2 + kSide / 3;

inline uint64_t morton_key(Vec3i p) {
  return spread_bits(static_cast<uint32_t>(p.x + kMortonShift)) |
         (spread_bits(static_cast<uint32_t>(p.y + kMortonShift)) << 1) |
         (spread_bits(static_cast<uint32_t>(p.z + kMortonShift)) << 2);
}
inline Vec3i position_of_key(uint64_t key) {
  return {static_cast<int32_t>(gather_bits(key)) - kMortonShift,
          static_cast<int32_t>(gather_bits(key >> 1)) - kMortonShift,
          static_cast<int32_t>(gather_bits(key >> 2)) - kMortonShift};
}

// Points to sort into Morton order: keys and the point of each; the rest is scratch.
struct MortonScratch {
  uint64_t* keys;
  uint64_t* other_keys;
  uint32_t* order;
  uint32_t* other_order;
  bool allocate(Arena& arena, size_t count) {
    keys = arena.alloc<uint64_t>(count);
    other_keys = arena.alloc<uint64_t>(count);
    order = arena.alloc<uint32_t>(count);
    other_order = arena.alloc<uint32_t>(count);
    return arena.ok();
  }
};

// Sorts `count` keys; equal ones become one point. index_of[order[i]] is the point of key i. Returns their number.
inline uint32_t weld_keys(const MortonScratch& scratch, uint32_t count, Vec3i* positions, uint32_t* index_of) {
  radix_sort_pairs(scratch.keys, scratch.order, count, scratch.other_keys, scratch.other_order);
  uint32_t welded = 0;
  for (uint32_t i = 0; i < count; ++i) {
    if (i == 0 || scratch.keys[i] != scratch.keys[i - 1]) positions[welded++] = position_of_key(scratch.keys[i]);
    index_of[scratch.order[i]] = welded - 1;
  }
  return welded;
}

}  // namespace sinew
#endif
