// SPDX-License-Identifier: MIT
// One frame: the source's turns in the target's world, the target's by its map, the hips over the floor, local again.
#include "motion/retarget.hpp"

#include "core/sort.hpp"

namespace sinew::motion {
namespace {

double lowest_floor_joint(const sinew_retarget& plan) {
  double lowest = 0;
  for (uint32_t i = 0; i < plan.floor_count; ++i) {
    const uint32_t source = static_cast<uint32_t>(plan.map[plan.floor_joints[i]]);
    const double height = dot(plan.up, plan.source_places[source]);
    if (i == 0 || height < lowest) lowest = height;
  }
  return lowest;
}

Vec3d without_height(Vec3d v, Vec3d up) { return v - dot(v, up) * up; }

// Where the middle of the anchors is to be.
Vec3d wanted_middle(const sinew_retarget& plan, double ground) {
  Vec3d from = {0, 0, 0}, rest = {0, 0, 0};
  for (uint32_t i = 0; i < plan.anchor_count; ++i) {
    from = from + plan.source_places[static_cast<uint32_t>(plan.map[plan.anchors[i]])];
    rest = rest + plan.target.positions[plan.anchors[i]];
  }
  const double share = 1.0 / plan.anchor_count;
  from = share * from;
  Vec3d wanted = plan.scale * (from - ground * plan.up) + plan.target_floor * plan.up;
  if (plan.in_place) wanted = without_height(share * rest, plan.up) + dot(wanted, plan.up) * plan.up;
  return wanted;
}

// How far a joint's source has left its place in its parent, where the two parents belong together: bones that stretch, feet
// that hang on the root.
Vec3d left_place(const sinew_retarget& plan, uint32_t t) {
  const int32_t joint = plan.map[t], parent = plan.map[plan.target.parents[t]];
  if (joint < 0 || parent < 0 || plan.source.parents[joint] != parent) return {0, 0, 0};
  const Vec3d rest = rotate(plan.turn, plan.source.positions[joint] - plan.source.positions[parent]);
  return plan.source_places[joint] - plan.source_places[parent] - rotate(plan.source_turns[parent], rest);
}

void pose_target(sinew_retarget* plan, double ground) {
  const MotionRig& rig = plan->target;
  for (uint32_t i = 0; i < rig.count; ++i) {
    const uint32_t t = rig.order[i];
    const int32_t parent = rig.parents[t];
    if (plan->map[t] >= 0) {
      plan->target_turns[t] = plan->source_turns[plan->map[t]] * plan->align[t];
    } else {
      plan->target_turns[t] = parent < 0 ? kNoTurn : plan->target_turns[parent];
    }
    Vec3d place = rig.positions[t];
    if (parent >= 0) {
      place = plan->target_places[parent] + rotate(plan->target_turns[parent], place - rig.positions[parent]) +
              plan->scale * left_place(*plan, t);
    } else if (plan->map[t] >= 0 && static_cast<int32_t>(t) != plan->mover) {  // on the floor, or beside the body
      const uint32_t source = static_cast<uint32_t>(plan->map[t]);
      Vec3d way = plan->scale * (plan->source_places[source] - rotate(plan->turn, plan->source.positions[source]));
      if (plan->in_place) way = dot(way, plan->up) * plan->up;
      place = place + way;
    }
    plan->target_places[t] = place;
  }
  Vec3d middle = {0, 0, 0};
  for (uint32_t i = 0; i < plan->anchor_count; ++i) middle = middle + plan->target_places[plan->anchors[i]];
  const Vec3d way = wanted_middle(*plan, ground) - (1.0 / plan->anchor_count) * middle;
  for (uint32_t t = 0; t < rig.count; ++t) {
    if (plan->moved[t] != 0) plan->target_places[t] = plan->target_places[t] + way;
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
    const Vec3d way = {static_cast<double>(t[0]), static_cast<double>(t[1]), static_cast<double>(t[2])};
    if (!is_finite(given.x + given.y + given.z + given.w + way.x + way.y + way.z)) return SINEW_ERROR_NOT_FINITE;
    const Quat local = normalised(given);
    const int32_t parent = rig.parents[j];
    plan->source_turns[j] = parent < 0 ? local : plan->source_turns[parent] * local;
    plan->source_places[j] = parent < 0 ? way : plan->source_places[parent] + rotate(plan->source_turns[parent], way);
  }
  const Quat back = conjugate(plan->turn);
  for (uint32_t j = 0; j < rig.count; ++j) {
    plan->source_turns[j] = plan->turn * (plan->source_turns[j] * conjugate(rig.rotations[j])) * back;
    plan->source_places[j] = rotate(plan->turn, plan->source_places[j]);
  }
  return SINEW_OK;
}

void load_target(sinew_retarget* plan, const float* rotations, const float* translations) {
  const MotionRig& rig = plan->target;
  for (uint32_t i = 0; i < rig.count; ++i) {
    const uint32_t t = rig.order[i];
    const float* const q = rotations + size_t{4} * t;
    const float* const p = translations + size_t{3} * t;
    Quat turn = normalised(
        {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]), static_cast<double>(q[3])});
    Vec3d place = {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    const int32_t parent = rig.parents[t];
    if (parent >= 0) {
      const Quat above = plan->target_turns[parent] * rig.rotations[parent];
      turn = above * turn;
      place = plan->target_places[parent] + rotate(above, place);
    }
    // Turns against the rest pose are kept; children need the parent's own again, which the product gives.
    plan->target_turns[t] = turn * conjugate(rig.rotations[t]);
    plan->target_places[t] = place;
  }
}

void store_target(const sinew_retarget& plan, float* rotations, float* translations) {
  const MotionRig& rig = plan.target;
  for (uint32_t t = 0; t < rig.count; ++t) {
    const int32_t parent = rig.parents[t];
    Quat local = plan.target_turns[t] * rig.rotations[t];
    Vec3d way = plan.target_places[t];
    if (parent >= 0) {
      const Quat back = conjugate(plan.target_turns[parent] * rig.rotations[parent]);
      local = back * local;
      way = rotate(back, way - plan.target_places[parent]);
    }
    local = normalised(local);
    if (local.w < 0) local = {-local.x, -local.y, -local.z, -local.w};  // one of the two that are the same turn
    float* const q = rotations + size_t{4} * t;
    q[0] = static_cast<float>(local.x);
    q[1] = static_cast<float>(local.y);
    q[2] = static_cast<float>(local.z);
    q[3] = static_cast<float>(local.w);
    float* const p = translations + size_t{3} * t;
    p[0] = static_cast<float>(way.x);
    p[1] = static_cast<float>(way.y);
    p[2] = static_cast<float>(way.z);
  }
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
  const bool stands = size(plan.source_lowest) <= 0.2 * plan.leg_length;
  if (!stands && size(fifth - plan.source_floor) > 0.05 * plan.leg_length) *ground = static_cast<float>(fifth);
  return SINEW_OK;
}

sinew_status retarget_frame(sinew_retarget* plan, const float* rotations, const float* translations, float ground,
                            float* out_rotations, float* out_translations) {
  const double height = static_cast<double>(ground);
  if (!is_finite(height)) return SINEW_ERROR_NOT_FINITE;
  const sinew_status status = pose_source(plan, rotations, translations);
  if (status != SINEW_OK) return status;
  pose_target(plan, height);
  store_target(*plan, out_rotations, out_translations);
  return SINEW_OK;
}

}  // namespace sinew::motion
