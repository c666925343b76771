// SPDX-License-Identifier: MIT
// Arms and legs of a plan, and where inverse kinematics puts them.
#include "motion/limbs.hpp"

#include <gtest/gtest.h>

#include "motion/retarget.hpp"
#include "motion_clip.hpp"

namespace {

using namespace sinew_test;
using sinew::motion::Limb;

TEST(MoveLimb, ReachesItsGoalWithBonesOfTheirLengthAndTheElbowOnItsSide) {
  const MotionScene scene = body(20);
  size_t bytes = 0;
  ASSERT_EQ(sinew_retarget_create_workspace_size(17, 17, &bytes), SINEW_OK);
  const sinew::Workspace block(bytes);
  sinew_retarget* plan = nullptr;
  const sinew_skeleton rig = scene.view();
  ASSERT_EQ(sinew_retarget_create(&rig, &rig, one_to_one(17).data(), scene.classes.data(), nullptr, block.data(), bytes,
                                  &plan),
            SINEW_OK);
  const sinew::motion::LimbList limbs = sinew::motion::find_limbs(*plan);
  ASSERT_EQ(limbs.count, 4u);
  EXPECT_FALSE(limbs.limbs[0].leg);
  EXPECT_TRUE(limbs.limbs[3].leg);
  const Limb arm = limbs.limbs[0];
  EXPECT_EQ(arm.first, kLeftUpperArm);
  EXPECT_EQ(arm.last, kLeftHand);
  const Pose rest = rest_pose(scene);
  for (const Vec3d way :
       {Vec3d{-0.1, 0.1, 0.2}, {0.05, -0.2, 0.1}, {-0.3, 0, 0.05}, {0, 0, 0}, {9, 9, 9}, {-0.5, 0.15, 0}}) {
    sinew::motion::load_target(plan, rest.rotations.data(), rest.translations.data());
    const Vec3d shoulder = plan->target_positions[arm.first], goal = plan->target_positions[arm.last] + way;
    const sinew::motion::Quat hand = plan->target_rotations[arm.last];
    const double upper = distance(scene.at(arm.first), scene.at(arm.middle)),
                 lower = distance(scene.at(arm.middle), scene.at(arm.last));
    sinew::motion::move_limb(arm, goal, plan->target_positions[arm.middle], plan);
    const Vec3d elbow = plan->target_positions[arm.middle], wrist = plan->target_positions[arm.last];
    EXPECT_NEAR(distance(elbow, shoulder), upper, 1e-9);
    EXPECT_NEAR(distance(wrist, elbow), lower, 1e-9);
    const double reach = distance(goal, shoulder), most = 0.9995 * (upper + lower), least = 1.001 * (upper - lower);
    const double wanted = reach > most ? most : reach < least ? least : reach;
    EXPECT_NEAR(distance(wrist, shoulder), wanted, 1e-6) << "as near as it comes";
    EXPECT_LT(distance(wrist, shoulder + wanted * sinew::unit(goal - shoulder)), 1e-6);
    EXPECT_EQ(plan->target_rotations[arm.last].x, hand.x) << "the hand keeps its turn";
    EXPECT_LT(distance(plan->target_positions[kLeftFinger] - wrist, scene.at(kLeftFinger) - scene.at(kLeftHand)), 1e-9);
    EXPECT_LT(distance(plan->target_positions[kRightHand], scene.at(kRightHand)), 1e-7);
  }
}

}  // namespace
