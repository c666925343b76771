// SPDX-License-Identifier: MIT
// Hands and forearms of a posed body against the rest of it: which triangles are near, and how deep an arm lies under them.
#ifndef SINEW_MOTION_ARM_SEARCH_HPP
#define SINEW_MOTION_ARM_SEARCH_HPP

#include "motion/clip_scene.hpp"
#include "motion/triangle_tree.hpp"

namespace sinew::motion {

constexpr uint32_t kMostArms = 4;  // that are kept in touch and out of the body

// Shares of the height: nearer than the first a hand touches, farther than the second it does not, and what is under the
// surface by more than the second is not seen.
constexpr double kTouch = 0.03, kFar = 0.12;

inline double squared(Vec3d v) { return dot(v, v); }

// The deepest point of an arm under the triangle whose middle is nearest to it, and that triangle's normal. 0: none is under one.
struct ArmDepth {
  double depth = 0;
  Vec3d out = {0, 0, 0};
  uint32_t vertex = 0;
};
// The point of a hand that is nearest to the body without its arm.
struct HandReach {
  bool near = false;  // within kFar
  uint32_t vertex = 0;
  double square = 0;  // of the distance from the nearest triangle's middle
};

class ArmSearch {
 public:
  // Works with a measuring arena. What open() needs beyond it is given back: no allocation may come between.
  void allocate(Arena& arena, uint32_t vertices, uint32_t triangles);
  // Lists the arms of a scene that is open; it must outlive this. Of an arm with more than `most` vertices, which is above 0, every second
  // or third ... along their Morton order represents it.
  void open(const ClipScene& scene, uint32_t most = UINT32_MAX);

  uint32_t count() const { return count_; }
  uint32_t limb(uint32_t arm) const { return limbs_[arm]; }
  // The functions below read a body's tree, which is filled once per pose; only_deepest: only deepest() will be
  // called.
  void fill(const PosedBody& posed, bool only_deepest, TriangleTree* tree) const {
    tree->fill(order_, posed, only_deepest);
  }
  // After PosedBody::take_pose(): the listed vertices of an arm alone, for deepest() in a tree that stays as it was filled.
  void pose_arm(uint32_t arm, PosedBody* posed) const {
    for (uint32_t i = begin_[arm]; i < end_[arm]; ++i) posed->vertices[vertices_[i]] = posed->skinned(vertices_[i]);
  }

  // Depth of hand and forearm, moved by `moved`, under triangles without a vertex of any arm; at least `least`.
  ArmDepth deepest(TriangleTree* tree, uint32_t arm, Vec3d moved, double least);
  // The same, but `least` for a point that only lies under the plane of a triangle, outside of the body.
  ArmDepth deepest_inside(TriangleTree* tree, uint32_t arm, Vec3d moved, double least);
  // Direction out of the body at p: area normals of triangles without a vertex of any arm, nearer ones more, in
  // shares of what a plane through p has. It is the slope of the body blurred by `reach`, so it changes little where
  // p does, and is short in the middle.
  Vec3d way_out(const TriangleTree& tree, Vec3d p, double reach) const;
  // The mean of the hand's vertices, of the pose that the tree is of; (0, 0, 0) where it has none.
  Vec3d middle_of_hand(const TriangleTree& tree, uint32_t arm) const;
  // Distance of the hand to triangles without a vertex of this arm.
  HandReach nearest(const TriangleTree& tree, uint32_t arm);
  // Distance of one vertex of the hand from the same triangles, kFar at most.
  double distance(const TriangleTree& tree, uint32_t arm, uint32_t vertex) const;
  // The triangles, of the same, whose middles are nearest to a vertex, near ones first: up to `most` of them within kFar of the box around
  // the hand. Returns their number; squares [most] of distances.
  uint32_t neighbors(const TriangleTree& tree, uint32_t arm, uint32_t vertex, uint32_t most, uint32_t* triangles,
                     double* squares) const;

 private:
  struct Box;
  struct Nearest {
    uint32_t triangle = UINT32_MAX, slot = 0;
    double square = 0;
  };
  // A ball around neighbors of an arm.
  struct Ball {
    Vec3d middle = {0, 0, 0};
    double radius = 0;
  };
  struct DepthSearch;
  static constexpr uint32_t kGroup = 12;  // neighbors that are tested together
  static constexpr uint32_t kMostLeaves = 128,
                            kMostCovers = 64;  // of a group; with more it is searched vertex by vertex
  static constexpr uint8_t kAllArms = 31;
  static constexpr double kRounding = 1 + 1e-9;  // of bounds that are not compared as they are summed

  uint8_t mask_of(uint32_t triangle) const;
  void thin_out(uint32_t arm, uint32_t most);
  // By solid angles of triangles without a vertex of any arm, as seen from afar: not for points near the surface.
  bool is_inside(const TriangleTree& tree, Vec3d p) const;
  // Calls look(middle, area normal, square of the middle's distance from p) for these triangles within the root of `square`.
  template <class Look>
  void look_at_areas(const TriangleTree& tree, Vec3d p, double square, Look look) const;
  static uint8_t bit_of(uint32_t arm) { return static_cast<uint8_t>(1u << arm); }
  static void take_nearer(const TriangleTree& tree, uint32_t leaf, const double (&squares)[kTreeFan], Nearest* found) {
    for (uint32_t i = 0; i < kTreeFan; ++i) {
      if (squares[i] > found->square) continue;
      const uint32_t slot = kTreeFan * leaf + i, t = tree.triangle(slot);
      if (squares[i] < found->square || t < found->triangle) *found = {t, slot, squares[i]};
    }
  }
  static void look_nearer(const TriangleTree& tree, uint8_t without, Vec3d p, Nearest* found);
  static bool is_any_within(const TriangleTree& tree, uint8_t without, Vec3d p, double reach);
  const uint32_t* corners(uint32_t triangle) const { return scene_->body->triangles + size_t{3} * triangle; }
  // Around the positions that position(i) returns.
  template <class SurfacePosition>
  static Ball ball_around(uint32_t first, uint32_t end, SurfacePosition position) {
    Ball ball;
    for (uint32_t i = first; i < end; ++i) ball.middle = ball.middle + position(i);
    ball.middle = (1.0 / (end - first)) * ball.middle;
    for (uint32_t i = first; i < end; ++i) {
      const double own = squared(position(i) - ball.middle);
      if (own > ball.radius) ball.radius = own;
    }
    ball.radius = root(ball.radius);
    return ball;
  }

  const ClipScene* scene_ = nullptr;
  TriangleOrder order_;           // masks: a bit for each arm that has a vertex, the fifth for arms that are ignored
  uint8_t* masks_ = nullptr;      // [triangles]
  MortonScratch scratch_ = {};    // until open() has returned
  uint32_t* vertices_ = nullptr;  // [vertices] of each arm those of the hand, then those of the forearm; thinned out
  uint32_t* near_ = nullptr;      // [vertices] indices into vertices_, of the same ranges, neighbors together
  uint32_t* hints_ =
      nullptr;             // [vertices / kGroup + kMostArms] of groups of near_ the slot that was nearest the last time
  bool any_body_ = false;  // triangles without a vertex of any arm
  uint32_t count_ = 0;
  uint32_t limbs_[kMostArms] = {};  // indices of limbs
  uint32_t begin_[kMostArms] = {}, hand_end_[kMostArms] = {}, end_[kMostArms] = {};
  // Where to begin, because it was there the last time: a group of near_, an index into vertices_.
  uint32_t deepest_[kMostArms] = {}, nearest_[kMostArms] = {};
};

}  // namespace sinew::motion
#endif
