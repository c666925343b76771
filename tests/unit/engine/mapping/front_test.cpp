// SPDX-License-Identifier: MIT
// Which way a rig without names faces.
#include "human_rig.hpp"

namespace sinew::mapping {
namespace {

TEST(MapFront, FeetPointAheadWhereverTheRigIsTurned) {
  HumanRig human;
  for (size_t i = 0; i < human.positions.size(); i += 3) {  // a quarter turn: +z becomes +x
    const float x = human.positions[i], z = human.positions[i + 2];
    human.positions[i] = z;
    human.positions[i + 2] = -x;
  }
  const Read read(&human);
  EXPECT_GT(read.anatomy.frame.front.x, 0.99);
  EXPECT_GT(read.anatomy.ahead(read.anatomy.at(HumanRig::kToe)), read.anatomy.ahead(read.anatomy.at(HumanRig::kFoot)));
  EXPECT_EQ(read.anatomy.side[HumanRig::kHand], 1);  // its left stays its left
}

TEST(MapFront, ADogsHeadIsBeforeItsTail) {
  DogRig dog;
  const Read read(&dog);
  EXPECT_GT(read.anatomy.frame.front.z, 0.99);
}

TEST(MapFront, FlippedItIsTheOtherWayAndLeftIsRight) {
  HumanRig human, same;
  const Read ahead(&human), flipped(&same, true);
  EXPECT_LT(dot(ahead.anatomy.frame.front, flipped.anatomy.frame.front), -0.99);
  EXPECT_EQ(ahead.anatomy.side[HumanRig::kHand], -flipped.anatomy.side[HumanRig::kHand]);
}

}  // namespace
}  // namespace sinew::mapping
