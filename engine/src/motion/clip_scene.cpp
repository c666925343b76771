// SPDX-License-Identifier: MIT
// Heights of the floor; memory, parts of the body and frames of a clip.
#include "motion/clip_scene.hpp"

#include "motion/motion_rig.hpp"
#include "motion/retarget.hpp"
#include "sinew/rig.h"

namespace sinew::motion {

sinew_status FloorGrid::take(const sinew_floor* floor) {
  if (floor == nullptr) return SINEW_OK;
  if (floor->heights == nullptr || floor->columns == 0 || floor->rows == 0) return SINEW_ERROR_ARGUMENT;
  if (floor->columns > SINEW_MAX_FLOOR_SIDE || floor->rows > SINEW_MAX_FLOOR_SIDE) return SINEW_ERROR_COUNT;
  step = static_cast<double>(floor->step);
  for (int i = 0; i < 2; ++i) first[i] = static_cast<double>(floor->first[i]);
  if (!is_finite(step + first[0] + first[1])) return SINEW_ERROR_NOT_FINITE;
  if (!(step > 0)) return SINEW_ERROR_ARGUMENT;
  for (size_t i = 0; i < size_t{floor->columns} * floor->rows; ++i) {
    if (!is_finite(static_cast<double>(floor->heights[i]))) return SINEW_ERROR_NOT_FINITE;
  }
  heights = floor->heights;
  columns = floor->columns;
  rows = floor->rows;
  return SINEW_OK;
}

double FloorGrid::height(Vec3d up, Vec3d p) const {
  if (heights == nullptr) return 0;
  const bool x_up = absolute(up.x) > 0.5, z_up = absolute(up.z) > 0.5;
  const double at[2] = {x_up ? p.y : p.x, z_up ? p.y : p.z};
  const uint32_t counts[2] = {columns, rows};
  uint32_t low[2], high[2];
  double share[2];
  for (int i = 0; i < 2; ++i) {
    const double cell = clamped((at[i] - first[i]) / step, 0, static_cast<double>(counts[i] - 1));
    low[i] = static_cast<uint32_t>(cell);
    high[i] = low[i] + 1 < counts[i] ? low[i] + 1 : low[i];
    share[i] = cell - static_cast<double>(low[i]);
  }
  const auto value = [&](uint32_t column, uint32_t row) {
    return static_cast<double>(heights[size_t{row} * columns + column]);
  };
  const double near = value(low[0], low[1]) + share[0] * (value(high[0], low[1]) - value(low[0], low[1]));
  const double far = value(low[0], high[1]) + share[0] * (value(high[0], high[1]) - value(low[0], high[1]));
  return near + share[1] * (far - near);
}

namespace {

bool all_finite(const float* values, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    if (!is_finite(static_cast<double>(values[i]))) return false;
  }
  return true;
}

// Part of each joint by its limb, shoulders with their arms; part of each vertex by its strongest joint.
void find_parts(ClipScene* scene) {
  const MotionRig& rig = scene->plan->target;
  for (uint32_t j = 0; j < rig.count; ++j) {
    scene->joint_parts[j] = BodyPart::kOther;
    scene->joint_limbs[j] = kMostLimbs;
    for (uint32_t l = 0; l < scene->limbs.count; ++l) {
      const Limb& limb = scene->limbs.limbs[l];
      uint32_t top = limb.first;
      while (!limb.leg && rig.parents[top] >= 0 && scene->plan->classes[rig.parents[top]] == SINEW_CLASS_CLAVICLE)
        top = static_cast<uint32_t>(rig.parents[top]);
      if (!rig.is_below(j, top)) continue;
      const bool end = rig.is_below(j, limb.last);
      scene->joint_limbs[j] = static_cast<uint8_t>(l);
      scene->joint_parts[j] = limb.leg                       ? (end ? BodyPart::kFoot : BodyPart::kLeg)
                              : end                          ? BodyPart::kHand
                              : rig.is_below(j, limb.middle) ? BodyPart::kForearm
                                                             : BodyPart::kUpperArm;
    }
  }
  const sinew_motion_body& body = *scene->body;
  for (uint32_t v = 0; v < body.vertex_count; ++v) {
    const uint32_t joint = heaviest_joint(body, v);
    scene->parts[v] = scene->joint_parts[joint];
    scene->limb_of[v] = scene->joint_limbs[joint];
  }
}

}  // namespace

bool ClipScene::allocate(Arena& arena, uint32_t source_joints, uint32_t target_joints, uint32_t vertices,
                         uint32_t triangles) {
  (void)source.allocate(arena, vertices, triangles, source_joints);
  (void)target.allocate(arena, vertices, triangles, target_joints);
  parts = arena.alloc<BodyPart>(vertices);
  limb_of = arena.alloc<uint8_t>(vertices);
  joint_parts = arena.alloc<BodyPart>(target_joints);
  joint_limbs = arena.alloc<uint8_t>(target_joints);
  return arena.ok();
}

sinew_status ClipScene::open(sinew_retarget* own_plan, const sinew_motion_body* source_body,
                             const sinew_motion_body& target_body, const ClipInputs& inputs) {
  plan = own_plan;
  in = &inputs;
  body = &target_body;
  has_source = source_body != nullptr;
  target.body = &target_body;
  target.rig = &plan->target;
  target.measure(plan->up);
  source.body = source_body;
  source.rig = &plan->source;
  source.rotation = plan->rotation;
  if (has_source) source.measure(plan->up);
  source_height = has_source ? source.height : target.height / plan->scale;
  limbs = find_limbs(*plan);
  find_parts(this);
  const size_t joints = size_t{inputs.frames} * plan->target.count;
  if (!all_finite(inputs.rotations, 4 * joints) || !all_finite(inputs.translations, 3 * joints))
    return SINEW_ERROR_NOT_FINITE;
  for (uint32_t f = 0; f < inputs.frames; ++f) {
    const sinew_status status = load_source(f, false);
    if (status != SINEW_OK) return status;
  }
  return SINEW_OK;
}

bool ClipScene::is_same_body() const {
  if (!plan->same_rig) return false;
  if (!has_source) return true;
  const Vec3d first = rotate(source.rotation, source.rest(0)) - target.rest(0);
  for (uint32_t v = 0; v < body->vertex_count; ++v) {
    const Vec3d offset = rotate(source.rotation, source.rest(v)) - target.rest(v) - first;
    if (length(offset) > 1e-5 * target.height) return false;
  }
  return true;
}

sinew_status ClipScene::load_source(uint32_t frame, bool with_body) {
  const size_t joints = plan->source.count;
  const sinew_status status =
      pose_source(plan, in->source_rotations + 4 * joints * frame, in->source_translations + 3 * joints * frame);
  if (status == SINEW_OK && has_source && with_body) source.pose(plan->source_rotations, plan->source_positions);
  return status;
}
// A target that stays in place is looked at where it would have gone: only there does a foot on the floor hold still.
void ClipScene::load(uint32_t frame) {
  const size_t joints = plan->target.count;
  load_target(plan, in->rotations + 4 * joints * frame, in->translations + 3 * joints * frame);
  if (plan->in_place) move_target(plan, travel(frame));
}
void ClipScene::store(uint32_t frame) const {
  const size_t joints = plan->target.count;
  const Vec3d path = plan->in_place ? travel(frame) : Vec3d{0, 0, 0};
  if (plan->in_place) move_target(plan, -1.0 * path);
  store_target(*plan, in->rotations + 4 * joints * frame, in->translations + 3 * joints * frame);
  if (plan->in_place) move_target(plan, path);
}
Vec3d ClipScene::travel(uint32_t frame) const {
  const size_t joints = plan->source.count;
  return travel_of(*plan, in->source_rotations + 4 * joints * frame, in->source_translations + 3 * joints * frame);
}
void ClipScene::pose_target(uint32_t frame) {
  load(frame);
  target.pose(plan->target_rotations, plan->target_positions);
}
void ClipScene::pose_target_at_rest() {
  for (uint32_t v = 0; v < body->vertex_count; ++v) target.vertices[v] = target.rest(v);
}

}  // namespace sinew::motion
