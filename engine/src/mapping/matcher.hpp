// SPDX-License-Identifier: MIT
// Two rigs' parts put side by side: trunk by landmarks, limbs by optimal assignment, joints of a limb in their order.
#ifndef SINEW_MAPPING_MATCHER_HPP
#define SINEW_MAPPING_MATCHER_HPP

#include "mapping/align.hpp"
#include "mapping/anatomy.hpp"
#include "mapping/assignment.hpp"
#include "mapping/hierarchy.hpp"

namespace sinew::mapping {

// Pairs fixed by the caller: source of each target joint and the reverse, kFree if none is given.
struct Pins {
  static constexpr int32_t kFree = -2;
  int32_t* source_of = nullptr;  // [target n] a joint, -1 = none, or kFree
  int32_t* target_of = nullptr;  // [source n] a joint or kFree
  bool any = false;
};

class Matcher {
 public:
  bool allocate(Arena& arena, uint32_t target_joints, uint32_t source_joints);
  // Fills sources [target n], -1 = none, and what it cost to put each there.
  void run(const Anatomy& target, const Anatomy& source, bool names, const Pins& pins, int32_t* sources, double* costs);

 private:
  // Landmarks of an arm or leg: start, bend and end of its two long bones, as indices of its points.
  struct Landmark {
    int64_t score;
    int32_t a, b, c;
    bool before(const Landmark& o) const {
      if (score != o.score) return score < o.score;
      if (a != o.a) return a < o.a;
      return b != o.b ? b < o.b : c < o.c;
    }
  };
  static constexpr int kMostLandmarks = 8;
  struct Landmarks {
    Landmark at[kMostLandmarks];
    int count = 0;
  };
  struct FingerPair {
    int32_t a, b;
  };

  void put(int32_t i, int32_t j, double cost);
  double name_cost(int32_t i, int32_t j) const;
  double pin_cost(int32_t i, int32_t j) const;
  double joint_cost(int32_t i, int32_t j) const { return name_cost(i, j) + pin_cost(i, j); }
  double limb_cost(int32_t la, int32_t lb) const;
  double limb_pins(const Limb& a, const Limb& b) const;

  void match_trunk();
  void match_in_order(const int32_t* a, int32_t n, const int32_t* b, int32_t m, int32_t base_a, int32_t base_b);
  void match_pairs();
  void match_singles();
  void match_others();
  void match_limbs(int32_t la, int32_t lb, bool leg, bool arm, double cost);
  void find_landmarks(const Anatomy& rig, int32_t limb, bool leg, double* t, Landmarks* found) const;
  void find_pair_landmarks(const Anatomy& rig, int32_t limb, bool leg, double* t, double* other,
                           Landmarks* found) const;
  void long_bone_positions(const Anatomy& rig, const Limb& limb, const double* t, const Landmark& at,
                           double* positions);
  void match_all_fingers();
  void match_twists(const Limb& a, const Limb& b, int32_t* fa, int32_t* na, int32_t* fb, int32_t* nb);
  void match_hand(const Limb& a, const Limb& b, const int32_t* fa, int32_t na, const int32_t* fb, int32_t nb);
  void match_finger(int32_t x, int32_t y, const Limb& a, const Limb& b);
  int32_t sort_fingers(const Anatomy& rig, const Limb& limb, int32_t* fingers, int32_t count, int32_t thumb) const;
  void match_ends();

  const Anatomy* a_ = nullptr;
  const Anatomy* b_ = nullptr;
  const Pins* pins_ = nullptr;
  bool names_ = false;
  int32_t* sources_ = nullptr;
  double* costs_ = nullptr;
  Assignment assignment_;
  Aligner aligner_;
  int32_t* rows_ = nullptr;                                               // [kMostSideLimbs]
  int32_t* columns_ = nullptr;                                            // [kMostSideLimbs]
  double *ta_ = nullptr, *tb_ = nullptr, *ua_ = nullptr, *ub_ = nullptr;  // [n + 4] positions along a chain
  FingerPair* fingers_ = nullptr;  // [kMostLimbs] limbs whose fingers are still to be matched
  int32_t finger_pairs_ = 0;
  uint8_t* used_ = nullptr;  // [source n]
  double limb_doubt_ = 0;    // what the limbs in hand cost
};

// How far the point k of a chain is along it, from `from`; leaves [count] in `out`.
inline void add_up_lengths(const Point* points, int32_t count, Point from, double* out) {
  double sum = 0;
  for (int32_t k = 0; k < count; ++k) {
    sum += distance(from, points[k]);
    out[k] = sum;
    from = points[k];
  }
}

// Returns whether two plain names denote parts that never represent each other: a jaw and a head, a finger and a shoulder.
bool contradict(const JointName& a, const JointName& b);

// Whether a joint below a hand, by its name, moves as a leg: as a thigh or calf, or as a foot that is not of the hand's own source.
bool is_leg_in_hand(const Hierarchy& target, const Hierarchy& source, const Pins& pins, const int32_t* sources,
                    int32_t joint);

// Whether a map by anatomy goes against joints of limbs and heads that are named alike, each once in its rig: its reading of one of the
// bodies is wrong there. Of upright bodies alone. Then these joints are pinned; pins that the caller gave stay.
//   sources  [target n] the map
bool pin_plain_names(const Hierarchy& target, const Hierarchy& source, const int32_t* sources, Pins* pins);

// The same where names say that one of the bodies has no legs: arms, spine, neck and head are pinned. True where the map goes against them.
bool pin_legless_names(const Hierarchy& target, const Hierarchy& source, const int32_t* sources, Pins* pins);

}  // namespace sinew::mapping
#endif
