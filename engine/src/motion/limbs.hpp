// SPDX-License-Identifier: MIT
// Arms and legs of a plan's target, and where they are put: inverse kinematics of two bones.
#ifndef SINEW_MOTION_LIMBS_HPP
#define SINEW_MOTION_LIMBS_HPP

#include "motion/retarget_plan.hpp"

namespace sinew {

constexpr uint32_t kMostLimbs = 16;

struct Limb {
  uint32_t first = 0, middle = 0, last = 0;  // shoulder, elbow, wrist; hip, knee, ankle
  int32_t toe = -1;                          // of a leg: the mapped toe joint, -1 without one
  bool leg = false;
};

struct LimbList {
  Limb limbs[kMostLimbs];
  uint32_t count = 0;
};

// Both long bones mapped; hands that stand on the floor are none. The first kMostLimbs.
LimbList find_limbs(const sinew_retarget& plan);

// Brings the limb's end to `goal` in the plan's target pose: the middle joint stays on its side, the end keeps its turn,
// what hangs on the limb follows. A goal out of reach is taken as near as a limb that is hardly bent comes.
void move_limb(const Limb& limb, Vec3d goal, sinew_retarget* plan);

}  // namespace sinew
#endif
