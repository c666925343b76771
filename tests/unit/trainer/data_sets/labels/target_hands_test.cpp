// SPDX-License-Identifier: MIT
// Fingers of characters by the names that makers give them.
#include <gtest/gtest.h>

#include "sinew_data_sets/target_skeleton.hpp"

namespace sinew {
namespace {

// A hand along +x with `fingers` of two joints, and a vertex for each joint.
Character hand(const std::vector<std::string>& fingers) {
  Character c;
  c.name = "hand";
  const auto add = [&](const std::string& name, float x, float z, int parent) {
    c.joints.push_back({name, {x, 0, z}, parent});
    c.vertices.push_back({x + 0.5f, 0, z});
    c.influences.push_back({{static_cast<uint32_t>(c.joints.size() - 1), 1}});
    return static_cast<int>(c.joints.size() - 1);
  };
  const int forearm = add("LeftForeArm", -10, 0, -1), wrist = add("LeftHand", 0, 0, forearm);
  for (size_t f = 0; f < fingers.size(); ++f) {
    const float z = static_cast<float>(f);
    const int first = add("LeftHand" + fingers[f] + "1", 4, z, wrist);
    (void)add("LeftHand" + fingers[f] + "2", 5, z, first);
  }
  return c;
}

TEST(TargetHands, HaveTheirFingersInOrderWithEnds) {
  const std::vector<TargetHand> hands = target_hands(hand({"Pinky", "Thumb", "Index"}));
  ASSERT_EQ(hands.size(), 1u);
  const TargetHand& one = hands[0];
  EXPECT_EQ(one.joint, 1u);
  EXPECT_EQ(one.elbow, 0);
  EXPECT_FALSE(one.right);
  EXPECT_TRUE(one.clear);
  EXPECT_NEAR(one.length, 5.7, 0.3);
  ASSERT_EQ(one.fingers.size(), 3u);
  EXPECT_EQ(one.fingers[0].finger, 0u);
  EXPECT_EQ(one.fingers[1].finger, 1u);
  EXPECT_EQ(one.fingers[2].finger, 4u);
  EXPECT_EQ(one.fingers[2].joints, (std::vector<uint32_t>{2, 3}));
  ASSERT_TRUE(one.fingers[2].end);
  EXPECT_NEAR((*one.fingers[2].end)[0], 5.475, 1e-6) << "0.95 of the way to the last vertex";
}

TEST(TargetHands, AreClearOnlyWithFingersOfTheirOwnOrNone) {
  EXPECT_TRUE(target_hands(hand({}))[0].clear);
  EXPECT_FALSE(target_hands(hand({"Thumb", "Index"}))[0].clear) << "the index finger moves the others";
  Character mitten = hand({"Thumb", "Index", "Middle"});
  mitten.joints[6].name = "Fingers.L";
  EXPECT_FALSE(target_hands(mitten)[0].clear);
}

TEST(TargetHands, BecomePartOfABodysTarget) {
  const Character c = hand({"Thumb", "Index", "Middle"});
  const TargetSkeleton body = target_skeleton(c), full = with_fingers(c, body);
  EXPECT_EQ(full.joints.size(), body.joints.size() + 3 * 3);
  EXPECT_TRUE(full.joints.back().tip);
}

}  // namespace
}  // namespace sinew
