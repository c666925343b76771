// SPDX-License-Identifier: MIT
// Clips as vertex animation textures: what the pixels say, and that the stated errors are true.
#include "sinew_character/jobs/vat_job.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "expect_error.hpp"
#include "sinew_character/picture/picture_file.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// A pole of two bones from 0 to 2 along y, three vertices a level, rigid; the upper half turns about x.
AnimatedCharacter pole() {
  AnimatedCharacter out;
  Character& c = out.character;
  c.name = "pole";
  c.joints = {{"low", {0, 0, 0}, -1}, {"high", {0, 1, 0}, 0}};
  for (uint32_t level = 0; level < 3; ++level)
    for (const Vec3& p : {Vec3{0, 0, 0.1f}, Vec3{0.1f, 0, 0}, Vec3{-0.1f, 0, 0}}) {
      c.vertices.push_back({p.x, static_cast<float>(level), p.z});
      c.influences.push_back({{level < 2 ? 0u : 1u, 1.0f}});
    }
  for (uint32_t level = 0; level < 2; ++level)
    for (uint32_t i = 0; i < 3; ++i) {
      const uint32_t a = 3 * level + i, b = 3 * level + (i + 1) % 3;
      c.face_vertices.insert(c.face_vertices.end(), {a, b, b + 3, a + 3});
      c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
    }
  out.motion = motion_of(c.joints);
  return out;
}

// `degrees` of the upper bone in each frame.
void add_clip(const std::string& name, const std::vector<double>& degrees, AnimatedCharacter* pole) {
  Clip clip;
  clip.name = name;
  clip.frame_time = 0.1;
  for (const double angle : degrees) {
    MotionFrame frame;
    frame.rotations = {kNoRotation4, axis_rotation(0, angle * kDegree)};
    for (const MotionJoint& joint : pole->motion.joints) frame.translations.push_back(joint.offset);
    clip.frames.push_back(frame);
  }
  pole->motion.clips.push_back(clip);
}

StepsOf no_steps() {
  return [](size_t) { return [] { return true; }; };
}

nlohmann::json layout_of(const VatResult& result) {
  return nlohmann::json::parse(std::string(result.files.back().bytes.begin(), result.files.back().bytes.end()));
}

TEST(VatJob, PixelsAreTheVerticesOfEveryFrame) {
  AnimatedCharacter animated = pole();
  add_clip("bend", {0, 40, 90}, &animated);
  const VatResult result = vertex_animation("pole", animated, std::nullopt, no_steps());
  ASSERT_EQ(result.files.size(), 5u);
  const Pixels high = decode_picture("", result.files[1].bytes).pixels,
               low = decode_picture("", result.files[2].bytes).pixels;
  EXPECT_EQ(high.width, result.layout.width);
  EXPECT_EQ(high.height, 3u);
  const auto y_of = [&](size_t vertex, size_t frame) {
    const size_t at = 4 * result.layout.texel(vertex, frame) + 1;
    const Point3 from = point(result.bounds.low), to = point(result.bounds.high);
    return from[1] + (256.0 * high.rgba[at] + low.rgba[at]) / 65535 * (to[1] - from[1]);
  };
  // The tip with z = 0.1, around the joint at y = 1: y = 1 + cos - 0.1 sin.
  std::optional<size_t> tip;
  for (size_t i = 0; i < result.layout.vertices; ++i)
    if (y_of(i, 0) > 1.9 && (!tip || y_of(i, 2) < y_of(*tip, 2))) tip = i;
  ASSERT_TRUE(tip);
  for (const auto& [frame, angle] : {std::pair{size_t{0}, 0.0}, {size_t{1}, 40.0}, {size_t{2}, 90.0}})
    EXPECT_NEAR(y_of(*tip, frame), 1 + std::cos(angle * kDegree) - 0.1 * std::sin(angle * kDegree), 2.2 / 65535);
}

TEST(VatJob, ErrorsAreThoseOfQuantizationInFramesAndOfChordsBetween) {
  AnimatedCharacter animated = pole();
  add_clip("bend", {0, 10, 20, 30}, &animated);
  const VatResult result = vertex_animation("pole", animated, std::nullopt, no_steps());
  const VatClip& clip = result.clips[0];
  const Point3 size = point(result.bounds.high) - point(result.bounds.low);
  const double half_step = length(size) / 65535 / 2;
  EXPECT_GT(clip.at_frames.largest, 0);
  EXPECT_LE(clip.at_frames.largest, half_step + 3e-7);  // floats of about 2
  EXPECT_LT(clip.at_frames.mean, clip.at_frames.largest);
  // A vertex turns by 10 degrees about the joint while the shader goes straight: r (1 - cos 5) at r = |(1, 0.1)|.
  const double sagitta = std::hypot(1, 0.1) * (1 - std::cos(5 * kDegree));
  EXPECT_NEAR(clip.between_frames.largest, sagitta, half_step + 3e-7);
  // Six of nine vertices of the welded mesh stand still; copies at seams count as often as they are drawn.
  EXPECT_LT(clip.between_frames.mean, sagitta * 2 / 3);
  EXPECT_LT(clip.normal_angle, 0.4);
  EXPECT_NEAR(result.height, 2, 1e-6);
  EXPECT_EQ(clip.bytes, size_t{4} * result.layout.vertices * 12);
}

TEST(VatJob, ClipsFollowEachOtherAndThoseThatCloseLoop) {
  AnimatedCharacter animated = pole();
  add_clip("bend", {0, 45}, &animated);
  add_clip("swing", {0, 20, 0.1}, &animated);
  add_clip("stand", {5}, &animated);
  const VatResult result = vertex_animation("pole", animated, std::nullopt, no_steps());
  EXPECT_EQ(result.layout.frames, 6u);
  const nlohmann::json layout = layout_of(result);
  ASSERT_EQ(layout["clips"].size(), 3u);
  EXPECT_EQ(layout["clips"][0]["loop"], false);
  EXPECT_EQ(layout["clips"][1]["loop"], true);  // 1.8 mm of 2 m
  EXPECT_EQ(layout["clips"][1]["first_frame"], 2);
  EXPECT_EQ(layout["clips"][1]["frames"], 3);
  EXPECT_DOUBLE_EQ(layout["clips"][1]["seconds"].get<double>(), 0.2);
  EXPECT_DOUBLE_EQ(layout["clips"][1]["rate"].get<double>(), 10);
  EXPECT_EQ(layout["clips"][2]["first_frame"], 5);
  EXPECT_EQ(layout["clips"][2]["loop"], false);
  EXPECT_EQ(layout["rows_per_frame"], 1);
}

TEST(VatJob, ZUpBecomesYUp) {
  AnimatedCharacter animated = pole();
  add_clip("stand", {0}, &animated);
  Character& c = animated.character;
  for (Vec3& v : c.vertices) v = {v.x, -v.z, v.y};
  for (Joint& joint : c.joints) joint.position = {0, 0, joint.position.y};
  c.up = Axis::kZ;
  animated.motion.joints = motion_of(c.joints).joints;
  animated.motion.clips[0].frames[0].translations = {{0, 0, 0}, {0, 0, 1}};
  const VatResult result = vertex_animation("pole", animated, std::nullopt, no_steps());
  EXPECT_NEAR(result.bounds.high.y, 2, 1e-6);
  EXPECT_NEAR(result.bounds.low.z, 0, 1e-6);
  EXPECT_NEAR(result.bounds.high.z, 0.1, 1e-6);
  EXPECT_NEAR(result.height, 2, 1e-6);
}

TEST(VatJob, CorrectionsAreInIt) {
  AnimatedCharacter animated = pole();
  for (size_t v = 3; v < 6; ++v) animated.character.influences[v] = {{0, 0.5f}, {1, 0.5f}};
  add_clip("bend", {0, 90}, &animated);
  const VatResult linear = vertex_animation("pole", animated, std::nullopt, no_steps());
  const VatResult corrected =
      vertex_animation("pole", animated, sinew_deform_options(SINEW_INIT(sinew_deform_options)), no_steps());
  EXPECT_NE(linear.files[1].bytes, corrected.files[1].bytes);
  EXPECT_LE(corrected.clips[0].at_frames.largest, linear.clips[0].at_frames.largest * 2);
}

TEST(VatJob, TooManyFramesAndAStopAreErrors) {
  AnimatedCharacter animated = pole();
  add_clip("long", std::vector<double>(kMostTextureHeight + 1, 0), &animated);
  EXPECT_ERROR(vertex_animation("pole", animated, std::nullopt, no_steps()), "pole", "8192 frames", "found 8193");
  animated.motion.clips[0].frames.resize(2);
  EXPECT_ERROR(vertex_animation("pole", animated, std::nullopt, [](size_t) { return [] { return false; }; }), "pole",
               "interrupted");
}

}  // namespace
}  // namespace sinew
