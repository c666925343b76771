// SPDX-License-Identifier: MIT
// The published method as drawn: ways from the root to every leaf, compared by the costs of their joints.
#ifndef SINEW_MAPPING_BRANCHES_HPP
#define SINEW_MAPPING_BRANCHES_HPP

#include "mapping/align.hpp"
#include "mapping/frame.hpp"

namespace sinew::mapping {

constexpr uint64_t kMostBranchPairs = uint64_t{1} << 18, kMostBranchCells = uint64_t{1} << 30;

class Branches {
 public:
  bool allocate(Arena& arena, uint32_t target_joints, uint32_t source_joints);
  // Prepares both rigs, each in its own axes: left, up, front. Returns how many pairs of joints run() would compare; UINT64_MAX beyond the limits.
  uint64_t prepare(const Hierarchy& target, const Frame& target_frame, const Hierarchy& source,
                   const Frame& source_frame);
  // Fills sources [target n], -1 = none, and each pair's cost. Returns the mean cost of the pairs.
  double run(int32_t* sources, double* costs);

 private:
  struct Rig {
    const Hierarchy* rig = nullptr;
    Point* at = nullptr;              // [n] relative to the root, the farthest at 1
    double* root_distance = nullptr;  // [n] from the root
    int32_t* leaves = nullptr;        // [n] a branch each
    int32_t* mirror = nullptr;        // [n] of a branch, -1 = none
    int32_t* through = nullptr;       // [n] branches through a joint
    int32_t* chain = nullptr;         // [n] of the branch in hand, from the root on
    double* ratio = nullptr;          // [n] of the branch in hand: way to the root over the branch's
    int32_t branches = 0, length = 0;

    bool allocate(Arena& arena, uint32_t joints);
    void prepare(const Hierarchy& hierarchy, const Frame& frame);
    void take(int32_t branch);
    void find_mirrors();
    int32_t degree(int32_t j) const { return rig->kid_count(j) + (rig->parent[j] >= 0 ? 1 : 0); }
  };
  double joint_cost(int32_t i, int32_t j) const;
  double stored_cost(int32_t i, int32_t j) const {
    return table_ == nullptr || !use_table_ ? joint_cost(i, j) : table_[i * b_.rig->n + j];
  }
  double compare();
  void keep_pairs(int32_t* sources, double* costs);
  void fill_in(int32_t* sources, double* costs);
  bool crosses(int32_t t, int32_t s, const int32_t* sources) const;

  Rig a_, b_;
  double* table_ = nullptr;  // costs of joints, where they are few enough
  bool use_table_ = false;
  double* costs_ = nullptr;    // [branches of a x branches of b]
  double* row_ = nullptr;      // [2 x (longest + 1)]
  uint8_t* better_ = nullptr;  // [(joints + 1) x (joints + 1)] the cheapest place so far
  int32_t* choice_ = nullptr;  // [branches of a]
  uint8_t* used_ = nullptr;    // [source n]
};

}  // namespace sinew::mapping
#endif
