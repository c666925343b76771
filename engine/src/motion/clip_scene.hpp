// SPDX-License-Identifier: MIT
// A clip that was copied from one rig to another, with the body that it moves and an uneven floor: what every pass over
// whole clips shares.
#ifndef SINEW_MOTION_CLIP_SCENE_HPP
#define SINEW_MOTION_CLIP_SCENE_HPP

#include "core/counts.hpp"
#include "core/vec3d.hpp"
#include "motion/limbs.hpp"
#include "motion/posed_body.hpp"
#include "sinew/motion.h"

namespace sinew::motion {

struct FloorGrid {
  const float* heights = nullptr;  // [rows x columns]; null: level
  uint32_t columns = 0, rows = 0;
  double first[2] = {}, step = 1;  // along the two axes that are not up

  // SINEW_OK, SINEW_ERROR_ARGUMENT, SINEW_ERROR_COUNT or SINEW_ERROR_NOT_FINITE. floor null: level.
  sinew_status take(const sinew_floor* floor);
  // Over the level floor, under a point.
  double height(Vec3d up, Vec3d p) const;
};

// The part of a vertex of the target.
enum class BodyPart : uint8_t { kOther, kUpperArm, kForearm, kHand, kLeg, kFoot };

struct ClipInputs {
  uint32_t frames = 0;
  const float* source_rotations = nullptr;     // [frames x source joints x 4]
  const float* source_translations = nullptr;  // [frames x source joints x 3]
  double ground = 0, fps = 30;
  FloorGrid floor = {};
  float* rotations = nullptr;     // [frames x target joints x 4]
  float* translations = nullptr;  // [frames x target joints x 3]
  Progress progress = {};
};

struct ClipScene {
  sinew_retarget* plan = nullptr;
  const ClipInputs* in = nullptr;
  const sinew_motion_body* body = nullptr;  // the target's
  bool has_source = false;
  PosedBody source, target;
  LimbList limbs;
  BodyPart* parts = nullptr;        // [vertices]
  uint8_t* limb_of = nullptr;       // [vertices] index into limbs, kMostLimbs: none
  BodyPart* joint_parts = nullptr;  // [target joints]
  uint8_t* joint_limbs = nullptr;   // [target joints]
  double source_height = 0;         // of the source's body, in its units

  // Works with a measuring arena. Returns arena.ok().
  bool allocate(Arena& arena, uint32_t source_joints, uint32_t target_joints, uint32_t vertices, uint32_t triangles);
  // Fills what was allocated and looks for limbs and parts. `inputs` and the bodies must outlive it; source null: none.
  // Returns SINEW_OK, or SINEW_ERROR_NOT_FINITE for a frame of either rig, with nothing written to the clip.
  sinew_status open(sinew_retarget* own_plan, const sinew_motion_body* source_body,
                    const sinew_motion_body& target_body, const ClipInputs& inputs);
  // The motion comes from this very rig and body.
  bool is_same_body() const;
  // The same body, and arms that were not spread: every contact is as in the source.
  bool has_all_contacts() const { return is_same_body() && plan->arm_spread == 0; }

  // How far a point of the target's world is over its floor, which is level with the lowest vertex at rest where there is no grid.
  double over_floor(Vec3d p) const { return dot(plan->up, p) - target.lowest - in->floor.height(plan->up, p); }

  // A frame of the source, and its body where there is one; of the target, without its body.
  sinew_status load_source(uint32_t frame, bool with_body);
  void load(uint32_t frame);
  void store(uint32_t frame) const;
  // The target's frame with its body; the body at rest.
  void pose_target(uint32_t frame);
  void pose_target_at_rest();

 private:
  Vec3d travel(uint32_t frame) const;
};

}  // namespace sinew::motion
#endif
