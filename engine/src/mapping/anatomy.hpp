// SPDX-License-Identifier: MIT
// Parts of a rig by its joints' positions: sides, limbs, legs, trunk, arms, head. The source of the method is named
// in engine/src/mapping/README.md.
#ifndef SINEW_MAPPING_ANATOMY_HPP
#define SINEW_MAPPING_ANATOMY_HPP

#include "mapping/limbs.hpp"

namespace sinew::mapping {

// Features by which limbs are compared, see limb_features.cpp.
struct LimbFeatures {
  double attach = 0;      // position on the line hips (0), chest (1), head (2)
  double log_length = 0;  // against the torso's
  Point axis;             // start to end, outward, up, front; of length 1
  double log_tree = 0;    // joints
  double rank = -1;       // of three or more pairs of legs: 0 the hindmost, 1 the first
  bool point = false, grounded = false, hip = false, arm = false;
  uint64_t parts = 0;                      // bit per Part, arms and legs as one each
  int32_t first_hash = 0, hash_count = 0;  // in Anatomy::hashes
};

struct Anatomy {
  const Hierarchy* rig = nullptr;
  Frame frame;
  Limbs limbs;
  double* x = nullptr;                         // [n] off the mirror plane, left is > 0
  double* height = nullptr;                    // [n] along up
  int8_t* side = nullptr;                      // [n] 1, -1, or 0 = central: trunk, tail, jaw
  int32_t side_limbs = 0;                      // limbs [0, side_limbs) are attached to the torso
  int32_t* limb_head = nullptr;                // [n] first of the limbs attached to the joint, -1 = none
  int32_t* limb_next = nullptr;                // [kMostSideLimbs]
  int32_t others_first = 0, others_count = 0;  // limbs in the plane beside the spine: tail, jaw
  double ground = 0, tall = 1;                 // lowest height and extent along up

  LimbPair* legs = nullptr;  // [kMostSideLimbs]
  int32_t leg_count = 0;
  LimbPair* feet = nullptr;  // [kMostSideLimbs] pairs that come near the ground
  int32_t foot_count = 0;
  bool quad = false;
  bool lying = false;       // no legs, longer than high
  LimbPair hip_pair, arms;  // a = -1: none
  int32_t hip = 0;
  int32_t* spine = nullptr;  // [n] joints above the hips, up to a leaf
  int32_t spine_count = 0;
  int32_t chest = -1, head = -1, other_head = -1;  // in spine, -1 = none; other_head may be the head as well
  double trunk = 1;                                // hips to chest
  Point line[3];                                   // hips, chest, head
  int32_t line_count = 1;
  double sure = 0;  // votes for the sign of front

  int8_t* path_open = nullptr;       // [n] scratch: on a path from the hips through the plane
  LimbFeatures* features = nullptr;  // [kMostLimbs]
  uint32_t* hashes = nullptr;        // words of limbs
  int32_t hashes_used = 0;

  bool allocate(Arena& arena, uint32_t joints);
  // Everything. `up` null: guessed. `flip`: front is opposite to the one found.
  bool build(const Hierarchy& hierarchy, const Point* up, bool flip, Arena& arena);

  const Point& at(int32_t joint) const { return rig->at[joint]; }
  double ahead(const Point& p) const { return dot(p, frame.front); }
  const Limb& limb(int32_t k) const { return limbs.at[k]; }
  bool is_leg(int32_t limb) const {
    for (int32_t k = 0; k < leg_count; ++k) {
      if (legs[k].a == limb || legs[k].b == limb) return true;
    }
    return false;
  }
  // Where the fingers of a hand begin.
  Point wrist(const Limb& limb) const { return limb.has_hand ? limbs.last_point(limb) : at(limbs.last_joint(limb)); }
  // The thumb among the limbs `fingers`: its joints lie nearest to the wrist and it points away from the others.
  int32_t thumb(const Limb& limb, const int32_t* fingers, int32_t count) const;
  // Position on the torso's line; the line goes on beyond its ends.
  double trunk_position(const Point& p) const;
  // Distance of a possible head from the arms relative to that from the hips.
  double head_ratio(int32_t spine_index) const;

 private:
  friend class FrontVotes;

  void find_sides();
  void begin_limbs();
  bool pair_limbs(Arena& arena);
  void find_legs();
  void find_pairs_on_ground();
  void find_short_legs();
  void find_hip();
  void climb_to_trunk();
  void climb_to_chest();
  void join_feet();
  void find_front(bool flip_it);
  void flip();
  void find_body();
  void find_lying();
  void find_others();
  void find_arms();
  bool is_on_face(int32_t number) const;
  bool is_at_end(int32_t number) const;
  void find_chest();
  void find_head();
  void find_features();
  double leg_rank(int32_t number) const;

  double drop(const LimbPair& pair) const;
  double low(const LimbPair& pair) const;
  double low_end(const LimbPair& pair) const;
  double start_height(const LimbPair& pair) const;
  void leave_out_arms();
  bool are_fins() const;
  int32_t common_attach(const LimbPair& pair) const;
  // Marks joints on paths from the hips through the plane to a leaf, end markers aside.
  void open_paths();
  bool is_path_end(int32_t joint) const;
  double path_length(int32_t leaf) const;
  // Returns whether the path from the hips to a leaf leads to a pelvis below them, the parent of the legs.
  bool leads_to_legs(int32_t leaf) const;
  // Returns how much the names on the path to a leaf indicate a spine.
  double path_names(int32_t leaf) const;
  // Middle of the first points of a pair, ahead.
  double pair_ahead(const LimbPair& pair) const;
  bool is_inner(double ahead_of, double first, double last) const;
  int32_t pick_spine();
  void take_spine(int32_t leaf);
  void take_hips_from_floor();
  int32_t head_of(int32_t first, int32_t base) const;
  bool is_arm_root(int32_t joint) const {
    return arms.a >= 0 && (limbs.joint(limb(arms.a), 0) == joint || limbs.joint(limb(arms.b), 0) == joint);
  }
};

}  // namespace sinew::mapping
#endif
