// SPDX-License-Identifier: MIT
// The published method: paths from the root to every leaf, compared by the costs of their joints.
#ifndef SINEW_PUBLISHED_BRANCHES_HPP
#define SINEW_PUBLISHED_BRANCHES_HPP

#include "mapping/align.hpp"
#include "mapping/anatomy.hpp"

namespace sinew::mapping {

constexpr uint64_t kMostBranchPairs = uint64_t{1} << 18, kMostBranchCells = uint64_t{1} << 30;

class Branches {
 public:
  bool allocate(Arena& arena, uint32_t target_joints, uint32_t source_joints);
  // Prepares both rigs, each in its own axes: left, up, front. Areas are [n] shares of the surface, or null. Returns how many
  // pairs of joints run() would compare; UINT64_MAX beyond the limits.
  uint64_t prepare(const Anatomy& target, const float* target_areas, const Anatomy& source, const float* source_areas);
  // Fills sources [target n], -1 = none, and each pair's cost. Returns the mean cost of the pairs.
  //   first     SINEW_BRANCHES_BOTH, ...
  //   mean      of the pairs of two branches, else their sum
  //   animated  [source n], or null: all are
  double run(uint32_t first, bool mean, const uint8_t* animated, int32_t* sources, double* costs);

 private:
  struct Rig {
    const Hierarchy* rig = nullptr;
    int32_t root = 0;         // the first joint that branches; what is above it is no node, nor are ends of bones
    uint8_t* node = nullptr;  // [n]
    Point* at = nullptr;      // [n] relative to the hips, the farthest at 1
    double* area = nullptr;   // [n] share of the surface
    double* root_distance = nullptr;     // [n] from the root
    int32_t* depth = nullptr;            // [n] below the root
    int32_t* kids = nullptr;             // [n] number of its descendants
    int32_t* leaves = nullptr;           // [n] a branch each
    int32_t* mirror = nullptr;           // [n] of a branch, -1 = none
    int32_t* through = nullptr;          // [n] branches through a joint
    int32_t* chain = nullptr;            // [n] of the branch in hand, from the root on
    double* ratio = nullptr;             // [n] of the current branch: distance to the root over the branch's
    int8_t* side = nullptr;              // [n] of a branch
    const int8_t* joint_side = nullptr;  // [n] left, right or between
    int32_t branches = 0, length = 0;

    bool allocate(Arena& arena, uint32_t joints);
    void prepare(const Anatomy& anatomy, const float* areas);
    void take(int32_t branch);
    void find_mirrors();
    int32_t degree(int32_t j) const { return kids[j] + (j != root ? 1 : 0); }
  };
  double joint_cost(int32_t i, int32_t j) const;
  double stored_cost(int32_t i, int32_t j) const {
    return table_ == nullptr || !use_table_ ? joint_cost(i, j) : table_[i * b_.rig->n + j];
  }
  // Returns whether branch i of the first rig may be paired with branch k of the other, and the cost.
  bool may_pair(int32_t i, int32_t k) const;
  double choice_cost(int32_t i, int32_t k) const {
    const int32_t row = first_ == &a_ ? i : k, column = first_ == &a_ ? k : i;
    return costs_[static_cast<size_t>(row) * static_cast<size_t>(b_.branches) + static_cast<size_t>(column)];
  }
  double mirrored_cost(int32_t i, int32_t k) const;
  void take_over(int32_t i, int32_t k);
  void give(int32_t i, int32_t k);
  int32_t cheapest(int32_t i, bool free) const;
  bool is_outbid(int32_t i) const;
  bool same_side(int32_t t, int32_t s) const { return a_.joint_side[t] == b_.joint_side[s]; }
  double compare(bool mean);
  double choose(bool target_first);
  template <class Body>
  void each_pair(bool target_first, const Body& body);
  void keep_pairs(bool target_first, int32_t* sources, double* costs);
  void settle_crossings(bool target_first, int32_t* sources, double* costs);
  void serve_crossroads(const uint8_t* animated, int32_t* sources, double* costs);
  void fill_in(int32_t* sources, double* costs);
  void map_outside(int32_t* sources, double* costs);
  bool crosses(int32_t t, int32_t s, const int32_t* sources) const;

  Rig a_, b_;
  const Rig *first_ = nullptr, *second_ = nullptr;  // whose branches choose, and the other
  double* table_ = nullptr;                         // costs of joints, where they are few enough
  bool use_table_ = false;
  double* costs_ = nullptr;     // [branches of a x branches of b]
  double* row_ = nullptr;       // [2 x (longest + 1)]
  uint8_t* better_ = nullptr;   // [(joints + 1) x (joints + 1)] the cheapest choice so far
  int32_t* choice_ = nullptr;   // [branches of the first rig]
  int32_t* holders_ = nullptr;  // [branches of the other] how many have it
  uint8_t* used_ = nullptr;     // [source n]
  uint8_t* open_ = nullptr;     // [target n]
};

}  // namespace sinew::mapping
#endif
