// SPDX-License-Identifier: MIT
// The point of a surface that is nearest to another point and faces as it does: a tree of boxes over triangles.
#ifndef SINEW_TRANSFER_NEAREST_HPP
#define SINEW_TRANSFER_NEAREST_HPP

#include "mesh/morton.hpp"
#include "transfer/real.hpp"

namespace sinew::transferring {

struct MatchedPoint {
  uint32_t corners[3] = {0, 0, 0};
  double shares[3] = {1, 0, 0};  // sum to 1
  double distance = 0;
  double cosine = 1;  // between the surface's normal there and the one asked with
};

// How normals count: the cost of a point is its distance times 1 + (1 - cosine).
enum class Facing {
  kSame,   // the reverse costs three times as much
  kEither  // cloth and what is below it may face against each other; costs as kSame, but `cosine` has no sign
};

class SurfaceTree {
 public:
  // Memory for a mesh of so many vertices and triangles.
  bool allocate(Arena& arena, const Counts& counts);
  // Over the mesh's triangles with its vertices at `positions` [U], which must live as long as the tree. Triangles without a
  // vertex of use [U] are left out; a mesh without any other offers its vertices of use as points.
  void build(const Mesh& mesh, const Vec3d* positions, const uint8_t* of_use, Arena& arena);
  // Takes what build() takes from a measuring arena.
  static void measure(Arena& arena, const Counts& counts);

  uint32_t item_count() const { return item_count_; }
  // The point of least cost; of several the first in the tree's order. normal is a unit vector or (0, 0, 0), then every face
  // costs the same. item_count() > 0.
  MatchedPoint nearest(Vec3d point, Vec3d normal, Facing facing) const;

 private:
  static constexpr uint32_t kFan = 4;      // items of a leaf, and boxes of a box
  static constexpr uint32_t kLevels = 14;  // 4^14 leaves are more than there are triangles
  struct Box {
    double low[3], high[3];
  };
  struct Level {
    uint32_t first, count;  // in boxes_
  };
  static uint32_t capacity(const Counts& counts) {
    return counts.triangles() > counts.vertices ? counts.triangles() : counts.vertices;
  }
  void corners_of(uint32_t item, uint32_t (&corners)[3]) const;
  double distance2(const Box& box, Vec3d p) const;
  void fill_boxes();

  const Mesh* mesh_ = nullptr;
  const Vec3d* positions_ = nullptr;
  bool of_points_ = false;
  uint32_t item_count_ = 0, level_count_ = 0;
  uint32_t* items_ = nullptr;  // [capacity] triangles, or vertices, in the order of their middles
  Vec3d* normals_ = nullptr;   // [capacity] of the items
  Box* boxes_ = nullptr;       // leaves first, then the boxes over them, level by level
  Level levels_[kLevels] = {};
};

}  // namespace sinew::transferring
#endif
