// SPDX-License-Identifier: MIT
// Builds the tree along the Morton order of the triangles' middles and walks it from near boxes to far ones.
#include "transfer/nearest.hpp"

#include "core/triangle.hpp"

namespace sinew::transferring {
bool SurfaceTree::allocate(Arena& arena, const Counts& counts) {
  const uint32_t most = capacity(counts);
  items_ = arena.alloc<uint32_t>(most);
  normals_ = arena.alloc<Vec3d>(most);
  boxes_ = arena.alloc<Box>(most / 3 + 2 * kLevels);  // a quarter, a sixteenth, ... and one for each level's rest
  return arena.ok();
}

void SurfaceTree::measure(Arena& arena, const Counts& counts) {
  const ArenaScope scope(arena);
  MortonScratch scratch;
  (void)scratch.allocate(arena, capacity(counts));
}

void SurfaceTree::corners_of(uint32_t item, uint32_t (&corners)[3]) const {
  for (uint32_t k = 0; k < 3; ++k)
    corners[k] = of_points_ ? items_[item] : mesh_->triangles[3 * static_cast<size_t>(items_[item]) + k];
}

void SurfaceTree::build(const Mesh& mesh, const Vec3d* positions, const uint8_t* of_use, Arena& arena) {
  const ArenaScope scope(arena);
  MortonScratch scratch;
  mesh_ = &mesh;
  positions_ = positions;
  item_count_ = 0;
  of_points_ = false;
  const uint32_t most = mesh.triangle_count > mesh.welded_count ? mesh.triangle_count : mesh.welded_count;
  if (!scratch.allocate(arena, most)) return;
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
    const uint32_t* const c = mesh.triangles + 3 * static_cast<size_t>(t);
    if (of_use[c[0]] != 0 || of_use[c[1]] != 0 || of_use[c[2]] != 0) scratch.order[item_count_++] = t;
  }
  if (item_count_ == 0) {
    of_points_ = true;
    for (uint32_t v = 0; v < mesh.welded_count; ++v) {
      if (of_use[v] != 0) scratch.order[item_count_++] = v;
    }
  }
  if (item_count_ == 0) return;

  // Middles on a grid of 2^20 cells along the longest side of their box.
  const auto middle = [&](uint32_t item) {
    if (of_points_) return positions[item];
    const uint32_t* const c = mesh.triangles + 3 * static_cast<size_t>(item);
    return (1.0 / 3) * (positions[c[0]] + positions[c[1]] + positions[c[2]]);
  };
  Vec3d low = middle(scratch.order[0]), high = low;
  for (uint32_t i = 1; i < item_count_; ++i) {
    const Vec3d m = middle(scratch.order[i]);
    low = {lesser(low.x, m.x), lesser(low.y, m.y), lesser(low.z, m.z)};
    high = {greater(high.x, m.x), greater(high.y, m.y), greater(high.z, m.z)};
  }
  const double side = greater(greater(high.x - low.x, high.y - low.y), high.z - low.z);
  const double cells = side > 1e-30 ? (kSide - 1) / side : 0;
  for (uint32_t i = 0; i < item_count_; ++i) {
    const Vec3d m = cells * (middle(scratch.order[i]) - low);
    scratch.keys[i] = spread_bits(static_cast<uint32_t>(m.x)) | (spread_bits(static_cast<uint32_t>(m.y)) << 1) |
                      (spread_bits(static_cast<uint32_t>(m.z)) << 2);
  }
  radix_sort_pairs(scratch.keys, scratch.order, item_count_, scratch.other_keys, scratch.other_order);
  for (uint32_t i = 0; i < item_count_; ++i) {
    items_[i] = scratch.order[i];
    uint32_t c[3];
    corners_of(i, c);
    normals_[i] = unit(cross(positions[c[1]] - positions[c[0]], positions[c[2]] - positions[c[0]]));
  }
  fill_boxes();
}

void SurfaceTree::fill_boxes() {
  constexpr double kFarAway = 1e300;
  uint32_t below = item_count_, first_below = 0, next = 0;
  level_count_ = 0;
  do {
    Level& level = levels_[level_count_];
    level = {next, (below + kFan - 1) / kFan};
    for (uint32_t b = 0; b < level.count; ++b) {
      Box& box = boxes_[level.first + b];
      for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = kFarAway;
        box.high[axis] = -kFarAway;
      }
      const uint32_t end = (b + 1) * kFan < below ? (b + 1) * kFan : below;
      for (uint32_t i = b * kFan; i < end; ++i) {
        if (level_count_ > 0) {
          const Box& child = boxes_[first_below + i];
          for (int axis = 0; axis < 3; ++axis) {
            box.low[axis] = lesser(box.low[axis], child.low[axis]);
            box.high[axis] = greater(box.high[axis], child.high[axis]);
          }
          continue;
        }
        uint32_t corners[3];
        corners_of(i, corners);
        for (const uint32_t corner : corners) {
          const Vec3d p = positions_[corner];
          const double at[3] = {p.x, p.y, p.z};
          for (int axis = 0; axis < 3; ++axis) {
            box.low[axis] = lesser(box.low[axis], at[axis]);
            box.high[axis] = greater(box.high[axis], at[axis]);
          }
        }
      }
    }
    first_below = level.first;
    below = level.count;
    next += level.count;
    ++level_count_;
  } while (below > 1 && level_count_ < kLevels);
}

double SurfaceTree::distance2(const Box& box, Vec3d p) const {
  const double at[3] = {p.x, p.y, p.z};
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double gap = greater(greater(box.low[axis] - at[axis], at[axis] - box.high[axis]), 0);
    sum += gap * gap;
  }
  return sum;
}

MatchedPoint SurfaceTree::nearest(Vec3d point, Vec3d normal, Facing facing) const {
  struct PendingBox {
    double bound;
    uint32_t level, index;
  };
  PendingBox stack[kFan * kLevels];
  uint32_t depth = 0;
  const bool any_normal = dot(normal, normal) > 0.25 && !of_points_;
  MatchedPoint best;
  double least = 1e300;  // cost squared
  stack[depth++] = {0, level_count_ - 1, 0};
  while (depth > 0) {
    const PendingBox top = stack[--depth];
    if (top.bound >= least) continue;
    const uint32_t begin = top.index * kFan;
    if (top.level > 0) {
      const Level& below = levels_[top.level - 1];
      const uint32_t end = begin + kFan < below.count ? begin + kFan : below.count;
      const uint32_t floor = depth;
      for (uint32_t i = begin; i < end; ++i) {
        const double bound = distance2(boxes_[below.first + i], point);
        if (bound >= least) continue;
        uint32_t at = depth++;
        for (; at > floor && stack[at - 1].bound < bound; --at) stack[at] = stack[at - 1];
        stack[at] = {bound, top.level - 1, i};
      }
      continue;
    }
    const uint32_t end = begin + kFan < item_count_ ? begin + kFan : item_count_;
    for (uint32_t i = begin; i < end; ++i) {
      MatchedPoint here;
      corners_of(i, here.corners);
      const Vec3d a = positions_[here.corners[0]], b = positions_[here.corners[1]], c = positions_[here.corners[2]];
      nearest_on_triangle(point, a, b, c, here.shares);
      const Vec3d gap = here.shares[0] * a + here.shares[1] * b + here.shares[2] * c - point;
      const double square = dot(gap, gap);
      if (square >= least) continue;
      here.cosine = any_normal ? dot(normals_[i], normal) : 1;
      const double factor = 2 - here.cosine;
      if (square * factor * factor >= least) continue;
      least = square * factor * factor;
      here.distance = root(square);
      if (facing == Facing::kEither) here.cosine = absolute(here.cosine);
      best = here;
    }
  }
  return best;
}

}  // namespace sinew::transferring
