// SPDX-License-Identifier: MIT
// BVH in and out: what programs write is read, what is wrong is one line, what was written reads back.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "expect_error.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

const std::string kSmall =
    "HIERARCHY\n"
    "ROOT Hips\n{\n\tOFFSET 0 1 0\n\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    "\tJOINT Leg\n\t{\n\t\tOFFSET 0.5 -0.5 0\n\t\tCHANNELS 3 Yrotation Zrotation Xrotation\n"
    "\t\tEnd Site\n\t\t{\n\t\t\tOFFSET 0 -0.5 0\n\t\t}\n\t}\n}\n"
    "MOTION\nFrames: 2\nFrame Time: 0.04\n"
    "0 1 0 0 0 0 0 0 0\n"
    "1 2 3 90 0 0 0 0 90\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void expect_same(const Motion& a, const Motion& b, double tolerance) {
  ASSERT_EQ(a.joints.size(), b.joints.size());
  for (size_t j = 0; j < a.joints.size(); ++j) {
    EXPECT_EQ(a.joints[j].name, b.joints[j].name);
    EXPECT_EQ(a.joints[j].parent, b.joints[j].parent);
    EXPECT_EQ(a.joints[j].end, b.joints[j].end);
    for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(a.joints[j].offset[i], b.joints[j].offset[i], tolerance);
  }
  ASSERT_EQ(a.clips.size(), b.clips.size());
  ASSERT_EQ(a.clips[0].frames.size(), b.clips[0].frames.size());
  EXPECT_NEAR(a.clips[0].frame_time, b.clips[0].frame_time, 1e-9);
  for (size_t f = 0; f < a.clips[0].frames.size(); ++f) {
    const MotionFrame &x = a.clips[0].frames[f], &y = b.clips[0].frames[f];
    for (size_t j = 0; j < a.joints.size(); ++j) {
      EXPECT_NEAR(std::abs(dot(x.rotations[j], y.rotations[j])), 1, tolerance) << f << " " << j;
      for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(x.translations[j][i], y.translations[j][i], tolerance);
    }
  }
}

TEST(Bvh, ReadsJointsChannelsAndFrames) {
  const TempFolder folder;
  const Motion motion = read_bvh(folder.write("small.bvh", kSmall));
  EXPECT_EQ(motion.name, "small");
  ASSERT_EQ(motion.joints.size(), 3u);
  EXPECT_EQ(motion.joints[1].name, "Leg");
  EXPECT_EQ(motion.joints[1].parent, 0);
  EXPECT_EQ(motion.joints[2].name, "Leg_end");
  EXPECT_TRUE(motion.joints[2].end);
  EXPECT_EQ(rest_joints(motion)[2].position.x, 0.5f);
  EXPECT_EQ(rest_joints(motion)[2].position.y, 0.0f);
  ASSERT_EQ(motion.clips.size(), 1u);
  EXPECT_EQ(motion.clips[0].name, "small");
  EXPECT_DOUBLE_EQ(motion.clips[0].frame_time, 0.04);
  // The root stands at (1 2 3), turned by 90 degrees about z: x becomes y. The leg turns about x.
  const WorldPose pose = world_pose(motion, motion.clips[0].frames[1]);
  const Point3 leg = pose.positions[1], tip = pose.positions[2];
  EXPECT_NEAR(leg[0], 1.5, 1e-12);
  EXPECT_NEAR(leg[1], 2.5, 1e-12);
  EXPECT_NEAR(leg[2], 3, 1e-12);
  EXPECT_NEAR(tip[0], 1.5, 1e-12);
  EXPECT_NEAR(tip[1], 2.5, 1e-12);
  EXPECT_NEAR(tip[2], 2.5, 1e-12);
}

TEST(Bvh, TurnsApplyInTheOrderOfTheirChannels) {
  const TempFolder folder;
  const Quaternion x = axis_rotation(0, 0.3), y = axis_rotation(1, 0.5), z = axis_rotation(2, 0.7);
  const std::string degrees[3] = {std::to_string(0.3 * 180 / std::numbers::pi),
                                  std::to_string(0.5 * 180 / std::numbers::pi),
                                  std::to_string(0.7 * 180 / std::numbers::pi)};
  const auto read = [&](const std::string& channels, const std::string& values) {
    const std::string text = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 " + channels +
                             "\n}\nMOTION\nFrames: 1\nFrame Time: 1\n" + values + "\n";
    return read_bvh(folder.write("one.bvh", text)).clips[0].frames[0].rotations[0];
  };
  const auto expect = [](const Quaternion& found, const Quaternion& wanted) {
    EXPECT_NEAR(dot(found, wanted), 1, 1e-9);
  };
  expect(read("Zrotation Xrotation Yrotation", degrees[2] + " " + degrees[0] + " " + degrees[1]),
         multiply(z, multiply(x, y)));
  expect(read("Xrotation Yrotation Zrotation", degrees[0] + " " + degrees[1] + " " + degrees[2]),
         multiply(x, multiply(y, z)));
  expect(read("YROTATION zrotation Xrotation", degrees[1] + " " + degrees[2] + " " + degrees[0]),
         multiply(y, multiply(z, x)));
}

TEST(Bvh, ReadsWhatOtherProgramsWrite) {
  const TempFolder folder;
  const Motion plain = read_bvh(folder.write("small.bvh", kSmall));
  std::string crlf;
  for (const char c : kSmall) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_same(read_bvh(folder.write("small.bvh", crlf)), plain, 0);
  expect_same(read_bvh(folder.write("small.bvh", with(kSmall, "ROOT Hips\n{", "root Hips {"))), plain, 0);
  expect_same(read_bvh(folder.write("small.bvh",
                                    with(kSmall, "Frames: 2\nFrame Time: 0.04", "Frames:\t2\n\nFrame Time:\t4e-2"))),
              plain, 0);
  expect_same(read_bvh(folder.write("small.bvh", with(kSmall, "1 2 3 90", "1.0e0 +2 3. 9.0E+1"))), plain, 0);
  expect_same(read_bvh(folder.write("small.bvh", kSmall + "\n\n")), plain, 0);
  const std::string in_line = "End Site { OFFSET 0 -0.5 0 } } }\n";
  expect_same(read_bvh(folder.write("small.bvh", kSmall.substr(0, kSmall.find("End Site")) + in_line +
                                                     kSmall.substr(kSmall.find("MOTION")))),
              plain, 0);
  EXPECT_EQ(read_bvh(folder.write("a.bvh", with(kSmall, "JOINT Leg", "JOINT Left Leg"))).joints[1].name, "Left Leg");
  EXPECT_EQ(read_bvh(folder.write("a.bvh", with(kSmall, "JOINT Leg", "JOINT Hips"))).joints[1].name, "Hips_2");
  // Positions in every joint: as positions, or all 0 as differences from the offsets.
  const std::string six = with(kSmall, "CHANNELS 3 Y", "CHANNELS 6 Xposition Yposition Zposition Y");
  for (const std::string position : {"0.5 -0.5 0 ", "0 0 0 "}) {
    const std::string rows = "0 1 0 0 0 0 " + position + "0 0 0\n1 2 3 90 0 0 " + position + "0 0 90\n";
    expect_same(read_bvh(folder.write("small.bvh", six.substr(0, six.find("0 1 0 0 0 0")) + rows)), plain, 1e-12);
  }
  // Two roots, one of them a prop.
  const std::string two = with(with(kSmall, "MOTION", "ROOT Ball\n{\nOFFSET 0 0 0\nCHANNELS 1 Yposition\n}\nMOTION"),
                               "0 0 0\n1", "0 0 0 5\n1");
  const Motion both = read_bvh(folder.write("two.bvh", with(two, "0 90\n", "0 90 6\n")));
  EXPECT_EQ(both.joints[3].parent, -1);
  EXPECT_EQ(both.clips[0].frames[1].translations[3][1], 6);
  // A skeleton alone.
  const std::string still = kSmall.substr(0, kSmall.find("Frames")) + "Frames: 0\nFrame Time: 0\n";
  EXPECT_TRUE(read_bvh(folder.write("still.bvh", still)).clips.empty());
}

TEST(Bvh, WhatTheHeaderGetsWrongIsToldAndRead) {
  const TempFolder folder;
  const Motion plain = read_bvh(folder.write("small.bvh", kSmall));
  EXPECT_TRUE(plain.notes.empty());
  const auto told = [&](const std::string& from, const std::string& to, const char* wanted) {
    const Motion motion = read_bvh(folder.write("small.bvh", with(kSmall, from, to)));
    ASSERT_EQ(motion.notes.size(), 1u);
    EXPECT_NE(motion.notes[0].find(wanted), std::string::npos) << motion.notes[0];
    EXPECT_EQ(motion.clips[0].frames.size(), 2u);
  };
  told("Frames: 2", "Frames: 3", "announces 3 frames, the file has 2");
  told("Frames: 2", "Frames: 1", "announces 1 frames, the file has 2");
  told("Frame Time: 0.04", "Frame Time: 0", "'Frame Time:' is 0");
  EXPECT_DOUBLE_EQ(read_bvh(folder.write("a.bvh", with(kSmall, "0.04", "0"))).clips[0].frame_time, 1.0 / 30);
  std::string mixed = with(kSmall, "MOTION\n", "MOTION\r\n");
  expect_same(read_bvh(folder.write("small.bvh", with(mixed, "0 0 0 0\n1", "0 0 0 0\r1"))), plain, 0);
}

TEST(Bvh, WhatIsWrongIsOneLine) {
  const TempFolder folder;
  const auto expect = [&](const std::string& text, const char* first, const char* second = "expected") {
    EXPECT_ERROR(read_bvh(folder.write("bad.bvh", text)), "bad.bvh", first, second);
  };
  expect("", "empty file");
  expect(std::string("HIER\0", 5), "binary");
  expect(with(kSmall, "HIERARCHY", "HELLO"), ":1: expected HIERARCHY");
  expect(with(kSmall, "OFFSET 0.5 -0.5 0", "OFFSET 0.5 -0.5"), ":8: expected 'OFFSET x y z'");
  expect(with(kSmall, "0.5 -0.5 0", "0.5 nan 0"), ":8: expected a finite number", "nan");
  expect(with(kSmall, "0.5 -0.5 0", "0,5 1 0"), "finite number", "0,5");
  expect(with(kSmall, "CHANNELS 3", "CHANNELS 4"), ":9: expected 4 channels");
  expect(with(kSmall, "CHANNELS 3", "CHANNELS 7"), "0 to 6");
  expect(with(kSmall, "Yrotation Zrotation", "Yrotation Yrotation"), "each channel once");
  expect(with(kSmall, "Yrotation Zrotation", "Yrotation Wrotation"), "Wrotation");
  expect(with(kSmall, "\t\tOFFSET 0.5 -0.5 0\n", ""), "an OFFSET in 'Leg'");
  expect(with(kSmall, "JOINT Leg", "ROOT Leg"), "JOINT or 'End Site' inside of a joint");
  expect(with(kSmall, "ROOT Hips", "JOINT Hips"), "ROOT or MOTION");
  expect(with(kSmall, "ROOT Hips", "ROOT"), "a name behind ROOT");
  expect(with(kSmall, "\t}\n}\n", "\t}\n"), "OFFSET, CHANNELS, JOINT");
  expect(with(kSmall, "End Site\n\t\t{", "End Site\n"), "'{'");
  expect(with(kSmall, "Frames: 2", "Frames: two"), "the number of frames", "two");
  expect(with(kSmall, "Frame Time: 0.04", "Frame Time: -0.04"), "0 or more");
  expect(with(kSmall, "Frame Time", "Frame Rate"), "Frame Time");
  expect(with(kSmall, "3 90", "3 inf"), ":20: expected a finite number", "inf");
  expect(with(kSmall, "0 1 0 0", "1 0 0"), ":19: expected 9 numbers in frame 0, found '8 of them'");
  const std::string two = with(kSmall, "1 2 3 90", "2 3 90");
  expect(two + "1 2 3\n1 2 3 90 0 0 0 0 90\n", ":20: expected 9 numbers in frame 1, found '8 of them'");
}

TEST(Bvh, AFrameWithoutAllNumbersIsLeftOutOrFilled) {
  const TempFolder folder;
  const Motion end = read_bvh(folder.write("end.bvh", with(kSmall, "1 2 3 90 0", "1 2 3 90")));
  ASSERT_EQ(end.clips[0].frames.size(), 1u);
  ASSERT_EQ(end.notes.size(), 1u);
  EXPECT_EQ(end.notes[0], "warning: 1 frame without 9 numbers at the end (line 20), left out");
  const std::string three = with(kSmall, "Frames: 2", "Frames: 3") + "3 2 3 90 0 0 0 0 90\n";
  const Motion middle = read_bvh(folder.write("middle.bvh", with(three, "1 2 3 90 0", "1 2 3 90")));
  ASSERT_EQ(middle.clips[0].frames.size(), 3u);
  EXPECT_NEAR(middle.clips[0].frames[1].translations[0][0], 1.5, 1e-12);
  EXPECT_NEAR(middle.clips[0].frames[1].translations[0][1], 1.5, 1e-12);
  ASSERT_EQ(middle.notes.size(), 1u);
  EXPECT_EQ(middle.notes[0], "warning: 1 frame without 9 numbers (line 20), interpolated from the frames around");
}

TEST(Bvh, ATruncatedFileIsRefusedAtEveryLength) {
  const TempFolder folder;
  size_t read = 0;
  for (size_t length = 0; length < kSmall.size(); ++length) {
    const std::string path = folder.write("cut.bvh", kSmall.substr(0, length));
    try {
      (void)read_bvh(path);
      ++read;
    } catch (const Error& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.rfind(path, 0), 0u) << text;
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
      EXPECT_NE(text.find("expected"), std::string::npos) << text;
    }
  }
  const size_t last_line = std::string("1 2 3 90 0 0 0 0 90\n").size();
  EXPECT_LE(read, last_line + 2) << "the last frame alone may be incomplete";
}

TEST(Bvh, WhatIsWrittenReadsBack) {
  const TempFolder folder;
  Motion motion = read_bvh(folder.write("small.bvh", kSmall));
  Clip& clip = motion.clips[0];
  clip.frames.clear();
  for (int f = 0; f < 40; ++f) {
    MotionFrame frame;
    const double t = 0.31 * f;
    frame.rotations = {normalized({std::sin(t), std::cos(3 * t), std::sin(5 * t), 0.3}),
                       multiply(axis_rotation(2, t), multiply(axis_rotation(0, f % 2 == 0 ? std::numbers::pi / 2 : t),
                                                              axis_rotation(1, 2 * t))),
                       kNoRotation4};
    frame.translations = {{t, -t, 100 * t}, motion.joints[1].offset, motion.joints[2].offset};
    clip.frames.push_back(frame);
  }
  write_bvh(folder.file("again.bvh"), motion, clip);
  expect_same(read_bvh(folder.file("again.bvh")), motion, 2e-5);
  const std::string text = folder.text_of("again.bvh");
  EXPECT_NE(text.find("CHANNELS 3"), std::string::npos) << "joints that keep their place";
  write_bvh(folder.file("third.bvh"), read_bvh(folder.file("again.bvh")), read_bvh(folder.file("again.bvh")).clips[0]);
  expect_same(read_bvh(folder.file("third.bvh")), motion, 2e-5);
  for (MotionFrame& frame : clip.frames) frame.translations[1][0] = 2;
  write_bvh(folder.file("moved.bvh"), motion, clip);
  EXPECT_EQ(folder.text_of("moved.bvh").find("CHANNELS 3"), std::string::npos);
  expect_same(read_bvh(folder.file("moved.bvh")), motion, 2e-5);
}

TEST(Bvh, IsASkeletonForAMesh) {
  const TempFolder folder;
  Character character;
  read_skeleton(folder.write("small.bvh", kSmall), false, &character);
  ASSERT_EQ(character.joints.size(), 3u);
  EXPECT_EQ(character.joints[2].name, "Leg_end");
  EXPECT_EQ(character.joints[2].parent, 1);
  EXPECT_EQ(character.joints[1].position.y, 0.5f);
}

}  // namespace
}  // namespace sinew
