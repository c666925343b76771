// SPDX-License-Identifier: MIT
// Regions of joints, their borders, least costs over several.
#include "rig/body_ways.hpp"

#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

constexpr int64_t kCostPerUnit = 59093;  // Q32: 10 log2(e) / kSide
constexpr int32_t kPassing = 3 << 16;    // bits, Q16
constexpr int32_t kAirFactor = 4;        // a straight path through the air
constexpr int32_t kFarthest = 1 << 24;   // unreachable

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
    if (!image || tree.only(j) >= 0) starts[count++] = {interior->solid_near(at), static_cast<uint8_t>(j)};
    if (image && tree.only(j) <= 0)
      starts[count++] = {interior->solid_near({-at.x, at.y, at.z}), static_cast<uint8_t>(j)};
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
