// SPDX-License-Identifier: MIT
// Leaf joints in the middle of small parts of their own.
#include "candidates/own_parts.hpp"

#include "core/vector_math.hpp"

namespace sinew {
namespace {

struct PartBox {
  Vec3i low, high;
};

// Whether a point is at most half of `reach` from the middle of the box on each axis.
SINEW_ONCE bool is_near(const PartBox& box, Vec3i point, int32_t reach) {
  return extent((point - box.low) + (point - box.high)) <= reach;
}

// The longest side of the box of a small part that is neither a disc nor a strand, else 0.
int32_t side_of_ball(const PartBox& box) {
  const Vec3i sides = box.high - box.low;
  const int32_t longest = extent(sides), least = 2 * longest / 5;
  return longest <= kSide / 32 && sides.x >= least && sides.y >= least && sides.z >= least ? longest : 0;
}

}  // namespace

sinew_status find_own_parts(const Mesh& mesh, const Counts& counts, Arena& arena, Skeleton* skeleton,
                            uint16_t* owners) {
  const ArenaScope scope(arena);
  PartBox* const boxes = arena.alloc<PartBox>(counts.vertices);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  for (uint32_t p = 0; p < mesh.part_count; ++p) {
    PartBox& box = boxes[p];
    owners[p] = kNoJoint;
    box.low = box.high = mesh.positions[mesh.part_vertices[mesh.part_offsets[p]]];
  }
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    PartBox& box = boxes[mesh.part[v]];
    grow(mesh.positions[v], &box.low, &box.high);
  }
  for (uint32_t p = 0; p < mesh.part_count; ++p) {
    const int32_t side = side_of_ball(boxes[p]);
    if (side == 0) continue;
    uint32_t near = 0, leaf = 0;
    for (uint32_t j = 0; j < skeleton->joint_count; ++j) {
      if (!is_near(boxes[p], skeleton->positions[j], side)) continue;
      ++near;
      leaf = j;
    }
    const int32_t parent = skeleton->parents[leaf];
    if (near != 1 || skeleton->child_count[leaf] != 0 || skeleton->usable[leaf] == 0 || parent < 0 ||
        skeleton->usable[parent] == 0 || !is_near(boxes[p], skeleton->positions[leaf], 3 * side / 5))
      continue;
    const uint32_t bone = static_cast<uint32_t>(length(skeleton->positions[leaf] - skeleton->positions[parent]));
    if (bone / 2 - static_cast<uint32_t>(side) > 2 * static_cast<uint32_t>(side)) continue;  // 2 to 6 sides
    skeleton->usable[leaf] = 0;
    for (uint32_t other = 0; other < mesh.part_count; ++other) {
      if (is_near(boxes[p], boxes[other].low, 6 * side / 5) && is_near(boxes[p], boxes[other].high, 6 * side / 5))
        owners[other] = static_cast<uint16_t>(leaf);
    }
  }
  return SINEW_OK;
}

}  // namespace sinew
