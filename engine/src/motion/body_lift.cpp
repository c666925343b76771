// SPDX-License-Identifier: MIT
// Needs of a frame, smoothed over frames, moved in rounds.
#include "motion/body_lift.hpp"

namespace sinew::motion {
namespace {

constexpr double kFeltFeet = 0.1;    // share of the source's height up to which feet carry
constexpr double kSteep = 0.04;      // square of the share of its length that a torso lies level, at which it is steep
constexpr double kMostPitch = 0.15;  // about the angle of one round
constexpr double kStraight = 0.999;  // share of an arm's length that it reaches
constexpr uint32_t kFloorPasses = 12, kNeedPasses = 4;

// One height for several patches: patches below the floor come first, and those hardly on it hold nothing down.
struct Wanted {
  double greatest = -1e300, least = 0, weight = 0;
  double slack = 0;  // a patch of no weight may be as far below

  void add(double own, double rise) {
    if (!(own > 0)) return;
    greatest = greater(greatest, rise > 0 ? own * rise : rise - (1 - own) * slack);
    least = lesser(least, own * rise);
    weight = greater(weight, own);
  }
  double rise() const { return weight > 0 ? greater(greatest, least) : 0; }
};

}  // namespace

void BodyLift::follow_floor() {
  if (s_.in->floor.heights == nullptr) return;
  for (uint32_t f = 0; f < s_.in->frames; ++f) {
    s_.load(f);
    s_.lifts[f] = {floor_below(), 0, 0};
  }
  apply(kFloorPasses);
}

double BodyLift::floor_below() const {
  const FloorGrid& floor = s_.in->floor;
  double low = 0;
  bool any = false;
  for (uint32_t l = 0; l < s_.limbs.count; ++l) {
    if (!s_.limbs.limbs[l].leg) continue;
    const double own = floor.height(plan_.up, plan_.target_positions[feet_.sole_joint(s_.limbs.limbs[l])]);
    low = any ? lesser(low, own) : own;
    any = true;
  }
  return any ? low : floor.height(plan_.up, hips());
}

void BodyLift::meet_floor() {
  for (uint32_t f = 0; f < s_.in->frames; ++f) s_.lifts[f] = needs_of(f);
  apply(kNeedPasses);
}

// x: of all, y: of the torso's pitch.
Vec3d BodyLift::needs_of(uint32_t frame) {
  const FloorPatches& patches = s_.floor_patches;
  bool any = false;
  for (uint32_t i = 0; i < kPatchCount; ++i) any = any || patches.at(frame, i).weight > 0;
  if (!any) return {0, 0, 0};
  (void)s_.load_source(frame, false);
  s_.load(frame);
  double rises[kPatchCount];
  patches.find_rises(frame, ~uint64_t{0}, rises);
  Wanted lower, upper;
  lower.slack = upper.slack = 0.1 * s_.target.height;
  lower.add(patches.at(frame, kSeat).weight, rises[kSeat]);
  upper.add(patches.at(frame, kChest).weight, rises[kChest]);
  double carried = 0;
  for (uint32_t l = 0; l < s_.limbs.count; ++l) {
    const Limb& limb = s_.limbs.limbs[l];
    const uint32_t middle = middle_patch(l);
    (limb.leg ? lower : upper).add(patches.at(frame, middle).weight, rises[middle]);
    if (limb.leg) carried = greater(carried, 1 - ramp(feet_.height(limb), 0, kFeltFeet * s_.source_height));
  }
  carried = greater(carried, lower.weight);
  double touch = 0;  // of arms
  const double arms = arm_need(frame, rises, &touch);
  const double above = upper.rise() + (1 - upper.weight) * arms;
  const double lift = lower.rise() + (1 - carried) * above;
  // Errors that remain after the lift. Arms that reach the floor then ask for nothing, and where nothing above
  // touches the torso stays.
  const double left = upper.weight * (upper.rise() - lift) + (1 - upper.weight) * lesser(0, arms - touch * lift);
  const Vec3d trunk = shoulders() - hips();
  const double level = length(cross(trunk, plan_.up)), square = dot(trunk, trunk);
  if (!(square > 0)) return {lift, 0, 0};
  return {lift, clamped(left * level / (level * level + kSteep * square), -kMostPitch, kMostPitch), 0};
}

// How far shoulders are to sink so that straight arms reach the floor; 0 or less. touch: the greatest weight of a hand.
double BodyLift::arm_need(uint32_t frame, const double* rises, double* touch) const {
  double need = 0;
  for (uint32_t l = 0; l < s_.limbs.count; ++l) {
    const Limb& limb = s_.limbs.limbs[l];
    const double own = limb.leg ? 0 : s_.floor_patches.at(frame, l).weight;
    if (!(own > 0)) continue;
    *touch = greater(*touch, own);
    const Vec3d first = plan_.target_positions[limb.first], middle = plan_.target_positions[limb.middle],
                last = plan_.target_positions[limb.last];
    const double whole = kStraight * (length(middle - first) + length(last - middle));
    const Vec3d arm = first - last - rises[l] * plan_.up;
    const double height = dot(arm, plan_.up), across = dot(arm, arm) - height * height;
    const double reach = whole * whole > across ? root(whole * whole - across) : 0;
    need = lesser(need, own * (reach - height));
  }
  return need;
}

void BodyLift::apply(uint32_t passes) {
  smooth_over_time(s_.lifts, s_.in->frames, 1, passes, s_.smooth);
  for (uint32_t f = 0; f < s_.in->frames; ++f) {
    const Vec3d move = s_.lifts[f];
    if (!(dot(move, move) > 0)) continue;
    s_.load(f);
    move_trunk(move.x, move.y);
    s_.store(f);
  }
}

void BodyLift::move_trunk(double lift, double pitch) {
  const Vec3d pivot = hips(), axis = unit(cross(shoulders() - pivot, plan_.up));
  const Vec3d half = (0.5 * pitch) * axis;
  const Quat rotation = normalized({half.x, half.y, half.z, 1});
  const Vec3d raise = lift * plan_.up;
  Vec3d shifts[kMostLimbs];  // of legs, which keep their rotations
  for (uint32_t l = 0; l < s_.limbs.count; ++l) {
    const Vec3d before = plan_.target_positions[s_.limbs.limbs[l].first];
    shifts[l] = pivot + rotate(rotation, before - pivot) - before;
  }
  for (uint32_t t = 0; t < plan_.target.count; ++t) {
    if (plan_.moved[t] == 0) continue;
    Vec3d* const position = &plan_.target_positions[t];
    const uint32_t limb = s_.joint_limbs[t];
    if (limb < kMostLimbs && s_.limbs.limbs[limb].leg) {
      *position = *position + shifts[limb] + raise;
    } else {
      *position = pivot + rotate(rotation, *position - pivot) + raise;
      plan_.target_rotations[t] = rotation * plan_.target_rotations[t];
    }
  }
}

Vec3d BodyLift::hips() const {
  Vec3d sum = {0, 0, 0};
  for (uint32_t i = 0; i < plan_.anchor_count; ++i) sum = sum + plan_.target_positions[plan_.anchors[i]];
  return (1.0 / plan_.anchor_count) * sum;
}

// The hips where there are no arms.
Vec3d BodyLift::shoulders() const {
  Vec3d sum = {0, 0, 0};
  double count = 0;
  for (uint32_t l = 0; l < s_.limbs.count; ++l) {
    if (s_.limbs.limbs[l].leg) continue;
    sum = sum + plan_.target_positions[s_.limbs.limbs[l].first];
    count += 1;
  }
  return count > 0 ? (1 / count) * sum : hips();
}

}  // namespace sinew::motion
