// SPDX-License-Identifier: MIT
// The order of triangles at rest, and boxes around their middles in a pose.
#include "motion/triangle_tree.hpp"

namespace sinew::motion {
namespace {

constexpr double kFarAway = 1e300;  // of the box of nothing: its square is infinite, and no bound is
// Boxes are larger, and distances from them less, than rounding makes them.
constexpr double kOutward = 1 + 1e-12, kInward = 0.25 * (1 - 1e-9);

double magnitude(double a) {
#if defined(__GNUC__)
  return __builtin_fabs(a);  // in one instruction, for several at once
#else
  return absolute(a);
#endif
}

Vec3d middle_of(const Vec3d* vertices, const uint32_t* corner) {
  return (1.0 / 3.0) * (vertices[corner[0]] + vertices[corner[1]] + vertices[corner[2]]);
}

}  // namespace

uint32_t TriangleOrder::most_rows(uint32_t triangles) {
  uint32_t all = 0;
  for (uint32_t below = most_leaves(triangles); below > 1 || all == 0;) {
    below = (below + kTreeFan - 1) / kTreeFan;
    all += below;
  }
  return all;
}

void TriangleOrder::allocate(Arena& arena, uint32_t triangles) {
  triangles_ = arena.alloc<uint32_t>(size_t{kTreeFan} * most_leaves(triangles));
  shared_ = arena.alloc<uint8_t>(size_t{kTreeFan} * most_rows(triangles));
}

void TriangleOrder::sort(const PosedBody& rest, const uint8_t* masks, const MortonScratch& scratch) {
  const uint32_t count = rest.body->triangle_count;
  corners_ = rest.body->triangles;
  level_count_ = leaf_count_ = unmasked_leaf_count_ = 0;
  if (count == 0) return;
  const auto middle = [&](uint32_t t) {
    const uint32_t* const c = corners(t);
    return (1.0 / 3.0) * (rest.rest(c[0]) + rest.rest(c[1]) + rest.rest(c[2]));
  };
  sort_by_position(count, scratch, middle, [&](uint32_t t) { return masks[t]; });
  fill_leaves(masks, scratch, count);
  fill_rows(masks);
}

void TriangleOrder::fill_leaves(const uint8_t* masks, const MortonScratch& scratch, uint32_t count) {
  uint32_t filled = 0;
  for (uint32_t k = 0; k < count; ++k) {
    const uint32_t t = scratch.order[k];
    if (filled % kTreeFan == 0) ++leaf_count_;
    if (masks[t] == 0) unmasked_leaf_count_ = leaf_count_;
    triangles_[filled++] = t;
    const bool ends = k + 1 == count || masks[scratch.order[k + 1]] != masks[t];
    while (ends && filled % kTreeFan != 0) triangles_[filled++] = t;
  }
}

void TriangleOrder::fill_rows(const uint8_t* masks) {
  uint32_t below = leaf_count_, next = 0;
  while (below > 1 || level_count_ == 0) {
    const uint32_t count = (below + kTreeFan - 1) / kTreeFan;
    first_rows_[level_count_] = next;
    for (uint32_t i = 0; i < count * kTreeFan; ++i) {
      uint8_t bits = 0xFF;
      if (level_count_ == 0 && i < below) bits = masks[triangles_[size_t{kTreeFan} * i]];
      const uint32_t row = level_count_ == 0 || i >= below ? 0 : first_rows_[level_count_ - 1] + i;
      for (uint32_t c = 0; level_count_ > 0 && i < below && c < kTreeFan; ++c) bits &= shared(row)[c];
      shared_[size_t{kTreeFan} * next + i] = bits;
    }
    next += count;
    first_rows_[++level_count_] = next;
    below = count;
  }
}

void TriangleTree::allocate(Arena& arena, uint32_t triangles) {
  leaves_ = arena.alloc<Leaf>(TriangleOrder::most_leaves(triangles));
  normals_ = arena.alloc<Leaf>(TriangleOrder::most_leaves(triangles));
  has_normals_ = arena.alloc<uint8_t>(TriangleOrder::most_leaves(triangles));
  rows_ = arena.alloc<Row>(TriangleOrder::most_rows(triangles));
}

void TriangleTree::fill(const TriangleOrder& order, const PosedBody& posed, bool only_unmasked) {
  order_ = &order;
  posed_ = &posed;
  const uint32_t leaf_count = only_unmasked ? order.unmasked_leaf_count() : order.leaf_count();
  for (uint32_t l = 0; l < leaf_count; ++l) {
    const uint32_t* const triangles = order.leaf(l);
    Leaf& leaf = leaves_[l];
    has_normals_[l] = 0;
    for (uint32_t i = 0; i < kTreeFan; ++i) {
      const Vec3d m = middle_of(posed.vertices, order.corners(triangles[i]));
      leaf.at[0][i] = m.x;
      leaf.at[1][i] = m.y;
      leaf.at[2][i] = m.z;
    }
  }
  fill_rows(leaf_count);
}

void TriangleTree::fill_rows(uint32_t leaf_count) {
  for (uint32_t level = 0; level < order_->level_count(); ++level) {
    const uint32_t below = level == 0 ? leaf_count : order_->rows(level - 1);
    for (uint32_t i = 0; i < order_->rows(level) * kTreeFan; ++i) {
      Row& row = rows_[order_->first_row(level) + i / kTreeFan];
      for (int c = 0; c < 3; ++c) {
        double low = 0, high = 0;
        bool any = false;
        for (uint32_t k = 0; i < below && k < kTreeFan; ++k) {
          double from, to;
          if (level == 0) {
            from = to = leaves_[i].at[c][k];
          } else {
            const Row& under = rows_[order_->first_row(level - 1) + i];
            if (!(under.half[c][k] >= 0)) continue;
            from = under.middle[c][k] - under.half[c][k];
            to = under.middle[c][k] + under.half[c][k];
          }
          low = any ? lesser(low, from) : from;
          high = any ? greater(high, to) : to;
          any = true;
        }
        const double middle = 0.5 * (low + high);
        row.middle[c][i % kTreeFan] = middle;
        row.half[c][i % kTreeFan] = any ? greater(high - middle, middle - low) * kOutward : -kFarAway;
      }
    }
  }
}

void TriangleTree::distances(const Leaf& leaf, Vec3d p, double (&squares)[kTreeFan]) {
  for (uint32_t i = 0; i < kTreeFan; ++i) {
    const double x = p.x - leaf.at[0][i], y = p.y - leaf.at[1][i], z = p.z - leaf.at[2][i];
    squares[i] = x * x + y * y + z * z;
  }
}

// No comparisons, so that compilers take several at once: a + |a| is twice a, or 0.
void TriangleTree::distances(const Row& row, Vec3d p, double (&squares)[kTreeFan]) {
  for (uint32_t i = 0; i < kTreeFan; ++i) {
    const double x = magnitude(p.x - row.middle[0][i]) - row.half[0][i];
    const double y = magnitude(p.y - row.middle[1][i]) - row.half[1][i];
    const double z = magnitude(p.z - row.middle[2][i]) - row.half[2][i];
    const double xx = x + magnitude(x), yy = y + magnitude(y), zz = z + magnitude(z);
    squares[i] = kInward * (xx * xx + yy * yy + zz * zz);
  }
}

const TriangleTree::Leaf& TriangleTree::normals(uint32_t leaf) {
  Leaf& own = normals_[leaf];
  if (has_normals_[leaf] != 0) return own;
  has_normals_[leaf] = 1;
  for (uint32_t i = 0; i < kTreeFan; ++i) {
    const Vec3d n = posed_->normal(order_->corners(order_->leaf(leaf)[i]));
    own.at[0][i] = n.x;
    own.at[1][i] = n.y;
    own.at[2][i] = n.z;
  }
  return own;
}

}  // namespace sinew::motion
