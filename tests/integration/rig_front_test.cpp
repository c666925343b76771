// SPDX-License-Identifier: MIT
// The same mesh facing elsewhere, or with another axis up: the same skeleton, there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "rig_scene.hpp"
#include "sample_mesh.hpp"

namespace {

using sinew_test::from_file;
using sinew_test::MeshScene;
using sinew_test::RiggedScene;

// About the upright axis, +z towards +x; then z up in place of y.
struct Orientation {
  double degrees = 0;
  bool z_up = false;

  void to(const float* p, float* out) const {
    const double a = degrees * 3.14159265358979 / 180, c = std::cos(a), s = std::sin(a);
    const auto x = static_cast<float>(c * static_cast<double>(p[0]) + s * static_cast<double>(p[2]));
    const auto z = static_cast<float>(c * static_cast<double>(p[2]) - s * static_cast<double>(p[0]));
    const float y = p[1];
    out[0] = x;
    out[1] = z_up ? -z : y;
    out[2] = z_up ? y : z;
  }
  MeshScene of(MeshScene scene) const {
    for (uint32_t v = 0; v < scene.vertex_count(); ++v) to(&scene.positions[3 * v], &scene.positions[3 * v]);
    return scene;
  }
};

void expect_same_joints(const RiggedScene& plain, const RiggedScene& other, const Orientation& orientation,
                        double most) {
  ASSERT_EQ(other.status, SINEW_OK);
  ASSERT_EQ(plain.names, other.names) << orientation.degrees;
  for (uint32_t j = 0; j < plain.count; ++j) {
    float wanted[3];
    orientation.to(&plain.positions[3 * j], wanted);
    double squared = 0;
    for (uint32_t axis = 0; axis < 3; ++axis) {
      const double d = static_cast<double>(wanted[axis] - other.positions[3 * j + axis]);
      squared += d * d;
    }
    EXPECT_LE(std::sqrt(squared), most) << plain.names[j] << " " << orientation.degrees
                                        << (orientation.z_up ? " z up" : "");
  }
}

double side_of(const MeshScene& scene) {
  float low[3] = {1e9f, 1e9f, 1e9f}, high[3] = {-1e9f, -1e9f, -1e9f};
  for (uint32_t i = 0; i < 3 * scene.vertex_count(); ++i) {
    low[i % 3] = std::min(low[i % 3], scene.positions[i]);
    high[i % 3] = std::max(high[i % 3], scene.positions[i]);
  }
  return static_cast<double>(std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}));
}

TEST(RigFront, AFrontThatIsGivenIsWhereTheSkeletonFaces) {
  const MeshScene scene = from_file("biped__robot.obj");
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.front = SINEW_FRONT_PLUS_Z;
  const RiggedScene plain(scene, options);
  plain.expect_sound();
  EXPECT_EQ(plain.outputs.front_confidence, 1);
  const struct {
    uint32_t front, up;
    Orientation orientation;
    float x, y, z;
  } cases[] = {{SINEW_FRONT_PLUS_X, SINEW_UP_Y, {90, false}, 1, 0, 0},
               {SINEW_FRONT_MINUS_Z, SINEW_UP_Y, {180, false}, 0, 0, -1},
               {SINEW_FRONT_MINUS_X, SINEW_UP_Z, {270, true}, -1, 0, 0},
               {SINEW_FRONT_MINUS_Y, SINEW_UP_Z, {0, true}, 0, -1, 0}};
  for (const auto& one : cases) {
    options.front = one.front;
    options.up = one.up;
    const RiggedScene other(one.orientation.of(scene), options);
    expect_same_joints(plain, other, one.orientation, 0.002 * side_of(scene));
    EXPECT_EQ(other.outputs.front[0], one.x);
    EXPECT_EQ(other.outputs.front[1], one.y);
    EXPECT_EQ(other.outputs.front[2], one.z);
    EXPECT_EQ(other.outputs.up, one.up);
  }
}

TEST(RigFront, AFrontAlongTheUpAxisIsRefused) {
  const MeshScene scene = from_file("snake__long.obj");
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.up = SINEW_UP_Z;
  options.front = SINEW_FRONT_PLUS_Z;
  EXPECT_EQ(RiggedScene(scene, options).status, SINEW_ERROR_ARGUMENT);
  options.front = 7;
  EXPECT_EQ(RiggedScene(scene, options).status, SINEW_ERROR_ARGUMENT);
  options = SINEW_INIT(sinew_rig_options);
  options.front_model = bundled_rig_model();
  EXPECT_EQ(RiggedScene(scene, options).status, SINEW_ERROR_MODEL_TASK) << "a model of bodies knows no fronts";
}

TEST(RigFront, IsFoundAtAnyAngleAndWithZUp) {
  const MeshScene scene = from_file("biped__robot.obj");
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.front_model = bundled_front_model();
  const RiggedScene plain(scene, options);
  plain.expect_sound();
  EXPECT_GT(plain.outputs.front[2], 0.99f);
  EXPECT_GT(plain.outputs.front_confidence, 0.7f);
  for (const Orientation& orientation :
       {Orientation{30, false}, Orientation{45, false}, Orientation{90, false}, Orientation{180, false},
        Orientation{137.318, false}, Orientation{0, true}, Orientation{250, true}}) {
    const RiggedScene other(orientation.of(scene), options);
    expect_same_joints(plain, other, orientation, 0.005 * side_of(scene));
    EXPECT_EQ(other.outputs.up, orientation.z_up ? SINEW_UP_Z : SINEW_UP_Y);
    float front[3];
    orientation.to(plain.outputs.front, front);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(other.outputs.front[axis], front[axis], 0.01) << orientation.degrees;
  }
}

// Angles that are found to a part of a step of the grid only: no joint comes or goes, and none moves.
TEST(RigFront, AnyTurnHasTheSameSkeleton) {
  sinew_rig_options options = SINEW_INIT(sinew_rig_options);
  options.front_model = bundled_front_model();
  for (const char* const file : {"biped__robot.obj", "bird__winged.obj"}) {
    const MeshScene scene = from_file(file);
    const RiggedScene plain(scene, options);
    for (const double degrees : {12.3456, -77.7777, 101.0101, 163.9})
      expect_same_joints(plain, RiggedScene(Orientation{degrees, false}.of(scene), options), {degrees, false},
                         0.005 * side_of(scene));
  }
}

}  // namespace
