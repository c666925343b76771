// SPDX-License-Identifier: MIT
// Regions of joints, their borders, least costs over several.
#include "rig/body_ways.hpp"

#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

constexpr int64_t kCostPerUnit = 59093;       // Q32: 10 log2(e) / kSide
constexpr int32_t kPassing = 3 << 16;         // bits, Q16
constexpr int32_t kAirFactor = 4;             // a straight way through the air
constexpr int32_t kFarthest = 1 << 24;        // what no way leads to
constexpr int32_t kNearCells = 6;             // a joint outside the body counts for a solid cell so near

// The cell of a point, or the nearest solid one within reach: the first of the least distance.
uint32_t cell_near(const Interior& interior, Vec3i p) {
  const VoxelGrid& grid = interior.grid;
  const int32_t at[3] = {grid.coordinate(0, p.x), grid.coordinate(1, p.y), grid.coordinate(2, p.z)};
  uint32_t best = grid.index(at[0], at[1], at[2]);
  if (interior.depth[best] != 0) return best;
  int32_t least = INT32_MAX;
  int32_t from[3], to[3];
  for (int axis = 0; axis < 3; ++axis) {
    from[axis] = at[axis] - kNearCells < 1 ? 1 : at[axis] - kNearCells;
    to[axis] = at[axis] + kNearCells > grid.size[axis] - 2 ? grid.size[axis] - 2 : at[axis] + kNearCells;
  }
  for (int32_t z = from[2]; z <= to[2]; ++z) {
    for (int32_t y = from[1]; y <= to[1]; ++y) {
      for (int32_t x = from[0]; x <= to[0]; ++x) {
        const uint32_t c = grid.index(x, y, z);
        const int32_t dx = x - at[0], dy = y - at[1], dz = z - at[2], distance = dx * dx + dy * dy + dz * dz;
        if (interior.depth[c] == 0 || distance >= least) continue;
        least = distance;
        best = c;
      }
    }
  }
  return best;
}

}  // namespace

int32_t straight_cost(Vec3i a, Vec3i b) {
  return static_cast<int32_t>((static_cast<int64_t>(length(b - a)) * kCostPerUnit) >> 16);
}

SINEW_RARE bool find_body_ways(const FoldedTree* folded_tree, Arena& arena, Interior* interior, int32_t* costs) {
  const ArenaScope scope(arena);
  uint8_t* const owner = arena.alloc<uint8_t>(Interior::max_cells());
  if (!arena.ok()) return false;
  if (arena.measuring()) return divide_body(nullptr, 0, arena, interior, owner);
  const FoldedTree& tree = *folded_tree;
  const uint32_t n = tree.count;
  WayStart starts[2 * kMaxFoldedJoints];
  uint32_t count = 0;
  for (uint32_t j = 0; j < n; ++j) {
    const Vec3i at = tree.nodes[j].at;
    const bool image = tree.beside(j);
    if (!image || tree.only(j) >= 0) starts[count++] = {cell_near(*interior, at), static_cast<uint8_t>(j)};
    if (image && tree.only(j) <= 0)
      starts[count++] = {cell_near(*interior, {-at.x, at.y, at.z}), static_cast<uint8_t>(j)};
  }
  if (!divide_body(starts, count, arena, interior, owner)) return false;
  for (uint32_t i = 0; i < n * n; ++i) costs[i] = i % (n + 1) == 0 ? 0 : kFarthest;
  const auto offer = [&](uint32_t i, uint32_t j, int32_t cost) {
    if (cost < costs[i * n + j]) costs[i * n + j] = costs[j * n + i] = cost;
  };
  for (uint32_t i = 0; i < count; ++i) {
    for (uint32_t k = 0; k < i; ++k)
      if (starts[i].cell == starts[k].cell) offer(starts[i].owner, starts[k].owner, 0);
  }
  // Q16 bits of a fifth of a cell.
  const int32_t per_unit =
      static_cast<int32_t>((int64_t{interior->grid.cell_size} * kCostPerUnit / kDistanceUnits) >> 16);
  each_border(*interior, owner, [&](uint8_t a, uint8_t b, uint32_t distance) {
    const int64_t cost = int64_t{per_unit} * distance;
    offer(a, b, cost < kFarthest ? static_cast<int32_t>(cost) : kFarthest);
  });
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = 0; j < i; ++j)
      offer(i, j, kAirFactor * straight_cost(tree.nodes[i].at, tree.nodes[j].at) + kPassing);
  }
  for (uint32_t k = 0; k < n; ++k) {
    for (uint32_t i = 0; i < n; ++i) {
      for (uint32_t j = 0; j < i; ++j) {
        if (i != k && j != k) offer(i, j, costs[i * n + k] + costs[k * n + j] + kPassing);
      }
    }
  }
  return true;
}

}  // namespace sinew::rigging
