// SPDX-License-Identifier: MIT
// glTF animations: every interpolation sampled, against the bind pose; clips written into a document that stays as it was.
#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.hpp"
#include "make_glb.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

constexpr float kHalf = 0.70710678f;

int add_channel(GlbBuilder* builder, nlohmann::json* animation, int node, const char* path,
                const std::vector<float>& times, const std::vector<float>& values, const char* interpolation) {
  const bool turns = std::string(path) == "rotation";
  (*animation)["channels"].push_back(
      {{"sampler", (*animation)["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
  (*animation)["samplers"].push_back({{"input", builder->accessor(times, "SCALAR")},
                                      {"output", builder->accessor(values, turns ? "VEC4" : "VEC3")},
                                      {"interpolation", interpolation}});
  return static_cast<int>((*animation)["samplers"].size()) - 1;
}

nlohmann::json named(const char* name) {
  return {{"name", name}, {"channels", nlohmann::json::array()}, {"samplers", nlohmann::json::array()}};
}

Motion read_clips(const TempFolder& folder, const GlbBuilder& builder, double fps = 0) {
  return read_gltf_motion(folder.write("a.glb", builder.glb()), fps);
}

TEST(GltfMotion, SamplesEveryInterpolation) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  nlohmann::json linear = named("linear"), step = named("step"), cubic = named("");
  add_channel(&builder, &linear, 1, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, kHalf, kHalf}, "LINEAR");
  add_channel(&builder, &linear, 0, "translation", {0.5f, 1}, {10, 0, 0, 14, 0, 0}, "LINEAR");
  add_channel(&builder, &step, 1, "rotation", {1, 2}, {0, 0, 0, 1, 0, 0, kHalf, kHalf}, "STEP");
  add_channel(&builder, &cubic, 0, "translation", {0, 2}, {0, 0, 0, 10, 0, 0, 3, 0, 0, 5, 0, 0, 16, 0, 0, 0, 0, 0},
              "CUBICSPLINE");
  for (nlohmann::json* animation : {&linear, &step, &cubic}) builder.add("animations", *animation);
  const Motion motion = read_clips(folder, builder, 10);
  ASSERT_EQ(motion.joints.size(), 2u);
  EXPECT_EQ(motion.joints[0].name, "hip");
  EXPECT_EQ(motion.joints[1].offset[1], 2);
  ASSERT_EQ(motion.clips.size(), 3u);
  EXPECT_EQ(motion.clips[0].name, "linear");
  EXPECT_EQ(motion.clips[2].name, "animation_2");
  const Clip& smooth = motion.clips[0];
  ASSERT_EQ(smooth.frames.size(), 11u);
  EXPECT_NEAR(dot(smooth.frames[4].rotations[1], axis_rotation(2, 0.4 * std::acos(0.0))), 1, 1e-7) << "constant speed";
  EXPECT_NEAR(smooth.frames[3].translations[0][0], 10, 1e-6) << "before the first key";
  EXPECT_NEAR(smooth.frames[7].translations[0][0], 11.6, 1e-5);
  EXPECT_NEAR(smooth.frames[7].translations[1][1], 2, 1e-6);
  ASSERT_EQ(motion.clips[1].frames.size(), 11u) << "from the first key on";
  EXPECT_NEAR(motion.clips[1].frames[9].rotations[1][2], 0, 1e-7);
  EXPECT_NEAR(motion.clips[1].frames[10].rotations[1][2], kHalf, 1e-6);
  // Hermite at t = 0.5 over 2 s: (10 + 16) / 2 + 2 (3 - 5) / 8.
  EXPECT_NEAR(motion.clips[2].frames[10].translations[0][0], 12.5, 1e-5);
}

// Tangents of rotations are of their four numbers; the blend has length 1 again.
TEST(GltfMotion, RotationsBlendCubically) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  nlohmann::json cubic = named("cubic");
  add_channel(&builder, &cubic, 1, "rotation", {0, 1},
              {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0.5f, 0, 0, 0, 0, 0, 0, 0, kHalf, kHalf, 0, 0, 0, 0}, "CUBICSPLINE");
  builder.add("animations", cubic);
  const Quaternion q = read_clips(folder, builder, 4).clips.at(0).frames.at(1).rotations[1];
  // Hermite at t = 0.25: 0.84375 of the first, 0.140625 of its tangent, 0.15625 of the second.
  const Quaternion wanted = normalized({0, 0, 0.140625 * 0.5 + 0.15625 * kHalf, 0.84375 + 0.15625 * kHalf});
  EXPECT_NEAR(dot(q, wanted), 1, 1e-7);
}

TEST(GltfMotion, TakesTheRateOfItsKeys) {
  const TempFolder folder;
  const auto fps_of = [&](const std::vector<float>& times) {
    GlbBuilder builder = two_joint_strip();
    nlohmann::json animation = named("a");
    std::vector<float> values;
    for (size_t i = 0; i < times.size(); ++i)  // every key moves the joint
      values.insert(values.end(), {0, 0, i % 2 == 0 ? 0 : kHalf, i % 2 == 0 ? 1 : kHalf});
    add_channel(&builder, &animation, 1, "rotation", times, values, "LINEAR");
    builder.add("animations", animation);
    return 1 / read_clips(folder, builder).clips[0].frame_time;
  };
  std::vector<float> times;
  for (int i = 0; i < 86; ++i) times.push_back(static_cast<float>(i * 0.033332));
  EXPECT_NEAR(fps_of(times), 1 / 0.033332, 1e-4) << "no frame is lost to rounding";
  EXPECT_NEAR(fps_of({0, 0.0416667f, 0.0833333f}), 24, 1e-9);
  EXPECT_NEAR(fps_of({0, 1}), 24, 1e-9) << "few keys, smooth motion";
  EXPECT_NEAR(fps_of({0, 0.1f, 0.5f}), 30, 1e-5);
  EXPECT_NEAR(fps_of({0}), 30, 1e-9);
}

// Above the skin's joints stands a node with the scale and the axes of another program; it moves, too.
TEST(GltfMotion, ReadsThroughScaledAndTurnedParents) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][0]["translation"] = {1000, 0, 0};
  builder.document["nodes"][1]["translation"] = {0, 200, 0};
  builder.root({{"name", "Armature"}, {"scale", {0.01, 0.01, 0.01}}, {"children", {0}}});
  builder.document["scenes"][0]["nodes"] = {2, 3};
  builder.document["skins"][0].erase("inverseBindMatrices");
  const std::vector<float> binds = {100, 0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0, 0,    0, 1,
                                    100, 0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0, -200, 0, 1};
  builder.document["skins"][0]["inverseBindMatrices"] = builder.accessor(binds, "MAT4");
  nlohmann::json animation = named("a");
  add_channel(&builder, &animation, 3, "translation", {0, 1}, {0, 0, 0, 0, 0, 5}, "LINEAR");
  add_channel(&builder, &animation, 0, "translation", {0, 1}, {1000, 0, 0, 1100, 0, 0}, "LINEAR");
  add_channel(&builder, &animation, 0, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, kHalf, kHalf}, "LINEAR");
  builder.add("animations", animation);
  const Motion motion = read_clips(folder, builder, 1);
  ASSERT_EQ(motion.joints.size(), 3u);
  EXPECT_EQ(motion.joints[0].name, "hip");
  EXPECT_EQ(motion.joints[0].parent, 2);
  EXPECT_EQ(motion.joints[2].name, "Armature");
  EXPECT_NEAR(motion.joints[0].offset[0], 10, 1e-5);
  const WorldPose pose = world_pose(motion, motion.clips[0].frames[1]);
  EXPECT_NEAR(pose.positions[0][0], 11, 1e-5);
  EXPECT_NEAR(pose.positions[0][2], 5, 1e-5);
  EXPECT_NEAR(pose.positions[1][0], 9, 1e-5) << "the knee has turned to the side";
  EXPECT_NEAR(dot(pose.rotations[1], axis_rotation(2, std::acos(0.0))), 1, 1e-6);
}

TEST(GltfMotion, NodesWithoutASkinAreJoints) {
  const TempFolder folder;
  GlbBuilder builder;
  builder.root({{"name", "a"}, {"children", {1}}});
  builder.add("nodes", {{"name", "b"}, {"translation", {0, 1, 0}}});
  nlohmann::json animation = named("a");
  add_channel(&builder, &animation, 0, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, kHalf, kHalf}, "LINEAR");
  builder.add("animations", animation);
  const Motion motion = read_clips(folder, builder);
  ASSERT_EQ(motion.joints.size(), 2u);
  EXPECT_EQ(motion.joints[1].parent, 0);
  EXPECT_EQ(motion.clips[0].frames.size(), 25u);
}

TEST(GltfMotion, TwoKeysAtOneTimeAreAJump) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  nlohmann::json animation = named("a");
  const std::vector<float> still = {0, 0, 0, 1}, turned = {0, 0, kHalf, kHalf};
  std::vector<float> values;
  for (const std::vector<float>& key : {still, still, turned, turned})
    values.insert(values.end(), key.begin(), key.end());
  add_channel(&builder, &animation, 1, "rotation", {0, 0.5f, 0.5f, 1}, values, "LINEAR");
  builder.add("animations", animation);
  const Clip clip = read_clips(folder, builder).clips.at(0);
  ASSERT_GE(clip.frames.size(), 3u);
  size_t jumps = 0;
  for (size_t f = 1; f < clip.frames.size(); ++f)
    jumps += std::abs(dot(clip.frames[f].rotations[1], clip.frames[f - 1].rotations[1])) < 0.99 ? 1 : 0;
  EXPECT_EQ(jumps, 1u);
}

TEST(GltfMotion, WhatIsWrongIsOneLine) {
  const TempFolder folder;
  EXPECT_ERROR(read_clips(folder, two_joint_strip()), "a.glb: expected an animation, found none");
  const auto expect = [&](const std::function<void(nlohmann::json*, GlbBuilder*)>& change, const char* wanted) {
    GlbBuilder builder = two_joint_strip();
    nlohmann::json animation = named("a");
    add_channel(&builder, &animation, 1, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, kHalf, kHalf}, "LINEAR");
    change(&animation, &builder);
    builder.add("animations", animation);
    EXPECT_ERROR(read_clips(folder, builder), "a.glb: animation ", "'a'", wanted);
  };
  using Animation = nlohmann::json*;
  expect([](Animation a, GlbBuilder*) { (*a)["channels"][0]["target"]["node"] = 99; }, "expected a node below 3");
  expect([](Animation a, GlbBuilder*) { (*a)["channels"][0]["sampler"] = 9; }, "expected a sampler below 1");
  expect([](Animation a, GlbBuilder*) { (*a)["channels"][0]["target"]["path"] = "translation"; }, "3 components");
  expect([](Animation a, GlbBuilder*) { (*a)["samplers"][0]["interpolation"] = "WILD"; }, "'WILD'");
  expect([](Animation a, GlbBuilder*) { (*a)["samplers"][0]["interpolation"] = "CUBICSPLINE"; }, "expected 6 values");
  expect(
      [](Animation a, GlbBuilder* b) {
        (*a)["samplers"][0]["input"] = b->accessor(std::vector<float>{1, 0.5f}, "SCALAR");
      },
      "ascending times from 0");
  expect(
      [](Animation a, GlbBuilder* b) {
        (*a)["samplers"][0]["input"] = b->accessor(std::vector<float>{-1, 1}, "SCALAR");
      },
      "ascending times from 0");
  expect(
      [](Animation a, GlbBuilder* b) {
        (*a)["samplers"][0]["input"] = b->accessor(std::vector<float>{0, 1e30f}, "SCALAR");
      },
      "frames times joints");
  expect(
      [](Animation a, GlbBuilder* b) {
        (*a)["samplers"][0]["input"] = b->accessor(std::vector<float>{0, NAN}, "SCALAR");
      },
      "finite numbers");
  expect([](Animation a, GlbBuilder*) { (*a)["samplers"][0]["output"] = 77; }, "an accessor below");
}

Motion swing(const Character& character) {
  Motion motion = motion_of(character.joints);
  Clip clip = {"swing", 0.125, {}};
  for (int f = 0; f < 5; ++f) {
    MotionFrame frame;
    for (const MotionJoint& joint : motion.joints) {
      frame.rotations.push_back(axis_rotation(f % 3 == 0 ? 0 : 2, 0.4 * f));
      frame.translations.push_back(joint.offset);
    }
    frame.translations[0][1] += f;
    clip.frames.push_back(frame);
  }
  motion.clips.push_back(clip);
  return motion;
}

void expect_plays(const Motion& found, const Motion& wanted, size_t clip) {
  ASSERT_GT(found.clips.size(), clip);
  ASSERT_EQ(found.clips[clip].frames.size(), wanted.clips[0].frames.size());
  EXPECT_NEAR(found.clips[clip].frame_time, wanted.clips[0].frame_time, 1e-9);
  for (size_t f = 0; f < wanted.clips[0].frames.size(); ++f) {
    const WorldPose a = world_pose(found, found.clips[clip].frames[f]),
                    b = world_pose(wanted, wanted.clips[0].frames[f]);
    for (size_t j = 0; j < wanted.joints.size(); ++j) {
      EXPECT_NEAR(std::abs(dot(a.rotations[j], b.rotations[j])), 1, 1e-6) << f << " " << j;
      for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(a.positions[j][i], b.positions[j][i], 1e-5) << f << " " << j;
    }
  }
}

TEST(GltfMotion, ClipsAreWrittenIntoTheDocumentAndNothingElseChanges) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  builder.document["nodes"][1].erase("translation");
  builder.document["nodes"][1]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1};
  builder.root({{"name", "Armature"}, {"rotation", {-kHalf, 0, 0, kHalf}}, {"scale", {2, 2, 2}}, {"children", {0}}});
  builder.document["scenes"][0]["nodes"] = {2, 3};
  builder.document["extras"] = {{"mine", {1, 2, 3}}};
  nlohmann::json old = named("swing");
  add_channel(&builder, &old, 0, "scale", {0, 1}, {1, 1, 1, 1, 1, 1}, "LINEAR");
  builder.add("animations", old);
  const std::string path = folder.write("in.glb", builder.glb());
  const Character character = read_gltf(path);
  const Motion motion = swing(character);
  GlbOptions options;
  options.keep_skin = true;
  options.motion = &motion;
  write_gltf(folder.file("out.glb"), character, options);

  const nlohmann::json before = json_of_glb(folder.text_of("in.glb")), after = json_of_glb(folder.text_of("out.glb"));
  for (const char* key : {"meshes", "skins", "scenes", "extras", "scene"}) EXPECT_EQ(before[key], after[key]) << key;
  for (const size_t node : {0, 2, 3}) EXPECT_EQ(before["nodes"][node], after["nodes"][node]) << node;
  EXPECT_FALSE(after["nodes"][1].contains("matrix")) << "an animated node";
  for (size_t i = 0; i < before["accessors"].size(); ++i) EXPECT_EQ(before["accessors"][i], after["accessors"][i]);
  ASSERT_EQ(after["animations"].size(), 2u);
  EXPECT_EQ(before["animations"][0], after["animations"][0]);
  EXPECT_EQ(after["animations"][1]["name"], "swing_2");
  const nlohmann::json& times = after["accessors"][after["animations"][1]["samplers"][0]["input"].get<size_t>()];
  EXPECT_EQ(times["min"], nlohmann::json::array({0}));
  EXPECT_EQ(times["max"], nlohmann::json::array({0.5}));
  expect_plays(read_gltf_motion(folder.file("out.glb"), 8), motion, 1);
  const Character again = read_gltf(folder.file("out.glb"));
  for (size_t v = 0; v < character.vertices.size(); ++v) EXPECT_EQ(again.vertices[v].y, character.vertices[v].y);
}

TEST(GltfMotion, AMeshWithoutADocumentGetsSkinAndClips) {
  const TempFolder folder;
  Character character;
  character.name = "chain";
  character.joints = {{"a", {0, 0, 0}, -1}, {"b", {1, 0, 0}, 0}, {"e", {2, 0, 0}, 1}};
  character.vertices = {{0, 0.1f, 0}, {1, 0.1f, 0}, {2, 0.1f, 0}};
  character.face_offsets = {0, 3};
  character.face_vertices = {0, 1, 2};
  character.influences = {{{0, 1.0f}}, {{0, 0.5f}, {1, 0.5f}}, {{1, 1.0f}}};
  const Motion motion = swing(character);
  GlbOptions options;
  options.motion = &motion;
  write_gltf(folder.file("out.gltf"), character, options);
  expect_plays(read_gltf_motion(folder.file("out.gltf"), 8), motion, 0);
  // Nothing moves: a clip of that length is there all the same.
  Motion still = motion_of(character.joints);
  still.clips.push_back({"still", 0.5, {}});
  for (int f = 0; f < 3; ++f) {
    still.clips[0].frames.push_back({std::vector<Quaternion>(3, kNoRotation4), {}});
    for (const MotionJoint& joint : still.joints) still.clips[0].frames.back().translations.push_back(joint.offset);
  }
  options.motion = &still;
  write_gltf(folder.file("still.glb"), character, options);
  EXPECT_EQ(read_gltf_motion(folder.file("still.glb"), 2).clips.at(0).frames.size(), 3u);
  EXPECT_DOUBLE_EQ(read_gltf_motion(folder.file("still.glb")).clips[0].frame_time, 1.0 / 30) << "no key tells a rate";
  for (MotionFrame& frame : still.clips[0].frames) frame.rotations[1] = axis_rotation(2, 0.5);  // a held pose
  write_gltf(folder.file("held.glb"), character, options);
  EXPECT_EQ(read_gltf_motion(folder.file("held.glb"), 2).clips.at(0).frames.size(), 3u);
  Motion wrong = motion;
  wrong.joints.pop_back();
  options.motion = &wrong;
  EXPECT_ERROR(write_gltf(folder.file("wrong.glb"), character, options), "wrong.glb", "3 joints, found one of 2");
}

TEST(GltfMotion, ATruncatedFileIsRefusedAtEveryLength) {
  const TempFolder folder;
  GlbBuilder builder = two_joint_strip();
  nlohmann::json animation = named("a");
  add_channel(&builder, &animation, 1, "rotation", {0, 1}, {0, 0, 0, 1, 0, 0, kHalf, kHalf}, "LINEAR");
  builder.add("animations", animation);
  const std::string glb = builder.glb();
  for (size_t length = 0; length < glb.size(); length += 3) {
    const std::string path = folder.write("cut.glb", glb.substr(0, length));
    EXPECT_ERROR(read_gltf_motion(path), "cut.glb");
  }
}

}  // namespace
}  // namespace sinew
