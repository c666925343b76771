// SPDX-License-Identifier: MIT
// The trunk of a clip's frames: as high and as steep as lets what touches the floor reach it.
#ifndef SINEW_MOTION_BODY_LIFT_HPP
#define SINEW_MOTION_BODY_LIFT_HPP

#include "motion/floor_contacts.hpp"

namespace sinew::motion {

class BodyLift {
 public:
  // The scenes must be open and outlive this.
  BodyLift(FloorScene* scene, const FootSearch& feet) : s_(*scene), plan_(*scene->plan), feet_(feet) {}

  // On an uneven floor: as much higher as it is under the lower foot, smoothed over time.
  SINEW_RARE void follow_floor();
  // One round towards where the patches that cannot reach the floor by bending a limb are on it: seat, knees and, where legs do not
  // carry, hands by the height of all; chest, elbows and arms that are too short by the pitch of the torso, which legs do not follow.
  void meet_floor();

 private:
  double floor_below() const;
  SINEW_RARE Vec3d needs_of(uint32_t frame);
  SINEW_RARE double arm_need(uint32_t frame, const double* rises, double* touch) const;
  void apply(uint32_t passes);
  SINEW_RARE void move_trunk(double lift, double pitch);
  SINEW_RARE Vec3d hips() const;
  SINEW_RARE Vec3d shoulders() const;

  FloorScene& s_;
  sinew_retarget& plan_;
  const FootSearch& feet_;
};

}  // namespace sinew::motion
#endif
