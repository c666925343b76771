// SPDX-License-Identifier: MIT
// A stance is found whatever the rest pose says, and rest poses that are one are left alone.
#include "sinew_character/motion/stance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sinew_character/clips/builtin_motion.hpp"
#include "sinew_formats/base/point.hpp"
#include "walking_motion.hpp"

namespace sinew {
namespace {

Point3 rest_of(const std::vector<Joint>& joints, const std::string& name) {
  for (const Joint& joint : joints)
    if (joint.name == name) return {double{joint.position.x}, double{joint.position.y}, double{joint.position.z}};
  ADD_FAILURE() << name;
  return {};
}

// Mean distance of joints at rest, of lengths of about 1.7.
double mean_distance(const std::vector<Joint>& a, const std::vector<Joint>& b) {
  double sum = 0;
  for (size_t j = 0; j < a.size(); ++j)
    sum += std::hypot(a[j].position.x - b[j].position.x, a[j].position.y - b[j].position.y,
                      a[j].position.z - b[j].position.z);
  return sum / static_cast<double>(a.size());
}

void expect_same_motion(const Motion& a, const Motion& b) {
  for (size_t f = 0; f < a.clips[0].frames.size(); ++f) {
    const WorldPose x = world_pose(a, a.clips[0].frames[f]), y = world_pose(b, b.clips[0].frames[f]);
    for (size_t j = 0; j < a.joints.size(); ++j) ASSERT_LT(length(x.positions[j] - y.positions[j]), 1e-9) << f << j;
  }
}

TEST(Stance, ARestPoseThatIsOneStays) {
  const Motion walk = walking_person();
  EXPECT_FALSE(standing_motion(walk));
  EXPECT_FALSE(standing_motion(numbered(walk)));
  EXPECT_FALSE(standing_motion(turned_world(walk, axis_rotation(0, std::acos(0.0))))) << "z up";
  EXPECT_FALSE(standing_motion(turned_world(walk, axis_rotation(1, 2.4))));
  Motion still = walk;
  still.clips.clear();
  EXPECT_FALSE(standing_motion(with_random_axes(still)));
}

TEST(Stance, IsFoundInTheMotionWhateverTheRestPoseIs) {
  const Motion walk = walking_person();
  const std::vector<Motion> written = {with_random_axes(walk), with_random_axes(walk, 2), with_rest_of_frame(walk, 7),
                                       with_random_axes(numbered(walk))};
  for (size_t k = 0; k < written.size(); ++k) {
    const std::optional<Motion> found = standing_motion(written[k]);
    ASSERT_TRUE(found) << k;
    expect_same_motion(*found, walk);
    EXPECT_LT(mean_distance(rest_joints(*found), rest_joints(walk)), 0.04) << k;
    EXPECT_FALSE(standing_motion(*found)) << "it stands now";
  }
}

// Knees are never straight and the chest is never level with the hips, but feet are flat and shoulders are as wide as they are.
TEST(Stance, FeetAreFlatAndShouldersAcross) {
  Motion walk = walking_person();
  for (MotionFrame& frame : walk.clips[0].frames) {
    for (size_t j = 0; j < walk.joints.size(); ++j) {
      const std::string& name = walk.joints[j].name;
      if (name == "Chest") frame.rotations[j] = axis_rotation(1, 0.4);
      if (name == "LeftLeg" || name == "RightLeg") frame.rotations[j] = axis_rotation(0, 0.5);
    }
    const WorldPose pose = world_pose(walk, frame);
    for (size_t j = 0; j < walk.joints.size(); ++j) {
      const std::string& name = walk.joints[j].name;
      if (name == "LeftFoot" || name == "RightFoot")
        frame.rotations[j] = conjugate(pose.rotations[static_cast<size_t>(walk.joints[j].parent)]);
    }
  }
  const std::optional<Motion> found = standing_motion(with_random_axes(walk));
  ASSERT_TRUE(found);
  const std::vector<Joint> rest = rest_joints(*found);
  for (const std::string side : {"Left", "Right"})
    EXPECT_LT(length(rest_of(rest, side + "ToeBase") - rest_of(rest, side + "Foot") - Point3{0, -0.07, 0.13}), 0.02);
  const Point3 across = rest_of(rest, "LeftArm") - rest_of(rest, "RightArm");
  EXPECT_LT(std::hypot(across[1], across[2]), 0.01);
}

// Pitched this way and that, as a swimmer's: only where the toes are is known, and they are ahead.
TEST(Stance, AFootThatIsNeverFlatDoesNotTellWhatUpIs) {
  Motion swim = walking_person();
  size_t number = 0;
  for (MotionFrame& frame : swim.clips[0].frames) {
    const WorldPose pose = world_pose(swim, frame);
    const double pitch = number++ % 2 == 0 ? 1.75 : -0.35;
    for (size_t j = 0; j < swim.joints.size(); ++j) {
      const std::string& name = swim.joints[j].name;
      if (name != "LeftFoot" && name != "RightFoot") continue;
      const Quaternion above = conjugate(pose.rotations[static_cast<size_t>(swim.joints[j].parent)]);
      frame.rotations[j] = multiply(above, axis_rotation(0, pitch));
    }
  }
  const std::optional<Motion> found = standing_motion(with_random_axes(swim));
  ASSERT_TRUE(found);
  const std::vector<Joint> rest = rest_joints(*found);
  for (const std::string side : {"Left", "Right"}) {
    const Point3 toes = unit(rest_of(rest, side + "ToeBase") - rest_of(rest, side + "Foot"));
    EXPECT_GT(toes[2], 0.98) << side << " " << toes[0] << " " << toes[1] << " " << toes[2];
  }
}

// Curled in every frame: at rest fingers lie along the arm, thumbs halfway to the front.
TEST(Stance, FingersAreStretched) {
  Motion walk = walking_person();
  const auto add = [&](const std::string& name, const std::string& parent, const Point3& offset) {
    MotionJoint joint;
    joint.name = name;
    joint.offset = offset;
    for (size_t j = 0; j < walk.joints.size(); ++j)
      if (walk.joints[j].name == parent) joint.parent = static_cast<int>(j);
    walk.joints.push_back(joint);
    for (MotionFrame& frame : walk.clips[0].frames) {
      const bool curled = name.back() == '1' || name.back() == '2';
      frame.rotations.push_back(curled ? axis_rotation(2, name[0] == 'L' ? -0.6 : 0.6) : kNoRotation4);
      frame.translations.push_back(offset);
    }
  };
  for (const std::string side : {"Left", "Right"}) {
    const double sign = side == "Left" ? 1 : -1;
    add(side + "HandIndex1", side + "Hand", {0.08 * sign, 0, 0.01});
    add(side + "HandIndex2", side + "HandIndex1", {0.03 * sign, 0, 0});
    add(side + "HandIndex3", side + "HandIndex2", {0.02 * sign, 0, 0});
    add(side + "HandThumb1", side + "Hand", {0.02 * sign, 0, 0.02});
    add(side + "HandThumb2", side + "HandThumb1", {0.02 * sign, 0, 0.02});
  }
  const std::optional<Motion> found = standing_motion(with_random_axes(walk));
  ASSERT_TRUE(found);
  expect_same_motion(*found, walk);
  const std::vector<Joint> rest = rest_joints(*found);
  for (const std::string side : {"Left", "Right"}) {
    const double sign = side == "Left" ? 1 : -1, half = std::sqrt(0.5);
    for (const char* const part : {"2", "3"}) {
      const std::string before = part[0] == '2' ? "1" : "2";
      const Point3 bone = unit(rest_of(rest, side + "HandIndex" + part) - rest_of(rest, side + "HandIndex" + before));
      EXPECT_LT(length(bone - Point3{sign, 0, 0}), 0.01) << side << part;
    }
    const Point3 thumb = unit(rest_of(rest, side + "HandThumb2") - rest_of(rest, side + "HandThumb1"));
    EXPECT_LT(length(thumb - Point3{half * sign, 0, half}), 0.01) << side;
  }
}

TEST(Stance, IsInTheMotionsOwnWorld) {
  const Motion upright = turned_world(walking_person(), axis_rotation(0, std::acos(0.0)));  // y to z
  for (const Motion& written : {with_random_axes(upright), with_random_axes(numbered(upright))}) {
    std::optional<Motion> found = standing_motion(written);
    ASSERT_TRUE(found);
    for (size_t j = 0; j < upright.joints.size(); ++j) found->joints[j].name = upright.joints[j].name;
    const std::vector<Joint> rest = rest_joints(*found);
    EXPECT_GT(rest_of(rest, "Head")[2], 0.5);
    EXPECT_LT(rest_of(rest, "LeftFoot")[2], -0.7);
    EXPECT_GT(rest_of(rest, "LeftArm")[0], 0.1);
    EXPECT_LT(rest_of(rest, "LeftToeBase")[1], -0.05) << "ahead is -y";
  }
}

TEST(Stance, NamesSayLeftAndRight) {
  Motion mirrored = walking_person();
  for (MotionJoint& joint : mirrored.joints) {
    const bool left = joint.name.rfind("Left", 0) == 0, right = joint.name.rfind("Right", 0) == 0;
    if (left) joint.name = "Right" + joint.name.substr(4);
    if (right) joint.name = "Left" + joint.name.substr(5);
  }
  const std::optional<Motion> found = standing_motion(with_random_axes(mirrored));
  ASSERT_TRUE(found);
  EXPECT_GT(rest_of(rest_joints(*found), "LeftUpLeg")[0], 0.05);
}

Motion on_four_legs() {
  Motion animal = walking_person();
  const Quaternion down = axis_rotation(0, std::acos(0.0));
  for (MotionFrame& frame : animal.clips[0].frames)
    for (size_t j = 0; j < animal.joints.size(); ++j) {
      const std::string& name = animal.joints[j].name;
      const double side = name.rfind("Left", 0) == 0 ? 1 : -1;
      if (name == "Spine") frame.rotations[j] = down;
      if (name == "LeftUpLeg" || name == "RightUpLeg") frame.rotations[j] = axis_rotation(0, 0.1);
      if (name == "LeftArm" || name == "RightArm")  // down again, from the side
        frame.rotations[j] = multiply(axis_rotation(0, -std::acos(0.0)), axis_rotation(2, -side * std::acos(0.0)));
    }
  return animal;
}

// A body on four legs is never set upright: its stance is its typical pose, its legs below it.
TEST(Stance, WhatDoesNotGoUprightStandsAsItMostlyDoes) {
  const Motion animal = on_four_legs();
  for (const Motion& written : {with_random_axes(animal), with_bones_in_one_line(animal)}) {
    const std::optional<Motion> found = standing_motion(written);
    ASSERT_TRUE(found);
    expect_same_motion(*found, animal);
    const std::vector<Joint> rest = rest_joints(*found);
    EXPECT_LT(std::abs(unit(rest_of(rest, "Chest") - rest_of(rest, "Spine"))[1]), 0.5) << "it lies";
    for (const std::string name : {"LeftUpLeg", "RightUpLeg", "LeftArm", "RightArm"}) {
      const std::string end = name.find("Leg") != std::string::npos ? name.substr(0, name.size() - 5) + "Foot"
                                                                    : name.substr(0, name.size() - 3) + "Hand";
      EXPECT_GT(unit(rest_of(rest, name) - rest_of(rest, end))[1], 0.7) << name;
    }
    EXPECT_FALSE(standing_motion(*found)) << "it stands now";
  }
  EXPECT_FALSE(standing_motion(builtin_motions("builtin:quadruped/walk")[0])) << "its rest pose is one";
}

// Who leans all the time has an upright stance, and an arm is rolled as its elbow bends.
TEST(Stance, TheTrunkIsUprightAndElbowsBendToTheFrontAndUp) {
  Motion leaning = walking_person();
  for (MotionFrame& frame : leaning.clips[0].frames)
    for (size_t j = 0; j < leaning.joints.size(); ++j) {
      const std::string& name = leaning.joints[j].name;
      if (name == "Spine") frame.rotations[j] = axis_rotation(0, 0.35);
      if (name == "LeftArm") frame.rotations[j] = multiply(frame.rotations[j], axis_rotation(0, 0.6));  // rolled
    }
  const Motion written = with_random_axes(leaning);
  const std::optional<Motion> found = standing_motion(written);
  ASSERT_TRUE(found);
  const std::vector<Joint> rest = rest_joints(*found);
  const Point3 trunk = unit(rest_of(rest, "Chest") - rest_of(rest, "Spine"));
  EXPECT_GT(trunk[1], std::cos(0.02));
  const Clip& clip = found->clips[0];
  for (size_t j = 0; j < found->joints.size(); ++j)
    if (found->joints[j].name == "LeftForeArm") {
      // Against the stance a forearm turns towards the front, and by 20 degrees less towards up.
      const Quaternion& turn = clip.frames[10].rotations[j];
      const double sine = turn[3] < 0 ? -std::sin(0.175) : std::sin(0.175);
      EXPECT_LT(std::abs(turn[0]), 0.02);
      EXPECT_NEAR(turn[1], -sine * std::cos(0.349), 0.02);
      EXPECT_NEAR(turn[2], sine * std::sin(0.349), 0.02);
    }
}

// What is its own mirror image but for some hundredths of a leg is a pose of somebody who moves.
TEST(Stance, ARestPoseThatIsNotQuiteAMirrorImageIsNone) {
  Motion walk = walking_person();
  const auto asymmetric = [&](double angle) {
    return with_axes(walk, [&](size_t j) {
      const std::string& name = walk.joints[j].name;
      return name == "LeftUpLeg" || name == "LeftLeg" || name == "LeftFoot" ? axis_rotation(0, angle) : kNoRotation4;
    });
  };
  EXPECT_FALSE(standing_motion(asymmetric(0.15)));
  EXPECT_TRUE(standing_motion(asymmetric(0.28)));
}

}  // namespace
}  // namespace sinew
