// SPDX-License-Identifier: MIT
// Chains of joints off the torso, chains off those, and which of them are mirror images.
#ifndef SINEW_MAPPING_LIMBS_HPP
#define SINEW_MAPPING_LIMBS_HPP

#include "mapping/frame.hpp"

namespace sinew::mapping {

constexpr int32_t kMostLimbs = SINEW_MAX_MAP_LIMBS;
constexpr int32_t kMostSideLimbs = 256;  // limbs attached to the torso, which are matched
constexpr int32_t kMostFingers = 64;     // fingers of one hand that are matched

// A chain of joints. Its points are its joints' positions, then the position of its only end marker, or of a hand that is no
// joint.
struct Limb {
  int32_t first_joint = 0, joint_count = 0;  // in Limbs::joints
  int32_t first_point = 0, point_count = 0;  // in Limbs::points
  int32_t attach = -1;                       // the joint that it is attached to, -1 = none
  int32_t tree = 1;                          // joints of its first joint's subtree
  int32_t mate = -1;                         // the limb on the other side
  int32_t first_sub = -1, next = -1;         // limbs off its joints; the next of its siblings
  int8_t side = 0;                           // 1 where x > 0, -1 where x < 0, 0 = in the plane
  bool has_hand = false;                     // its last point is a hand that is no joint
  double length = 0;                         // along its points
};

// Two limbs that are each other's mirror image, x > 0 first.
struct LimbPair {
  int32_t a = -1, b = -1;

  int32_t of(int side) const { return side == 0 ? a : b; }
};

struct Limbs {
  Limb* at = nullptr;
  int32_t count = 0;
  int32_t* joints = nullptr;
  Point* points = nullptr;
  int32_t joints_used = 0, points_used = 0, joints_room = 0, kept_room = 0;
  LimbPair* pairs = nullptr;
  int32_t pair_count = 0;
  bool full = false;  // some had no room

  bool allocate(Arena& arena, uint32_t rig_joints);
  int32_t joint(const Limb& limb, int32_t k) const { return joints[limb.first_joint + k]; }
  int32_t last_joint(const Limb& limb) const { return joint(limb, limb.joint_count - 1); }
  const Point& point(const Limb& limb, int32_t k) const { return points[limb.first_point + k]; }
  const Point& last_point(const Limb& limb) const { return point(limb, limb.point_count - 1); }
  Point mean_point(const Limb& limb) const;
  double lowest(const Limb& limb, const Point& up) const;
  // Calls body(sub) for each limb that branches off.
  template <class Body>
  void each_sub(const Limb& limb, const Body& body) const {
    for (int32_t t = limb.first_sub; t >= 0; t = at[t].next) body(t);
  }
  template <class Body>
  void each_end_sub(const Limb& limb, const Body& body) const {  // of those, the descendants of the last joint
    const int32_t last = last_joint(limb);
    for (int32_t t = limb.first_sub; t >= 0; t = at[t].next) {
      if (at[t].attach == last) body(t);
    }
  }
  int32_t end_subs(const Limb& limb) const {
    int32_t n = 0;
    each_end_sub(limb, [&](int32_t) { ++n; });
    return n;
  }

  // Whether the limb `sub` begins on one of a chain's long bones: it only rotates with it.
  bool is_twist(const Limb& limb, int32_t sub) const;
  // A limb that begins at `joint`, without its chain yet. -1 when there is no room.
  int32_t begin(const Hierarchy& rig, int32_t joint, int8_t side, int32_t attach);
  // Follows the chains of limbs from number `from` on, and of all that branch off them.
  //   side  [n] 1, -1, or 0 in the plane
  void grow(const Hierarchy& rig, const int8_t* side, int32_t from);
  // Joints, points and limbs of `foot` go on where `limb` ends. Nothing happens where there is no room.
  void append(int32_t limb, int32_t foot);

 private:
  void follow(const Hierarchy& rig, const int8_t* side, int32_t limb);
};

}  // namespace sinew::mapping
#endif
