// SPDX-License-Identifier: MIT
// Directions against cosines and sines that are written down: no angle is needed.
#include "motion/natural_range.hpp"

namespace sinew::motion {
namespace {

constexpr double kSine5 = 0.0871557427476582;      // to the wrong side
constexpr double kCosine155 = -0.906307787036650;  // bent
constexpr double kSine1 = 0.0174524064372835;      // what a measure does not see
constexpr double kLeastBend = 0.0871557427476582;  // sine of a bend at rest that says to which side
constexpr double kLeastFront = 0.01;               // share of the height that feet reach forward, on average

Vec3d across(Vec3d v, Vec3d u) { return v - dot(v, u) * u; }

// Where feet point, over the floor; not of length 1, none where they do not tell.
Vec3d front_of(const ClipScene& scene) {
  const sinew_retarget& plan = *scene.plan;
  const Vec3d* const at = plan.target.positions;
  Vec3d by_joints = {0, 0, 0}, by_mesh = {0, 0, 0};
  for (uint32_t l = 0; l < scene.limbs.count; ++l) {
    const Limb& limb = scene.limbs.limbs[l];
    if (!limb.leg) continue;
    if (limb.toe >= 0) by_joints = by_joints + across(at[limb.toe] - at[limb.last], plan.up);
    Vec3d sum = {0, 0, 0};
    double count = 0;
    for (uint32_t v = 0; v < scene.body->vertex_count; ++v) {
      if (scene.limb_of[v] != l || scene.parts[v] != BodyPart::kFoot) continue;
      sum = sum + across(scene.target.rest(v) - at[limb.last], plan.up);
      count += 1;
    }
    if (count > 0) by_mesh = by_mesh + (1 / count) * sum;
  }
  const double least = kLeastFront * scene.target.height;
  return length(by_joints) > least ? by_joints : length(by_mesh) > least ? by_mesh : Vec3d{0, 0, 0};
}

struct Bones {
  double along, side;  // parts of the second bone's direction
  Vec3d direction;     // in the axes of the first bone's joint
};
Bones bones_of(const sinew_retarget& plan, const Limb& limb, const Hinge& hinge) {
  const Vec3d second = unit(plan.target_positions[limb.last] - plan.target_positions[limb.middle]);
  const Vec3d direction = rotate(conjugate(plan.target_rotations[limb.first]), second);
  return {dot(direction, hinge.along), dot(direction, hinge.side), direction};
}

}  // namespace

void find_hinges(const ClipScene& scene, Hinge (&hinges)[kMostLimbs]) {
  const Vec3d front = front_of(scene);
  const Vec3d* const at = scene.plan->target.positions;
  for (uint32_t l = 0; l < scene.limbs.count; ++l) {
    const Limb& limb = scene.limbs.limbs[l];
    Hinge& hinge = hinges[l];
    hinge = Hinge();
    hinge.along = unit(at[limb.middle] - at[limb.first]);
    const Vec3d second = unit(at[limb.last] - at[limb.middle]);
    // A calf bends back, a forearm to the front.
    const Vec3d by_front = across(limb.leg ? -1.0 * front : front, hinge.along), by_rest = across(second, hinge.along);
    const bool fronted = length(by_front) > 0.3 * length(front) && length(front) > 0;
    const bool bent = length(by_rest) > kLeastBend;
    if (dot(hinge.along, hinge.along) == 0 || dot(second, second) == 0 || (!fronted && !bent)) continue;
    hinge.known = true;
    hinge.side = unit(bent && (!fronted || dot(by_rest, by_front) > 0) ? by_rest : by_front);
    const double rest = dot(second, hinge.side);
    hinge.least_side = rest < -kSine5 ? rest : -kSine5;
  }
}

bool is_out_of_range(const sinew_retarget& plan, const Limb& limb, const Hinge& hinge) {
  if (!hinge.known) return false;
  const Bones now = bones_of(plan, limb, hinge);
  return now.side < hinge.least_side - kSine1 || now.along < kCosine155 - kSine1;
}

bool bend_into_range(const Limb& limb, const Hinge& hinge, sinew_retarget* plan) {
  if (!hinge.known) return false;
  const Bones now = bones_of(*plan, limb, hinge);
  if (dot(now.direction, now.direction) == 0) return false;
  const Vec3d third = cross(hinge.along, hinge.side);
  double x = now.along, y = now.side, z = dot(now.direction, third);
  // A joint bent to the wrong side is straightened by as much.
  if (y < hinge.least_side) {
    x += hinge.least_side - y;
    y = hinge.least_side;
    const double rest = root(x * x + z * z), whole = root(1 - y * y);
    x = rest > 0 ? x * whole / rest : whole;
    z = rest > 0 ? z * whole / rest : 0;
  }
  if (x < kCosine155) {
    x = kCosine155;
    const double rest = root(y * y + z * z), whole = root(1 - x * x);
    y = rest > 0 ? y * whole / rest : whole;
    z = rest > 0 ? z * whole / rest : 0;
  }
  if (x == now.along && y == now.side) return false;
  const Vec3d wanted = x * hinge.along + y * hinge.side + z * third;
  const Quat first = plan->target_rotations[limb.first];
  const Quat bend = shortest_arc(rotate(first, now.direction), rotate(first, wanted));
  const MotionRig& rig = plan->target;
  const Vec3d pivot = plan->target_positions[limb.middle];
  for (uint32_t t = 0; t < rig.count; ++t) {
    if (!rig.is_below(t, limb.middle)) continue;
    plan->target_positions[t] = pivot + rotate(bend, plan->target_positions[t] - pivot);
    plan->target_rotations[t] = bend * plan->target_rotations[t];
  }
  return true;
}

void keep_range_of_frame(ClipScene& scene, const Hinge (&hinges)[kMostLimbs], uint32_t frame) {
  scene.load(frame);
  bool bent = false;
  for (uint32_t l = 0; l < scene.limbs.count; ++l)
    bent = bend_into_range(scene.limbs.limbs[l], hinges[l], scene.plan) || bent;
  if (bent) scene.store(frame);
}

}  // namespace sinew::motion
