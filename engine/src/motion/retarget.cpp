// SPDX-License-Identifier: MIT
// Retargets one frame: the source's rotations in the target's world, the target's by its map, the hips over the
// floor, local rotations.
#include "motion/retarget.hpp"

#include "core/sort.hpp"
#include "sinew/rig.h"

namespace sinew::motion {
namespace {

Vec3d without_height(Vec3d v, Vec3d up) { return v - dot(v, up) * up; }

// How far the whole source is over its floor, a tenth of a leg less: heels are as high while toes are on it.
double flight_of(const sinew_retarget& plan, double ground) {
  double low = 0;
  bool any = false;
  for (uint32_t t = 0; t < plan.target.count; ++t) {
    if (plan.map[t] < 0) continue;
    const double height = dot(plan.up, plan.source_positions[plan.map[t]]);
    low = any ? lesser(low, height) : height;
    any = true;
  }
  const double flight = low - ground - 0.1 * plan.leg_length;
  return flight > 0 ? flight : 0;
}

// Where the middle of the anchors is to be.
Vec3d wanted_middle(const sinew_retarget& plan, double ground) {
  Vec3d from = {0, 0, 0}, rest = {0, 0, 0};
  for (uint32_t i = 0; i < plan.anchor_count; ++i) {
    from = from + plan.source_positions[static_cast<uint32_t>(plan.map[plan.anchors[i]])];
    rest = rest + plan.target.positions[plan.anchors[i]];
  }
  const double share = 1.0 / plan.anchor_count;
  from = share * from;
  Vec3d wanted = plan.scale * (from - ground * plan.up) + plan.target_floor * plan.up;
  if (plan.flight_scale > plan.scale)
    wanted = wanted + (plan.flight_scale - plan.scale) * flight_of(plan, ground) * plan.up;
  if (plan.in_place) wanted = without_height(share * rest, plan.up) + dot(wanted, plan.up) * plan.up;
  return wanted;
}

// A bone of a torso, an arm or a leg, which keeps its length: rigs have other ideas of how long they are, or move joints that the
// target's skin does not follow. Hands and feet outside of their limbs do not count.
bool keeps_length(const sinew_retarget& plan, uint32_t t) {
  const uint32_t own = plan.classes[t], above = plan.classes[plan.target.parents[t]];
  switch (own) {
    case SINEW_CLASS_SPINE:
    case SINEW_CLASS_NECK:
    case SINEW_CLASS_HEAD:
    case SINEW_CLASS_CLAVICLE:
    case SINEW_CLASS_UPPER_ARM:
    case SINEW_CLASS_HIP:
    case SINEW_CLASS_THIGH:
      return true;
    case SINEW_CLASS_FOREARM:
      return above == SINEW_CLASS_UPPER_ARM || above == own;
    case SINEW_CLASS_HAND:
      return above == SINEW_CLASS_FOREARM || above == own;
    case SINEW_CLASS_CALF:
      return above == SINEW_CLASS_THIGH || above == own;
    case SINEW_CLASS_FOOT:
      return above == SINEW_CLASS_CALF || above == own;
    case SINEW_CLASS_TOE:
      return above == SINEW_CLASS_FOOT || above == own;
    default:
      return false;
  }
}

// Translation of a joint's source in its parent, if the two parents match: feet that are children of the root, and
// bones that stretch.
Vec3d left_position(const sinew_retarget& plan, uint32_t t) {
  constexpr double kRounding = 1e-4;  // of a leg: what numbers in files leave, which is no stretching
  const int32_t joint = plan.map[t], parent = plan.map[plan.target.parents[t]];
  if (joint < 0 || parent < 0 || plan.source.parents[joint] != parent) return {0, 0, 0};
  const Vec3d rest = rotate(plan.rotation, plan.source.positions[joint] - plan.source.positions[parent]);
  const Vec3d left =
      plan.source_positions[joint] - plan.source_positions[parent] - rotate(plan.source_rotations[parent], rest);
  const bool stretches = length(left) > kRounding * plan.leg_length;
  return stretches && !plan.translations && !plan.same_rig && keeps_length(plan, t) ? Vec3d{0, 0, 0} : left;
}

// Feet and hands outside their limbs move to the ends of these, with their children.
void carry_ends(sinew_retarget* plan) {
  const MotionRig& rig = plan->target;
  for (uint32_t t = 0; t < rig.count; ++t) {
    const int32_t carrier = plan->carriers[t];
    if (carrier < 0) continue;
    const Vec3d offset = rotate(plan->target_rotations[carrier], rig.positions[t] - rig.positions[carrier]);
    const Vec3d shift = plan->target_positions[carrier] + offset - plan->target_positions[t];
    for (uint32_t below = 0; below < rig.count; ++below) {
      if (rig.is_below(below, t)) plan->target_positions[below] = plan->target_positions[below] + shift;
    }
  }
}

void pose_target(sinew_retarget* plan, double ground) {
  const MotionRig& rig = plan->target;
  for (uint32_t i = 0; i < rig.count; ++i) {
    const uint32_t t = rig.order[i];
    const int32_t parent = rig.parents[t];
    if (plan->map[t] >= 0) {
      plan->target_rotations[t] = plan->source_rotations[plan->map[t]] * plan->align[t];
    } else {
      plan->target_rotations[t] = parent < 0 ? kNoRotation : plan->target_rotations[parent];
    }
    Vec3d position = rig.positions[t];
    if (parent >= 0) {
      position = plan->target_positions[parent] +
                 rotate(plan->target_rotations[parent], position - rig.positions[parent]) +
                 plan->scale * left_position(*plan, t);
    } else if (plan->map[t] >= 0 && static_cast<int32_t>(t) != plan->mover) {  // on the floor, or beside the body
      const uint32_t source = static_cast<uint32_t>(plan->map[t]);
      Vec3d offset =
          plan->scale * (plan->source_positions[source] - rotate(plan->rotation, plan->source.positions[source]));
      if (plan->in_place) offset = dot(offset, plan->up) * plan->up;
      position = position + offset;
    }
    plan->target_positions[t] = position;
  }
  Vec3d middle = {0, 0, 0};
  for (uint32_t i = 0; i < plan->anchor_count; ++i) middle = middle + plan->target_positions[plan->anchors[i]];
  const Vec3d offset = wanted_middle(*plan, ground) - (1.0 / plan->anchor_count) * middle;
  move_target(plan, offset);
  carry_ends(plan);
}

// As published: joints go with their sources' frames, at the offset that they have at rest, the source's lengths scaled.
void offset_target(sinew_retarget* plan) {
  const MotionRig& rig = plan->target;
  Vec3d before = {0, 0, 0}, after = {0, 0, 0};  // sums over the anchors
  for (uint32_t i = 0; i < plan->anchor_count; ++i) before = before + rig.positions[plan->anchors[i]];
  for (uint32_t i = 0; i < rig.count; ++i) {
    const uint32_t t = rig.order[i];
    const int32_t parent = rig.parents[t], source = plan->map[t];
    if (source >= 0) {
      const Vec3d offset = rig.positions[t] - plan->scale * rotate(plan->rotation, plan->source.positions[source]);
      plan->target_rotations[t] = plan->source_rotations[source];
      plan->target_positions[t] =
          plan->scale * plan->source_positions[source] + rotate(plan->target_rotations[t], offset);
    } else {
      const Vec3d away = rig.positions[t] - (parent < 0 ? Vec3d{0, 0, 0} : rig.positions[parent]);
      plan->target_rotations[t] = parent < 0 ? kNoRotation : plan->target_rotations[parent];
      plan->target_positions[t] =
          parent < 0 ? away : plan->target_positions[parent] + rotate(plan->target_rotations[t], away);
    }
  }
  if (!plan->in_place) return;
  for (uint32_t i = 0; i < plan->anchor_count; ++i) after = after + plan->target_positions[plan->anchors[i]];
  const Vec3d back = without_height((1.0 / plan->anchor_count) * (before - after), plan->up);
  for (uint32_t t = 0; t < rig.count; ++t) plan->target_positions[t] = plan->target_positions[t] + back;
}

// A joint at which an arm begins.
bool is_shoulder(const sinew_retarget& plan, uint32_t t) {
  return plan.classes[t] == SINEW_CLASS_UPPER_ARM && plan.long_ends[t] >= 0;
}

// The topmost shoulder at or above a joint, or -1. What is carried belongs to its carrier's arm.
int32_t shoulder_of(const sinew_retarget& plan, uint32_t t) {
  int32_t at = static_cast<int32_t>(t), found = -1;
  for (int32_t up = at; up >= 0; up = plan.target.parents[up]) {
    if (plan.carriers[up] < 0) continue;
    at = plan.carriers[up];
    break;
  }
  for (; at >= 0; at = plan.target.parents[at]) {
    if (is_shoulder(plan, static_cast<uint32_t>(at))) found = at;
  }
  return found;
}

// Rotates each arm at its shoulder, away from the plane between left and right that the shoulder's parent carries along.
// The angle is whole where the upper arm lies in that plane, and fades to none where it points sideways: a constant
// rotation about the body's front would bring raised arms into the head.
SINEW_RARE void spread_arms(sinew_retarget* plan) {
  const MotionRig& rig = plan->target;
  Vec3d middle = {0, 0, 0}, anchors = {0, 0, 0};  // of all shoulders at rest
  double count = 0;
  for (uint32_t t = 0; t < rig.count; ++t) {
    if (!is_shoulder(*plan, t)) continue;
    middle = middle + rig.positions[t];
    count += 1;
  }
  for (uint32_t i = 0; i < plan->anchor_count; ++i) anchors = anchors + rig.positions[plan->anchors[i]];
  middle = count > 1 ? (1 / count) * middle : (1.0 / plan->anchor_count) * anchors;
  for (uint32_t s = 0; s < rig.count; ++s) {
    if (!is_shoulder(*plan, s) || shoulder_of(*plan, s) != static_cast<int32_t>(s)) continue;
    const int32_t parent = rig.parents[s];
    const Quat carried = parent < 0 ? kNoRotation : plan->target_rotations[parent];
    const Vec3d outward = rotate(carried, unit(without_height(rig.positions[s] - middle, plan->up)));
    const Vec3d pivot = plan->target_positions[s];
    const Vec3d across = cross(unit(plan->target_positions[plan->long_ends[s]] - pivot), outward);
    double cosine, sine;
    cosine_and_sine(0.5 * plan->arm_spread * length(across), &cosine, &sine);
    const Vec3d axis = sine * unit(across);
    const Quat rotation = {axis.x, axis.y, axis.z, cosine};
    for (uint32_t t = 0; t < rig.count; ++t) {
      if (shoulder_of(*plan, t) != static_cast<int32_t>(s)) continue;
      plan->target_rotations[t] = rotation * plan->target_rotations[t];
      plan->target_positions[t] = pivot + rotate(rotation, plan->target_positions[t] - pivot);
    }
  }
}

}  // namespace

sinew_status pose_source(sinew_retarget* plan, const float* rotations, const float* translations) {
  const MotionRig& rig = plan->source;
  for (uint32_t i = 0; i < rig.count; ++i) {
    const uint32_t j = rig.order[i];
    const float* const q = rotations + size_t{4} * j;
    const float* const t = translations + size_t{3} * j;
    const Quat given = {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]),
                        static_cast<double>(q[3])};
    const Vec3d offset = {static_cast<double>(t[0]), static_cast<double>(t[1]), static_cast<double>(t[2])};
    if (!is_finite(given.x + given.y + given.z + given.w + offset.x + offset.y + offset.z))
      return SINEW_ERROR_NOT_FINITE;
    const Quat local = normalized(given);
    const int32_t parent = rig.file_parents[j];
    plan->source_rotations[j] = parent < 0 ? local : plan->source_rotations[parent] * local;
    plan->source_positions[j] =
        parent < 0 ? offset : plan->source_positions[parent] + rotate(plan->source_rotations[parent], offset);
  }
  const Quat back = conjugate(plan->rotation);
  for (uint32_t j = 0; j < rig.count; ++j) {
    plan->source_rotations[j] = plan->rotation * (plan->source_rotations[j] * conjugate(rig.rotations[j])) * back;
    plan->source_positions[j] = rotate(plan->rotation, plan->source_positions[j]);
  }
  return SINEW_OK;
}

Vec3d travel_of(const sinew_retarget& plan, const float* rotations, const float* translations) {
  const MotionRig& rig = plan.source;
  Vec3d path = {0, 0, 0};
  for (uint32_t i = 0; i < plan.anchor_count; ++i) {
    Vec3d position = {0, 0, 0};
    for (int32_t j = plan.map[plan.anchors[i]]; j >= 0; j = rig.file_parents[j]) {
      const float* const q = rotations + size_t{4} * static_cast<uint32_t>(j);
      const float* const t = translations + size_t{3} * static_cast<uint32_t>(j);
      const Quat rotation = normalized(
          {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]), static_cast<double>(q[3])});
      position = rotate(rotation, position) +
                 Vec3d{static_cast<double>(t[0]), static_cast<double>(t[1]), static_cast<double>(t[2])};
    }
    path = path + plan.scale * rotate(plan.rotation, position) - plan.target.positions[plan.anchors[i]];
  }
  return without_height((1.0 / plan.anchor_count) * path, plan.up);
}

void move_target(sinew_retarget* plan, Vec3d offset) {
  for (uint32_t t = 0; t < plan->target.count; ++t) {
    if (plan->moved[t] != 0) plan->target_positions[t] = plan->target_positions[t] + offset;
  }
}

void load_target(sinew_retarget* plan, const float* rotations, const float* translations) {
  const MotionRig& rig = plan->target;
  for (uint32_t i = 0; i < rig.count; ++i) {
    const uint32_t t = rig.order[i];
    const float* const q = rotations + size_t{4} * t;
    const float* const p = translations + size_t{3} * t;
    Quat rotation = normalized(
        {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]), static_cast<double>(q[3])});
    Vec3d position = {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    const int32_t parent = rig.file_parents[t];
    if (parent >= 0) {
      const Quat above = plan->target_rotations[parent] * rig.rotations[parent];
      rotation = above * rotation;
      position = plan->target_positions[parent] + rotate(above, position);
    }
    // Rotations relative to the rest pose are kept; children need the parent's full rotation, which is the product.
    plan->target_rotations[t] = rotation * conjugate(rig.rotations[t]);
    plan->target_positions[t] = position;
  }
}

void store_target(const sinew_retarget& plan, float* rotations, float* translations) {
  const MotionRig& rig = plan.target;
  for (uint32_t t = 0; t < rig.count; ++t) {
    const int32_t parent = rig.file_parents[t];
    Quat local = plan.target_rotations[t] * rig.rotations[t];
    Vec3d offset = plan.target_positions[t];
    if (parent >= 0) {
      const Quat back = conjugate(plan.target_rotations[parent] * rig.rotations[parent]);
      local = back * local;
      offset = rotate(back, offset - plan.target_positions[parent]);
    }
    local = normalized(local);
    if (local.w < 0) local = {-local.x, -local.y, -local.z, -local.w};  // one of the two that are the same rotation
    float* const q = rotations + size_t{4} * t;
    q[0] = static_cast<float>(local.x);
    q[1] = static_cast<float>(local.y);
    q[2] = static_cast<float>(local.z);
    q[3] = static_cast<float>(local.w);
    float* const p = translations + size_t{3} * t;
    p[0] = static_cast<float>(offset.x);
    p[1] = static_cast<float>(offset.y);
    p[2] = static_cast<float>(offset.z);
  }
}

double lowest_floor_joint(const sinew_retarget& plan) {
  double lowest = 0;
  for (uint32_t i = 0; i < plan.floor_count; ++i) {
    const uint32_t source = static_cast<uint32_t>(plan.map[plan.floor_joints[i]]);
    const double height = dot(plan.up, plan.source_positions[source]);
    if (i == 0 || height < lowest) lowest = height;
  }
  return lowest;
}

bool stands_at_rest(const sinew_retarget& plan) {
  const double low = plan.source_lowest < 0 ? -plan.source_lowest : plan.source_lowest;
  return low <= 0.2 * plan.leg_length;
}

sinew_status source_height(sinew_retarget* plan, const float* rotations, const float* translations, float* height) {
  const sinew_status status = pose_source(plan, rotations, translations);
  if (status == SINEW_OK) *height = static_cast<float>(lowest_floor_joint(*plan));
  return status;
}

sinew_status standing_height(const sinew_retarget& plan, float* heights, size_t count, float* ground) {
  for (size_t i = 0; i < count; ++i) {
    if (!is_finite(static_cast<double>(heights[i]))) return SINEW_ERROR_NOT_FINITE;
  }
  *ground = static_cast<float>(plan.source_floor);
  if (count == 0) return SINEW_OK;
  heap_sort(heights, count, [](float a, float b) { return a < b; });
  const double at = 0.05 * static_cast<double>(count - 1);
  const size_t below = static_cast<size_t>(at);
  const double low = static_cast<double>(heights[below]);
  const double next = static_cast<double>(heights[below + 1 < count ? below + 1 : below]);
  const double fifth = low + (at - static_cast<double>(below)) * (next - low);
  const auto size = [](double x) { return x < 0 ? -x : x; };
  const bool stands = stands_at_rest(plan);
  // A clip whose feet never come down to where they are at rest stands on a floor of its own; one that is higher than its legs hangs,
  // or stands on its hands.
  const double over = fifth - plan.source_floor;
  const double third = static_cast<double>(heights[(count - 1) * 3 / 10]);  // of ten: feet come back to one height
  const bool floats =
      stands && over > 0.25 * plan.leg_length && over < plan.leg_length && third - fifth < 0.05 * plan.leg_length;
  if (floats || (!stands && size(over) > 0.05 * plan.leg_length)) *ground = static_cast<float>(fifth);
  return SINEW_OK;
}

sinew_status retarget_frame(sinew_retarget* plan, const float* rotations, const float* translations, float ground,
                            float* out_rotations, float* out_translations) {
  const double height = static_cast<double>(ground);
  if (!is_finite(height)) return SINEW_ERROR_NOT_FINITE;
  const sinew_status status = pose_source(plan, rotations, translations);
  if (status != SINEW_OK) return status;
  if (plan->node_offsets) {
    offset_target(plan);
  } else {
    pose_target(plan, height);
  }
  if (plan->arm_spread != 0) spread_arms(plan);
  store_target(*plan, out_rotations, out_translations);
  return SINEW_OK;
}

}  // namespace sinew::motion
