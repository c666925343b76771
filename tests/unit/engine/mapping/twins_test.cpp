// SPDX-License-Identifier: MIT
// A body that stands in no mirrored pose has sides all the same.
#include <cmath>

#include "human_rig.hpp"
#include "mapping/frame.hpp"

namespace sinew::mapping {
namespace {

// Turns joints [first, last) about the hips, by `z` about z, then by `y` about y, in radians.
void turn(HumanRig* human, size_t first, size_t last, double z, double y) {
  const double hips[3] = {human->positions[0], human->positions[1], human->positions[2]};
  for (size_t j = first; j < last; ++j) {
    float* const p = &human->positions[3 * j];
    const double a = p[0] - hips[0], b = p[1] - hips[1], c = p[2] - hips[2];
    const double x = a * std::cos(z) - b * std::sin(z), up = a * std::sin(z) + b * std::cos(z);
    p[0] = static_cast<float>(hips[0] + x * std::cos(y) + c * std::sin(y));
    p[1] = static_cast<float>(hips[1] + up);
    p[2] = static_cast<float>(hips[2] - x * std::sin(y) + c * std::cos(y));
  }
}

HumanRig leaning() {
  HumanRig human;
  const float arms[] = {0.2f, 1.7f, 0, 0.45f, 1.7f, 0, -0.2f, 1.45f, 0, -0.2f, 1.45f, 0.25f, -0.2f, 1.2f, 0.25f};
  for (size_t k = 0; k < 15; ++k) human.positions[3 * (HumanRig::kUpperArm + 1) + k] = arms[k];
  turn(&human, HumanRig::kSpine, HumanRig::kThigh, 0.5, 0.7);
  turn(&human, HumanRig::kThigh, HumanRig::kThigh + HumanRig::kRightLeg, 1.2, 0.6);
  return human;
}

TEST(MapTwins, BonesOfTheSameLengthsTellTheSidesOfAPosedBody) {
  HumanRig human = leaning();
  const Read read(&human);
  const Anatomy& a = read.anatomy;
  EXPECT_TRUE(a.frame.posed);
  for (const int32_t joint : {HumanRig::kUpperArm, HumanRig::kHand}) {
    EXPECT_EQ(a.frame.mate[joint], joint + HumanRig::kRightArm);
    EXPECT_NE(a.side[joint], 0);
    EXPECT_EQ(a.side[joint], -a.side[joint + HumanRig::kRightArm]);
  }
  EXPECT_EQ(a.side[HumanRig::kHand], a.side[HumanRig::kFoot]);
  ASSERT_EQ(a.leg_count, 1);
  EXPECT_GE(a.arms.a, 0);
}

TEST(MapTwins, AMirroredBodyKeepsItsMirrorPlane) {
  HumanRig human;
  EXPECT_FALSE(Read(&human).anatomy.frame.posed);
}

}  // namespace
}  // namespace sinew::mapping
