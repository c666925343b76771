// SPDX-License-Identifier: MIT
// Limbs by the long bones of a plan; the law of cosines without angles.
#include "motion/limbs.hpp"

#include "sinew/rig.h"

namespace sinew::motion {
namespace {

// The part of v unit_across u, of length 1; (0, 0, 0) where they are in line.
Vec3d unit_across(Vec3d v, Vec3d u, double least) {
  const Vec3d side = v - dot(v, u) * u;
  return length(side) > least ? unit(side) : Vec3d{0, 0, 0};
}

constexpr double kCosine25 = 0.906307787036650, kCosine45 = 0.707106781186548;

// The end's rotate against the second bone, as little changed as brings it within a right angle or to `before`.
void turn_end(const Limb& limb, double before, sinew_retarget* plan) {
  const Quat second = plan->target_rotations[limb.middle];
  Quat own = conjugate(second) * plan->target_rotations[limb.last];
  if (own.w < 0) own = {-own.x, -own.y, -own.z, -own.w};
  const double least = before < kCosine45 ? before : kCosine45;  // cosine of half the angle
  if (own.w >= least) return;
  const Vec3d axis = root(1 - least * least) * unit({own.x, own.y, own.z});
  const Quat rotation = second * Quat{axis.x, axis.y, axis.z, least} * conjugate(plan->target_rotations[limb.last]);
  const Vec3d pivot = plan->target_positions[limb.last];
  for (uint32_t t = 0; t < plan->target.count; ++t) {
    if (!plan->target.is_below(t, limb.last)) continue;
    plan->target_positions[t] = pivot + rotate(rotation, plan->target_positions[t] - pivot);
    plan->target_rotations[t] = rotation * plan->target_rotations[t];
  }
}

}  // namespace

LimbList find_limbs(const sinew_retarget& plan) {
  LimbList list;
  const MotionRig& rig = plan.target;
  for (uint32_t t = 0; t < rig.count && list.count < kMostLimbs; ++t) {
    const uint32_t own = plan.classes[t];
    if ((own != SINEW_CLASS_THIGH && own != SINEW_CLASS_UPPER_ARM) || plan.long_ends[t] < 0) continue;
    Limb limb;
    limb.first = t;
    limb.middle = static_cast<uint32_t>(plan.long_ends[t]);
    limb.leg = own == SINEW_CLASS_THIGH;
    if (plan.long_ends[limb.middle] < 0) continue;
    limb.last = static_cast<uint32_t>(plan.long_ends[limb.middle]);
    if (!rig.is_below(limb.last, limb.middle)) continue;  // carried
    for (uint32_t i = 0; i < rig.count && limb.toe < 0; ++i) {
      const uint32_t j = rig.order[i];
      if (plan.classes[j] == SINEW_CLASS_TOE && plan.map[j] >= 0 && rig.is_below(j, limb.last))
        limb.toe = static_cast<int32_t>(j);
    }
    list.limbs[list.count++] = limb;
  }
  return list;
}

Quat axes_of(const Limb& limb, const sinew_retarget& plan) {
  const int32_t above = plan.target.parents[limb.first];
  return above < 0 ? kNoRotation : plan.target_rotations[above];
}

void swing(uint32_t pivot, uint32_t end, Quat rotation, sinew_retarget* plan) {
  const MotionRig& rig = plan->target;
  const Vec3d at = plan->target_positions[pivot], before = plan->target_positions[end];
  const Vec3d shift = at + rotate(rotation, before - at) - before;
  for (uint32_t t = 0; t < rig.count; ++t) {
    if (!rig.is_below(t, pivot)) continue;
    if (rig.is_below(t, end)) {
      plan->target_positions[t] = plan->target_positions[t] + shift;
    } else {
      plan->target_positions[t] = at + rotate(rotation, plan->target_positions[t] - at);
      plan->target_rotations[t] = rotation * plan->target_rotations[t];
    }
  }
}

void move_limb(const Limb& limb, Vec3d goal, Vec3d wanted_middle, sinew_retarget* plan) {
  const MotionRig& rig = plan->target;
  const Vec3d a = plan->target_positions[limb.first], b = plan->target_positions[limb.middle],
              c = plan->target_positions[limb.last];
  const double upper = length(b - a), lower = length(c - b);
  if (upper <= 0 || lower <= 0) return;
  const double gap = upper > lower ? upper - lower : lower - upper;
  double nearest = 1.001 * gap + 1e-6 * upper;
  // A limb that is straighter already stays so: it would pop where it is hardly bent to one side, then to the other.
  const double now = length(c - a), straight = 0.9995 * (upper + lower);
  const double farthest = now > straight ? now : straight;
  if (limb.natural) {
    const double folded = root(upper * upper + lower * lower - 2 * kCosine25 * upper * lower);
    nearest = folded > nearest && folded < farthest ? folded : nearest;
  }
  const Quat end = conjugate(plan->target_rotations[limb.middle]) * plan->target_rotations[limb.last];
  const Vec3d offset = goal - a;
  double reach = length(offset);
  const Vec3d u = reach > 0 ? unit(offset) : unit(c - a);
  reach = reach < nearest ? nearest : reach > farthest ? farthest : reach;
  Vec3d side = unit_across(wanted_middle - a, u, 1e-4 * upper);
  if (dot(side, side) == 0) side = unit_across(b - a, u, 1e-4 * upper);
  if (dot(side, side) == 0) side = unit_across(b - a, unit(c - a), 1e-6 * upper);  // as it is bent now
  side = unit_across(side, u, 1e-6);
  if (dot(side, side) == 0) return;  // straight: the bend direction is unknown
  double cosine = (upper * upper + reach * reach - lower * lower) / (2 * upper * reach);
  cosine = cosine > 1 ? 1 : cosine < -1 ? -1 : cosine;
  const Vec3d middle = a + upper * (cosine * u + root(1 - cosine * cosine) * side);
  const Quat first = shortest_arc(b - a, middle - a);
  const Quat second = shortest_arc(rotate(first, c - b), a + reach * u - middle) * first;
  for (uint32_t i = 0; i < rig.count; ++i) {
    const uint32_t t = rig.order[i];
    if (!rig.is_below(t, limb.first)) continue;
    if (t != limb.first) {
      const uint32_t parent = static_cast<uint32_t>(rig.parents[t]);
      plan->target_positions[t] = plan->target_positions[parent] +
                                  rotate(plan->target_rotations[parent], rig.positions[t] - rig.positions[parent]);
    }
    if (rig.is_below(t, limb.last)) continue;
    plan->target_rotations[t] = (rig.is_below(t, limb.middle) ? second : first) * plan->target_rotations[t];
  }
  if (limb.natural) turn_end(limb, end.w < 0 ? -end.w : end.w, plan);
}

}  // namespace sinew::motion
