// SPDX-License-Identifier: MIT
// Arms and legs of a plan's target, and where they are put: inverse kinematics of two bones.
#ifndef SINEW_MOTION_LIMBS_HPP
#define SINEW_MOTION_LIMBS_HPP

#include "motion/retarget_plan.hpp"
#include "sinew/motion_clips.h"

namespace sinew::motion {

constexpr uint32_t kMostLimbs = SINEW_MAX_MOTION_LIMBS;

struct Limb {
  uint32_t first = 0, middle = 0, last = 0;  // shoulder, elbow, wrist; hip, knee, ankle
  int32_t toe = -1;                          // of a leg: the mapped toe joint, -1 without one
  bool leg = false;
  bool natural =
      false;  // it bends by 155 degrees at most, and its end rotates within 90 of the second bone or where it was
};

struct LimbList {
  Limb limbs[kMostLimbs];
  uint32_t count = 0;
};

// Both long bones mapped; hands that stand on the floor are none. The first kMostLimbs.
LimbList find_limbs(const sinew_retarget& plan);

// Rotation of a limb's parent, in the plan's target pose.
Quat axes_of(const Limb& limb, const sinew_retarget& plan);

// Brings the limb's end to `goal` in the plan's target pose, the middle joint to the side where `middle` lies, or stays where
// the limb has none there; the end keeps its rotation, and children of the limb follow. A goal out of reach is taken
// as near as a limb that is hardly bent comes, or as straight as it is.
void move_limb(const Limb& limb, Vec3d goal, Vec3d middle, sinew_retarget* plan);

// Rotates the descendants of `pivot` about it, in the plan's target pose; those of `end` keep their rotation.
SINEW_RARE void swing(uint32_t pivot, uint32_t end, Quat rotation, sinew_retarget* plan);

}  // namespace sinew::motion
#endif
