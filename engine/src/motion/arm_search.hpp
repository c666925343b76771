// SPDX-License-Identifier: MIT
// Hands and forearms of a posed body against the rest of it: which triangles are near, and how deep an arm lies under them.
#ifndef SINEW_MOTION_ARM_SEARCH_HPP
#define SINEW_MOTION_ARM_SEARCH_HPP

#include "motion/clip_scene.hpp"

namespace sinew {

constexpr uint32_t kMostArms = 4;  // that are kept in touch and out of the body

// Shares of the height: nearer than the first a hand touches, farther than the second it does not, and what is under the
// surface by more than the second is not seen.
constexpr double kTouch = 0.03, kFar = 0.12;

inline double squared(Vec3d v) { return dot(v, v); }

// The deepest point of an arm under the nearest triangle, and that triangle's normal. 0: none is under one.
struct ArmDepth {
  double depth = 0;
  Vec3d out = {0, 0, 0};
  uint32_t vertex = 0;
};
// The point of a hand that is nearest to the body without its arm.
struct HandReach {
  bool near = false;  // within kFar
  uint32_t vertex = 0;
  uint32_t triangle = 0;
  double square = 0;  // of the distance from the triangle's middle
};

class ArmSearch {
 public:
  // Works with a measuring arena.
  void allocate(Arena& arena, uint32_t vertices, uint32_t triangles);
  // Lists the arms of a scene that is open; it must outlive this.
  void open(const ClipScene& scene);

  uint32_t count() const { return count_; }
  uint32_t limb(uint32_t arm) const { return limbs_[arm]; }

  // Of hand and forearm, moved by `moved`, under triangles without a vertex of any arm. `posed` has its triangles.
  ArmDepth deepest(const PosedBody& posed, uint32_t arm, Vec3d moved);
  // Of the hand to triangles without a vertex of this arm, which picked() lists afterwards.
  HandReach nearest(const PosedBody& posed, uint32_t arm);
  // Of one vertex of the hand from the same triangles, kFar at most.
  double distance(const PosedBody& posed, uint32_t arm, uint32_t vertex);
  const uint32_t* picked() const { return picked_; }
  uint32_t picked_count() const { return picked_count_; }

 private:
  struct Box;
  struct Nearest {
    uint32_t triangle;
    double square;
  };
  void pick(const PosedBody& posed, const Box& box, double reach, uint32_t arm, bool of_other_arms);
  void sort_into_cells(const PosedBody& posed, const Box& box, double reach);
  uint32_t cell_along(double from_low) const;
  void look_nearer(const PosedBody& posed, Vec3d p, Nearest* found) const;
  const uint32_t* corners(uint32_t triangle) const { return scene_->body->triangles + size_t{3} * triangle; }
  bool is_arm_vertex(uint32_t v) const;

  const ClipScene* scene_ = nullptr;
  uint32_t* picked_ = nullptr;    // [triangles]
  uint32_t* vertices_ = nullptr;  // [vertices] of each arm those of the hand, then those of the forearm
  // Picked triangles by the cell of a grid around the arm in which their middle lies.
  static constexpr uint32_t kCells = 16;  // a side
  uint32_t* cells_ = nullptr;             // [kCells^3 + 1] first one in `sorted_`
  uint32_t* sorted_ = nullptr;            // [triangles]
  uint16_t* cell_of_ = nullptr;           // [triangles] in the order of `picked_`
  Vec3d low_ = {0, 0, 0};
  double cell_ = 0, per_length_ = 0;  // a cell's side, and 1 over it
  uint32_t picked_count_ = 0, count_ = 0;
  uint32_t limbs_[kMostArms] = {};  // indices of limbs
  uint32_t begin_[kMostArms] = {}, hand_end_[kMostArms] = {}, end_[kMostArms] = {};
};

}  // namespace sinew
#endif
