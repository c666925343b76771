// SPDX-License-Identifier: MIT
// Memory, parts of the body and the order of the work.
#include "motion/contacts.hpp"

#include "motion/retarget.hpp"
#include "sinew/rig.h"

namespace sinew {
namespace {

constexpr uint32_t kFeetEnd = 250;  // permille

struct ContactMemory {
  BodyPart* joint_parts = nullptr;  // [target joints]
  uint8_t* joint_limbs = nullptr;

  bool allocate(Arena& arena, uint32_t source_joints, uint32_t target_joints, uint32_t vertices, uint32_t triangles,
                uint32_t frames, ContactScene* scene) {
    (void)scene->source.allocate(arena, vertices, triangles, source_joints);
    (void)scene->target.allocate(arena, vertices, triangles, target_joints);
    scene->parts = arena.alloc<BodyPart>(vertices);
    scene->limb_of = arena.alloc<uint8_t>(vertices);
    scene->picked = arena.alloc<uint32_t>(triangles);
    scene->arm_vertices = arena.alloc<uint32_t>(vertices);
    scene->moves = arena.alloc<Vec3d>(size_t{frames} * kMostLimbs);
    scene->smooth = arena.alloc<Vec3d>(frames);
    scene->stands = arena.alloc<uint8_t>(frames);
    scene->heights = arena.alloc<double>(frames);
    scene->hands = arena.alloc<HandContact>(size_t{frames} * kMostArms);
    joint_parts = arena.alloc<BodyPart>(target_joints);
    joint_limbs = arena.alloc<uint8_t>(target_joints);
    return arena.ok();
  }
};

// Every joint's part by the limb that it hangs on; shoulders go with their arms.
void find_parts(const ContactMemory& memory, ContactScene* scene) {
  const MotionRig& rig = scene->plan->target;
  for (uint32_t j = 0; j < rig.count; ++j) {
    memory.joint_parts[j] = BodyPart::kOther;
    memory.joint_limbs[j] = kMostLimbs;
    for (uint32_t l = 0; l < scene->limbs.count; ++l) {
      const Limb& limb = scene->limbs.limbs[l];
      uint32_t top = limb.first;
      while (!limb.leg && rig.parents[top] >= 0 && scene->plan->classes[rig.parents[top]] == SINEW_CLASS_CLAVICLE)
        top = static_cast<uint32_t>(rig.parents[top]);
      const bool end = rig.is_below(j, limb.last);
      if (limb.leg ? !end : !rig.is_below(j, top)) continue;
      memory.joint_limbs[j] = static_cast<uint8_t>(l);
      memory.joint_parts[j] = limb.leg                       ? BodyPart::kFoot
                              : end                          ? BodyPart::kHand
                              : rig.is_below(j, limb.middle) ? BodyPart::kForearm
                                                             : BodyPart::kUpperArm;
    }
  }
  const sinew_motion_body& body = *scene->body;
  const uint32_t slots = body.influence_count;
  for (uint32_t v = 0; v < body.vertex_count; ++v) {
    uint32_t best = 0;
    for (uint32_t i = 1; i < slots; ++i) {
      if (body.weights[size_t{slots} * v + i] > body.weights[size_t{slots} * v + best]) best = i;
    }
    const uint32_t joint = body.joints[size_t{slots} * v + best];
    scene->parts[v] = memory.joint_parts[joint];
    scene->limb_of[v] = memory.joint_limbs[joint];
  }
}

// A body that is the source's own needs no mending, and none is made.
bool is_same_body(const ContactScene& scene) {
  if (!scene.plan->same_rig) return false;
  if (!scene.has_source) return true;
  const Vec3d first = rotate(scene.source.turn, scene.source.rest(0)) - scene.target.rest(0);
  for (uint32_t v = 0; v < scene.body->vertex_count; ++v) {
    const Vec3d way = rotate(scene.source.turn, scene.source.rest(v)) - scene.target.rest(v) - first;
    if (length(way) > 1e-5 * scene.target.height) return false;
  }
  return true;
}

bool all_finite(const float* values, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    if (!is_finite(static_cast<double>(values[i]))) return false;
  }
  return true;
}

}  // namespace

sinew_status ContactScene::load_source(uint32_t frame, bool with_body) {
  const size_t joints = plan->source.count;
  const sinew_status status =
      pose_source(plan, in->source_rotations + 4 * joints * frame, in->source_translations + 3 * joints * frame);
  if (status == SINEW_OK && has_source && with_body) source.pose(plan->source_turns, plan->source_places);
  return status;
}
void ContactScene::load(uint32_t frame) {
  const size_t joints = plan->target.count;
  load_target(plan, in->rotations + 4 * joints * frame, in->translations + 3 * joints * frame);
}
void ContactScene::store(uint32_t frame) const {
  const size_t joints = plan->target.count;
  store_target(*plan, in->rotations + 4 * joints * frame, in->translations + 3 * joints * frame);
}

void smooth_over_time(Vec3d* values, uint32_t count, uint32_t stride, uint32_t passes, Vec3d* scratch) {
  for (uint32_t pass = 0; pass < passes; ++pass) {
    for (uint32_t i = 0; i < count; ++i) scratch[i] = values[size_t{stride} * i];
    for (uint32_t i = 1; i + 1 < count; ++i)
      values[size_t{stride} * i] = 0.25 * (scratch[i - 1] + 2.0 * scratch[i] + scratch[i + 1]);
  }
}

size_t measure_contacts(uint32_t source_joints, uint32_t target_joints, uint32_t vertices, uint32_t triangles,
                        uint32_t frames) {
  Arena arena;
  ContactScene scene;
  ContactMemory memory;
  (void)memory.allocate(arena, source_joints, target_joints, vertices, triangles, frames, &scene);
  return arena.ok() ? arena.high_water() : 0;
}

sinew_status run_contacts(sinew_retarget* plan, const sinew_motion_body* source, const sinew_motion_body& target,
                          const ContactInputs& inputs, Arena& arena) {
  ContactScene scene;
  ContactMemory memory;
  if (!memory.allocate(arena, plan->source.count, plan->target.count, target.vertex_count, target.triangle_count,
                       inputs.frames, &scene)) {
    return SINEW_ERROR_WORKSPACE;
  }
  scene.plan = plan;
  scene.in = &inputs;
  scene.body = &target;
  scene.has_source = source != nullptr;
  scene.target.body = &target;
  scene.target.rig = &plan->target;
  scene.target.measure(plan->up);
  scene.source.body = source;
  scene.source.rig = &plan->source;
  scene.source.turn = plan->turn;
  if (source != nullptr) scene.source.measure(plan->up);
  scene.source_height = source != nullptr ? scene.source.height : scene.target.height / plan->scale;
  scene.limbs = find_limbs(*plan);
  find_parts(memory, &scene);
  if (is_same_body(scene)) return SINEW_OK;
  // A frame that is no number ends it before anything is written.
  const size_t joints = size_t{inputs.frames} * plan->target.count;
  if (!all_finite(inputs.rotations, 4 * joints) || !all_finite(inputs.translations, 3 * joints))
    return SINEW_ERROR_NOT_FINITE;
  for (uint32_t f = 0; f < inputs.frames; ++f) {
    const sinew_status status = scene.load_source(f, false);
    if (status != SINEW_OK) return status;
  }
  sinew_status status = hold_feet(&scene);
  if (status == SINEW_OK && !inputs.progress.report(kFeetEnd)) return SINEW_ERROR_CANCELLED;
  if (status == SINEW_OK && source != nullptr) status = place_hands(&scene);
  return status;
}

}  // namespace sinew
