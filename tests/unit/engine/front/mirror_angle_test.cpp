// SPDX-License-Identifier: MIT
// Upright mirror planes at any angle.
#include "front/mirror_angle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh_scene.hpp"

namespace {

using namespace sinew;
using namespace sinew::rigging;
using sinew_test::add_cube;
using sinew_test::MeshRun;
using sinew_test::MeshScene;

// A body with a head and legs, alike on both sides of x = 0 unless `lean` moves two legs, turned by an angle.
MeshScene animal(double radians, float lean = 0) {
  MeshScene scene;
  scene.add_joint(0, 0, 0, -1);
  add_cube(&scene, -0.5f, 1, -1);
  add_cube(&scene, -0.5f, 1, 0);
  add_cube(&scene, -0.4f, 1.6f, 1, 0.8f);
  for (const float z : {-1.0f, 0.6f}) {
    add_cube(&scene, -0.5f, 0, z, 0.3f);
    add_cube(&scene, 0.2f + lean, 0, z, 0.3f);
  }
  const auto c = static_cast<float>(std::cos(radians)), s = static_cast<float>(std::sin(radians));
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
    float* const p = &scene.positions[3 * v];
    const float x = p[0], z = p[2];
    p[0] = c * x + s * z;
    p[2] = c * z - s * x;
  }
  return scene;
}

struct Found {
  bool found = false;
  double degrees = 0;  // of the front, from +z towards +x, 0..180
};

Found plane_of(const MeshScene& scene, Heading expected) {
  const MeshRun run(scene);
  Heading normal = {0, 0};
  Found result;
  Arena measuring;
  EXPECT_TRUE(find_mirror_angle(run.mesh, 0, expected, measuring, &normal, &result.found));
  Workspace block(measuring.high_water());
  Arena arena(block.data(), measuring.high_water());
  EXPECT_TRUE(find_mirror_angle(run.mesh, 0, expected, arena, &normal, &result.found));
  EXPECT_EQ(arena.used(), 0u);
  result.degrees = std::atan2(static_cast<double>(-normal.z), static_cast<double>(normal.x)) * 180 / 3.14159265358979;
  if (result.degrees < -0.01) result.degrees += 180;
  return result;
}

TEST(MirrorAngle, IsFoundToAHundredthOfADegree) {
  constexpr int64_t kOne = 1 << 28;
  for (const double degrees : {0.0, 30.0, 45.0, 77.0, 90.0, 140.0}) {
    for (const Heading expected : {Heading{0, kOne}, Heading{kOne, 0}, Heading{0, 0}}) {
      const Found found = plane_of(animal(degrees * 3.14159265358979 / 180), expected);
      EXPECT_TRUE(found.found) << degrees;
      EXPECT_NEAR(found.degrees, degrees, 0.01);
    }
  }
}

TEST(MirrorAngle, OfAPosedMeshIsThatOfItsLargerPart) {
  constexpr int64_t kOne = 1 << 28;
  const Found found = plane_of(animal(0, 1.5f), {kOne / 4, kOne * 968 / 1000});
  EXPECT_TRUE(found.found);
  EXPECT_NEAR(std::remainder(found.degrees, 180.0), 0, 5);
}

TEST(MirrorAngle, IsNotFoundWhereThereIsNone) { EXPECT_FALSE(plane_of(animal(0.4, 1.5f), {0, 0}).found); }

}  // namespace
