// SPDX-License-Identifier: MIT
// Fingers of two nameless hands: by their order from the thumb, their joints by the distance from the wrist.
#include <algorithm>

#include "matched_rigs.hpp"

namespace sinew::mapping {
namespace {

enum Finger { kThumb, kIndex, kMiddle, kRing, kLittle };

// The human with fingers on both hands, added in the order that is asked for.
struct FingerRig : HumanRig {
  int32_t first[2][5];  // of each side and finger, -1 = none

  explicit FingerRig(const std::vector<Finger>& fingers, int joints = 3, float size = 1) {
    for (int side = 0; side < 2; ++side) {
      const float x = side == 0 ? 1.0f : -1.0f;
      for (int32_t& one : first[side]) one = -1;
      for (const Finger finger : fingers) {
        first[side][finger] = static_cast<int32_t>(parents.size());
        int32_t last = side == 0 ? int32_t{kHand} : kHand + kRightArm;
        for (int k = 0; k < joints; ++k) {
          const float along = 0.03f * static_cast<float>(k), out = finger == kThumb ? 0.02f + along : 0.08f + along,
                      ahead = finger == kThumb ? 0.04f + along : 0.05f - 0.02f * static_cast<float>(finger);
          positions.insert(positions.end(), {x * (0.7f + size * out), 1.45f, size * ahead});
          parents.push_back(last);
          last = static_cast<int32_t>(parents.size()) - 1;
        }
      }
    }
  }
};

// Which finger of the source the first joint of each of the target's is given, -1 = none; the same on both sides.
std::vector<int> matched_fingers(const std::vector<Finger>& target, const std::vector<Finger>& source, float size = 1) {
  FingerRig a(target), b(source, 3, size);
  const MatchedRigs matched(&a, &b);
  std::vector<int> found[2];
  for (int side = 0; side < 2; ++side) {
    for (const int32_t joint : a.first[side]) {
      if (joint < 0) continue;
      int of = -1;
      for (int finger = 0; finger < 5; ++finger) {
        if (b.first[side][finger] < 0 || matched.of(joint) != b.first[side][finger]) continue;
        of = finger;
        for (int32_t k = 1; k < 3; ++k) EXPECT_EQ(matched.of(joint + k), b.first[side][finger] + k);
      }
      EXPECT_EQ(of < 0, matched.of(joint) < 0) << "a finger begins where a finger begins";
      found[side].push_back(of);
    }
  }
  EXPECT_EQ(found[0], found[1]) << "left as right";
  return found[0];
}

const std::vector<Finger> kAll = {kThumb, kIndex, kMiddle, kRing, kLittle};

TEST(MapHands, FingersFindEachOtherInWhateverOrderTheyAreListed) {
  const std::vector<int> each = {0, 1, 2, 3, 4};
  EXPECT_EQ(matched_fingers(kAll, kAll), each);
  EXPECT_EQ(matched_fingers(kAll, {kLittle, kMiddle, kThumb, kIndex, kRing}), each);
  EXPECT_EQ(matched_fingers({kRing, kThumb, kLittle, kIndex, kMiddle}, kAll), each);
}

TEST(MapHands, TheirSizeDoesNotMatter) {
  EXPECT_EQ(matched_fingers(kAll, kAll, 0.6f), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(matched_fingers(kAll, kAll, 1.6f), (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(MapHands, ThreeFingersLackTheLastButOne) {
  const std::vector<Finger> three = {kThumb, kIndex, kMiddle, kLittle};
  EXPECT_EQ(matched_fingers(three, kAll), (std::vector<int>{0, 1, 2, 4}));
  EXPECT_EQ(matched_fingers(kAll, three), (std::vector<int>{0, 1, 2, -1, 4}));
}

TEST(MapHands, OfTwoFingersOneIsAtEitherEnd) {
  EXPECT_EQ(matched_fingers({kThumb, kIndex, kLittle}, kAll), (std::vector<int>{0, 1, 4}));
  EXPECT_EQ(matched_fingers(kAll, {kThumb, kIndex, kLittle}), (std::vector<int>{0, 1, -1, -1, 4}));
}

// A finger of four joints begins with a bone of the palm; that of three begins at the knuckle.
TEST(MapHands, JointsOfAFingerAreMatchedByTheirDistanceFromTheWrist) {
  FingerRig three(kAll);
  FingerRig four(kAll, 4);
  for (int side = 0; side < 2; ++side) {
    for (int finger = 0; finger < 5; ++finger) {
      // The last three where the other rig has its three, the first in the palm.
      for (int32_t k = 3; k >= 0; --k) {
        const size_t to = 3 * static_cast<size_t>(four.first[side][finger] + k);
        for (size_t i = 0; i < 3; ++i) {
          const size_t from = 3 * static_cast<size_t>(three.first[side][finger] + std::max(k - 1, 0)) + i;
          const size_t hand = 3 * static_cast<size_t>(side == 0 ? HumanRig::kHand : HumanRig::kHand + 3) + i;
          four.positions[to + i] =
              k > 0 ? three.positions[from] : 0.7f * three.positions[hand] + 0.3f * three.positions[from];
        }
      }
    }
  }
  const MatchedRigs matched(&three, &four);
  for (int side = 0; side < 2; ++side)
    for (int finger = 0; finger < 5; ++finger)
      for (int32_t k = 0; k < 3; ++k)
        EXPECT_EQ(matched.of(three.first[side][finger] + k), four.first[side][finger] + k + 1) << finger << " " << k;
}

TEST(MapHands, ASingleFingerFindsOne) {
  FingerRig mitten({kMiddle}), hand({kMiddle});
  const MatchedRigs matched(&mitten, &hand);
  for (const auto& first : mitten.first) EXPECT_EQ(matched.of(first[kMiddle]), first[kMiddle]);
}

TEST(MapHands, HandsWithoutFingersTakeNoneAndGiveNone) {
  FingerRig bare({}), hand(kAll);
  const MatchedRigs given(&bare, &hand);
  EXPECT_EQ(given.of(HumanRig::kHand), HumanRig::kHand);
  FingerRig other({}), fingers(kAll);
  const MatchedRigs taken(&fingers, &other);
  EXPECT_EQ(taken.of(HumanRig::kHand), HumanRig::kHand);
  for (int32_t j = HumanRig::kCount; j < static_cast<int32_t>(taken.sources.size()); ++j) EXPECT_EQ(taken.of(j), -1);
}

// Joints along the bones of the arm turn with it; they stand for each other by the bone that they lie on.
TEST(MapHands, TwistsAreNoFingersAndFindTwists) {
  FingerRig a(kAll), b(kAll);
  std::vector<int32_t> twists;
  for (FingerRig* const rig : {&a, &b}) {
    for (const float x : {1.0f, -1.0f}) {
      const int32_t arm = x > 0 ? int32_t{HumanRig::kUpperArm} : HumanRig::kUpperArm + HumanRig::kRightArm;
      // The source has those of the forearm first.
      for (const int32_t bone : rig == &a ? std::vector<int32_t>{0, 1} : std::vector<int32_t>{1, 0}) {
        if (rig == &b) twists.push_back(static_cast<int32_t>(rig->parents.size()));
        rig->positions.insert(rig->positions.end(), {x * (bone == 0 ? 0.32f : 0.57f), 1.45f, -0.005f});
        rig->parents.push_back(arm + bone);
      }
    }
  }
  const MatchedRigs matched(&a, &b);
  const int32_t first = static_cast<int32_t>(a.parents.size()) - 4;
  EXPECT_EQ(matched.of(first), twists[1]) << "the upper arm's";
  EXPECT_EQ(matched.of(first + 1), twists[0]) << "the forearm's";
  EXPECT_EQ(matched.of(first + 2), twists[3]);
  EXPECT_EQ(matched.of(first + 3), twists[2]);
  for (int finger = 0; finger < 5; ++finger) EXPECT_EQ(matched.of(a.first[0][finger]), b.first[0][finger]);
}

}  // namespace
}  // namespace sinew::mapping
