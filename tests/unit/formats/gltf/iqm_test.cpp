// SPDX-License-Identifier: MIT
// IQM in: mesh, joints, weights and animations; broken files in one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "expect_error.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

template <class T>
std::string raw_values(const std::vector<T>& values) {
  std::string out(values.size() * sizeof(T), '\0');
  if (!values.empty()) std::memcpy(out.data(), values.data(), out.size());
  return out;
}
std::string words(const std::vector<uint32_t>& values) { return raw_values(values); }

// The parts of a file behind its header, and the header's numbers that say where they are.
struct IqmParts {
  std::string body;
  std::vector<uint32_t> header = std::vector<uint32_t>(27, 0);  // from the version on

  // Returns where it begins.
  uint32_t add(const std::string& part) {
    const uint32_t at = static_cast<uint32_t>(124 + body.size());
    body += part;
    return at;
  }
  void add(size_t count_at, uint32_t count, size_t offset_at, const std::string& part) {
    header[count_at] = count;
    header[offset_at] = add(part);
  }
  std::string bytes() {
    header[0] = 2;
    header[1] = static_cast<uint32_t>(124 + body.size());
    return std::string("INTERQUAKEMODEL\0", 16) + words(header) + body;
  }
};

// A triangle across the root and a joint 2 above it, with z up. In "slide" the joint moves along x to 1 in three frames, 10 a second; in "hold" nothing
// moves in three frames.
std::string small_iqm() {
  IqmParts iqm;
  const std::string text = std::string("\0body\0skin\0hip\0tip\0slide\0hold\0", 31);
  iqm.add(3, static_cast<uint32_t>(text.size()), 4, text);
  iqm.add(5, 1, 6, words({1, 6, 0, 3, 0, 1}));
  const uint32_t positions = iqm.add(raw_values<float>({0, 0, 0, 1, 0, 0, 0, 0, 2}));
  const uint32_t joints = iqm.add(raw_values<uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0}));
  const uint32_t weights = iqm.add(raw_values<uint8_t>({255, 0, 0, 0, 255, 0, 0, 0, 51, 204, 0, 0}));
  iqm.header[8] = 3;
  iqm.add(7, 3, 9, words({0, 0, 7, 3, positions, 4, 0, 1, 4, joints, 5, 0, 1, 4, weights}));
  iqm.add(10, 1, 11, words({0, 2, 1}));
  const std::vector<float> still = {0, 0, 0, 1, 1, 1, 1};
  const auto joint = [&](uint32_t name, uint32_t parent, float z) {
    return words({name, parent}) + raw_values<float>({0, 0, z}) + raw_values(still);
  };
  iqm.add(13, 2, 14, joint(11, 0xffffffff, 0) + joint(15, 0, 2));
  const auto pose = [&](uint32_t parent, uint32_t mask, float z, float step) {
    std::vector<float> scales(10, 0);
    scales[0] = step;
    return words({parent, mask}) + raw_values<float>({0, 0, z}) + raw_values(still) + raw_values(scales);
  };
  iqm.add(15, 2, 16, pose(0xffffffff, 0, 0, 0) + pose(0, 1, 2, 0.01f));
  const auto animation = [](uint32_t name, uint32_t first) {
    return words({name, first, 3}) + raw_values<float>({10}) + words({0});
  };
  iqm.add(17, 2, 18, animation(19, 0) + animation(25, 3));
  iqm.header[20] = 1;
  iqm.add(19, 6, 21, raw_values<uint16_t>({0, 50, 100, 0, 0, 0}));
  return iqm.bytes();
}

TEST(Iqm, MeshJointsAndWeights) {
  const TempFolder folder;
  const Character c = read_character(folder.write("ogre.iqm", small_iqm()));
  ASSERT_EQ(c.vertices.size(), 3u);
  EXPECT_EQ(c.face_count(), 1u);
  EXPECT_NEAR(c.vertices[2].y, 2, 1e-6) << "y is up";
  ASSERT_EQ(c.joints.size(), 2u);
  EXPECT_EQ(c.joints[1].name, "tip");
  EXPECT_EQ(c.joints[1].parent, 0);
  EXPECT_NEAR(c.joints[1].position.y, 2, 1e-6);
  const auto row = std::find_if(c.influences.begin(), c.influences.end(), [](const auto& r) { return r.size() == 2; });
  ASSERT_NE(row, c.influences.end());
  for (const Influence& influence : *row) EXPECT_NEAR(influence.weight, influence.joint == 1 ? 0.8f : 0.2f, 1e-4f);
  EXPECT_EQ(c.material_names, std::vector<std::string>{"skin"});
  // The file's order of corners is the other side's.
  const Point3 a = point(c.vertices[c.face_vertices[0]]), b = point(c.vertices[c.face_vertices[1]]),
               d = point(c.vertices[c.face_vertices[2]]);
  EXPECT_GT(cross(b - a, d - a)[2], 0);
}

TEST(Iqm, AnimationsAreClipsOfTheirLength) {
  const TempFolder folder;
  const Motion motion = read_motion(folder.write("ogre.iqm", small_iqm()), 10);
  ASSERT_EQ(motion.clips.size(), 2u);
  EXPECT_EQ(motion.clips[0].name, "slide");
  for (const Clip& clip : motion.clips) {
    ASSERT_EQ(clip.frames.size(), 3u) << clip.name;
    EXPECT_NEAR(clip.frame_time, 0.1, 1e-6);
  }
  const Point3 moved = world_pose(motion, motion.clips[0].frames[1]).positions[1];
  EXPECT_LT(length(moved - Point3{0.5, 2, 0}), 1e-5);
  EXPECT_LT(length(world_pose(motion, motion.clips[1].frames[2]).positions[1] - Point3{0, 2, 0}), 1e-5);
}

TEST(Iqm, WhatIsWrongIsOneLine) {
  const TempFolder folder;
  const std::string whole = small_iqm();
  const auto changed = [&](size_t number, uint32_t value) {
    std::string bytes = whole;
    std::memcpy(&bytes[16 + 4 * number], &value, 4);
    return folder.write("ogre.iqm", bytes);
  };
  EXPECT_ERROR(read_character(folder.write("ogre.iqm", "IQM")), "ogre.iqm: expected an IQM (INTERQUAKEMODEL)");
  EXPECT_ERROR(read_character(changed(0, 1)), "expected version 2 of IQM, found version 1");
  EXPECT_ERROR(read_character(changed(8, 2)), "expected meshes within the file's vertices and triangles");
  EXPECT_ERROR(read_character(changed(13, 9999)), "truncated IQM, expected 9999 joints");
  EXPECT_ERROR(read_character(changed(13, 1)), "expected poses of all 1 joints, found 2");
  EXPECT_ERROR(read_character(changed(20, 0)), "expected as many channels as the poses' masks say");
  EXPECT_ERROR(read_character(changed(19, 5)), "expected animations within the file's 5 frames");
  for (size_t i = 0; i < 2 * whole.size(); i += 3) {
    std::string bytes = i < whole.size() ? whole.substr(0, i) : whole;
    if (i >= whole.size()) bytes[i - whole.size()] = static_cast<char>(bytes[i - whole.size()] ^ 0x5a);
    try {
      (void)read_motion(folder.write("ogre.iqm", bytes));
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace sinew
