// SPDX-License-Identifier: MIT
// Votes of a limb's joints, counted together.
#include "rig/limbs.hpp"

namespace sinew::rigging {
namespace {

constexpr int32_t kClearSide = side_share(250);
constexpr int64_t kNoHead = int64_t{1} << 40;  // above all

}  // namespace

bool continues_limb(uint32_t from, uint32_t to) {
  const bool arm = from >= kClassClavicle && from <= kClassForearm && to >= kClassUpperArm && to <= kClassHand;
  return arm || (from >= kClassHip && from <= kClassCalf && to >= kClassThigh && to <= kClassFoot);
}

bool leaves_limb(uint32_t from, uint32_t to) {
  const auto is_arm_or_leg = [](LimbClass limb) { return limb == LimbClass::kArm || limb == LimbClass::kLeg; };
  const LimbClass on = limb_of(from), limb = limb_of(to);
  if (is_arm_or_leg(on)) return limb == LimbClass::kEar;
  return is_arm_or_leg(limb) && on != LimbClass::kNone;
}

bool lies_across(const FoldedNode& a, const FoldedNode& b) {
  if (!is_paired_class(a.joint_class) || !is_paired_class(b.joint_class)) return false;
  return (a.at.x > kClearSide && b.at.x < -kClearSide) || (a.at.x < -kClearSide && b.at.x > kClearSide);
}

namespace {

// Limbs of a tree, joint by joint from the root.
class Limbs {
 public:
  Limbs(LimbVotes& votes, FoldedTree& tree) : votes_(votes), tree_(tree) {}

  void settle() {
    collect();
    for (uint32_t i = 0; i < count_; ++i) {
      FoldedNode& node = tree_.nodes[order_[i]];
      const uint32_t first = first_[order_[i]];
      const int16_t trunk = tree_.nodes[first].parent;
      int64_t(&votes)[kLimbs] = votes_[first];
      // Of 728 arms none begins above its parent head, of 46 ears 32 do.
      if (trunk >= 0 && tree_.nodes[trunk].joint_class == kClassHead &&
          tree_.nodes[first].at.y > tree_.nodes[trunk].at.y) {
        constexpr auto kArm = static_cast<uint32_t>(LimbClass::kArm), kEar = static_cast<uint32_t>(LimbClass::kEar);
        votes[kEar] += votes[kArm];
        votes[kArm] = 0;
      }
      uint32_t best = 0;
      for (uint32_t k = 1; k < kLimbs; ++k) best = votes[k] > votes[best] ? k : best;
      if (votes[best] > 0) node.joint_class = class_in_limb(static_cast<LimbClass>(best), node.joint_class);
    }
    if (!tree_.mirrored) choose_sides();
  }

  // Legs by position, see steer_limbs(). Joints of each limb are those that collect() found.
  bool steer(BodyKind kind, LimbVotes& votes) {
    collect();
    if (kind != BodyKind::kAny && kind != BodyKind::kBiped && kind != BodyKind::kQuadruped) return false;
    uint32_t limbs[kMaxFoldedJoints], n = 0;
    for (uint32_t j = 0; j < tree_.count; ++j) {
      if (!is_paired_limb(j) || joints_[j] < 2 || (tree_.mirrored && !tree_.beside(j))) continue;
      uint32_t at = n++;
      for (; at > 0 && how_far(kind, limbs[at - 1]) > how_far(kind, j); --at) limbs[at] = limbs[at - 1];
      limbs[at] = j;
    }
    const uint32_t legs = tree_.mirrored ? 1 : 2;
    if (n <= legs || (kind == BodyKind::kAny && !stands_on_four(limbs, n, legs))) return false;
    bool changed = false;
    for (uint32_t i = 0; i < n; ++i) {
      const LimbClass limb = i < legs ? LimbClass::kLeg : LimbClass::kArm;
      changed = changed || limb_of(tree_.nodes[limbs[i]].joint_class) != limb;
      for (uint32_t j = 0; j < tree_.count; ++j)
        if (first_[j] == limbs[i]) make(limb, j, votes);
    }
    return changed;
  }

 private:
  void collect() {
    order_[count_++] = tree_.root;
    for (uint32_t i = 0; i < count_; ++i) take(order_[i]);
  }

  bool is_paired_limb(uint32_t j) const {
    const LimbClass limb = limb_of(tree_.nodes[j].joint_class);
    return first_[j] == j && (limb == LimbClass::kArm || limb == LimbClass::kLeg);
  }
  bool hangs_below(int16_t node, int16_t above) const {
    do node = tree_.nodes[node].parent;
    while (node >= 0 && node != above);
    return node >= 0;
  }
  int64_t depth(int16_t node) const {
    int64_t steps = 0;
    for (; node >= 0; node = tree_.nodes[node].parent) ++steps;
    return steps;
  }

  // Whether these are two pairs of legs, the front one, which comes last, on a spine farther from the root than the
  // parent of the rear one.
  bool stands_on_four(const uint32_t* limbs, uint32_t n, uint32_t legs) const {
    if (n != 2 * legs) return false;
    for (uint32_t i = 0; i < n; ++i) {
      const int16_t trunk = tree_.nodes[limbs[i]].parent;
      if (trunk < 0 || limb_of(tree_.nodes[limbs[i]].joint_class) != LimbClass::kLeg) return false;
      if (i < legs) continue;
      if (tree_.nodes[trunk].joint_class != kClassSpine) return false;
      for (uint32_t k = 0; k < legs; ++k)
        if (!hangs_below(trunk, tree_.nodes[limbs[k]].parent)) return false;
    }
    return true;
  }

  // Mean position of a limb's joints: height, or for a quadruped distance from behind; for an unknown kind the depth
  // of its parent in the tree.
  int64_t how_far(BodyKind kind, uint32_t limb) const {
    if (kind == BodyKind::kAny) return depth(tree_.nodes[limb].parent);
    int64_t sum = 0;
    for (uint32_t j = 0; j < tree_.count; ++j)
      if (first_[j] == limb) sum += kind == BodyKind::kQuadruped ? tree_.nodes[j].at.z : tree_.nodes[j].at.y;
    return sum / joints_[limb];
  }

  void make(LimbClass limb, uint32_t j, LimbVotes& votes) {
    constexpr auto kArm = static_cast<uint32_t>(LimbClass::kArm), kLeg = static_cast<uint32_t>(LimbClass::kLeg);
    const int64_t both = votes[j][kArm] + votes[j][kLeg];
    votes[j][kArm] = limb == LimbClass::kArm ? both : 0;
    votes[j][kLeg] = limb == LimbClass::kLeg ? both : 0;
    const uint8_t c = tree_.nodes[j].joint_class;
    if (c != kClassTail && c != kClassEar && c != kClassHair) tree_.nodes[j].joint_class = class_in_limb(limb, c);
  }

  bool begins(uint32_t limb) const { return first_[limb] == limb && is_paired_class(tree_.nodes[limb].joint_class); }

  void take(uint32_t j) {
    const FoldedNode& node = tree_.nodes[j];
    const bool goes_on = node.parent >= 0 && limb_of(node.joint_class) != LimbClass::kNone &&
                         limb_of(tree_.nodes[node.parent].joint_class) != LimbClass::kNone;
    const bool forks =
        goes_on && forks_[node.parent] && continues_limb(tree_.nodes[node.parent].joint_class, node.joint_class);
    first_[j] = goes_on && !forks ? first_[node.parent] : j;
    stem_[j] = forks ? node.parent : int16_t{-1};
    across_[first_[j]] += node.at.x;
    ++joints_[first_[j]];
    for (uint32_t k = 0; k < kLimbs && first_[j] != j; ++k) votes_[first_[j]][k] += votes_[j][k];
    uint32_t next = 0;
    for (uint32_t k = 0; k < tree_.count; ++k) {
      if (tree_.nodes[k].parent != static_cast<int16_t>(j)) continue;
      order_[count_++] = k;
      next += continues_limb(node.joint_class, tree_.nodes[k].joint_class) ? 1 : 0;
    }
    forks_[j] = !tree_.mirrored && next > 1;
  }

  // Parent of a limb; of two limbs that fork from one joint, the parent of that joint's limb.
  int64_t trunk_at(uint32_t limb) const {
    const int16_t above = tree_.nodes[stem_[limb] < 0 ? limb : first_[stem_[limb]]].parent;
    return above < 0 ? 0 : tree_.nodes[above].at.x;
  }
  int64_t lean(uint32_t limb) const { return across_[limb] / joints_[limb] - trunk_at(limb); }
  bool is_stem(uint32_t limb) const {
    for (uint32_t j = 0; j < tree_.count; ++j)
      if (stem_[j] >= 0 && first_[stem_[j]] == limb) return true;
    return false;
  }

  int8_t side_of(uint32_t limb) const {
    const LimbClass kind = limb_of(tree_.nodes[limb].joint_class);
    uint32_t others = 0, other = limb;
    for (uint32_t k = 0; k < tree_.count; ++k) {
      if (k == limb || !begins(k) || limb_of(tree_.nodes[k].joint_class) != kind || is_stem(k)) continue;
      ++others;
      other = k;
    }
    if (is_stem(limb) || others != 1 || (kind != LimbClass::kArm && kind != LimbClass::kLeg))
      return lean(limb) >= 0 ? 1 : -1;
    const int64_t begin = (tree_.nodes[limb].at.x - trunk_at(limb)) - (tree_.nodes[other].at.x - trunk_at(other));
    const int64_t whole = lean(limb) - lean(other);
    const bool clear = begin > kClearSide || begin < -kClearSide;
    const int64_t x = clear ? begin : whole;
    return x > 0 || (x == 0 && limb < other) ? 1 : -1;
  }

  void choose_sides() {
    int8_t side[kMaxFoldedJoints] = {};
    for (uint32_t j = 0; j < tree_.count; ++j)
      if (begins(j)) side[j] = side_of(j);
    for (uint32_t j = 0; j < tree_.count; ++j)
      if (is_paired_class(tree_.nodes[j].joint_class)) tree_.nodes[j].side = side[first_[j]];
    // Two limbs that fork from a joint of one of them: the other is attached to the torso.
    for (uint32_t j = 0; j < tree_.count; ++j) {
      if (stem_[j] < 0 || side[j] == side[first_[stem_[j]]]) continue;
      const int16_t trunk = tree_.nodes[first_[stem_[j]]].parent;
      if (trunk >= 0) tree_.nodes[j].parent = trunk;
    }
  }

  LimbVotes& votes_;
  FoldedTree& tree_;
  uint32_t order_[kMaxFoldedJoints], count_ = 0;
  uint32_t first_[kMaxFoldedJoints], joints_[kMaxFoldedJoints] = {};
  int64_t across_[kMaxFoldedJoints] = {};  // sum of a limb's joints' x
  int16_t stem_[kMaxFoldedJoints];         // the joint that a limb and another one fork from, or -1
  bool forks_[kMaxFoldedJoints] = {};
};

// Children of joints of arms.
class ArmForks {
 public:
  explicit ArmForks(FoldedTree& tree) : tree_(tree) {
    for (uint32_t j = 0; j < tree_.count; ++j) {
      const FoldedNode& node = tree_.nodes[j];
      if (node.joint_class == kClassHead && node.at.y < head_) head_ = node.at.y;
    }
    for (uint32_t j = 0; j < tree_.count; ++j) {
      const int16_t above = tree_.nodes[j].parent;
      goes_on_[j] = above >= 0 && limb_of(tree_.nodes[above].joint_class) == LimbClass::kArm &&
                    continues_limb(tree_.nodes[above].joint_class, tree_.nodes[j].joint_class);
    }
  }

  // Whether another joint goes on from the same one by a surer bone.
  bool is_second(uint32_t j) const {
    for (uint32_t k = 0; k < tree_.count && goes_on_[j]; ++k) {
      const FoldedNode &one = tree_.nodes[j], &other = tree_.nodes[k];
      const bool raised = tree_.only(j) != 0 && tree_.only(k) == -tree_.only(j);  // the other arm
      if (goes_on_[k] && !raised && other.parent == one.parent && other.parent_confidence > one.parent_confidence)
        return true;
    }
    return false;
  }
  bool is_behind(uint32_t k, uint32_t j) const {
    while (k != j && goes_on_[k]) k = static_cast<uint32_t>(tree_.nodes[k].parent);
    return k == j;
  }
  bool lies_above_head(const Heights& heights, uint32_t j) const {
    int64_t points = 0, sum = 0;
    for (uint32_t k = 0; k < tree_.count; ++k) {
      if (!is_behind(k, j)) continue;
      points += heights.points[k];
      sum += heights.sum[k];
    }
    return sum > head_ * points;
  }
  void make_ear(uint32_t j, LimbVotes& votes) {
    constexpr auto kArm = static_cast<uint32_t>(LimbClass::kArm), kEar = static_cast<uint32_t>(LimbClass::kEar);
    tree_.nodes[j].joint_class = kClassEar;
    votes[j][kEar] += votes[j][kArm];
    votes[j][kArm] = 0;
  }

 private:
  FoldedTree& tree_;
  int64_t head_ = kNoHead;  // height of the lowest head
  bool goes_on_[kMaxFoldedJoints] = {};
};

}  // namespace

SINEW_RARE void settle_limbs(LimbVotes& votes, FoldedTree* tree) { Limbs(votes, *tree).settle(); }

SINEW_RARE bool free_ears(const Heights& heights, LimbVotes& votes, FoldedTree* tree) {
  ArmForks forks(*tree);
  bool freed = false;
  for (uint32_t j = 0; j < tree->count; ++j) {
    if (!forks.is_second(j) || !forks.lies_above_head(heights, j)) continue;
    for (uint32_t k = 0; k < tree->count; ++k)
      if (forks.is_behind(k, j)) forks.make_ear(k, votes);
    freed = true;
  }
  return freed;
}

SINEW_RARE bool steer_limbs(BodyKind kind, FoldedTree* tree, LimbVotes& votes) {
  LimbVotes sums = {};
  return Limbs(sums, *tree).steer(kind, votes);
}

}  // namespace sinew::rigging
