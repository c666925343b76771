// SPDX-License-Identifier: MIT
#include "sinew_character/pose/rest_pose.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "expect_error.hpp"
#include "sinew_formats/io.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

struct JointRow {
  const char* name;
  const char* parent;
  Vec3 at;
};

// Arms hang forward and down, the left knee is bent, the left foot points outwards; faces +z, left is +x.
const std::vector<JointRow> kSlouched = {
    {"Hips", "", {0, 1, 0}},
    {"Spine", "Hips", {0, 1.2f, 0}},
    {"Neck", "Spine", {0, 1.5f, 0}},
    {"Head", "Neck", {0, 1.6f, 0}},
    {"LeftArm", "Spine", {0.2f, 1.45f, 0}},
    {"LeftForeArm", "LeftArm", {0.3f, 1.2f, 0.1f}},
    {"LeftHand", "LeftForeArm", {0.3f, 1.0f, 0.3f}},
    {"RightArm", "Spine", {-0.2f, 1.45f, 0}},
    {"RightForeArm", "RightArm", {-0.25f, 1.18f, 0}},
    {"RightHand", "RightForeArm", {-0.25f, 0.9f, 0}},
    {"LeftUpLeg", "Hips", {0.1f, 0.95f, 0}},
    {"LeftLeg", "LeftUpLeg", {0.1f, 0.6f, 0.2f}},
    {"LeftFoot", "LeftLeg", {0.1f, 0.2f, 0}},
    {"LeftToeBase", "LeftFoot", {0.22f, 0.15f, 0.05f}},
    {"RightUpLeg", "Hips", {-0.1f, 0.95f, 0}},
    {"RightLeg", "RightUpLeg", {-0.1f, 0.52f, 0}},
    {"RightFoot", "RightLeg", {-0.1f, 0.08f, 0}},
    {"RightToeBase", "RightFoot", {-0.1f, 0.03f, 0.13f}},
};

std::vector<Joint> joints_of(const std::vector<JointRow>& rows) {
  std::vector<Joint> joints;
  for (const JointRow& row : rows) {
    int parent = -1;
    for (size_t j = 0; j < joints.size(); ++j)
      if (joints[j].name == row.parent) parent = static_cast<int>(j);
    joints.push_back({row.name, row.at, parent});
  }
  return joints;
}

// A small tetrahedron around every joint, bound to it.
Character figure(const std::vector<JointRow>& rows) {
  Character character;
  character.name = "figure";
  character.joints = joints_of(rows);
  for (uint32_t j = 0; j < character.joints.size(); ++j) {
    const Vec3 p = character.joints[j].position;
    const uint32_t first = static_cast<uint32_t>(character.vertices.size());
    for (const Vec3 d : {Vec3{0.02f, 0, 0}, Vec3{-0.02f, 0, 0.01f}, Vec3{0, 0.02f, 0}, Vec3{0, -0.02f, 0.02f}}) {
      character.vertices.push_back({p.x + d.x, p.y + d.y, p.z + d.z});
      character.influences.push_back({{j, 1.0f}});
    }
    constexpr std::array<std::array<uint32_t, 3>, 4> kFaces = {{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    for (const auto& face : kFaces) {
      for (const uint32_t corner : face) character.face_vertices.push_back(first + corner);
      character.face_offsets.push_back(static_cast<uint32_t>(character.face_vertices.size()));
    }
  }
  return character;
}

Vec3 position_of(const Character& character, const std::string& name) {
  for (const Joint& joint : character.joints)
    if (joint.name == name) return joint.position;
  ADD_FAILURE() << name;
  return {};
}

std::array<double, 3> bone(const Character& character, const std::string& from, const std::string& to) {
  const Vec3 a = position_of(character, from), b = position_of(character, to);
  const double x = static_cast<double>(b.x - a.x), y = static_cast<double>(b.y - a.y),
               z = static_cast<double>(b.z - a.z);
  const double size = std::sqrt(x * x + y * y + z * z);
  return {x / size, y / size, z / size};
}

void expect_bone(const Character& character, const std::string& from, const std::string& to,
                 const std::array<double, 3>& wanted) {
  const auto found = bone(character, from, to);
  for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], wanted[c], 1e-4) << from << " to " << to << ", component " << c;
}

double length_of(const Character& character, const std::string& from, const std::string& to) {
  const Vec3 a = position_of(character, from), b = position_of(character, to);
  return std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y), static_cast<double>(b.z - a.z));
}

RestPose pose_of(RestPose::Kind kind) {
  RestPose pose;
  pose.kind = kind;
  pose.name = kind == RestPose::Kind::kT ? "t" : "a";
  return pose;
}

TEST(RestPose, TStretchesArmsAndLegsAndTurnsFeetAhead) {
  const Character rest = figure(kSlouched);
  const Character posed = in_rest_pose(rest, pose_of(RestPose::Kind::kT), Axis::kY);
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "Left" : "Right";
    expect_bone(posed, name + "Arm", name + "ForeArm", {side, 0, 0});
    expect_bone(posed, name + "ForeArm", name + "Hand", {side, 0, 0});
    expect_bone(posed, name + "UpLeg", name + "Leg", {0, -1, 0});
    expect_bone(posed, name + "Leg", name + "Foot", {0, -1, 0});
    EXPECT_NEAR(bone(posed, name + "Foot", name + "ToeBase")[0], 0, 1e-4);
    EXPECT_GT(bone(posed, name + "Foot", name + "ToeBase")[2], 0.3);
    EXPECT_NEAR(length_of(posed, name + "Arm", name + "ForeArm"), length_of(rest, name + "Arm", name + "ForeArm"),
                1e-5);
  }
}

TEST(RestPose, ALowersTheArms) {
  const Character posed = in_rest_pose(figure(kSlouched), pose_of(RestPose::Kind::kA), Axis::kY);
  const double half = std::sqrt(0.5);
  expect_bone(posed, "LeftArm", "LeftForeArm", {half, -half, 0});
  expect_bone(posed, "RightForeArm", "RightHand", {-half, -half, 0});
}

TEST(RestPose, MeshFollowsItsJointsAndStaysOnTheFloor) {
  const Character rest = figure(kSlouched);
  const Character posed = in_rest_pose(rest, pose_of(RestPose::Kind::kT), Axis::kY);
  float low = 9, before = 9;
  for (size_t v = 0; v < rest.vertices.size(); ++v) {
    low = std::min(low, posed.vertices[v].y);
    before = std::min(before, rest.vertices[v].y);
    const Vec3 joint = posed.joints[rest.influences[v][0].joint].position, p = posed.vertices[v];
    EXPECT_LT(std::hypot(p.x - joint.x, p.y - joint.y, p.z - joint.z), 0.04f) << v;
  }
  EXPECT_NEAR(low, before, 1e-5f);
  EXPECT_EQ(posed.influences.size(), rest.influences.size());
}

TEST(RestPose, ALeaningTrunkIsPutUpright) {
  std::vector<JointRow> leaning = kSlouched;
  for (JointRow& row : leaning)
    if (row.at.y > 1.1f) row.at.z += 0.5f * (row.at.y - 1);
  const Character posed = in_rest_pose(figure(leaning), pose_of(RestPose::Kind::kT), Axis::kY);
  expect_bone(posed, "Hips", "Neck", {0, 1, 0});
  expect_bone(posed, "LeftArm", "LeftForeArm", {1, 0, 0});
}

TEST(RestPose, StandsAsAnotherFileDoes) {
  const TempFolder folder;
  const std::string file = folder.file("stands.rig.txt");
  Character other = figure(kSlouched);
  for (Joint& joint : other.joints) {  // twice the size, turned to face +x
    const Vec3 p = joint.position;
    joint.position = {2 * p.z, 2 * p.y, -2 * p.x};
  }
  write_rig(file, other);
  const Character t = in_rest_pose(figure(kSlouched), pose_of(RestPose::Kind::kT), Axis::kY);
  const Character back = in_rest_pose(t, read_rest_pose(file), Axis::kY);
  const Character slouched = figure(kSlouched);
  for (const auto& [from, to] : {std::pair{"LeftArm", "LeftForeArm"},
                                 {"LeftForeArm", "LeftHand"},
                                 {"RightLeg", "RightFoot"},
                                 {"LeftUpLeg", "LeftLeg"}}) {
    const auto wanted = bone(slouched, from, to);
    expect_bone(back, from, to, wanted);
  }
}

TEST(RestPose, RefusesWhatItCannotTell) {
  std::vector<JointRow> crawling = kSlouched;
  for (JointRow& row : crawling) std::swap(row.at.y, row.at.z);
  EXPECT_ERROR(in_rest_pose(figure(crawling), pose_of(RestPose::Kind::kT), Axis::kY), "figure",
               "needs an upright character");
  Character nameless = figure(kSlouched);
  for (size_t j = 0; j < nameless.joints.size(); ++j) nameless.joints[j].name = "joint" + std::to_string(j);
  EXPECT_ERROR(in_rest_pose(nameless, pose_of(RestPose::Kind::kT), Axis::kY), "figure", "left from right");
  EXPECT_ERROR(read_rest_pose("no_such_file.rig.txt"), "no_such_file.rig.txt");
}

TEST(RestPose, ADocumentOfGltfIsMovedToo) {
  const TempFolder folder;
  const std::string file = folder.file("bare.glb"), moved = folder.file("moved.glb");
  Character bare = figure(kSlouched);
  bare.joints.clear();
  bare.influences.clear();
  write_gltf(file, bare);
  Character rest = read_gltf(file);
  ASSERT_TRUE(rest.gltf);
  const Character again = figure(kSlouched);
  rest.joints = again.joints;
  for (const Vec3& v : rest.vertices) {
    uint32_t nearest = 0;
    const auto distance = [&](uint32_t j) {
      const Vec3& p = rest.joints[j].position;
      return std::hypot(p.x - v.x, p.y - v.y, p.z - v.z);
    };
    for (uint32_t j = 1; j < rest.joints.size(); ++j)
      if (distance(j) < distance(nearest)) nearest = j;
    rest.influences.push_back({{nearest, 1.0f}});
  }
  const Character posed = in_rest_pose(rest, pose_of(RestPose::Kind::kT), Axis::kY);
  write_gltf(moved, posed);
  const Character read = read_gltf(moved);
  ASSERT_EQ(read.vertices.size(), posed.vertices.size());
  for (size_t v = 0; v < read.vertices.size(); ++v) {
    EXPECT_NEAR(read.vertices[v].x, posed.vertices[v].x, 1e-5f);
    EXPECT_NEAR(read.vertices[v].y, posed.vertices[v].y, 1e-5f);
    EXPECT_NEAR(read.vertices[v].z, posed.vertices[v].z, 1e-5f);
  }
  EXPECT_NEAR(position_of(read, "LeftHand").y, position_of(posed, "LeftHand").y, 1e-5f);
}

// Joints of the file itself are moved, by their own names, with the matrices of its skin: what is read is what was posed.
TEST(RestPose, AFilesOwnJointsMoveWithTheMesh) {
  const TempFolder folder;
  const std::string file = folder.file("bound.glb"), moved = folder.file("moved.glb");
  write_gltf(file, figure(kSlouched));
  const Character rest = read_gltf(file);
  ASSERT_EQ(rest.joints.size(), kSlouched.size());
  const Character posed = in_rest_pose(rest, pose_of(RestPose::Kind::kT), Axis::kY);
  write_gltf(moved, posed);
  const Character read = read_gltf(moved);
  ASSERT_EQ(read.joints.size(), rest.joints.size());
  for (size_t j = 0; j < read.joints.size(); ++j) {
    EXPECT_EQ(read.joints[j].name, rest.joints[j].name);
    EXPECT_NEAR(read.joints[j].position.x, posed.joints[j].position.x, 1e-5f);
    EXPECT_NEAR(read.joints[j].position.y, posed.joints[j].position.y, 1e-5f);
    EXPECT_NEAR(read.joints[j].position.z, posed.joints[j].position.z, 1e-5f);
  }
  ASSERT_EQ(read.vertices.size(), posed.vertices.size());
  for (size_t v = 0; v < read.vertices.size(); ++v) {
    EXPECT_NEAR(read.vertices[v].x, posed.vertices[v].x, 1e-5f);
    EXPECT_NEAR(read.vertices[v].y, posed.vertices[v].y, 1e-5f);
    EXPECT_NEAR(read.vertices[v].z, posed.vertices[v].z, 1e-5f);
  }
  expect_bone(read, "LeftArm", "LeftForeArm", {1, 0, 0});
}

}  // namespace
}  // namespace sinew
