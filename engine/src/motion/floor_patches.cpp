// SPDX-License-Identifier: MIT
// Joints select the patches that may be near the floor, whose vertices give the distance. A source without a body has
// the target's flesh.
#include "motion/floor_patches.hpp"

#include "sinew/rig.h"

namespace sinew::motion {
namespace {

// Shares of the source's height. A joint within the first may have skin on the floor; a patch touches up to the second and no longer from
// the third on. Flesh that is the target's is not that well known.
constexpr double kJointReach = 0.15;
constexpr double kTouchFloor = 0.012, kLeaveFloor = 0.04;
constexpr double kGuessedTouch = 0.03, kGuessedLeave = 0.06;
constexpr double kMostRise = 0.12;   // from where it was copied, for a touch of full weight
constexpr double kEarly = 2;         // heights over the floor per length that a patch has to go
constexpr double kNoHeight = 1e299;  // the lowest vertex of none

}  // namespace

bool FloorPatches::allocate(Arena& arena, uint32_t target_joints, uint32_t vertices, uint32_t frames) {
  vertex_patches_ = arena.alloc<uint8_t>(vertices);
  joint_patches_ = arena.alloc<uint8_t>(target_joints);
  patches_ = arena.alloc<FloorPatch>(size_t{frames} * kPatchCount);
  return arena.ok();
}

// Half a bone around knees and elbows, and around hips, is theirs; feet are held for themselves.
uint8_t FloorPatches::patch_of(uint32_t joint, Vec3d position) const {
  const sinew_retarget& plan = *s_->plan;
  const BodyPart part = s_->joint_parts[joint];
  const uint32_t limb_index = s_->joint_limbs[joint], own = plan.classes[joint];
  if (part == BodyPart::kOther) {
    if (own == SINEW_CLASS_PELVIS || own == SINEW_CLASS_HIP) return kSeat;
    const bool trunk =
        own == SINEW_CLASS_SPINE || own == SINEW_CLASS_NECK || own == SINEW_CLASS_HEAD || own == SINEW_CLASS_CLAVICLE;
    return trunk ? static_cast<uint8_t>(kChest) : kNoPatch;
  }
  if (part == BodyPart::kFoot) return kNoPatch;
  if (part == BodyPart::kHand) return static_cast<uint8_t>(limb_index);
  const Limb& limb = s_->limbs.limbs[limb_index];
  const Vec3d first = plan.target.positions[limb.first], middle = plan.target.positions[limb.middle];
  const double upper = length(middle - first), lower = length(plan.target.positions[limb.last] - middle);
  if (length(position - middle) < 0.5 * lesser(upper, lower)) return static_cast<uint8_t>(middle_patch(limb_index));
  return limb.leg && length(position - first) < 0.5 * upper ? static_cast<uint8_t>(kSeat) : kNoPatch;
}

void FloorPatches::open(ClipScene* scene) {
  s_ = scene;
  const MotionRig& rig = s_->plan->target;
  for (uint32_t j = 0; j < rig.count; ++j) joint_patches_[j] = patch_of(j, rig.positions[j]);
  for (uint32_t v = 0; v < s_->body->vertex_count; ++v)
    vertex_patches_[v] = patch_of(heaviest_joint(*s_->body, v), s_->target.rest(v));
}

void FloorPatches::look(double source_floor) {
  any_ = false;
  for (uint32_t f = 0; f < s_->in->frames; ++f) look_at(f, source_floor);
}

void FloorPatches::look_at(uint32_t frame, double source_floor) {
  sinew_retarget* const plan = s_->plan;
  const double touch = (s_->has_source ? kTouchFloor : kGuessedTouch) * s_->source_height;
  const double leave = (s_->has_source ? kLeaveFloor : kGuessedLeave) * s_->source_height;
  FloorPatch* const row = patches_ + size_t{frame} * kPatchCount;
  for (uint32_t i = 0; i < kPatchCount; ++i) row[i] = FloorPatch();
  (void)s_->load_source(frame, false);
  uint32_t joints[kPatchCount];
  const uint64_t mask = near_floor(source_floor, joints);
  if (mask == 0) return;
  double low[kPatchCount], own[kPatchCount];
  s_->load(frame);
  s_->target.take_pose(plan->target_rotations, plan->target_positions);
  find_lowest(s_->target, mask, false, own);
  if (s_->has_source) {
    s_->source.take_pose(plan->source_rotations, plan->source_positions);
    find_lowest(s_->source, mask, false, low);
  }
  for (uint32_t i = 0; i < kPatchCount; ++i) {
    if ((mask >> i & 1) == 0 || own[i] > kNoHeight) continue;
    if (!s_->has_source) {  // flesh below the joint, scaled
      const uint32_t t = joints[i];
      const double flesh = dot(plan->up, plan->target_positions[t]) - own[i];
      low[i] = dot(plan->up, plan->source_positions[plan->map[t]]) - flesh / plan->scale;
    }
    const double height = low[i] - source_floor;
    const double rise = absolute(height - (own[i] - s_->target.lowest) / plan->scale);
    // A long movement begins early, so that it is no faster than the source; one that is too long belongs to another
    // body.
    const double far = clamped(kEarly * rise, leave, kJointReach * s_->source_height);
    row[i].weight = (1 - ramp(height, touch, far)) *
                    (1 - ramp(rise, kMostRise * s_->source_height, 2 * kMostRise * s_->source_height));
    const double over = s_->has_source ? height : height - touch;
    row[i].height = over > 0 ? plan->scale * over : 0;
    if (i < s_->limbs.count) {
      const Vec3d wrist = plan->target_positions[s_->limbs.limbs[i].last];
      row[i].wrist = wrist - dot(wrist, plan->up) * plan->up;
    }
    any_ = any_ || row[i].weight > 0;
  }
}

// Patches with a joint near the source's floor, and the lowest of their joints.
uint64_t FloorPatches::near_floor(double source_floor, uint32_t (&lowest_joints)[kPatchCount]) const {
  const sinew_retarget& plan = *s_->plan;
  uint64_t mask = 0;
  double lowest[kPatchCount];
  const double reach = source_floor + kJointReach * s_->source_height;
  for (uint32_t t = 0; t < plan.target.count; ++t) {
    const uint32_t patch = joint_patches_[t];
    if (patch == kNoPatch || plan.map[t] < 0) continue;
    const double height = dot(plan.up, plan.source_positions[plan.map[t]]);
    if (height > reach || ((mask >> patch & 1) != 0 && height >= lowest[patch])) continue;
    mask |= uint64_t{1} << patch;
    lowest[patch] = height;
    lowest_joints[patch] = t;
  }
  return mask;
}

void FloorPatches::find_lowest(const PosedBody& posed, uint64_t mask, bool over_floor, double* heights) const {
  for (uint32_t i = 0; i < kPatchCount; ++i) heights[i] = 1e300;
  for (uint32_t v = 0; v < s_->body->vertex_count; ++v) {
    const uint32_t patch = vertex_patches_[v];
    if (patch == kNoPatch || (mask >> patch & 1) == 0) continue;
    const Vec3d p = posed.skinned(v);
    const double height = over_floor ? s_->over_floor(p) : dot(s_->plan->up, p);
    if (height < heights[patch]) heights[patch] = height;
  }
}

void FloorPatches::find_rises(uint32_t frame, uint64_t mask, double* rises) const {
  for (uint32_t i = 0; i < kPatchCount; ++i) {
    rises[i] = 0;
    if (!(at(frame, i).weight > 0)) mask &= ~(uint64_t{1} << i);
  }
  if (mask == 0) return;
  s_->target.take_pose(s_->plan->target_rotations, s_->plan->target_positions);
  double low[kPatchCount];
  find_lowest(s_->target, mask, true, low);
  for (uint32_t i = 0; i < kPatchCount; ++i) {
    if ((mask >> i & 1) != 0 && low[i] < kNoHeight) rises[i] = at(frame, i).height - low[i];
  }
}

}  // namespace sinew::motion
