// SPDX-License-Identifier: MIT
// Axes by the roll rule, against those that other programs' characters have.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "predict/turn.hpp"
#include "sinew_character/profile/profile.hpp"
#include "sinew_formats/base/point.hpp"
#include "walking_figure.hpp"

namespace sinew {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

double angle_between(const Rotation& a, const Rotation& b) {
  double trace = 0;
  for (size_t i = 0; i < 9; ++i) trace += a[i] * b[i];
  return std::acos(std::min(1.0, std::max(-1.0, (trace - 1) / 2))) / kDegree;
}

Point3 column(const Rotation& r, size_t c) { return {r[c], r[3 + c], r[6 + c]}; }

struct Posed {
  const char *name, *parent;
  double length;   // to the joint that comes next
  double x, y, z;  // Euler angles against the parent, degrees, x first: as Mixamo's characters stand in an FBX
};

// Rest rotations of a Mixamo character (github.com/DaveDubUK/walkTools). A joint stands at the end of its parent's y axis.
const std::vector<Posed> kMixamo = {{"Hips", "", 0.1, 0, 0, 0},
                                    {"Spine", "Hips", 0.1, -10.54, 0, 0},
                                    {"Spine1", "Spine", 0.1, 0, 0, 0},
                                    {"Spine2", "Spine1", 0.15, 0, 0, 0},
                                    {"Neck", "Spine2", 0.1, 10.54, 0, 0},
                                    {"Head", "Neck", 0.2, 0, 0, 0},
                                    {"LeftShoulder", "Spine2", 0.12, -74.5, 87.11, -179.04},
                                    {"LeftArm", "LeftShoulder", 0.27, -7.97, 0, 2.38},
                                    {"LeftForeArm", "LeftArm", 0.25, -8.57, 0, 3.82},
                                    {"LeftHand", "LeftForeArm", 0.1, 8.9, 5.37, -5.2},
                                    {"RightShoulder", "Spine2", 0.12, -74.43, -87.32, 179.01},
                                    {"RightArm", "RightShoulder", 0.27, -8.05, 0, -2.01},
                                    {"RightForeArm", "RightArm", 0.25, -8.5, 0, -4.17},
                                    {"RightHand", "RightForeArm", 0.1, 8.01, -4.89, 5.82},
                                    {"LeftUpLeg", "Hips", 0.42, 1.02, -0.02, -178.69},
                                    {"LeftLeg", "LeftUpLeg", 0.42, -7.68, 0, -0.9},
                                    {"LeftFoot", "LeftLeg", 0.15, 54.84, 9.08, 0},
                                    {"LeftToeBase", "LeftFoot", 0.08, 42.03, 1.26, 0},
                                    {"RightUpLeg", "Hips", 0.42, 1.36, 0.03, 178.69},
                                    {"RightLeg", "RightUpLeg", 0.42, -8.4, 0, 0.9},
                                    {"RightFoot", "RightLeg", 0.15, 55.41, -8.98, 0},
                                    {"RightToeBase", "RightFoot", 0.08, 41.83, -1.4, 0}};

TEST(JointAxes, AreThoseOfMixamosOwnCharacters) {
  std::vector<Joint> joints;
  std::vector<Rotation> real;
  for (const Posed& one : kMixamo) {
    int parent = -1;
    for (size_t j = 0; j < joints.size(); ++j)
      if (joints[j].name == std::string("mixamorig:") + one.parent) parent = static_cast<int>(j);
    const Rotation local =
        multiply(axis_rotation({0, 0, 1}, one.z * kDegree),
                 multiply(axis_rotation({0, 1, 0}, one.y * kDegree), axis_rotation({1, 0, 0}, one.x * kDegree)));
    Point3 at = {0, 1, 0};
    if (parent >= 0) {
      const size_t p = static_cast<size_t>(parent);
      real.push_back(multiply(real[p], local));
      // Where several hang on a joint the offset is the limb's, not the bone's.
      const std::string name = one.name;
      const bool limb = name.find("Shoulder") != std::string::npos || name.find("UpLeg") != std::string::npos;
      const double side = name.rfind("Left", 0) == 0 ? 1 : -1;
      at = point(joints[p].position) +
           (limb ? Point3{side * 0.08, name.find("UpLeg") != std::string::npos ? -0.05 : 0.1, 0}
                 : kMixamo[p].length * column(real[p], 1));
    } else {
      real.push_back(local);
    }
    joints.push_back({std::string("mixamorig:") + one.name,
                      {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])},
                      parent});
  }
  // Ends, as Mixamo has them, tell where the last bones point.
  for (const char* name : {"Head", "LeftHand", "RightHand", "LeftToeBase", "RightToeBase"})
    for (size_t j = 0; j < kMixamo.size(); ++j)
      if (kMixamo[j].name == std::string(name)) {
        const Point3 at = point(joints[j].position) + kMixamo[j].length * column(real[j], 1);
        joints.push_back({joints[j].name + "_End",
                          {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])},
                          static_cast<int>(j)});
      }
  const std::vector<Rotation> ours = joint_axes(joints, *profile_named("mixamo").axes);
  for (size_t j = 0; j < kMixamo.size(); ++j) EXPECT_LT(angle_between(ours[j], real[j]), 15) << joints[j].name;
}

TEST(JointAxes, OfEveryTableAreRightHandedAndHaveTheBoneAlongOne) {
  const std::vector<Joint> joints = walking_figure().joints;
  for (const Profile& profile : profiles()) {
    if (profile.axes == nullptr) continue;
    for (const Rotation& r : joint_axes(joints, *profile.axes)) {
      EXPECT_NEAR(dot(cross(column(r, 0), column(r, 1)), column(r, 2)), 1, 1e-9) << profile.name;
      for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(length(column(r, c)), 1, 1e-9);
    }
  }
  const auto axis_of = [&](const char* profile, const char* name, size_t c) {
    for (size_t j = 0; j < joints.size(); ++j)
      if (joints[j].name == name) return column(joint_axes(joints, *profile_named(profile).axes)[j], c);
    return Point3{};
  };
  EXPECT_NEAR(axis_of("mixamo", "LeftForeArm", 1)[0], 1, 1e-6);  // +y to the hand
  EXPECT_NEAR(axis_of("mixamo", "RightForeArm", 1)[0], -1, 1e-6);
  EXPECT_NEAR(axis_of("unreal", "LeftForeArm", 0)[0], 1, 1e-6);   // +x to the hand
  EXPECT_NEAR(axis_of("unreal", "RightForeArm", 0)[0], 1, 1e-6);  // mirrored: from the hand
  EXPECT_GT(axis_of("unreal", "LeftLeg", 0)[1], 0.99);            // mirrored the other way round on legs
  EXPECT_LT(axis_of("unreal", "RightLeg", 0)[1], -0.99);
  EXPECT_GT(axis_of("godot", "LeftUpLeg", 2)[2], 0.99);  // knees to the front
}

TEST(JointAxes, AreTheBodysWhereverItLies) {
  std::vector<Joint> joints = walking_figure().joints;
  EXPECT_EQ(body_axes(joints), kNoRotation);
  for (Joint& joint : joints)
    joint.position = {joint.position.x, -joint.position.z, joint.position.y};  // z up, front -y
  EXPECT_EQ(body_axes(joints), (Rotation{1, 0, 0, 0, 0, -1, 0, 1, 0}));
  for (Joint& joint : joints) joint.name = "bone";
  EXPECT_EQ(body_axes(joints), kNoRotation);  // nobody tells
}

TEST(ProfileNames, AreTheConventionsAndUnique) {
  std::vector<Joint> joints = walking_figure().joints;
  joints.push_back({"hand_l", {0, 0, 0}, 0});  // one that has another's name
  const auto named = [&](const char* profile, const char* own) {
    const std::vector<std::string> names = profile_names(joints, profile_named(profile).names);
    for (size_t j = 0; j < joints.size(); ++j)
      if (joints[j].name == own) return names[j];
    return std::string();
  };
  EXPECT_EQ(named("mixamo", "LeftForeArm"), "mixamorig:LeftForeArm");
  EXPECT_EQ(named("maya", "LeftForeArm"), "LeftForeArm");
  EXPECT_EQ(named("unreal", "Chest"), "spine_02");
  EXPECT_EQ(named("unreal", "RightUpLeg"), "thigh_r");
  EXPECT_EQ(named("blender", "LeftArm"), "upper_arm.L");
  EXPECT_EQ(named("godot", "LeftToeBase"), "LeftToes");
  EXPECT_EQ(named("unity", "Hips"), "Hips");
  EXPECT_EQ(named("vrm", "RightArm"), "rightUpperArm");
  EXPECT_EQ(named("three", "LeftArm"), "LeftArm");
  joints[0].name = "rig:Hips [1]";
  EXPECT_EQ(profile_names(joints, profile_named("three").names)[0], "rig_Hips__1_");
}

}  // namespace
}  // namespace sinew
