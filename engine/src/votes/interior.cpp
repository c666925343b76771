// SPDX-License-Identifier: MIT
// Depth by two chamfer passes, paths by a queue of buckets.
#include "votes/interior.hpp"

#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

Counts rig_counts() {
  Counts counts;
  counts.grid = kRigCells;
  return counts;
}

// The 26 neighbors; the first 13 lie behind in the order of cells.
struct Steps {
  int32_t depth[26], distance[26];  // what they cost
  int32_t offset[26];

  explicit Steps(const VoxelGrid& grid) {
    constexpr int32_t kStepLengths[4] = {0, 5, 7, 9};
    int count = 0;
    for (int32_t z = -1; z <= 1; ++z) {
      for (int32_t y = -1; y <= 1; ++y) {
        for (int32_t x = -1; x <= 1; ++x) {
          const int32_t axes = (x != 0) + (y != 0) + (z != 0);
          if (axes == 0) continue;
          depth[count] = 2 + axes;
          distance[count] = kStepLengths[axes];
          offset[count++] = (z * grid.size[1] + y) * grid.size[0] + x;
        }
      }
    }
  }
};

// Border cells are outside, so that no neighbor of a solid cell is missing.
void find_depths(const Steps& steps, Interior* interior) {
  const VoxelGrid& grid = interior->grid;
  for (uint32_t c = 0; c < grid.cell_count; ++c) interior->depth[c] = Interior::solid(grid.states[c]) ? 0x7FFF : 0;
  for (int pass = 0; pass < 2; ++pass) {
    for (uint32_t i = 0; i < grid.cell_count; ++i) {
      const uint32_t c = pass == 0 ? i : grid.cell_count - 1 - i;
      uint16_t least = interior->depth[c];
      if (least == 0) continue;
      for (int n = 13 * pass; n < 13 * (pass + 1); ++n) {
        const uint16_t other =
            static_cast<uint16_t>(interior->depth[c + static_cast<uint32_t>(steps.offset[n])] + steps.depth[n]);
        if (other < least) least = other;
      }
      interior->depth[c] = least;
    }
  }
}

// The solid cell that is nearest to the middle of all solid cells, deep ones before shallow ones; the first of several.
uint32_t middle_cell(const Interior& interior) {
  const VoxelGrid& grid = interior.grid;
  int64_t sum[3] = {0, 0, 0}, count = 0;
  uint32_t c = 0;
  const auto each = [&](auto visit) {
    c = 0;
    for (int32_t z = 0; z < grid.size[2]; ++z) {
      for (int32_t y = 0; y < grid.size[1]; ++y) {
        for (int32_t x = 0; x < grid.size[0]; ++x, ++c) {
          if (interior.depth[c] != 0) visit(x, y, z);
        }
      }
    }
  };
  each([&](int32_t x, int32_t y, int32_t z) {
    sum[0] += x;
    sum[1] += y;
    sum[2] += z;
    ++count;
  });
  if (count == 0) return kNoIndex;
  constexpr int64_t kParts = 48;  // of a cell; a multiple of kDepthUnits
  const int64_t middle[3] = {kParts * sum[0] / count, kParts * sum[1] / count, kParts * sum[2] / count};
  int64_t least = INT64_MAX;
  uint32_t best = kNoIndex;
  each([&](int32_t x, int32_t y, int32_t z) {
    const int64_t dx = kParts * x - middle[0], dy = kParts * y - middle[1], dz = kParts * z - middle[2];
    const int64_t cost =
        int64_t{isqrt64(static_cast<uint64_t>(dx * dx + dy * dy + dz * dz))} - kParts / kDepthUnits * interior.depth[c];
    if (cost < least) {
      least = cost;
      best = c;
    }
  });
  return best;
}

// Cells that wait, by their path length so far: rings of doubly linked lists, as many as a step can cost.
constexpr uint32_t kBuckets = 9 * kOutsideCost + 1;

struct Queue {
  uint32_t head[kBuckets];
  uint32_t* next;  // [cells]
  uint32_t* back;  // [cells]

  void push(uint32_t cell, uint32_t bucket) {
    next[cell] = head[bucket];
    back[cell] = kNoIndex;
    if (head[bucket] != kNoIndex) back[head[bucket]] = cell;
    head[bucket] = cell;
  }
  void remove(uint32_t cell, uint32_t bucket) {
    if (back[cell] == kNoIndex) {
      head[bucket] = next[cell];
    } else {
      next[back[cell]] = next[cell];
    }
    if (next[cell] != kNoIndex) back[next[cell]] = back[cell];
  }
};

// Ends with the last solid cell: outside, where it costs most to walk, paths are known near the body only, and not
// the shortest.
//   owner  null, or as divide_body() says
void find_distances(const Steps& steps, const WayStart* starts, uint32_t count, Queue* queue, Interior* interior,
                    uint8_t* owner) {
  const VoxelGrid& grid = interior->grid;
  uint16_t* const distance = interior->distance;
  uint32_t solid = 0;
  for (uint32_t c = 0; c < grid.cell_count; ++c) {
    distance[c] = kNoDistance;
    if (owner != nullptr) owner[c] = kNoOwner;
    solid += interior->depth[c] != 0 ? 1 : 0;
  }
  for (uint32_t& head : queue->head) head = kNoIndex;
  for (uint32_t i = 0; i < count; ++i) {
    if (distance[starts[i].cell] == 0) continue;
    distance[starts[i].cell] = 0;
    if (owner != nullptr) owner[starts[i].cell] = starts[i].owner;
    queue->push(starts[i].cell, 0);
  }
  for (uint32_t at = 0; solid > 0 && count > 0; ++at) {  // every cell but the border's can be reached
    const uint32_t bucket = at % kBuckets;
    for (uint32_t cell = queue->head[bucket]; cell != kNoIndex; cell = queue->head[bucket]) {
      queue->remove(cell, bucket);
      const bool inside = interior->depth[cell] != 0;
      solid -= inside ? 1 : 0;
      for (int n = 0; n < 26; ++n) {
        const uint32_t other = cell + static_cast<uint32_t>(steps.offset[n]);
        if (grid.states[other] == kCellBorder) continue;
        const uint32_t factor = inside && interior->depth[other] != 0 ? 1 : kOutsideCost;
        const uint32_t cost = at + factor * static_cast<uint32_t>(steps.distance[n]);
        if (cost >= distance[other]) continue;
        if (distance[other] != kNoDistance) queue->remove(other, distance[other] % kBuckets);
        distance[other] = static_cast<uint16_t>(cost);
        if (owner != nullptr) owner[other] = owner[cell];
        queue->push(other, cost % kBuckets);
      }
    }
  }
}

}  // namespace

uint32_t Interior::march(Vec3i p, Vec3i direction, uint32_t most) const {
  uint32_t last = 0, outside = 0;
  const int64_t half = grid.cell_size / 2;
  for (uint32_t step = 1; step <= most; ++step) {
    const Vec3i at = {p.x + static_cast<int32_t>(round_shift(half * step * direction.x, 14)),
                      p.y + static_cast<int32_t>(round_shift(half * step * direction.y, 14)),
                      p.z + static_cast<int32_t>(round_shift(half * step * direction.z, 14))};
    if (solid_at(at)) {
      last = step;
      outside = 0;
    } else if (++outside == 2) {
      break;
    }
  }
  return last;
}

uint32_t Interior::solid_near(Vec3i p) const {
  constexpr int32_t kReach = 6;
  const int32_t at[3] = {grid.coordinate(0, p.x), grid.coordinate(1, p.y), grid.coordinate(2, p.z)};
  uint32_t best = grid.index(at[0], at[1], at[2]);
  if (depth[best] != 0) return best;
  int32_t least = INT32_MAX;
  int32_t from[3], to[3];
  for (int axis = 0; axis < 3; ++axis) {
    from[axis] = at[axis] - kReach < 1 ? 1 : at[axis] - kReach;
    to[axis] = at[axis] + kReach > grid.size[axis] - 2 ? grid.size[axis] - 2 : at[axis] + kReach;
  }
  for (int32_t z = from[2]; z <= to[2]; ++z) {
    for (int32_t y = from[1]; y <= to[1]; ++y) {
      for (int32_t x = from[0]; x <= to[0]; ++x) {
        const uint32_t c = grid.index(x, y, z);
        const int32_t dx = x - at[0], dy = y - at[1], dz = z - at[2], square = dx * dx + dy * dy + dz * dz;
        if (depth[c] == 0 || square >= least) continue;
        least = square;
        best = c;
      }
    }
  }
  return best;
}

bool Interior::allocate(Arena& arena) {
  depth = arena.alloc<uint16_t>(max_cells());
  distance = arena.alloc<uint16_t>(max_cells());
  return grid.allocate(arena, rig_counts());
}
size_t Interior::max_cells() { return VoxelGrid::max_cells(rig_counts()); }

bool build_interior(const Mesh& mesh, Arena& arena, Interior* interior) {
  const ArenaScope scope(arena);
  const Counts counts = rig_counts();
  Queue queue;
  queue.next = arena.alloc<uint32_t>(Interior::max_cells());
  queue.back = arena.alloc<uint32_t>(Interior::max_cells());
  if (!arena.ok()) return false;
  if (arena.measuring()) return true;
  voxelise(mesh, counts, queue.next, &interior->grid);
  const Steps steps(interior->grid);
  find_depths(steps, interior);
  const WayStart middle = {middle_cell(*interior), 0};
  find_distances(steps, &middle, middle.cell == kNoIndex ? 0 : 1, &queue, interior, nullptr);
  return true;
}

bool divide_body(const WayStart* starts, uint32_t count, Arena& arena, Interior* interior, uint8_t* owner) {
  const ArenaScope scope(arena);
  Queue queue;
  queue.next = arena.alloc<uint32_t>(Interior::max_cells());
  queue.back = arena.alloc<uint32_t>(Interior::max_cells());
  if (!arena.ok()) return false;
  if (!arena.measuring()) find_distances(Steps(interior->grid), starts, count, &queue, interior, owner);
  return true;
}

}  // namespace sinew::rigging
