// SPDX-License-Identifier: MIT
// The deepest point of an arm. Groups of neighbors are tested first, as a ball: most of an arm is outside, and one
// ball decides for all of them. It does so if no surface can be in it, and where no triangle that may be the nearest
// to one of its points lies over it.
#include "motion/arm_search.hpp"

namespace sinew::motion {

struct ArmSearch::DepthSearch {
  const ArmSearch& search;
  TriangleTree& tree;
  Vec3d moved;
  double reach, slack;
  ArmDepth most;
  struct NearLeaf {
    uint32_t leaf;
    double square;  // of the least distance from the ball's middle
  };
  NearLeaf leaves[kMostLeaves];
  uint32_t leaf_count = 0;  // more than kMostLeaves: not all are listed
  struct Cover {
    Vec3d middle, normal;
  };
  Cover covers[kMostCovers];
  uint32_t cover_count = 0;       // the same
  uint32_t deepest = UINT32_MAX;  // in vertices_; the first of equally deep ones

  DepthSearch(const ArmSearch& own, TriangleTree& own_tree, Vec3d by, double least)
      : search(own), tree(own_tree), moved(by), reach(kFar * tree.posed().height), slack(1e-9 * tree.posed().height) {
    most.depth = least;
  }

  Vec3d position(uint32_t member) const {
    return tree.posed().vertices[search.vertices_[search.near_[member]]] + moved;
  }

  // Those of near_ [first, end). `hint` is a slot, at best that of a triangle nearby, and one on return.
  void look_at_ball(uint32_t first, uint32_t end, uint32_t* hint) {
    const Ball ball = ball_around(first, end, [&](uint32_t k) { return position(k); });
    Nearest near = known(*hint, ball.middle, reach + ball.radius);
    // Where what is known to be near says outside, the nearest will, and finding that alone is cheaper than all that may be.
    const bool is_far = near.triangle == UINT32_MAX || is_outside(ball, near);
    if (is_far) look_nearer(tree, kAllArms, ball.middle, &near);
    if (near.triangle != UINT32_MAX && !(is_far && is_outside(ball, near))) find_leaves(ball, &near);
    *hint = near.slot;
    if (near.triangle == UINT32_MAX || is_outside(ball, near)) return;
    const double deep = most.depth - ball.radius;
    if (deep > 0 && near.square <= deep * deep) return;  // no deeper than it is far
    if (leaf_count <= kMostLeaves) find_covers(ball, near);
    if (leaf_count <= kMostLeaves && cover_count == 0) return;
    uint32_t slot = near.slot;
    for (uint32_t k = first; k < end; ++k) {
      if (may_be_covered(position(k))) look_at_vertex(k, near.slot, &slot);
    }
  }

  // The nearest triangle is so far that no surface lies in the ball, and the ball is not under it.
  bool is_outside(const Ball& ball, const Nearest& near) const {
    const PosedBody& posed = tree.posed();
    const uint32_t* const corner = search.corners(near.triangle);
    const Vec3d middle = tree.middle(near.slot);
    double size = 0;
    for (int c = 0; c < 3; ++c) size = greater(size, squared(posed.vertices[corner[c]] - middle));
    const double margin = ball.radius + root(size);
    return near.square > margin * margin && dot(middle - ball.middle, posed.normal(corner)) <= 0;
  }

  // Leaves with a triangle that may be the nearest to a point of the ball; the nearest to its middle.
  void find_leaves(const Ball& ball, Nearest* near) {
    leaf_count = 0;
    const double farthest = (reach + ball.radius) * (reach + ball.radius) * kRounding;
    double bound = farthest;
    const auto tighten = [&] {
      const double around = root(near->square) + 2 * ball.radius;
      bound = lesser(around * around * kRounding, farthest);
    };
    tighten();
    tree.walk(ball.middle, kAllArms, &bound, [&](uint32_t leaf, const double(&squares)[kTreeFan]) {
      const double least = least_of(squares);
      if (least > bound) return;
      if (leaf_count < kMostLeaves) leaves[leaf_count] = {leaf, least};
      ++leaf_count;
      if (least > near->square) return;
      take_nearer(tree, leaf, squares, near);
      tighten();
    });
    if (leaf_count > kMostLeaves) return;
    uint32_t kept = 0;
    for (uint32_t n = 0; n < leaf_count; ++n) {
      if (leaves[n].square <= bound) leaves[kept++] = leaves[n];
    }
    leaf_count = kept;
  }
  static double least_of(const double (&squares)[kTreeFan]) {
    double least = squares[0];
    for (uint32_t i = 1; i < kTreeFan; ++i) least = lesser(least, squares[i]);
    return least;
  }
  void look_nearer_in_leaves(Vec3d p, Nearest* found) const {
    if (leaf_count > kMostLeaves) {
      look_nearer(tree, kAllArms, p, found);
      return;
    }
    double squares[kTreeFan];
    for (uint32_t n = 0; n < leaf_count; ++n) {
      TriangleTree::distances(tree.leaf(leaves[n].leaf), p, squares);
      if (least_of(squares) <= found->square) take_nearer(tree, leaves[n].leaf, squares, found);
    }
  }

  // Triangles that may be the nearest to a point of the ball which is deeper under their plane than the deepest yet.
  void find_covers(const Ball& ball, const Nearest& near) {
    cover_count = 0;
    const double radius = ball.radius * kRounding + slack;
    const Vec3d nearest = tree.middle(near.slot);
    for (uint32_t n = 0; n < leaf_count; ++n) {
      const TriangleTree::Leaf& at = tree.leaf(leaves[n].leaf);
      const TriangleTree::Leaf& normal = tree.normals(leaves[n].leaf);
      double depths[kTreeFan];  // from the ball's middle down to where it is as deep
      for (uint32_t i = 0; i < kTreeFan; ++i) {
        depths[i] = most.depth -
                    ((at.at[0][i] - ball.middle.x) * normal.at[0][i] + (at.at[1][i] - ball.middle.y) * normal.at[1][i] +
                     (at.at[2][i] - ball.middle.z) * normal.at[2][i]);
      }
      uint32_t under = 0;
      for (uint32_t i = 0; i < kTreeFan; ++i) under |= static_cast<uint32_t>(depths[i] < radius) << i;
      for (; under != 0; under &= under - 1) {
        const uint32_t i = static_cast<uint32_t>(low_bit(under)), slot = kTreeFan * leaves[n].leaf + i;
        const Cover cover = {tree.middle(slot), {normal.at[0][i], normal.at[1][i], normal.at[2][i]}};
        if (!meet(ball, radius, nearest, cover, depths[i])) continue;
        if (cover_count < kMostCovers) covers[cover_count] = cover;
        ++cover_count;
      }
    }
  }
  // A point q of the ball, from its middle, may be nearer to the cover's middle than to `nearest`, (middle - nearest) q >= half of what
  // their squares differ by, and lie under the plane, -normal q >= way: the shortest q of both is no longer than the radius.
  static bool meet(const Ball& ball, double radius, Vec3d nearest, const Cover& cover, double distance) {
    const Vec3d a = cover.middle - nearest;
    const double square = squared(a);
    const double half = 0.5 * (squared(cover.middle - ball.middle) - squared(nearest - ball.middle));
    if (half > 0 && half * half > radius * radius * square) return false;
    if (half <= 0 || distance <= 0) return true;
    const double s = -dot(a, cover.normal), across = square - s * s;
    if (half * s >= distance * square || distance * s >= half) return true;  // the one implies the other
    if (across < 1e-9 * square) return true;  // a lies along the normal: rounding would decide
    return half * half - 2 * s * half * distance + square * distance * distance <= radius * radius * across;
  }
  bool may_be_covered(Vec3d p) const {
    if (leaf_count > kMostLeaves || cover_count > kMostCovers) return true;
    for (uint32_t n = 0; n < cover_count; ++n) {
      if (dot(covers[n].middle - p, covers[n].normal) > most.depth - slack) return true;
    }
    return false;
  }

  void look_at_vertex(uint32_t member, uint32_t hint, uint32_t* other) {
    const Vec3d p = position(member);
    Nearest found = known(hint, p, reach);
    const Nearest second = known(*other, p, reach);
    if (second.square < found.square) found = second;
    if (found.square <= most.depth * most.depth) return;  // no deeper than it is far
    look_nearer_in_leaves(p, &found);
    if (found.triangle == UINT32_MAX) return;
    *other = found.slot;
    const uint32_t i = search.near_[member];
    const Vec3d normal = tree.posed().normal(search.corners(found.triangle));
    const double own = dot(tree.middle(found.slot) - p, normal);
    if (own < most.depth || (own == most.depth && i >= deepest)) return;
    most = {own, normal, search.vertices_[i]};
    deepest = i;
  }

  Nearest known(uint32_t slot, Vec3d p, double farthest) const {
    const Nearest own = {tree.triangle(slot), slot, squared(p - tree.middle(slot))};
    return own.square < farthest * farthest ? own : Nearest{UINT32_MAX, 0, farthest * farthest};
  }
};

ArmDepth ArmSearch::deepest(TriangleTree* tree, uint32_t arm, Vec3d moved, double least) {
  const uint32_t begin = begin_[arm], end = end_[arm];
  DepthSearch own(*this, *tree, moved, least);
  if (!any_body_ || begin == end) return own.most;
  // First where it was deepest the last time: what is known to lie deep spares the rest a search.
  uint32_t* const hints = hints_ + begin / kGroup + arm;
  const auto look = [&](uint32_t group) {
    const uint32_t first = begin + kGroup * group;
    own.look_at_ball(first, first + kGroup < end ? first + kGroup : end, hints + group);
  };
  const uint32_t before = deepest_[arm], count = (end - begin + kGroup - 1) / kGroup;
  look(before);
  for (uint32_t g = 0; g < count; ++g) {
    const uint32_t known = own.deepest;
    if (g != before) look(g);
    if (own.deepest != known) deepest_[arm] = g;
  }
  return own.most;
}

}  // namespace sinew::motion
