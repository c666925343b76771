// SPDX-License-Identifier: MIT
// Clips: found by name, cut, resampled; palettes.
#include "sinew_formats/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_affine.hpp"
#include "expect_error.hpp"
#include "sinew_formats/base/affine.hpp"
#include "swinging_motion.hpp"

namespace sinew {
namespace {

TEST(Motion, ResamplesAlongTheArcAtConstantSpeed) {
  const Clip fine = resample(swing(11).clips[0], 40);
  ASSERT_EQ(fine.frames.size(), 41u);
  for (size_t f = 0; f < fine.frames.size(); ++f) {
    const double t = 0.25 * static_cast<double>(f);
    EXPECT_NEAR(dot(fine.frames[f].rotations[1], axis_rotation(2, 0.1 * t)), 1, 1e-12);
    EXPECT_NEAR(fine.frames[f].translations[0][0], t, 1e-9);
  }
  EXPECT_EQ(resample(fine, 10).frames.size(), 11u);
  // The same turn with the other sign is no way round.
  EXPECT_NEAR(
      std::abs(dot(slerp(axis_rotation(0, 0.2), {-std::sin(0.2), 0, 0, -std::cos(0.2)}, 0.5), axis_rotation(0, 0.3))),
      1, 1e-12);
  EXPECT_NEAR(dot(slerp(axis_rotation(0, 0), axis_rotation(0, 2), 0.25), axis_rotation(0, 0.5)), 1, 1e-12);
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

}  // namespace
}  // namespace sinew
