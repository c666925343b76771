// SPDX-License-Identifier: MIT
// NumPy files: rotations of body models in all their forms, keypoints alone, zips, and what is wrong in one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "expect_error.hpp"
#include "motion/keypoint_layouts.hpp"
#include "motion/named_skeletons.hpp"
#include "motion/npy.hpp"
#include "motion/person.hpp"
#include "numpy_bytes.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/keypoints_stream.hpp"
#include "sinew_formats/motion.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

using test::npy_of;
using test::zip_of;

constexpr size_t kFrames = 5;

std::string shape_of(std::initializer_list<size_t> sides) {
  std::string text = "(";
  for (const size_t side : sides) text += std::to_string(side) + ", ";
  return text + ")";
}

// Axis angles of a body that faces along x and bends knees, elbows and spine, [frames x joints x 3].
std::vector<double> bent_body(size_t joints) {
  std::vector<double> values(kFrames * joints * 3, 0);
  for (size_t f = 0; f < kFrames; ++f) {
    double* const row = &values[f * joints * 3];
    const double t = static_cast<double>(f);
    row[1] = 1.2;                // the root turns about y
    row[3 * 4] = 0.5 + 0.2 * t;  // left knee
    row[3 * 5] = 1.1 - 0.1 * t;  // right knee
    row[3 * 1] = -0.4;           // left hip
    row[3 * 2 + 1] = 0.7;        // the right thigh twists
    row[3 * 6] = 0.1 * t;        // chest
    row[3 * 16 + 2] = -0.6;      // arms down
    row[3 * 17 + 2] = 0.7;
    row[3 * 18 + 1] = -0.3 - 0.3 * t;  // left elbow
    row[3 * 15] = 0.2;                 // head
  }
  return values;
}
std::vector<double> path() {
  std::vector<double> values;
  for (size_t f = 0; f < kFrames; ++f) values.insert(values.end(), {0.1 * static_cast<double>(f), 0.95, 0.3});
  return values;
}

Motion read(const std::string& name, const std::string& bytes, const std::string& layout = "") {
  const TempFolder folder;
  return read_motion(folder.write(name, bytes), 0, layout);
}
Motion amass() {
  return read("walk.npz", zip_of({{"poses.npy", npy_of(shape_of({kFrames, 72}), bent_body(24))},
                                  {"trans.npy", npy_of(shape_of({kFrames, 3}), path())},
                                  {"gender.npy", npy_of("<U6", "()", std::string(24, 'm'))},
                                  {"mocap_framerate.npy", npy_of("()", std::vector<double>{120})}}));
}

size_t joint_of(const Motion& motion, const std::string& name) {
  for (size_t j = 0; j < motion.joints.size(); ++j)
    if (motion.joints[j].name == name) return j;
  ADD_FAILURE() << name;
  return 0;
}
bool has_note(const Motion& motion, const std::string& part) {
  for (const std::string& note : motion.notes)
    if (note.find(part) != std::string::npos) return true;
  return false;
}

TEST(Numpy, ReadsRotationsOfABodyModel) {
  const Motion motion = amass();
  EXPECT_EQ(motion.name, "walk");
  ASSERT_EQ(motion.joints.size(), 24u);
  EXPECT_EQ(motion.joints[0].name, "hips");
  EXPECT_EQ(motion.joints[joint_of(motion, "leftLowerLeg")].parent, static_cast<int>(joint_of(motion, "leftUpperLeg")));
  EXPECT_EQ(motion.joints[joint_of(motion, "rightShoulder")].parent, static_cast<int>(joint_of(motion, "upperChest")));
  ASSERT_EQ(motion.clips.size(), 1u);
  ASSERT_EQ(motion.clips[0].frames.size(), kFrames);
  EXPECT_DOUBLE_EQ(motion.clips[0].frame_time, 1.0 / 120);
  const MotionFrame& last = motion.clips[0].frames[4];
  EXPECT_NEAR(std::abs(dot(last.rotations[joint_of(motion, "leftLowerLeg")], axis_rotation(0, 1.3))), 1, 1e-12);
  EXPECT_NEAR(std::abs(dot(last.rotations[0], axis_rotation(1, 1.2))), 1, 1e-12);
  EXPECT_NEAR(last.translations[0][0], 0.4, 1e-12);
  const std::vector<Joint> rest = rest_joints(motion);
  EXPECT_GT(rest[joint_of(motion, "leftHand")].position.x, 0.5f) << "left at +x";
  EXPECT_GT(rest[joint_of(motion, "head")].position.y, 1.4f);
  EXPECT_TRUE(has_note(motion, "SMPL")) << "told what it was taken for";
}

TEST(Numpy, SixAndNineNumbersSayTheSameAsAxisAngles) {
  const Motion plain = amass();
  std::vector<double> six, nine, root, body;
  for (const MotionFrame& frame : plain.clips[0].frames)
    for (size_t j = 0; j < 24; ++j) {
      const Rotation r = rotation_of(frame.rotations[j]);
      six.insert(six.end(), {r[0], r[3], r[6], r[1], r[4], r[7]});
      nine.insert(nine.end(), r.begin(), r.end());
      (j == 0 ? root : body).insert((j == 0 ? root : body).end(), {r[0], r[3], r[6], r[1], r[4], r[7]});
    }
  const std::vector<std::string> files = {zip_of({{"poses.npy", npy_of(shape_of({kFrames, 24, 6}), six)}}),
                                          zip_of({{"poses.npy", npy_of(shape_of({kFrames, 24, 3, 3}), nine)}}),
                                          zip_of({{"global_orient.npy", npy_of(shape_of({kFrames, 6}), root)},
                                                  {"body_pose.npy", npy_of(shape_of({kFrames, 23, 6}), body)}},
                                                 true)};
  for (const std::string& bytes : files) {
    const Motion motion = read("a.npz", bytes);
    EXPECT_TRUE(has_note(motion, "30 frames per second were assumed"));
    for (size_t f = 0; f < kFrames; ++f)
      for (size_t j = 0; j < 24; ++j)
        EXPECT_NEAR(std::abs(dot(motion.clips[0].frames[f].rotations[j], plain.clips[0].frames[f].rotations[j])), 1,
                    1e-12);
  }
}

TEST(Numpy, KnowsModelsByTheirCounts) {
  for (const auto& [joints, finger] : {std::pair<size_t, size_t>{52, 22}, {55, 25}, {22, 0}}) {
    const Motion motion =
        read("a.npz", zip_of({{"poses.npy", npy_of(shape_of({kFrames, joints * 3}), bent_body(joints))}}));
    ASSERT_EQ(motion.joints.size(), joints);
    if (finger == 0) continue;
    EXPECT_EQ(motion.joints[finger].name, "leftIndexProximal");
    EXPECT_EQ(motion.joints[finger + 12].name, "leftThumbMetacarpal");
    EXPECT_EQ(motion.joints[finger + 15].name, "rightIndexProximal");
    EXPECT_EQ(motion.joints.back().name, "rightThumbDistal");
  }
}

TEST(Numpy, AWorldWithZUpIsTurned) {
  std::vector<double> poses = bent_body(24), keypoints = path();
  for (size_t f = 0; f < kFrames; ++f) {  // about x by a quarter after the turn about y
    const Quaternion q = multiply(axis_rotation(0, std::acos(0.0)), axis_rotation(1, 1.2));
    const double angle = 2 * std::acos(q[3]), s = std::sin(angle / 2);
    for (size_t i = 0; i < 3; ++i) poses[f * 72 + i] = q[i] / s * angle;
    keypoints[3 * f + 1] = -0.3;
    keypoints[3 * f + 2] = 0.95;
  }
  const Motion motion = read("a.npz", zip_of({{"poses.npy", npy_of(shape_of({kFrames, 72}), poses)},
                                              {"trans.npy", npy_of(shape_of({kFrames, 3}), keypoints)}}));
  const MotionFrame &a = motion.clips[0].frames[2], b = amass().clips[0].frames[2];
  EXPECT_NEAR(std::abs(dot(a.rotations[0], b.rotations[0])), 1, 1e-12);
  for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(a.translations[0][i], b.translations[0][i], 1e-12);
  EXPECT_TRUE(has_note(motion, "upright along z"));
}

// Keypoints of a motion's joints, in the order that a layout has them.
std::vector<float> keypoints_of(const Motion& motion, const std::function<Point3(const Point3&)>& change = {}) {
  std::vector<float> values;
  for (const MotionFrame& frame : motion.clips[0].frames)
    for (const Point3& p : world_pose(motion, frame).positions)
      for (const double x : change ? change(p) : p) values.push_back(static_cast<float>(x));
  return values;
}
void expect_same_keypoints(const Motion& found, const Motion& from, double tolerance) {
  for (size_t f = 0; f < kFrames; ++f) {
    const WorldPose a = world_pose(found, found.clips[0].frames[f]), b = world_pose(from, from.clips[0].frames[f]);
    for (size_t j = 0; j < found.joints.size(); ++j) {
      const size_t other = joint_of(from, found.joints[j].name);
      EXPECT_LT(length(a.positions[j] - b.positions[other]), tolerance) << f << " " << found.joints[j].name;
    }
  }
}

TEST(Numpy, KeypointsAloneBecomeAMotion) {
  const Motion from = amass();
  const Motion found = read("p.npy", npy_of(shape_of({kFrames, 24, 3}), keypoints_of(from)));
  ASSERT_EQ(found.joints.size(), 24u);
  EXPECT_TRUE(has_note(found, "the layout smpl24 was assumed"));
  expect_same_keypoints(found, from, 1e-5);
  // Bent limbs turn about their hinges: as they did.
  const size_t knee = joint_of(from, "rightUpperLeg"), elbow = joint_of(from, "leftLowerArm");
  const WorldPose a = world_pose(found, found.clips[0].frames[4]), b = world_pose(from, from.clips[0].frames[4]);
  EXPECT_GT(std::abs(dot(a.rotations[knee], b.rotations[knee])), std::cos(0.05));
  EXPECT_GT(std::abs(dot(a.rotations[elbow], b.rotations[elbow])), std::cos(0.05));
}

std::vector<std::vector<Point3>> rows_of(const std::vector<float>& values, size_t count) {
  std::vector<std::vector<Point3>> rows(values.size() / (3 * count));
  for (size_t i = 0; i < values.size(); i += 3)
    rows[i / (3 * count)].push_back({double{values[i]}, double{values[i + 1]}, double{values[i + 2]}});
  return rows;
}
void expect_same_frame(const MotionFrame& found, const MotionFrame& from, double tolerance) {
  ASSERT_EQ(found.rotations.size(), from.rotations.size());
  for (size_t j = 0; j < from.rotations.size(); ++j) {
    EXPECT_GE(std::abs(dot(found.rotations[j], from.rotations[j])), std::cos(tolerance) - 1e-14) << j;
    EXPECT_LE(length(found.translations[j] - from.translations[j]), tolerance + 1e-12) << j;
  }
}

TEST(Keypoints, FramesThatComeAreThoseOfTheWhole) {
  const Motion from = amass();
  // As they are; along z, mirrored; relative to the hips.
  const std::vector<std::function<Point3(const Point3&)>> worlds = {{},
                                                                    [](const Point3& p) {
                                                                      return Point3{p[0], -p[2], p[1]};
                                                                    },
                                                                    [](const Point3& p) {
                                                                      return Point3{p[0], p[1], -p[2]};
                                                                    }};
  for (size_t w = 0; w <= worlds.size(); ++w) {
    std::vector<float> values = keypoints_of(from, w < worlds.size() ? worlds[w] : worlds[0]);
    if (w == worlds.size())
      for (size_t i = 0; i < values.size(); i += 3)
        for (size_t a = 0; a < 3; ++a)
          if (i % 72 != 0) values[i + a] -= values[i / 72 * 72 + a];
    if (w == worlds.size())
      for (size_t f = 0; f < kFrames; ++f) std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(72 * f), 3, 0.0f);
    const Motion whole = read("p.npy", npy_of(shape_of({kFrames, 24, 3}), values), "smpl24");
    const std::vector<std::vector<Point3>> rows = rows_of(values, 24);
    const KeypointsStream all("smpl24", rows), first("smpl24", {rows[0], rows[1]});
    EXPECT_EQ(all.person().clips[0].frames.size(), kFrames);
    for (size_t f = 0; f < kFrames; ++f) {
      expect_same_frame(all.next(rows[f]), whole.clips[0].frames[f], 0);
      expect_same_frame(first.next(rows[f]), whole.clips[0].frames[f], 1e-4);  // no bone stretches
    }
  }
}

TEST(Keypoints, WhatIsWrongIsOneLine) {
  const std::vector<std::vector<Point3>> rows = rows_of(keypoints_of(amass()), 24);
  const auto line = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_EQ(line([&] { KeypointsStream("h36m", rows); }),
            "keypoints: unknown layout 'h36m', expected one of smpl24, humanml3d22, lafan22, smplh52, smplx55, "
            "coco17, h36m17, h36m32, kinect25, openpose25, mediapipe33");
  EXPECT_EQ(line([&] { KeypointsStream("smpl24", {}); }),
            "keypoints: expected frames of a moving person, a second or two, found none");
  EXPECT_EQ(line([&] { KeypointsStream("coco17", rows); }), "keypoints: expected 17 keypoints as coco17 has, found 24");
  const KeypointsStream stream("smpl24", rows);
  std::vector<Point3> row = rows[0];
  row[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(line([&] { (void)stream.next(row); }), "keypoints: number 3 is not finite");
}

TEST(Numpy, KeypointsMayStandAlongAnyAxisAndBeMirrored) {
  const Motion from = amass();
  const Motion z_up = read("z.npy",
                           npy_of(shape_of({kFrames, 24, 3}), keypoints_of(from,
                                                                           [](const Point3& p) {
                                                                             return Point3{p[0], -p[2], p[1]};
                                                                           })),
                           "smpl24");
  expect_same_keypoints(z_up, from, 1e-5);
  EXPECT_TRUE(has_note(z_up, "upright along z"));
  EXPECT_FALSE(has_note(z_up, "assumed; choose another with --layout")) << "it was said";
  const Motion down = read("d.npy", npy_of(shape_of({kFrames, 24, 3}), keypoints_of(from, [](const Point3& p) {
                                             return Point3{p[0], -p[1], -p[2]};
                                           })));
  expect_same_keypoints(down, from, 1e-5);
  const Motion mirrored = read("m.npy", npy_of(shape_of({kFrames, 24, 3}), keypoints_of(from, [](const Point3& p) {
                                                 return Point3{p[0], p[1], -p[2]};
                                               })));
  expect_same_keypoints(mirrored, from, 1e-5);
  EXPECT_TRUE(has_note(mirrored, "left-handed"));
}

TEST(Numpy, LayoutsOfCamerasHaveMiddles) {
  const Motion from = amass();
  std::vector<float> coco;
  for (const MotionFrame& frame : from.clips[0].frames) {
    const WorldPose pose = world_pose(from, frame);
    const size_t head = joint_of(from, "head");
    const auto at_head = [&](double x, double y, double z) {
      return pose.positions[head] + rotate(pose.rotations[head], {x, y, z});
    };
    std::vector<Point3> row = {at_head(0, 0.05, 0.1), at_head(0.03, 0.08, 0.08), at_head(-0.03, 0.08, 0.08),
                               at_head(0.08, 0.05, 0), at_head(-0.08, 0.05, 0)};
    for (const char* joint : {"UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot"})
      for (const char* side : {"left", "right"})
        row.push_back(pose.positions[joint_of(from, side + std::string(joint))]);
    for (const Point3& p : row)
      for (const double x : p) coco.push_back(static_cast<float>(x - 0.1));
  }
  const Motion found = read("c.npz", zip_of({{"keypoints.npy", npy_of(shape_of({kFrames, 17, 3}), coco)}}));
  EXPECT_EQ(found.joints[0].name, "hips");
  for (size_t f = 0; f < kFrames; ++f) {
    const WorldPose a = world_pose(found, found.clips[0].frames[f]), b = world_pose(from, from.clips[0].frames[f]);
    const size_t head = joint_of(found, "head");
    EXPECT_GT(std::abs(dot(a.rotations[head], b.rotations[joint_of(from, "head")])), std::cos(0.2));
    for (const char* joint : {"leftHand", "rightFoot", "leftLowerLeg", "rightLowerArm"})
      EXPECT_LT(
          length(a.positions[joint_of(found, joint)] + Point3{0.1, 0.1, 0.1} - b.positions[joint_of(from, joint)]),
          0.03)
          << joint;
  }
}

// Human3.6M: z up, millimeters. Both layouts of 17 joints are told apart by what is a body.
TEST(Numpy, LayoutsOfOneCountAreToldApartByTheBody) {
  const Motion from = amass();
  std::vector<float> h36m;
  for (const MotionFrame& frame : from.clips[0].frames) {
    const WorldPose pose = world_pose(from, frame);
    const auto at = [&](const char* joint) { return pose.positions[joint_of(from, joint)]; };
    const size_t head = joint_of(from, "head");
    std::vector<Point3> row = {at("hips"),      at("rightUpperLeg"), at("rightLowerLeg"),
                               at("rightFoot"), at("leftUpperLeg"),  at("leftLowerLeg"),
                               at("leftFoot"),  at("spine"),         0.5 * (at("leftUpperArm") + at("rightUpperArm"))};
    for (const Point3& in_head : {Point3{0, 0.03, 0.11}, Point3{0, 0.17, 0}})
      row.push_back(pose.positions[head] + rotate(pose.rotations[head], in_head));
    for (const char* joint :
         {"leftUpperArm", "leftLowerArm", "leftHand", "rightUpperArm", "rightLowerArm", "rightHand"})
      row.push_back(at(joint));
    for (const Point3& p : row)
      for (const double x : {p[0], -p[2], p[1]}) h36m.push_back(static_cast<float>(1000 * x));
  }
  const Motion found = read("h.npy", npy_of(shape_of({kFrames, 17, 3}), h36m));
  EXPECT_TRUE(has_note(found, "the layout h36m17 was assumed"));
  EXPECT_TRUE(has_note(found, "upright along z"));
  for (size_t f = 0; f < kFrames; ++f) {
    const WorldPose a = world_pose(found, found.clips[0].frames[f]), b = world_pose(from, from.clips[0].frames[f]);
    for (const char* joint : {"leftHand", "rightFoot", "leftLowerLeg", "rightLowerArm", "spine"})
      EXPECT_LT(length(0.001 * a.positions[joint_of(found, joint)] - b.positions[joint_of(from, joint)]), 0.03)
          << joint;
    EXPECT_GT(std::abs(dot(a.rotations[joint_of(found, "head")], b.rotations[joint_of(from, "head")])), std::cos(0.2));
  }
  for (size_t i = 0; i < h36m.size(); i += 3) std::swap(h36m[i], h36m[(i * 7 + 30) % h36m.size() / 3 * 3]);
  EXPECT_ERROR(read("h.npy", npy_of(shape_of({kFrames, 17, 3}), h36m)),
               "h.npy: expected 17 keypoints that fit one known layout", "misfits of coco17 ", ", h36m17 ",
               "choose one with --layout NAME");
  EXPECT_EQ(read("h.npy", npy_of(shape_of({kFrames, 17, 3}), h36m), "h36m17").joints.size(), 18u) << "it was said";
}

// A walk's keypoints in each layout are no body in the others of its count.
TEST(Keypoints, EveryLayoutIsKnownByItsBody) {
  const Motion from = amass();
  for (const KeypointsLayout& layout : keypoint_layouts()) {
    const LayoutColumns columns(layout);
    std::vector<MotionJoint> person = person_joints(columns.names);
    std::vector<std::vector<Point3>> rows;
    for (size_t f = 0; f < kFrames; ++f) {
      Motion posed = {"", person, {}, {}};
      MotionFrame frame;
      for (const MotionJoint& joint : person) {
        const int source = joint_named(from.joints, joint.name);
        frame.rotations.push_back(source < 0 ? kNoRotation4
                                             : from.clips[0].frames[f].rotations[static_cast<size_t>(source)]);
        frame.translations.push_back(joint.parent < 0 ? from.clips[0].frames[f].translations[0] : joint.offset);
      }
      const std::vector<Point3> at = world_pose(posed, frame).positions;
      std::vector<Point3>& row = rows.emplace_back(layout.count, at[0]);
      for (const bool alone : {false, true})
        for (size_t j = 0; j < at.size(); ++j)
          for (const size_t column : columns.of[j])
            if ((columns.of[j].size() == 1) == alone) row[column] = at[j];
    }
    std::string misfits;
    for (const double noise : {0.0, 0.03}) {  // of a camera, m
      double number = 0;
      for (std::vector<Point3>& row : rows)
        for (Point3& p : row)
          for (double& x : p) x += noise * std::sin(100 * ++number);
      const KeypointsLayout* const found = recognize_layout(rows, &misfits);
      ASSERT_NE(found, nullptr) << layout.name << " " << misfits;
      EXPECT_STREQ(found->name, layout.name) << misfits;
    }
  }
}

// Captures mark what they did not see.
TEST(Numpy, OnlyArraysThatAreReadMustBeFinite) {
  const std::vector<float> unseen(kFrames * 6, NAN);
  const Motion motion = read("walk.npz", zip_of({{"poses.npy", npy_of(shape_of({kFrames, 72}), bent_body(24))},
                                                 {"trans.npy", npy_of(shape_of({kFrames, 3}), path())},
                                                 {"marker_data.npy", npy_of(shape_of({kFrames, 2, 3}), unseen)}}));
  EXPECT_EQ(motion.clips[0].frames.size(), kFrames);
  EXPECT_ERROR(
      read("walk.npz", zip_of({{"poses.npy", npy_of(shape_of({kFrames, 72}), bent_body(24))},
                               {"trans.npy", npy_of(shape_of({kFrames, 3}), std::vector<float>(kFrames * 3, NAN))}})),
      "walk.npz: 'trans': expected finite numbers, found another at 0");
}

TEST(Numpy, ReadsTheNamesOfAist) {
  std::vector<double> far = path();
  for (double& x : far) x *= 90;
  const Motion motion = read("dance.npz", zip_of({{"smpl_poses.npy", npy_of(shape_of({kFrames, 72}), bent_body(24))},
                                                  {"smpl_trans.npy", npy_of(shape_of({kFrames, 3}), far)},
                                                  {"smpl_scaling.npy", npy_of("(1,)", std::vector<double>{90})}}));
  EXPECT_NEAR(motion.clips[0].frames[4].translations[0][0], 0.4, 1e-9);
  EXPECT_DOUBLE_EQ(motion.clips[0].frame_time, 1.0 / 60);
}

// Joints of a skeleton that turn, each at its own pace, as a file with positions and rotations in the world.
std::string posed_file(const std::vector<int>& parents, std::vector<float>* places = nullptr) {
  std::vector<float> positions, rotations;
  for (size_t f = 0; f < kFrames; ++f) {
    std::vector<Point3> at;
    std::vector<Quaternion> turned;
    for (size_t j = 0; j < parents.size(); ++j) {
      const double t = static_cast<double>(f), number = static_cast<double>(j);
      const Quaternion own = axis_rotation(j % 3, 0.1 * t * std::sin(1 + number));
      if (parents[j] < 0) {
        at.push_back({0.1 * t, 1, 0});
        turned.push_back(own);
      } else {
        const size_t parent = static_cast<size_t>(parents[j]);
        at.push_back(at[parent] + rotate(turned[parent], {0.1 * std::sin(number), 0.2, 0.1 * std::cos(number)}));
        turned.push_back(multiply(turned[parent], own));
      }
      for (const double x : at.back()) positions.push_back(static_cast<float>(x));
      for (const double x : rotation_of(turned.back())) rotations.push_back(static_cast<float>(x));
    }
  }
  if (places != nullptr) *places = positions;
  return zip_of({{"posed_joints.npy", npy_of(shape_of({kFrames, parents.size(), 3}), positions)},
                 {"global_rot_mats.npy", npy_of(shape_of({kFrames, parents.size(), 3, 3}), rotations)}});
}

TEST(Numpy, JointsWithRotationsAreKnownByWhatCarriesThem) {
  for (const NamedSkeleton& skeleton : named_skeletons()) {
    std::vector<float> places;
    const Motion motion = read("k.npz", posed_file(skeleton.parents, &places));
    ASSERT_EQ(motion.joints.size(), skeleton.joints.size());
    EXPECT_TRUE(has_note(motion, skeleton.name));
    for (size_t j = 0; j < skeleton.joints.size(); ++j) {
      EXPECT_EQ(motion.joints[j].name, skeleton.joints[j]);
      EXPECT_EQ(motion.joints[j].parent, skeleton.parents[j]);
    }
    for (size_t f = 0; f < kFrames; ++f) {
      const WorldPose pose = world_pose(motion, motion.clips[0].frames[f]);
      for (size_t j = 0; j < skeleton.joints.size(); ++j)
        for (size_t i = 0; i < 3; ++i)
          EXPECT_NEAR(pose.positions[j][i], double{places[3 * (f * skeleton.joints.size() + j) + i]}, 1e-5);
    }
  }
}

TEST(Numpy, ParentsOfAnUnknownSkeletonAreGuessedAndTold) {
  const std::vector<int> parents = {-1, 0, 1, 1, 3, 0, 5};
  const Motion motion = read("k.npz", posed_file(parents));
  EXPECT_TRUE(has_note(motion, "parents were guessed"));
  for (size_t j = 0; j < parents.size(); ++j) EXPECT_EQ(motion.joints[j].parent, parents[j]) << j;
  std::vector<float> places, turns(kFrames * 7 * 9);
  posed_file(parents, &places);
  for (size_t i = 0; i < turns.size(); i += 4) turns[i] = 1;  // not those of these joints
  for (size_t i = 0; i < places.size(); i += 5) places[i] += 0.1f * static_cast<float>(i % 7);
  EXPECT_ERROR(read("k.npz", zip_of({{"posed_joints.npy", npy_of(shape_of({kFrames, 7, 3}), places)},
                                     {"global_rot_mats.npy", npy_of(shape_of({kFrames, 7, 3, 3}), turns)}})),
               "k.npz: expected rotations that move the joints, found joint ");
}

// HumanML3D features of the same body: half the turn about y and the step in the axes of the next frame, height, positions in the frame's axes.
TEST(Numpy, FeaturesOfHumanMl3dBecomeKeypoints) {
  const Motion from = read("a.npz", zip_of({{"poses.npy", npy_of(shape_of({kFrames, 66}), bent_body(22))},
                                            {"trans.npy", npy_of(shape_of({kFrames, 3}), path())}}));
  std::vector<std::vector<Point3>> at;
  for (const MotionFrame& frame : from.clips[0].frames) at.push_back(world_pose(from, frame).positions);
  const auto half_turn = [](size_t f) { return 0.15 * static_cast<double>(f); };
  std::vector<float> features(kFrames * 263, 0);
  for (size_t f = 0; f < kFrames; ++f) {
    const Quaternion own = axis_rotation(1, 2 * half_turn(f));
    float* const row = &features[263 * f];
    if (f + 1 < kFrames) {
      row[0] = static_cast<float>(half_turn(f + 1) - half_turn(f));
      const Point3 step = rotate(axis_rotation(1, 2 * half_turn(f + 1)), at[f + 1][0] - at[f][0]);
      row[1] = static_cast<float>(step[0]);
      row[2] = static_cast<float>(step[2]);
    }
    row[3] = static_cast<float>(at[f][0][1]);
    for (size_t j = 1; j < 22; ++j) {
      const Point3 p = rotate(own, at[f][j] - Point3{at[f][0][0], 0, at[f][0][2]});
      for (size_t i = 0; i < 3; ++i) row[4 + 3 * (j - 1) + i] = static_cast<float>(p[i]);
    }
  }
  const Motion found = read("f.npy", npy_of(shape_of({kFrames, 263}), features));
  EXPECT_TRUE(has_note(found, "HumanML3D features"));
  EXPECT_DOUBLE_EQ(found.clips[0].frame_time, 1.0 / 20);
  for (size_t f = 0; f < kFrames; ++f) {
    const WorldPose pose = world_pose(found, found.clips[0].frames[f]);
    for (size_t j = 0; j < found.joints.size(); ++j)
      EXPECT_LT(
          length(pose.positions[j] + Point3{at[0][0][0], 0, at[0][0][2]} - at[f][joint_of(from, found.joints[j].name)]),
          1e-4)
          << f << " " << found.joints[j].name;
  }
  EXPECT_ERROR(read("f.npy", npy_of(shape_of({kFrames, 263}), std::vector<float>(kFrames * 263, 0.5f))), "f.npy",
               "expected 22 keypoints that fit");
}

TEST(Numpy, KeypointsRelativeToTheHipsStandOnTheFloor) {
  Motion from = amass();
  for (MotionFrame& frame : from.clips[0].frames) frame.translations[0] = {};
  const Motion found = read("r.npy", npy_of(shape_of({kFrames, 24, 3}), keypoints_of(from)));
  EXPECT_TRUE(has_note(found, "on the floor"));
  for (const MotionFrame& frame : found.clips[0].frames) {
    double low = 1e9;
    for (const Point3& p : world_pose(found, frame).positions) low = std::min(low, p[1]);
    EXPECT_NEAR(low, 0, 1e-5);
  }
}

TEST(Numpy, IsASkeletonToo) {
  const TempFolder folder;
  Character character;
  read_skeleton(folder.write("p.npy", npy_of(shape_of({kFrames, 24, 3}), keypoints_of(amass()))), false, &character);
  EXPECT_EQ(character.joints.size(), 24u);
  EXPECT_ERROR(read_skeleton(folder.file("p.npy"), true, &character), "p.npy", "expected skin weights, found a NumPy");
}

TEST(Numpy, WhatIsWrongIsOneLine) {
  const auto fails = [](const std::string& name, const std::string& bytes, const std::string& expected,
                        const std::string& layout = "") { EXPECT_ERROR(read(name, bytes, layout), name, expected); };
  fails("a.npy", "", "expected a NumPy array");
  fails("a.npy", npy_of("|O", "(2, 24, 3)", "....."), "pickled objects");
  fails("a.npy", npy_of(shape_of({2, 24, 3}), std::vector<float>(10)),
        "truncated array, expected 144 numbers, found 10");
  fails("a.npy", npy_of(shape_of({2, 24, 3}), std::vector<float>(144, NAN)),
        "expected finite numbers, found another at 0");
  fails("a.npy", npy_of("<f4", "(99999999999, 99999999999, 3)", ""), "expected at most");
  fails("a.npy", npy_of("<f4", "2, 3", ""), "expected a 'shape' such as (3, 4)");
  fails("a.npy", npy_of("<f4", "(2, -3)", ""), "expected a 'shape' such as (3, 4)");
  fails("a.npy", npy_of(shape_of({2, 23, 3}), std::vector<float>(138)), "kinect25, openpose25, mediapipe33), found 23");
  fails("a.npy", npy_of(shape_of({2, 24, 3}), std::vector<float>(144)),
        "expected a layout (smpl24, humanml3d22, lafan22, smplh52, smplx55, coco17, h36m17, h36m32, kinect25, "
        "openpose25, mediapipe33), found 'h36m'",
        "h36m");
  fails("a.npy", npy_of(shape_of({2, 24, 3}), std::vector<float>(144)), "expected 17 joints of coco17, found 24",
        "coco17");
  fails("a.npy", npy_of(shape_of({0, 24, 3}), std::vector<float>()), "frames, found 0");
  fails("a.npy", npy_of(shape_of({7}), std::vector<float>(7)), "or keypoints [frames, joints, 3], found [7]");
  fails("a.npz", "PK", "expected a zip with its directory");
  fails("a.npz", zip_of({}), "found no numbers");
  std::string shrunk = zip_of({{"a.npy", npy_of("(1)", std::vector<float>{1})}});
  shrunk[shrunk.rfind("PK\1\2") + 10] = 5;
  fails("a.npz", shrunk, "expected files that are stored or deflated, found method 5");
  fails("a.npz", zip_of({{"poses.npy", npy_of(shape_of({2, 71}), std::vector<float>(142))}}),
        "expected rotations of 22");
  fails("a.npz", zip_of({{"global_orient.npy", npy_of(shape_of({2, 3}), std::vector<float>(6))}}),
        "expected 'body_pose'");
  fails("a.npz",
        zip_of({{"poses.npy", npy_of(shape_of({2, 72}), std::vector<float>(144))},
                {"trans.npy", npy_of(shape_of({3, 3}), std::vector<float>(9))}}),
        "'trans' of 3 numbers per frame");
  fails("a.npz",
        zip_of({{"poses.npy", npy_of(shape_of({2, 72}), std::vector<float>(144))},
                {"fps.npy", npy_of("()", std::vector<float>{0})}}),
        "a frame rate, found 0");
}

TEST(Numpy, EveryTruncationAndChangedByteIsRefusedOrRead) {
  const TempFolder folder;
  for (const bool deflated : {false, true}) {
    const std::string whole = zip_of({{"poses.npy", npy_of(shape_of({1, 72}), std::vector<float>(72))}}, deflated);
    for (size_t i = 0; i < 2 * whole.size(); i += 5) {
      std::string bytes = i < whole.size() ? whole.substr(0, i) : whole;
      if (i >= whole.size()) bytes[i - whole.size()] = static_cast<char>(bytes[i - whole.size()] ^ 0x5a);
      try {
        EXPECT_EQ(read_motion(folder.write("a.npz", bytes)).clips.size(), 1u);
      } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
    }
  }
}

}  // namespace
}  // namespace sinew
