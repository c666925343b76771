// SPDX-License-Identifier: MIT
// Clips: found by name, cut, resampled; palettes.
#include "sinew_formats/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_affine.hpp"
#include "expect_error.hpp"
#include "motion/turns.hpp"
#include "sinew_formats/pose.hpp"
#include "sinew_formats/retarget.hpp"

namespace sinew {
namespace {

// Two joints, the second at (0 1 0); it turns by 0.1 radians a frame about z and the first walks along x.
Motion swing(size_t frames) {
  Motion motion;
  motion.name = "swing";
  motion.joints = {{"a", -1, {0, 0, 0}}, {"b", 0, {0, 1, 0}}};
  Clip clip = {"swing", 0.1, {}};
  for (size_t f = 0; f < frames; ++f) {
    const double t = static_cast<double>(f);
    clip.frames.push_back({{kNoTurn4, axis_turn(2, 0.1 * t)}, {{t, 0, 0}, {0, 1, 0}}});
  }
  motion.clips.push_back(clip);
  return motion;
}

TEST(Motion, ResamplesAlongTheArcAtConstantSpeed) {
  const Clip fine = resample(swing(11).clips[0], 40);
  ASSERT_EQ(fine.frames.size(), 41u);
  for (size_t f = 0; f < fine.frames.size(); ++f) {
    const double t = 0.25 * static_cast<double>(f);
    EXPECT_NEAR(dot(fine.frames[f].rotations[1], axis_turn(2, 0.1 * t)), 1, 1e-12);
    EXPECT_NEAR(fine.frames[f].translations[0][0], t, 1e-9);
  }
  EXPECT_EQ(resample(fine, 10).frames.size(), 11u);
  // The same turn with the other sign is no way round.
  EXPECT_NEAR(std::abs(dot(slerp(axis_turn(0, 0.2), {-std::sin(0.2), 0, 0, -std::cos(0.2)}, 0.5), axis_turn(0, 0.3))),
              1, 1e-12);
  EXPECT_NEAR(dot(slerp(axis_turn(0, 0), axis_turn(0, 2), 0.25), axis_turn(0, 0.5)), 1, 1e-12);
}

TEST(Motion, CutsBySeconds) {
  const Clip clip = cut(swing(11).clips[0], 0.2, 0.5);
  ASSERT_EQ(clip.frames.size(), 4u);
  EXPECT_EQ(clip.frames[0].translations[0][0], 2);
  EXPECT_TRUE(cut(swing(11).clips[0], 3, 4).frames.empty());
  EXPECT_EQ(frame_at(clip, 99).translations[0][0], 5);
}

TEST(Motion, FindsClipsByNameAndNumber) {
  Motion motion = swing(2);
  EXPECT_EQ(&find_clip(motion, "f", ""), &motion.clips[0]);
  motion.clips.push_back(motion.clips[0]);
  motion.clips[1].name = "walk";
  EXPECT_EQ(find_clip(motion, "f", "walk").name, "walk");
  EXPECT_EQ(&find_clip(motion, "f", "1"), &motion.clips[1]);
  EXPECT_ERROR((void)find_clip(motion, "f.glb", ""), "f.glb", "'swing', 'walk'");
  EXPECT_ERROR((void)find_clip(motion, "f.glb", "run"), "f.glb", "'swing', 'walk'", "'run'");
  EXPECT_ERROR((void)find_clip(motion, "f.glb", "2"), "'2'");
}

TEST(Motion, PalettesArePosesAgainstRest) {
  const Motion motion = swing(3);
  const std::vector<Affine> palette = motion_palette(motion, motion.clips[0].frames[2], 2);
  sinew_test::expect_affine(palette[0], {1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0});
  const double c = std::cos(0.2), s = std::sin(0.2);
  sinew_test::expect_affine(palette[1], {c, -s, 0, 2 + s, s, c, 0, 1 - c, 0, 0, 1, 0});
  const Motion still = motion_of(rest_joints(motion));
  EXPECT_EQ(still.joints[1].offset, motion.joints[1].offset);
}

TEST(Retargeter, PlaysAClipAndCanBeStopped) {
  const Motion motion = swing(5);
  const std::vector<Joint> joints = rest_joints(motion);
  Retargeter same(motion, joints, {0, 1}, {17, 17});
  const Clip clip = same.run(motion.clips[0]);
  ASSERT_EQ(clip.frames.size(), 5u);
  for (size_t f = 0; f < 5; ++f) {
    EXPECT_NEAR(dot(clip.frames[f].rotations[1], motion.clips[0].frames[f].rotations[1]), 1, 1e-9);
    EXPECT_NEAR(clip.frames[f].translations[0][0], motion.clips[0].frames[f].translations[0][0], 1e-6);
  }
  int asked = 0;
  EXPECT_ERROR((void)same.run(motion.clips[0], [&] { return ++asked < 3; }), "swing", "interrupted");
  EXPECT_EQ(asked, 3);
  EXPECT_ERROR(Retargeter(motion, joints, {-1, -1}, {17, 17}), "swing", "cannot retarget");
}

}  // namespace
}  // namespace sinew
