// SPDX-License-Identifier: MIT
// Chains by classes: a chain goes on to the child of its kind with the most below it.
#include "predict/limbs.hpp"

#include <algorithm>
#include <cmath>

#include "sinew/sinew.h"
#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_formats/base/joint_tree.hpp"

namespace sinew {
namespace {

constexpr double kBeside = 0.02;  // of the skeleton's extent: a chain nearer to the plane is in the middle

LimbKind kind_of(uint8_t joint_class) {
  if (joint_class <= SINEW_CLASS_HEAD) return LimbKind::kTrunk;
  if (joint_class <= SINEW_CLASS_HAND) return LimbKind::kArm;
  if (joint_class <= SINEW_CLASS_TOE) return LimbKind::kLeg;
  switch (joint_class) {
    case SINEW_CLASS_TAIL:
      return LimbKind::kTail;
    case SINEW_CLASS_WING:
      return LimbKind::kWing;
    case SINEW_CLASS_EAR:
      return LimbKind::kEar;
    case SINEW_CLASS_HAIR:
      return LimbKind::kHair;
    default:
      return LimbKind::kOther;
  }
}

class LimbFinder {
 public:
  LimbFinder(const LabeledSkeleton& s, uint32_t across, double plane)
      : s_(s), across_(across), plane_(plane), core_parents_(count(), -1), below_(count(), 0), used_(count(), false) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
      double low = INFINITY, high = -INFINITY;
      for (const Joint& joint : s.joints) {
        low = std::min(low, static_cast<double>(component(joint.position, axis)));
        high = std::max(high, static_cast<double>(component(joint.position, axis)));
      }
      extent_ = std::max(extent_, high - low);
    }
    for (size_t j = 0; j < count(); ++j) {
      int above = s.joints[j].parent;
      while (above >= 0 && !is_core(above)) above = s.joints[joint_index(above)].parent;
      core_parents_[j] = above;
      if (is_core(static_cast<int>(j)))
        for (above = core_parents_[j]; above >= 0; above = core_parent_of(above)) ++below_[joint_index(above)];
    }
  }

  Limbs find() {
    find_pelvis();
    find_trunk();
    for (const LimbKind kind : {LimbKind::kArm, LimbKind::kLeg, LimbKind::kTail, LimbKind::kWing, LimbKind::kEar,
                                LimbKind::kHair, LimbKind::kOther})
      find_chains(kind);
    join_pieces();
    for (Limb& limb : out_.limbs) find_side(&limb);
    return std::move(out_);
  }

 private:
  size_t count() const { return s_.joints.size(); }
  bool is_core(int j) const { return s_.classes[joint_index(j)] != kClassDetail; }
  bool is_end(int j) const { return s_.ends[joint_index(j)] != 0; }
  uint8_t class_of(int j) const { return s_.classes[joint_index(j)]; }
  int core_parent_of(int j) const {
    int above = s_.joints[joint_index(j)].parent;
    while (above >= 0 && !is_core(above)) above = s_.joints[joint_index(above)].parent;
    return above;
  }
  int depth(int j) const {
    int steps = 0;
    for (int above = core_parents_[joint_index(j)]; above >= 0; above = core_parents_[joint_index(above)]) ++steps;
    return steps;
  }
  bool hangs_on(int j, int above) const {
    for (; j >= 0; j = core_parents_[joint_index(j)])
      if (j == above) return true;
    return false;
  }
  std::vector<int> core_children(int parent) const {
    std::vector<int> found;
    for (size_t j = 0; j < count(); ++j)
      if (core_parents_[j] == parent && is_core(static_cast<int>(j))) found.push_back(static_cast<int>(j));
    return found;
  }

  // The lowest common ancestor of the body, or the pelvis nearest below it, as roots on the floor may be called
  // pelvis too.
  void find_pelvis() {
    std::vector<int> body;
    for (size_t j = 0; j < count(); ++j)
      if (is_core(static_cast<int>(j)) && s_.ends[j] == 0 && s_.classes[j] != SINEW_CLASS_PELVIS &&
          s_.classes[j] != SINEW_CLASS_OTHER)
        body.push_back(static_cast<int>(j));
    int best = -1;
    size_t most = 0;
    int deepest = -1;
    for (size_t j = 0; j < count(); ++j) {
      const int joint = static_cast<int>(j);
      if (s_.classes[j] != SINEW_CLASS_PELVIS || s_.ends[j] != 0) continue;
      size_t carried = 0;
      for (const int one : body) carried += hangs_on(one, joint) ? 1 : 0;
      // A joint that carries slightly less than its parent is still the pelvis: feet for inverse kinematics are
      // children of roots.
      const bool better = best < 0 || (depth(joint) > deepest ? 2 * carried > most && carried > 0 : carried > 2 * most);
      if (!better) continue;
      best = joint;
      most = std::max(most, carried);
      deepest = depth(joint);
    }
    out_.pelvis = best;
  }

  void find_trunk() {
    int head = -1;
    for (const uint8_t wanted : {SINEW_CLASS_HEAD, SINEW_CLASS_NECK, SINEW_CLASS_SPINE}) {
      for (size_t j = 0; j < count(); ++j) {
        const int joint = static_cast<int>(j);
        if (s_.classes[j] != wanted || s_.ends[j] != 0) continue;
        const bool first = wanted == SINEW_CLASS_HEAD;
        if (head < 0 || (first ? depth(joint) < depth(head) : depth(joint) > depth(head))) head = joint;
      }
      if (head >= 0) break;
    }
    Limb trunk;
    trunk.kind = LimbKind::kTrunk;
    for (int j = head; j >= 0; j = core_parents_[joint_index(j)]) {
      if (j == out_.pelvis) break;
      if (class_of(j) == SINEW_CLASS_PELVIS) break;
      trunk.joints.push_back(j);
    }
    if (out_.pelvis >= 0) trunk.joints.push_back(out_.pelvis);
    std::reverse(trunk.joints.begin(), trunk.joints.end());
    if (trunk.joints.empty()) return;
    add_end(&trunk);
    take(trunk);
  }

  void add_end(Limb* limb) const {
    for (const int child : core_children(limb->joints.back())) {
      if (!is_end(child)) continue;
      limb->joints.push_back(child);
      return;
    }
  }

  void take(const Limb& limb) {
    for (const int j : limb.joints) used_[joint_index(j)] = true;
    out_.limbs.push_back(limb);
  }

  void find_chains(LimbKind kind) {
    while (true) {
      int start = -1;
      for (size_t j = 0; j < count(); ++j) {
        const int joint = static_cast<int>(j);
        if (used_[j] || !is_core(joint) || is_end(joint) || kind_of(s_.classes[j]) != kind) continue;
        if (kind == LimbKind::kOther && is_above_pelvis(joint)) continue;
        if (start < 0 || depth(joint) < depth(start)) start = joint;
      }
      if (start < 0) return;
      Limb limb;
      limb.kind = kind;
      for (int j = start; j >= 0; j = next(j, kind)) limb.joints.push_back(j);
      add_end(&limb);
      take(limb);
    }
  }

  bool is_above_pelvis(int j) const { return out_.pelvis >= 0 && hangs_on(out_.pelvis, j); }

  int next(int j, LimbKind kind) const {
    int best = -1;
    for (const int child : core_children(j)) {
      if (used_[joint_index(child)] || is_end(child) || kind_of(class_of(child)) != kind) continue;
      if ((kind == LimbKind::kArm || kind == LimbKind::kLeg) && class_of(child) < class_of(j)) continue;
      if (best < 0 || below_[joint_index(child)] > below_[joint_index(best)]) best = child;
    }
    return best;
  }

  // Arms and legs in pieces: feet that are children of a root continue at the end of the calf.
  void join_pieces() {
    for (size_t a = 0; a < out_.limbs.size(); ++a) {
      for (size_t b = 0; b < out_.limbs.size(); ++b) {
        Limb &limb = out_.limbs[a], &piece = out_.limbs[b];
        if (a == b || limb.kind != piece.kind || (limb.kind != LimbKind::kArm && limb.kind != LimbKind::kLeg)) continue;
        find_side(&limb);
        find_side(&piece);
        const int last = is_end(limb.joints.back()) && limb.joints.size() > 1 ? limb.joints[limb.joints.size() - 2]
                                                                              : limb.joints.back();
        if (limb.side != piece.side || class_of(piece.joints.front()) <= class_of(last)) continue;
        if (limb.joints.back() != last) limb.joints.pop_back();
        limb.joints.insert(limb.joints.end(), piece.joints.begin(), piece.joints.end());
        out_.limbs.erase(out_.limbs.begin() + static_cast<ptrdiff_t>(b));
        a = 0;
        b = 0;
      }
    }
  }

  void find_side(Limb* limb) const {
    limb->side = 0;
    if (limb->kind == LimbKind::kTrunk) return;
    double sum = 0;
    for (const int j : limb->joints)
      sum += static_cast<double>(component(s_.joints[joint_index(j)].position, across_)) - plane_;
    sum /= static_cast<double>(limb->joints.size());
    const bool paired = limb->kind == LimbKind::kArm || limb->kind == LimbKind::kLeg || limb->kind == LimbKind::kEar;
    if (std::fabs(sum) < kBeside * extent_ && !paired) return;
    limb->side = sum > 0 ? 1 : -1;
  }

  const LabeledSkeleton& s_;
  uint32_t across_;
  double plane_, extent_ = 0;
  std::vector<int> core_parents_;  // [J] the nearest joint above that is no detail
  std::vector<size_t> below_;      // [J] joints below that are no details
  std::vector<bool> used_;
  Limbs out_;
};

}  // namespace

Limbs find_limbs(const LabeledSkeleton& skeleton, uint32_t across, double plane) {
  return LimbFinder(skeleton, across, plane).find();
}

}  // namespace sinew
