// SPDX-License-Identifier: MIT
// Machines of boxes and drums: wheels, a turret, doors, and what goes with them.
#include "sinew_character/predict/vehicle_skeleton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace sinew {
namespace {

// y up, +z front.
class Machine {
 public:
  Character mesh;

  uint32_t add_box(Vec3 low, Vec3 high) {
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    for (uint32_t i = 0; i < 8; ++i)
      mesh.vertices.push_back(
          {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z});
    const uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& q : quads) {
      add_face(first + q[0], first + q[1], first + q[2]);
      add_face(first + q[0], first + q[2], first + q[3]);
    }
    return first;
  }
  // About an axle across.
  uint32_t add_drum(Vec3 middle, float radius, float half_width, uint32_t sides = 12) {
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    for (const float side : {-half_width, half_width}) {
      for (uint32_t i = 0; i < sides; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(sides);
        mesh.vertices.push_back(
            {middle.x + side, middle.y + radius * std::sin(angle), middle.z + radius * std::cos(angle)});
      }
    }
    for (uint32_t i = 0; i < sides; ++i) {
      const uint32_t next = (i + 1) % sides;
      add_face(first + i, first + next, first + sides + next);
      add_face(first + i, first + sides + next, first + sides + i);
      if (i > 1) add_face(first, first + i, first + i - 1);
    }
    return first;
  }

 private:
  void add_face(uint32_t a, uint32_t b, uint32_t c) {
    mesh.face_vertices.insert(mesh.face_vertices.end(), {a, b, c});
    mesh.face_offsets.push_back(static_cast<uint32_t>(mesh.face_vertices.size()));
  }
};

Machine car() {
  Machine car;
  car.add_box({-.8f, .3f, -2}, {.8f, 1, 2});
  for (const float x : {.9f, -.9f})
    for (const float z : {1.2f, -1.2f}) car.add_drum({x, .35f, z}, .35f, .12f);
  return car;
}

std::map<std::string, Vec3> places(const PartSkeleton& skeleton) {
  std::map<std::string, Vec3> out;
  for (const Joint& joint : skeleton.joints) out[joint.name] = joint.position;
  return out;
}

TEST(VehicleSkeleton, WheelsTurnAboutTheirMiddles) {
  Machine machine = car();
  const uint32_t hub = machine.add_drum({1.05f, .35f, 1.2f}, .1f, .05f);
  const uint32_t crate = machine.add_box({-.2f, .1f, -.3f}, {.2f, .5f, .1f});  // as high as long, and square
  const PartSkeleton skeleton = vehicle_skeleton(machine.mesh, Axis::kY, std::array<float, 3>{0, 0, 1});
  ASSERT_EQ(skeleton.joints.size(), 5u);
  EXPECT_EQ(skeleton.joints[0].name, "Root");
  EXPECT_FLOAT_EQ(skeleton.joints[0].position.y, 0);
  std::map<std::string, Vec3> at = places(skeleton);
  EXPECT_NEAR(at["LeftFrontWheel"].x, .9f, 1e-5f);
  EXPECT_NEAR(at["LeftFrontWheel"].y, .35f, 1e-5f);
  EXPECT_NEAR(at["RightRearWheel"].z, -1.2f, 1e-5f);
  for (size_t j = 1; j < 5; ++j) EXPECT_EQ(skeleton.joints[j].parent, 0);
  EXPECT_EQ(skeleton.joint_of[0], 0u);
  EXPECT_EQ(skeleton.joint_of[crate], 0u) << "a box is no wheel";
  EXPECT_EQ(skeleton.joints[skeleton.joint_of[hub]].name, "LeftFrontWheel") << "what lies within goes with it";
  EXPECT_EQ(skeleton.joint_of.size(), machine.mesh.vertices.size());
}

TEST(VehicleSkeleton, WithoutAWordTheFrontIsAcrossTheAxles) {
  Machine machine = car();
  for (Vec3& v : machine.mesh.vertices) v = {v.z, v.y, -v.x};
  const PartSkeleton skeleton = vehicle_skeleton(machine.mesh, Axis::kY, std::nullopt);
  EXPECT_EQ(skeleton.joints.size(), 5u);
  EXPECT_EQ(skeleton.front, (std::array<float, 3>{1, 0, 0}));
  for (Vec3& v : machine.mesh.vertices) v = {v.x, -v.z, v.y};
  EXPECT_EQ(vehicle_skeleton(machine.mesh, Axis::kZ, std::nullopt).joints.size(), 5u) << "z up";
}

TEST(VehicleSkeleton, ATurretCarriesItsGunAndDoorsHangOnHinges) {
  Machine machine = car();
  const uint32_t turret = machine.add_box({-.4f, .98f, -.6f}, {.4f, 1.4f, .6f});
  const uint32_t gun = machine.add_box({-.05f, 1.15f, .5f}, {.05f, 1.25f, 2.4f});
  const uint32_t hatch = machine.add_box({-.1f, 1.39f, -.2f}, {.1f, 1.45f, .1f});
  const uint32_t door = machine.add_box({.8f, .4f, -.5f}, {.84f, .95f, .6f});
  const PartSkeleton skeleton = vehicle_skeleton(machine.mesh, Axis::kY, std::array<float, 3>{0, 0, 1});
  const auto joint = [&](uint32_t vertex) { return skeleton.joints[skeleton.joint_of[vertex]]; };
  EXPECT_EQ(joint(turret).name, "Turret");
  EXPECT_EQ(joint(hatch).name, "Turret");
  EXPECT_EQ(joint(gun).name, "Gun");
  EXPECT_EQ(skeleton.joints[static_cast<size_t>(joint(gun).parent)].name, "Turret");
  EXPECT_EQ(joint(door).name, "LeftDoor");
  EXPECT_NEAR(joint(door).position.z, .6f, 1e-5f) << "its front edge";
}

TEST(VehicleSkeleton, OfOnePieceThereIsARoot) {
  Machine machine;
  machine.add_box({-1, 0, -2}, {1, 1, 2});
  const PartSkeleton skeleton = vehicle_skeleton(machine.mesh, Axis::kY, std::nullopt);
  ASSERT_EQ(skeleton.joints.size(), 1u);
  EXPECT_EQ(skeleton.joint_of, std::vector<uint32_t>(8, 0));
}

}  // namespace
}  // namespace sinew
