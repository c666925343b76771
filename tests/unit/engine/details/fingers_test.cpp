// SPDX-License-Identifier: MIT
// Fingers from votes: those that enough votes agree on, with their ends, none in the place of another.
#include "details/fingers.hpp"

#include <gtest/gtest.h>

#include "rig_votes.hpp"

namespace sinew::rigging {
namespace {

using sinew_test::Block;
using sinew_test::grid_point;
using sinew_test::units;
using sinew_test::VoteScene;

struct Found {
  Finger fingers[kFingers];
  explicit Found(const VoteScene& scene) {
    const Votes votes = scene.votes();
    const auto find = [&](Arena& arena) {
      VotePool pool;
      if (!pool.build(votes, false, arena)) return SINEW_ERROR_WORKSPACE;
      return find_fingers(pool, arena, fingers);
    };
    Arena measuring;
    EXPECT_EQ(find(measuring), SINEW_OK);
    Block block(measuring.high_water());
    EXPECT_EQ(find(block.arena), SINEW_OK);
  }
  uint32_t count() const {
    uint32_t n = 0;
    for (const Finger& finger : fingers) n += finger.joints > 0 ? 1 : 0;
    return n;
  }
};

// A finger along +x at z with 40 points a bone, the palm's among them; all votes are off by up to `noise` of the side.
void add_finger(VoteScene* scene, uint32_t finger, double z, uint32_t joints, double noise = 0.003) {
  test::Random random(finger + 7);
  const auto off = [&](Vec3i at) {
    const int32_t most = units(noise);
    return at + Vec3i{random.between(-most, most), random.between(-most, most), random.between(-most, most)};
  };
  for (uint32_t i = 0; i < 40; ++i) {
    scene->add(off(grid_point(0.1, 0, 0)), kHandPalm, off(grid_point(0.5, 0, z)), finger_class(finger, 0));
    for (uint32_t k = 0; k < joints; ++k) {
      const uint32_t next = k + 1 < joints ? finger_class(finger, k + 1) : kClassTip;
      scene->add(off(grid_point(0.5 + 0.12 * k, 0, z)), finger_class(finger, k), off(grid_point(0.62 + 0.12 * k, 0, z)),
                 next);
    }
  }
}

TEST(Fingers, AreWhereTheirVotesGatherAndEndWhereTipsDo) {
  VoteScene scene;
  for (uint32_t f = 0; f < kFingers; ++f) add_finger(&scene, f, 0.1 * f, f == 0 ? 2 : 3);
  const Found found(scene);
  for (uint32_t f = 0; f < kFingers; ++f) {
    const Finger& finger = found.fingers[f];
    ASSERT_EQ(finger.joints, f == 0 ? 2 : 3) << f;
    EXPECT_TRUE(finger.has_end);
    for (uint32_t k = 0; k <= finger.joints; ++k) {
      EXPECT_LT(square_distance(finger.at[k], grid_point(0.5 + 0.12 * k, 0, 0.1 * f)), square(units(0.004))) << f << k;
      EXPECT_GT(finger.confidence[k], 16384);
    }
  }
}

TEST(Fingers, AreOnlyThoseThatThereAre) {
  VoteScene scene;
  for (const uint32_t f : {0u, 1u, 4u}) add_finger(&scene, f, 0.1 * f, 3);
  const Found found(scene);
  EXPECT_EQ(found.count(), 3u);
  EXPECT_EQ(found.fingers[2].joints, 0);
  EXPECT_EQ(found.fingers[3].joints, 0);
}

TEST(Fingers, AreNoneWhereVotesDoNotAgreeOrSayPalm) {
  VoteScene scattered, palm;
  for (uint32_t f = 0; f < kFingers; ++f) add_finger(&scattered, f, 0.1 * f, 3, 0.3);
  EXPECT_EQ(Found(scattered).count(), 0u);
  for (uint32_t i = 0; i < 400; ++i) palm.add(grid_point(0.1, 0, 0), kHandPalm, grid_point(0.8, 0, 0), kClassTip);
  EXPECT_EQ(Found(palm).count(), 0u);
}

TEST(Fingers, InOnePlaceAreOne) {
  VoteScene scene;
  add_finger(&scene, 1, 0.1, 3);
  add_finger(&scene, 1, 0.1, 3);
  add_finger(&scene, 2, 0.11, 3);
  for (const uint32_t f : {0u, 4u}) add_finger(&scene, f, 0.1 * f - 0.1, 3);
  const Found found(scene);
  EXPECT_EQ(found.count(), 3u);
  EXPECT_EQ(found.fingers[1].joints, 3) << "the one with more votes";
}

TEST(Fingers, WithOneEndForTwoLeaveItToOne) {
  VoteScene scene;
  for (const uint32_t f : {0u, 1u, 2u}) add_finger(&scene, f, 0.1 * f, 3);
  for (size_t i = 0; i < scene.ends.size(); ++i) {  // the third finger's tips go to the second's
    if (scene.end_classes[i * kEndClasses + kClassTip] > 16384 && scene.ends[i].z > units(0.15))
      scene.ends[i].z -= units(0.1);
  }
  const Found found(scene);
  EXPECT_EQ(found.count(), 3u);
  EXPECT_NE(found.fingers[1].has_end, found.fingers[2].has_end);
}

TEST(Fingers, AreThreeAtLeast) {
  VoteScene scene;
  for (const uint32_t f : {0u, 4u}) add_finger(&scene, f, 0.1 * f, 3);
  EXPECT_EQ(Found(scene).count(), 0u) << "a mitten is no hand with fingers";
}

TEST(Fingers, AreAFunctionOfTheVotesAsASet) {
  VoteScene scene;
  for (uint32_t f = 0; f < kFingers; ++f) add_finger(&scene, f, 0.1 * f, 3, 0.02);
  const Found a(scene), b(scene.shuffled(3));
  for (uint32_t f = 0; f < kFingers; ++f) {
    ASSERT_EQ(a.fingers[f].joints, b.fingers[f].joints);
    for (uint32_t k = 0; k <= kFingerJoints; ++k) {
      EXPECT_EQ(a.fingers[f].at[k], b.fingers[f].at[k]);
      EXPECT_EQ(a.fingers[f].confidence[k], b.fingers[f].confidence[k]);
    }
  }
}

}  // namespace
}  // namespace sinew::rigging
