// SPDX-License-Identifier: MIT
// Which classes of joints a kind of body has.
#include "votes/body_kind.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace sinew::rigging {
namespace {

TEST(BodyKind, StandsForWhatABodyDoesNotHave) {
  EXPECT_EQ(class_in_body(BodyKind::kBird, kClassForearm), kClassWing);
  EXPECT_EQ(class_in_body(BodyKind::kBird, kClassCalf), kClassCalf);
  EXPECT_EQ(class_in_body(BodyKind::kFish, kClassFoot), kClassWing);
  EXPECT_EQ(class_in_body(BodyKind::kSnake, kClassWing), kClassSpine);
  EXPECT_EQ(class_in_body(BodyKind::kManyLegged, kClassHand), kClassFoot);
  for (uint8_t c = 0; c < kJointClasses; ++c) {
    EXPECT_EQ(class_in_body(BodyKind::kAny, c), c);
    for (uint32_t kind = 0; kind < kBodyKinds; ++kind) {
      const uint8_t once = class_in_body(static_cast<BodyKind>(kind), c);
      EXPECT_EQ(class_in_body(static_cast<BodyKind>(kind), once), once) << "what stands for another is there itself";
    }
  }
}

TEST(BodyKind, ChancesKeepTheirSum) {
  for (uint32_t kind = 0; kind < kBodyKinds; ++kind) {
    uint16_t chances[kEndClasses];
    for (uint32_t c = 0; c < kEndClasses; ++c) chances[c] = static_cast<uint16_t>(100 + c);
    const int before = std::accumulate(chances, chances + kEndClasses, 0);
    steer_classes(static_cast<BodyKind>(kind), chances);
    EXPECT_EQ(std::accumulate(chances, chances + kEndClasses, 0), before);
    EXPECT_EQ(chances[kClassTip], 100 + kClassTip);
    for (uint8_t c = 0; c < kJointClasses; ++c)
      EXPECT_TRUE(class_in_body(static_cast<BodyKind>(kind), c) == c || chances[c] == 0);
  }
}

}  // namespace
}  // namespace sinew::rigging
