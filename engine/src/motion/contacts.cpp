// SPDX-License-Identifier: MIT
// Memory and the order of the work.
#include "motion/contacts.hpp"

#include "motion/natural_range.hpp"

namespace sinew::motion {

bool ContactScene::allocate_all(Arena& arena, uint32_t source_joints, uint32_t target_joints, uint32_t vertices,
                                uint32_t triangles, uint32_t frames) {
  (void)allocate(arena, source_joints, target_joints, vertices, triangles);
  source_tree.allocate(arena, triangles);
  target_tree.allocate(arena, triangles);
  (void)allocate_floor(arena, target_joints, vertices, frames);
  hands = arena.alloc<HandContact>(size_t{frames} * kMostArms);
  search.allocate(arena, vertices, triangles);
  return arena.ok();
}

void ContactScene::search_source(uint32_t frame) {
  (void)load_source(frame, true);
  if (has_source) search.fill(source, false, &source_tree);
}
void ContactScene::search_target(uint32_t frame, bool only_deepest) {
  pose_target(frame);
  search.fill(target, only_deepest, &target_tree);
}
void ContactScene::search_target_at_rest() {
  pose_target_at_rest();
  search.fill(target, true, &target_tree);
}

size_t measure_contacts(uint32_t source_joints, uint32_t target_joints, uint32_t vertices, uint32_t triangles,
                        uint32_t frames) {
  Arena arena;
  ContactScene scene;
  (void)scene.allocate_all(arena, source_joints, target_joints, vertices, triangles, frames);
  return arena.ok() ? arena.high_water() : 0;
}

sinew_status run_contacts(sinew_retarget* plan, const sinew_motion_body* source, const sinew_motion_body& target,
                          const ClipInputs& inputs, Arena& arena) {
  ContactScene scene;
  if (!scene.allocate_all(arena, plan->source.count, plan->target.count, target.vertex_count, target.triangle_count,
                          inputs.frames)) {
    return SINEW_ERROR_WORKSPACE;
  }
  const sinew_status status = scene.open(plan, source, target, inputs);
  if (status != SINEW_OK || scene.has_all_contacts()) return status;
  for (uint32_t l = 0; l < scene.limbs.count; ++l) scene.limbs.limbs[l].natural = true;
  scene.floor_patches.open(&scene);
  FloorContacts(&scene, nullptr).run();
  if (!inputs.progress.report(kFeetEnd)) return SINEW_ERROR_CANCELLED;
  return place_hands(&scene);
}

sinew_status keep_range(sinew_retarget* plan, const sinew_motion_body& target, const ClipInputs& inputs, Arena& arena) {
  ContactScene scene;
  if (!scene.allocate_all(arena, plan->source.count, plan->target.count, target.vertex_count, target.triangle_count,
                          inputs.frames)) {
    return SINEW_ERROR_WORKSPACE;
  }
  const sinew_status status = scene.open(plan, nullptr, target, inputs);
  if (status != SINEW_OK || scene.is_same_body()) return status;
  Hinge hinges[kMostLimbs];
  find_hinges(scene, hinges);
  for (uint32_t f = 0; f < inputs.frames; ++f) keep_range_of_frame(scene, hinges, f);
  return SINEW_OK;
}

}  // namespace sinew::motion
