// SPDX-License-Identifier: MIT
// Shapes fitted to corrected poses of a tube: they halve the error of poses that they did not learn.
#include "sinew_character/bake/bake.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.hpp"

namespace sinew {
namespace {

constexpr int kRings = 25, kAround = 12;

// Along y from 0 to 4, an elbow at 2 that one ring in five follows in part.
Character arm() {
  Character c;
  c.name = "arm";
  c.joints = {{"root", {0, -1, 0}, -1}, {"upper", {0, 0, 0}, 0}, {"lower", {0, 2, 0}, 1}};
  for (int r = 0; r < kRings; ++r)
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2 * std::acos(-1.0) * k / kAround, y = 4.0 * r / (kRings - 1);
      c.vertices.push_back({static_cast<float>(0.4 * std::cos(angle)), static_cast<float>(y),
                            static_cast<float>(0.4 * std::sin(angle))});
      const float share = static_cast<float>(std::fmin(1.0, std::fmax(0.0, 0.5 + (y - 2) / 0.8)));
      c.influences.push_back({{1, 1 - share}, {2, share}});
    }
  for (uint32_t r = 0; r + 1 < kRings; ++r)
    for (uint32_t k = 0; k < kAround; ++k) {
      const uint32_t a = r * kAround + k, b = r * kAround + (k + 1) % kAround;
      c.face_vertices.insert(c.face_vertices.end(), {a, a + kAround, b + kAround, b});
      c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
    }
  return c;
}

bool on() { return true; }

TEST(Bake, HalvesTheErrorOfPosesThatItDidNotLearn) {
  const Character c = arm();
  const BakeSettings settings;
  const Morphs morphs = bake_bends(c, random_palettes(c, 120, 90, 1), settings, on);
  ASSERT_EQ(morphs.drivers.size(), 1u) << "nothing bends at the shoulder, whose side before it is empty";
  EXPECT_EQ(morphs.drivers[0].joint, 2u);
  EXPECT_LE(morphs.drivers[0].sum_count(), 8u);
  EXPECT_LE(morphs.shapes.size(), 2 * morphs.drivers[0].sum_count());
  EXPECT_EQ(morphs.shapes[0].name, "lower.1");
  const BakeError error = bake_error(c, morphs, random_palettes(c, 10, 90, 2), settings.deform, on);
  EXPECT_GT(error.linear, 0.002);
  EXPECT_LT(error.baked, 0.5 * error.linear);
  const std::vector<Affine> rest(3, kIdentity);
  for (const float weight : shape_weights(c.joints, morphs, rest)) EXPECT_EQ(weight, 0);
}

TEST(Bake, WeightsOfLearntPosesReachOneAndAreNeverBelowNone) {
  const Character c = arm();
  const std::vector<Palette> poses = random_palettes(c, 60, 90, 1);
  const Morphs morphs = bake_bends(c, poses, {}, on);
  std::vector<float> largest(morphs.shapes.size(), 0.0f);
  for (const Palette& pose : poses) {
    const std::vector<float> weights = shape_weights(c.joints, morphs, pose);
    for (size_t s = 0; s < weights.size(); ++s) {
      EXPECT_GE(weights[s], 0);
      largest[s] = std::fmax(largest[s], weights[s]);
    }
  }
  for (const float one : largest) EXPECT_NEAR(one, 1, 0.01);
}

TEST(Bake, ALooserBoundMakesFewerMoves) {
  const Character c = arm();
  const std::vector<Palette> poses = random_palettes(c, 60, 90, 1);
  size_t last = SIZE_MAX;
  for (const double error : {0.0, 3e-4, 3e-3, 0.3}) {
    BakeSettings settings;
    settings.error = error;
    size_t moves = 0;
    for (const MorphShape& shape : bake_bends(c, poses, settings, on).shapes) moves += shape.vertices.size();
    EXPECT_LT(moves, last) << error;
    last = moves;
  }
  EXPECT_EQ(last, 0u);
}

TEST(Bake, AClipNeedsFewShapes) {
  const Character c = arm();
  std::vector<Palette> frames;
  for (int f = 0; f < 30; ++f) {
    const Affine bend = rotation_about(axis_rotation({0, 0, 1}, 0.08 * f), {0, 2, 0});
    frames.push_back({kIdentity, kIdentity, bend});
  }
  const BakeSettings settings;
  std::vector<std::vector<float>> weights;
  const Morphs morphs = bake_clip(c, frames, settings, 6, on, &weights);
  EXPECT_LE(morphs.shapes.size(), 6u);
  EXPECT_TRUE(morphs.drivers.empty());
  ASSERT_EQ(weights.size(), 30u);
  for (const std::vector<float>& frame : weights)
    for (const float weight : frame) EXPECT_TRUE(weight >= 0 && weight <= 1) << weight;
  const BakeError error = bake_error(c, morphs, frames, settings.deform, on, &weights);
  EXPECT_LT(error.baked, 0.1 * error.linear);
}

TEST(Bake, SaysWhatItCannotDo) {
  Character c = arm();
  EXPECT_ERROR(bake_bends(c, {}, {}, on), "arm", "no pose");
  EXPECT_ERROR(bake_bends(c, random_palettes(c, 2, 90, 1), {}, [] { return false; }), "interrupted");
  c.influences.clear();
  EXPECT_ERROR(bake_bends(c, random_palettes(c, 2, 90, 1), {}, on), "arm", "bind it first");
}

TEST(Bake, AStiffCharacterGetsNoShape) {
  Character c = arm();
  for (auto& row : c.influences) row = {{1, 1.0f}};
  EXPECT_TRUE(bake_bends(c, random_palettes(c, 5, 90, 1), {}, on).shapes.empty());
}

}  // namespace
}  // namespace sinew
