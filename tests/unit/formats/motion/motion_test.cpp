// SPDX-License-Identifier: MIT
// Clips: found by name, cut, resampled; palettes.
#include "sinew_formats/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_affine.hpp"
#include "expect_error.hpp"
#include "motion/common_body.hpp"
#include "motion/turns.hpp"
#include "sinew_character/pose.hpp"
#include "sinew_character/retarget.hpp"

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

// A strip of quads along y with `extra` triangles behind it, `shift` vertices that no face names before it.
Character strip(size_t quads, size_t extra, size_t shift, float width) {
  Character c;
  c.name = "strip";
  c.joints = {{"a", {0, 0, 0}, -1}};
  c.vertices.resize(shift);
  for (size_t i = 0; i <= quads; ++i) {
    c.vertices.push_back({0, static_cast<float>(i), 0});
    c.vertices.push_back({width, static_cast<float>(i), 0});
  }
  const auto face = [&](std::initializer_list<size_t> corners) {
    for (const size_t v : corners) c.face_vertices.push_back(static_cast<uint32_t>(v + shift));
    c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
  };
  for (size_t i = 0; i < quads; ++i) face({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
  for (size_t i = 0; i < extra; ++i) face({0, 2 * i + 2, 1});
  c.influences.assign(c.vertices.size(), {{0, 1.0f}});
  return c;
}

TEST(CommonBody, IsWhatTwoMeshesBeginWith) {
  const CommonBody body = common_body(strip(60, 4, 0, 1), strip(60, 0, 7, 2));
  EXPECT_EQ(body.triangles.size(), 3u * 120);
  EXPECT_EQ(body.first.size(), 122u);
  for (size_t v = 0; v < body.first.size(); ++v) EXPECT_EQ(body.first[v] + 7, body.second[v]);
  EXPECT_EQ(common_body(strip(60, 4, 0, 1), strip(60, 4, 0, 1)).triangles.size(), 3u * 124);
  Character other = strip(60, 0, 0, 1);
  other.face_vertices[40] = 0;  // a corner of the eleventh quad
  EXPECT_EQ(common_body(strip(60, 0, 0, 1), other).triangles.size(), 3u * 20);
}

TEST(CommonBody, OfAHandAndTheRestOnlyWhatHangsTogetherIsSkin) {
  Character skirt = strip(30, 0, 62, 3), body = strip(30, 0, 0, 1);
  for (size_t v = 62; v < skirt.vertices.size(); ++v) body.vertices.push_back(skirt.vertices[v]);
  for (const uint32_t v : skirt.face_vertices) body.face_vertices.push_back(v);
  for (size_t f = 1; f <= 30; ++f) body.face_offsets.push_back(static_cast<uint32_t>(120 + 4 * f));
  body.joints.push_back({"hand", {0, 0, 0}, 0});
  body.influences.assign(body.vertices.size(), {{0, 1.0f}});
  body.influences[60] = body.influences[61] = {{0, 0.4f}, {1, 0.6f}};
  CommonBody common = common_body(body, body);
  ASSERT_EQ(common.triangles.size(), 3u * 120);
  keep_skin(body, {false, true}, &common);
  EXPECT_EQ(common.triangles.size(), 3u * 60);
  for (const uint32_t v : common.triangles) EXPECT_LT(common.first[v], 62u);
  common = common_body(body, body);
  keep_skin(body, {false, false}, &common);
  EXPECT_EQ(common.triangles.size(), 3u * 120) << "no hand: all of it";
}

TEST(Retargeter, SaysHowMuchBodyTheTwoShare) {
  const Motion motion = swing(5);
  const Character thin = strip(60, 3, 0, 1), wide = strip(60, 0, 0, 2), other = strip(20, 0, 0, 1);
  Retargeter retargeter(motion, rest_joints(motion), {0, 1}, {17, 17});
  EXPECT_EQ(retargeter.take_bodies(thin, &wide), 120u);
  EXPECT_EQ(retargeter.take_bodies(thin, &other), 0u) << "40 triangles are no body";
  EXPECT_EQ(retargeter.take_bodies(thin, nullptr), 0u);
  EXPECT_EQ(retargeter.run(motion.clips[0]).frames.size(), 5u);
  Character unbound = wide;
  unbound.influences.clear();
  EXPECT_EQ(retargeter.take_bodies(thin, &unbound), 0u);
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
