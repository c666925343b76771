// SPDX-License-Identifier: MIT
// Removes the cheapest removable bone of the lowest rank, together with the one of the same cost on the other side,
// until none may.
#include "simplify/simplify.hpp"

#include <stddef.h>

#include "core/struct_size.hpp"
#include "mapping/hierarchy.hpp"
#include "simplify/collapse_cost.hpp"
#include "simplify/joint_ranks.hpp"

namespace sinew::simplifying {
namespace {

using mapping::Hierarchy;
using mapping::Point;

constexpr int32_t kNone = -1;
constexpr uint32_t kBranching = 3;  // bones
// Mirrored joints: bones of one length, as a share, and like costs, in which the surface counts that is not so exact.
constexpr double kSame = 1e-2, kLikeCost = 0.1;

// A tree that loses joints: children in linked lists.
class Shrinking {
 public:
  bool allocate(Arena& arena, uint32_t count) {
    n_ = static_cast<int32_t>(count);
    at_ = arena.alloc<Point>(count);
    sample_ = arena.alloc<Point>(count);
    parent_ = arena.alloc<int32_t>(count);
    first_ = arena.alloc<int32_t>(count);
    next_ = arena.alloc<int32_t>(count);
    bones_ = arena.alloc<uint32_t>(count);
    area_ = arena.alloc<double>(count);
    cost_ = arena.alloc<double>(count);
    length_ = arena.alloc<double>(count);
    edges_ = arena.alloc<EdgesAtNode>(count);
    apart_ = arena.alloc<double>(count);
    rank_ = arena.alloc<uint8_t>(count);
    end_ = arena.alloc<uint8_t>(count);
    into_ = arena.alloc<int32_t>(count);
    return arena.ok();
  }

  uint8_t* ranks() { return rank_; }
  uint8_t* ends() { return end_; }

  sinew_status start(const SimplifyPlan& plan, const Hierarchy& rig) {
    left_ = 0;
    for (int32_t i = 0; i < n_; ++i) {
      at_[i] = sample_[i] = (1 / rig.size) * rig.at[i];
      parent_[i] = rig.parent[i];
      first_[i] = next_[i] = kNone;
      bones_[i] = parent_[i] >= 0 ? 1 : 0;
      into_[i] = i;
      const double area = plan.areas != nullptr ? static_cast<double>(plan.areas[i]) : 0;
      if (!(area - area == 0)) return SINEW_ERROR_NOT_FINITE;
      if (area < 0) return SINEW_ERROR_RANGE;
      area_[i] = area;
      whole_ += area;
      if (plan.centroids != nullptr) {
        const float* const c = plan.centroids + size_t{3} * static_cast<size_t>(i);
        sample_[i] = {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
        if (!(dot(sample_[i], sample_[i]) - dot(sample_[i], sample_[i]) == 0)) return SINEW_ERROR_NOT_FINITE;
        sample_[i] = (1 / rig.size) * sample_[i];
      }
      ++left_;
    }
    if (!(whole_ - whole_ == 0)) return SINEW_ERROR_NOT_FINITE;
    for (int32_t i = n_; i-- > 0;) {
      if (parent_[i] < 0) continue;
      next_[i] = first_[parent_[i]];
      first_[parent_[i]] = i;
      ++bones_[parent_[i]];
    }
    for (int32_t i = 0; i < n_; ++i) measure(i);
    for (int32_t i = 0; i < n_; ++i) price(i);
    return SINEW_OK;
  }

  void run(const SimplifyPlan& plan) {
    for (;;) {
      int32_t best = kNone;
      for (int32_t i = 0; i < n_; ++i) {
        if (may_go(plan, i) && (best == kNone || goes_before(i, best))) best = i;
      }
      if (best == kNone) return;
      int32_t twin = kNone;
      for (int32_t i = 0; i < n_ && plan.wanted == 0 && !plan.as_drawn; ++i) {
        if (i == best || !is_twin(best, i) || !may_go(plan, i, 1 + kLikeCost)) continue;
        if (twin == kNone || cost_[i] < cost_[twin]) twin = i;
      }
      if (twin != kNone && (parent_[twin] == best || parent_[best] == twin)) twin = kNone;  // no mirror image
      collapse(best);
      if (twin != kNone) collapse(twin);
    }
  }

  void write(uint32_t* into) const {
    for (int32_t i = 0; i < n_; ++i) {
      int32_t stays = i;
      while (into_[stays] != stays) stays = into_[stays];
      into[i] = static_cast<uint32_t>(stays);
    }
  }

 private:
  bool goes_before(int32_t i, int32_t j) const {
    return rank_[i] != rank_[j] ? rank_[i] < rank_[j] : cost_[i] < cost_[j];
  }
  bool is_twin(int32_t i, int32_t j) const {
    return rank_[i] == rank_[j] && cost_[j] <= cost_[i] * (1 + kLikeCost) &&
           absolute(length_[i] - length_[j]) <= kSame * length_[i];
  }
  // As published: the degree of a node of the edge is at least 3; the joint's surface; its length. (In a tree no two nodes
  // have more than one edge.) Ours: the body stays, details go at the low level, and by its degree alone no limb does.
  //   slack  of limits, more than 1 for a joint whose mirror image goes
  bool may_go(const SimplifyPlan& plan, int32_t i, double slack = 1) const {
    if (into_[i] != i || parent_[i] < 0 || (plan.keep != nullptr && plan.keep[i] != 0)) return false;
    if (plan.wanted > 0) return left_ > plan.wanted;
    const bool branches = bones_[i] >= kBranching || bones_[parent_[i]] >= kBranching;
    if (plan.as_drawn) return branches || (plan.low && is_small(plan, i, slack));
    if (rank_[i] == kRankBody) return false;
    const bool detail = rank_[i] == kRankDetail || (rank_[i] == kRankFinger && plan.low);
    if (detail && (plan.low || end_[i] != 0)) return true;
    if (branches && (detail || is_small_leaf(plan, i, slack))) return true;
    return plan.low && is_small(plan, i, slack);
  }
  bool is_small(const SimplifyPlan& plan, int32_t i, double slack) const {
    return (plan.areas != nullptr && area_[i] < slack * plan.least_area * whole_) ||
           length_[i] < slack * plan.least_length;
  }
  bool is_small_leaf(const SimplifyPlan& plan, int32_t i, double slack) const {
    return first_[i] == kNone && length_[i] < slack * plan.crowd_length &&
           (plan.areas == nullptr || area_[i] < slack * plan.crowd_area * whole_);
  }
  void measure(int32_t i) {
    edges_[i] = EdgesAtNode();
    apart_[i] = 0;
    const auto add = [&](int32_t k) {
      edges_[i].add(at_[k] - at_[i]);
      apart_[i] += length(sample_[k] - sample_[i]);
    };
    if (parent_[i] >= 0) add(parent_[i]);
    for (int32_t k = first_[i]; k != kNone; k = next_[k]) add(k);
  }
  void price(int32_t i) {
    const int32_t p = parent_[i];
    if (p < 0) return;
    const Point along = at_[p] - at_[i];
    length_[i] = length(along);
    cost_[i] = collapse_cost(edges_[i], edges_[p], along, length(sample_[p] - sample_[i]), apart_[i]);
  }
  // Joint i becomes part of its parent, which gets its children at the end of its own.
  void collapse(int32_t i) {
    const int32_t p = parent_[i];
    int32_t* link = &first_[p];
    while (*link != i) link = &next_[*link];
    *link = next_[i];
    while (*link != kNone) link = &next_[*link];
    *link = first_[i];
    --bones_[p];
    for (int32_t k = first_[i]; k != kNone; k = next_[k]) {
      parent_[k] = p;
      ++bones_[p];
      measure(k);
    }
    const bool moves = area_[i] > 0;
    if (moves) sample_[p] = sample_[p] + (area_[i] / (area_[p] + area_[i])) * (sample_[i] - sample_[p]);
    area_[p] += area_[i];
    into_[i] = p;
    --left_;
    measure(p);
    price(p);
    for (int32_t k = moves ? first_[p] : kNone; k != kNone; k = next_[k]) measure(k);
    if (moves && parent_[p] >= 0) {
      measure(parent_[p]);
      price(parent_[p]);
      for (int32_t k = first_[parent_[p]]; k != kNone; k = next_[k]) price(k);
    }
    for (int32_t k = first_[p]; k != kNone; k = next_[k]) {
      price(k);
      for (int32_t g = first_[k]; g != kNone && parent_[k] == p; g = next_[g]) price(g);
    }
  }

  int32_t n_ = 0;
  uint32_t left_ = 0;
  double whole_ = 0;
  Point* at_ = nullptr;                                           // the joints' box has a diagonal of 1
  Point* sample_ = nullptr;                                       // middle of the surface that moves with a joint
  int32_t* parent_ = nullptr;                                     // among those that are left
  int32_t *first_ = nullptr, *next_ = nullptr;                    // children
  uint32_t* bones_ = nullptr;                                     // to the parent and to children
  double *area_ = nullptr, *cost_ = nullptr, *length_ = nullptr;  // of roots only the area means something
  EdgesAtNode* edges_ = nullptr;
  double* apart_ = nullptr;  // distances of a joint's sample from those that it has a bone to
  uint8_t *rank_ = nullptr, *end_ = nullptr;
  int32_t* into_ = nullptr;
};

}  // namespace

sinew_status plan_simplify(uint32_t joint_count, const sinew_simplify_options* options, SimplifyPlan* plan) {
  sinew_simplify_options o = SINEW_INIT(sinew_simplify_options);
  constexpr uint32_t kFirstOptions = offsetof(sinew_simplify_options, as_drawn) + sizeof(uint32_t);
  const sinew_status status = options == nullptr ? SINEW_OK : read_struct(options, kFirstOptions, sizeof o, &o);
  if (status != SINEW_OK) return status;
  if (o.level > SINEW_SIMPLIFY_LOW || o.as_drawn > 1) return SINEW_ERROR_ARGUMENT;
  if (joint_count == 0 || joint_count > SINEW_MAX_JOINTS) return SINEW_ERROR_COUNT;
  const bool low = o.level == SINEW_SIMPLIFY_LOW;
  *plan = SimplifyPlan();
  plan->joint_count = joint_count;
  plan->wanted = o.joint_count;
  plan->centroids = o.centroids;
  plan->low = low;
  plan->as_drawn = o.as_drawn != 0;
  plan->least_area = 0.006;
  plan->least_length = 0.04;
  plan->crowd_area = low ? 0.02 : 0.001;
  plan->crowd_length = low ? 0.08 : 0.012;
  return SINEW_OK;
}

sinew_status run_simplify(const SimplifyPlan& plan, Arena& arena, uint32_t* into) {
  Hierarchy rig;
  Shrinking tree;
  (void)rig.allocate(arena, plan.joint_count);
  if (!tree.allocate(arena, plan.joint_count)) return SINEW_ERROR_WORKSPACE;
  sinew_skeleton skeleton = plan.skeleton;
  skeleton.joint_count = plan.joint_count;
  sinew_status status = SINEW_OK;
  if (!arena.measuring()) {
    sinew_skeleton unnamed = SINEW_INIT(sinew_skeleton);
    unnamed.positions = skeleton.positions;
    unnamed.parents = skeleton.parents;
    unnamed.joint_count = plan.joint_count;
    status = rig.build(unnamed, /*with_names=*/false);
    if (status == SINEW_OK) status = tree.start(plan, rig);
  }
  if (status == SINEW_OK) status = find_joint_ranks(skeleton, plan.areas, arena, tree.ranks(), tree.ends());
  if (status != SINEW_OK || arena.measuring()) return status;
  for (uint32_t j = 0; plan.as_drawn && j < plan.joint_count; ++j) tree.ranks()[j] = 0;  // names say nothing
  tree.run(plan);
  tree.write(into);
  return SINEW_OK;
}

}  // namespace sinew::simplifying
