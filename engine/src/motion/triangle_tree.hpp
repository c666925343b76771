// SPDX-License-Identifier: MIT
// Middles of a body's triangles in a tree of boxes. Its shape is found once, at rest; each pose fills its boxes anew.
#ifndef SINEW_MOTION_TRIANGLE_TREE_HPP
#define SINEW_MOTION_TRIANGLE_TREE_HPP

#include "mesh/morton.hpp"
#include "motion/posed_body.hpp"

namespace sinew::motion {

constexpr uint32_t kTreeFan = 8;  // triangles of a leaf, and boxes of a box

// Sorts scratch.order [count] by prefix(i), below 64, then along the Morton curve of position(i).
template <class SurfacePosition, class Prefix>
void sort_by_position(uint32_t count, const MortonScratch& scratch, SurfacePosition position, Prefix prefix) {
  if (count == 0) return;
  Vec3d low = position(0), high = low;
  for (uint32_t i = 1; i < count; ++i) {
    const Vec3d p = position(i);
    low = {lesser(low.x, p.x), lesser(low.y, p.y), lesser(low.z, p.z)};
    high = {greater(high.x, p.x), greater(high.y, p.y), greater(high.z, p.z)};
  }
  // 2^19 cells a side: 57 bits, and the prefix above them.
  const double side = greater(greater(high.x - low.x, high.y - low.y), high.z - low.z);
  const double cells = side > 1e-30 ? 524287 / side : 0;
  for (uint32_t i = 0; i < count; ++i) {
    const Vec3d p = cells * (position(i) - low);
    scratch.order[i] = i;
    scratch.keys[i] = spread_bits(static_cast<uint32_t>(p.x)) | (spread_bits(static_cast<uint32_t>(p.y)) << 1) |
                      (spread_bits(static_cast<uint32_t>(p.z)) << 2) | (static_cast<uint64_t>(prefix(i)) << 58);
  }
  radix_sort_pairs(scratch.keys, scratch.order, count, scratch.other_keys, scratch.other_order);
}

// Which triangles lie in which leaf: along the Morton order of their middles at rest, those of one mask together.
class TriangleOrder {
 public:
  static constexpr uint32_t kLevels = 10;     // 8^10 is more than there are triangles
  static constexpr uint32_t kMostMasks = 32;  // masks are below it

  // Works with a measuring arena. The scratch is needed until sort() has returned.
  void allocate(Arena& arena, uint32_t triangles);
  // `rest` is the body; masks [triangles] are those of walk().
  void sort(const PosedBody& rest, const uint8_t* masks, const MortonScratch& scratch);

  static uint32_t most_leaves(uint32_t triangles) { return triangles / kTreeFan + kMostMasks; }
  // Rows of eight boxes on all levels together.
  static uint32_t most_rows(uint32_t triangles);

  uint32_t leaf_count() const { return leaf_count_; }
  uint32_t unmasked_leaf_count() const { return unmasked_leaf_count_; }  // they come first
  uint32_t level_count() const { return level_count_; }                  // of rows; the last one has one row
  uint32_t first_row(uint32_t level) const { return first_rows_[level]; }
  uint32_t rows(uint32_t level) const { return first_rows_[level + 1] - first_rows_[level]; }
  // [kTreeFan] of a leaf; a short one repeats its last.
  const uint32_t* leaf(uint32_t index) const { return triangles_ + size_t{kTreeFan} * index; }
  const uint32_t* corners(uint32_t triangle) const { return corners_ + size_t{3} * triangle; }
  // The bits that all triangles below a row's box share.
  const uint8_t* shared(uint32_t row) const { return shared_ + size_t{kTreeFan} * row; }

 private:
  void fill_leaves(const uint8_t* masks, const MortonScratch& scratch, uint32_t count);
  void fill_rows(const uint8_t* masks);

  const uint32_t* corners_ = nullptr;  // the body's, which every other body in these triangles shares
  uint32_t* triangles_ = nullptr;      // [most_leaves x kTreeFan]
  uint8_t* shared_ = nullptr;          // [most_rows x kTreeFan]
  uint32_t leaf_count_ = 0, unmasked_leaf_count_ = 0, level_count_ = 0;
  uint32_t first_rows_[kLevels + 1] = {};
};

// The same triangles in a pose.
class TriangleTree {
 public:
  struct Leaf {
    double at[3][kTreeFan];
  };

  // Works with a measuring arena.
  void allocate(Arena& arena, uint32_t triangles);
  // With the vertices of `posed`, which must stay as they are. only_unmasked: triangles with any bit in their mask are not to be asked for.
  void fill(const TriangleOrder& order, const PosedBody& posed, bool only_unmasked);
  const PosedBody& posed() const { return *posed_; }

  uint32_t triangle(uint32_t slot) const { return order_->leaf(slot / kTreeFan)[slot % kTreeFan]; }
  Vec3d middle(uint32_t slot) const {
    const Leaf& own = leaves_[slot / kTreeFan];
    const uint32_t i = slot % kTreeFan;
    return {own.at[0][i], own.at[1][i], own.at[2][i]};
  }
  // Slots of a leaf are kTreeFan * leaf and those behind it.
  const Leaf& leaf(uint32_t index) const { return leaves_[index]; }
  // Normals of length 1, or 0; computed on first use.
  const Leaf& normals(uint32_t leaf);

  // Calls look(leaf, squares) for leaves with a middle whose square distance from p is at most *bound, which look may make less, and
  // whose triangles' mask has none of the bits of `without`. Boxes are left out by the same sums in the same order as
  // distances, so rounding leaves out none that is as near.
  template <class Look>
  void walk(Vec3d p, uint8_t without, const double* bound, Look look) const;
  // Squares of p's distances from the middles of a leaf.
  static void distances(const Leaf& leaf, Vec3d p, double (&squares)[kTreeFan]);

 private:
  struct Row {
    double middle[3][kTreeFan], half[3][kTreeFan];
  };
  static void distances(const Row& row, Vec3d p, double (&squares)[kTreeFan]);
  void fill_rows(uint32_t leaf_count);

  const TriangleOrder* order_ = nullptr;
  const PosedBody* posed_ = nullptr;
  Leaf* leaves_ = nullptr;          // [most_leaves] middles
  Leaf* normals_ = nullptr;         // [most_leaves]
  uint8_t* has_normals_ = nullptr;  // [most_leaves]
  Row* rows_ = nullptr;             // [most_rows] boxes
};

template <class Look>
void TriangleTree::walk(Vec3d p, uint8_t without, const double* bound, Look look) const {
  struct Entry {
    double square;
    uint32_t level, index;  // a row of a level
  };
  Entry stack[TriangleOrder::kLevels * kTreeFan];
  uint32_t depth = 0;
  if (order_->level_count() > 0) stack[depth++] = {0, order_->level_count() - 1, 0};
  double squares[kTreeFan];
  while (depth > 0) {
    const Entry top = stack[--depth];
    if (top.square > *bound) continue;
    const uint32_t row = order_->first_row(top.level) + top.index;
    distances(rows_[row], p, squares);
    uint32_t near = 0;
    for (uint32_t i = 0; i < kTreeFan; ++i) near |= static_cast<uint32_t>(squares[i] <= *bound) << i;
    const uint8_t* const shared = order_->shared(row);
    for (; near != 0; near &= near - 1) {
      const uint32_t i = static_cast<uint32_t>(low_bit(near));
      if ((shared[i] & without) != 0) continue;
      const uint32_t below = kTreeFan * top.index + i;
      if (top.level > 0) {
        stack[depth++] = {squares[i], top.level - 1, below};
        continue;
      }
      double own[kTreeFan];
      distances(leaves_[below], p, own);
      look(below, own);
    }
  }
}

}  // namespace sinew::motion
#endif
