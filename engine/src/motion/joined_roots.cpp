// SPDX-License-Identifier: MIT
// Attaches roots of one body to its joints: by the source's hierarchy, else by position. The same for hands and feet
// outside their limbs without a source.
#include "motion/retarget_plan.hpp"
#include "sinew/rig.h"

namespace sinew::motion {
namespace {

class RootJoiner {
 public:
  RootJoiner(sinew_retarget* plan, uint32_t* scratch) : plan_(*plan), rig_(plan->target), scratch_(scratch) {}

  void run() {
    for (uint32_t t = 0; t < rig_.count; ++t) {
      if (rig_.file_parents[t] >= 0) continue;
      const int32_t above = parent_of(t);
      if (above < 0) continue;
      hang(t, above);
    }
    for (uint32_t t = 0; t < rig_.count; ++t)
      if (is_loose_end(t)) hang_end(t);
  }

 private:
  void hang(uint32_t t, int32_t above) {
    rig_.parents[t] = above;
    (void)rig_.sort(scratch_);
  }

  // A hand or foot of inverse kinematics that nothing moves.
  bool is_loose_end(uint32_t t) const {
    const uint32_t own = plan_.classes[t], before = class_before(own);
    if (is_mapped(t) || (own != SINEW_CLASS_FOOT && own != SINEW_CLASS_HAND) || has_mapped_below(t)) return false;
    for (int32_t at = rig_.parents[t]; at >= 0; at = rig_.parents[at])
      if (plan_.classes[at] == before || plan_.classes[at] == own) return false;
    return true;
  }
  // Goes with the nearest forearm or calf that moves, and its control at the same position with it.
  void hang_end(uint32_t t) {
    int32_t best = -1;
    for (uint32_t c = 0; c < rig_.count; ++c)
      if (is_mapped(c) && plan_.classes[c] == class_before(plan_.classes[t]) && is_nearer(c, best, t))
        best = static_cast<int32_t>(c);
    if (best < 0) return;
    const double near = 0.1 * distance(static_cast<uint32_t>(best), t);
    uint32_t top = t;
    for (int32_t at = rig_.parents[t]; at >= 0; at = rig_.parents[at]) {
      if (is_mapped(static_cast<uint32_t>(at)) || has_mapped_below(static_cast<uint32_t>(at)) ||
          distance(static_cast<uint32_t>(at), t) > near)
        break;
      top = static_cast<uint32_t>(at);
    }
    if (!rig_.is_below(static_cast<uint32_t>(best), top)) hang(top, best);
  }
  bool has_mapped_below(uint32_t t) const {
    for (uint32_t c = 0; c < rig_.count; ++c)
      if (is_mapped(c) && rig_.is_below(c, t)) return true;
    return false;
  }

  bool is_mapped(uint32_t t) const { return plan_.map[t] >= 0; }
  double distance(uint32_t a, uint32_t b) const { return length(rig_.positions[a] - rig_.positions[b]); }
  bool is_nearer(uint32_t joint, int32_t best, uint32_t to) const {
    return best < 0 || distance(joint, to) < distance(static_cast<uint32_t>(best), to);
  }
  bool has_mapped_above(uint32_t t) const {
    for (int32_t at = rig_.parents[t]; at >= 0; at = rig_.parents[at])
      if (is_mapped(static_cast<uint32_t>(at))) return true;
    return false;
  }

  // -1 for a root of the body, for feet and hands of inverse kinematics, which have carriers, and for what is a root in the source as well.
  int32_t parent_of(uint32_t root) const {
    bool mapped = false;
    for (uint32_t i = 0; i < rig_.count; ++i) {
      const uint32_t t = rig_.order[i];
      if (!is_mapped(t) || !rig_.is_below(t, root) || has_mapped_above(t)) continue;
      mapped = true;
      if (plan_.classes[t] == SINEW_CLASS_FOOT || plan_.classes[t] == SINEW_CLASS_HAND) continue;
      const int32_t above = holder_of(t, root);
      if (above >= 0) return above;
    }
    return mapped ? -1 : nearest_of_body(root);
  }

  // The joint of another root that moves as the nearest joint above the source of `t`, or -1.
  int32_t holder_of(uint32_t t, uint32_t root) const {
    const MotionRig& source = plan_.source;
    for (int32_t s = source.parents[plan_.map[t]]; s >= 0; s = source.parents[s]) {
      int32_t best = -1;
      for (uint32_t c = 0; c < rig_.count; ++c)
        if (plan_.map[c] == s && !rig_.is_below(c, root) && is_nearer(c, best, root)) best = static_cast<int32_t>(c);
      if (best >= 0) return best;
    }
    return -1;
  }

  // -1 where it lies farther than a tenth of the body's extent, as a stage may.
  int32_t nearest_of_body(uint32_t root) const {
    const uint32_t body = busiest_root(plan_, scratch_);
    double extent = 0;
    int32_t best = -1;
    for (uint32_t t = 0; t < rig_.count; ++t) {
      if (rig_.is_below(t, root) || rig_.root_of(t) != body) continue;
      if (distance(t, body) > extent) extent = distance(t, body);
      if (is_nearer(t, best, root)) best = static_cast<int32_t>(t);
    }
    return best >= 0 && distance(static_cast<uint32_t>(best), root) <= 0.1 * extent ? best : -1;
  }

  sinew_retarget& plan_;
  MotionRig& rig_;
  uint32_t* scratch_;
};

}  // namespace

void hang_roots(sinew_retarget* plan, uint32_t* scratch) { RootJoiner(plan, scratch).run(); }

uint32_t busiest_root(const sinew_retarget& plan, uint32_t* counts) {
  const MotionRig& rig = plan.target;
  for (uint32_t t = 0; t < rig.count; ++t) counts[t] = 0;
  for (uint32_t t = 0; t < rig.count; ++t) counts[rig.root_of(t)] += plan.map[t] >= 0 ? 1 : 0;
  uint32_t best = 0;
  for (uint32_t t = 1; t < rig.count; ++t) best = counts[t] > counts[best] ? t : best;
  return best;
}

}  // namespace sinew::motion
