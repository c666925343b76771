// SPDX-License-Identifier: MIT
// What a plan knows of a clip before its frames: how high it stands.
#include "motion/retarget_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "motion_scene.hpp"

namespace {

using namespace sinew_test;
using sinew::RetargetPlan;

// A clip that was recorded on a platform, or moved up in an editor, stands; one that hangs or jumps is as high as it is.
TEST(Retarget, AClipAboveTheFloorStandsOnIt) {
  const MotionScene scene = body(10);
  RetargetPlan plan;
  ASSERT_EQ(plan.make(scene.view(), scene.view(), one_to_one(17).data(), scene.classes.data(), {}), SINEW_OK);
  const auto ground_of = [&](double lift, double swing) {
    std::vector<float> heights;
    for (int f = 0; f < 40; ++f)
      heights.push_back(static_cast<float>(0.1 + lift + swing * std::abs(std::sin(0.2 * f))));
    float ground = 0;
    EXPECT_EQ(plan.ground(heights.data(), heights.size(), &ground), SINEW_OK);
    return static_cast<double>(ground);
  };
  EXPECT_NEAR(ground_of(0, 0.02), 0.1, 1e-6);
  EXPECT_NEAR(ground_of(0.1, 0.02), 0.1, 1e-6) << "a chair";
  EXPECT_NEAR(ground_of(0.55, 0.02), 0.65, 0.01) << "a third of the height";
  EXPECT_NEAR(ground_of(0.55, 0.9), 0.1, 1e-6) << "leaps";
  EXPECT_NEAR(ground_of(1.2, 0.02), 0.1, 1e-6) << "on its hands";
}

}  // namespace
