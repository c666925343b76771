// SPDX-License-Identifier: MIT
// Frames of any length show one motion, jumps restart it, and what is wrong is refused.
#include "sinew/springs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "spring_scene.hpp"

namespace {

using namespace sinew_test;

constexpr Quat kUpright = {0, 0, 0, 1};

SpringScene tail() {
  SpringScene scene;
  scene.add_chain({0, 1, -0.1}, {0, -0.06, -0.08}, 6, spring_joint(1, 0.2f, 0.4f, 0.01f));
  scene.colliders = {{1, SINEW_COLLIDER_SPHERE, {0, 0, 0}, {}, 0.08f}};
  scene.share_colliders();
  return scene;
}

struct Player {
  explicit Player(const SpringScene& s) : scene(s) { EXPECT_EQ(springs.make(s.skeleton(), s.set()), SINEW_OK); }
  // Where joints are after the next frame.
  std::vector<Vec3d> frame(double seconds, Vec3d root, Quat head) {
    scene.pose(root, head, &rotations, &translations);
    EXPECT_EQ(springs.frame(static_cast<float>(seconds), rotations.data(), translations.data(), rotations.data()),
              SINEW_OK);
    return scene.worlds(rotations, translations);
  }
  SpringScene scene;
  sinew::SpringSystem springs;
  std::vector<float> rotations, translations;
};

// Where the tail's end is each sixth of a second of a motion that sways, at some number of frames a second.
std::vector<Vec3d> ends(int fps) {
  Player player(tail());
  std::vector<Vec3d> out;
  for (int f = 0; f <= 4 * fps; ++f) {
    const double t = static_cast<double>(f) / fps;
    const Vec3d root = {0.25 * std::sin(2.5 * t), 0.03 * std::sin(6 * t), 0};
    const std::vector<Vec3d> at = player.frame(1.0 / fps, root, about({0, 1, 0}, 0.6 * std::sin(3 * t)));
    if (f % (fps / 6) == 0) out.push_back(at.back());
  }
  return out;
}

TEST(Springs, DoNotDependOnTheFrameRate) {
  const std::vector<Vec3d> at_60 = ends(60);
  for (const int fps : {30, 144}) {
    const std::vector<Vec3d> other = ends(fps);
    double worst = 0;
    for (size_t i = 0; i < at_60.size(); ++i) worst = std::max(worst, distance(at_60[i], other[i]));
    EXPECT_LT(worst, 0.01) << fps;
  }
}

TEST(Springs, FramesBetweenStepsShowSharesOfThem) {
  // A thousand frames a second move smoothly, and pass where sixty do.
  Player player(tail());
  (void)player.frame(0, {}, kUpright);
  Vec3d last, velocity;
  double roughest = 0;
  for (int f = 1; f <= 1000; ++f) {
    const std::vector<Vec3d> at = player.frame(0.001, {0.2 * std::sin(0.003 * f), 0, 0}, kUpright);
    const Vec3d moved = at.back() - last;
    if (f > 2) roughest = std::max(roughest, distance(moved, velocity));
    last = at.back();
    velocity = moved;
  }
  EXPECT_LT(roughest, 3e-4);  // of 6e-4 a frame that the root moves at most
}

TEST(Springs, TheFirstFrameIsThePose) {
  Player player(tail());
  std::vector<float> rotations, translations;
  player.scene.pose({3, 0, 0}, about({1, 0, 0}, 0.4), &rotations, &translations);
  const std::vector<float> given = rotations;
  ASSERT_EQ(player.springs.frame(0, rotations.data(), translations.data(), rotations.data()), SINEW_OK);
  EXPECT_EQ(rotations, given);
  // After a gap, after a jump, after a restart: the same.
  for (int i = 0; i < 30; ++i) (void)player.frame(1.0 / 30, {3, 0.02 * i, 0}, about({0, 1, 0}, 0.1 * i));
  EXPECT_NE(player.rotations[4 * 4 + 3], 1);
  rotations = given;
  ASSERT_EQ(player.springs.frame(0.7f, rotations.data(), translations.data(), rotations.data()), SINEW_OK);
  EXPECT_EQ(rotations, given);
  for (int i = 0; i < 9; ++i) (void)player.frame(1.0 / 30, {3, 0.1 * i, 0}, kUpright);
  (void)player.frame(1.0 / 30, {30, 0, 0}, kUpright);
  EXPECT_EQ(player.rotations[4 * 4 + 3], 1);
  for (int i = 0; i < 9; ++i) (void)player.frame(1.0 / 30, {30, 0.1 * i, 0}, kUpright);
  ASSERT_EQ(player.springs.restart(), SINEW_OK);
  (void)player.frame(1.0 / 30, {30, 0, 0}, kUpright);
  EXPECT_EQ(player.rotations[4 * 4 + 3], 1);
}

TEST(Springs, HipsBelowARootJumpToo) {
  SpringScene scene = tail();
  sinew::SpringSystem springs;
  ASSERT_EQ(springs.make(scene.skeleton(), scene.set()), SINEW_OK);
  std::vector<float> rotations, translations;
  scene.pose({}, kUpright, &rotations, &translations);
  for (int f = 0; f < 9; ++f) {
    std::vector<float> moved = translations, out = rotations;
    moved[3] += 0.05f * static_cast<float>(f) + (f == 8 ? 50.0f : 0.0f);  // joint 1 hangs on the root
    ASSERT_EQ(springs.frame(1.0f / 30, rotations.data(), moved.data(), out.data()), SINEW_OK);
    EXPECT_EQ(out == rotations, f == 0 || f == 8) << f;
  }
}

TEST(Springs, ComeToRestAfterAStop) {
  Player player(tail());
  for (int f = 0; f < 60; ++f) (void)player.frame(1.0 / 60, {0.03 * f, 0, 0}, kUpright);
  std::vector<Vec3d> after;
  for (int f = 0; f < 150; ++f) after.push_back(player.frame(1.0 / 60, {0.03 * 59, 0, 0}, kUpright).back());
  double jitter = 0;
  for (size_t f = 90; f < after.size(); ++f) jitter = std::max(jitter, distance(after[f], after.back()));
  EXPECT_LT(jitter, 0.001);
}

TEST(Springs, NeverExplode) {
  Player player(tail());
  const std::vector<Vec3d> rest = player.frame(0, {}, kUpright);
  uint32_t state = 7;
  const auto draw = [&state] {
    return static_cast<double>((state = state * 1664525u + 1013904223u) >> 8) / (1 << 24) - 0.5;
  };
  for (int f = 0; f < 2000; ++f) {
    const double size = f % 100 == 0 ? 1e30 : f % 7 == 0 ? 100 : 0.9;
    const std::vector<Vec3d> at =
        player.frame(f % 50 == 0 ? 0 : 0.2 * (draw() + 0.5), {size * draw(), size * draw(), size * draw()},
                     about({draw(), draw(), draw()}, 10 * draw()));
    for (const float x : player.rotations) ASSERT_TRUE(std::isfinite(x)) << f;
    for (size_t j = 3; size < 1000 && j < at.size(); ++j)
      ASSERT_NEAR(distance(at[j], at[j - 1]), distance(rest[j], rest[j - 1]), 1e-4) << f;
  }
}

TEST(Springs, UnitsScaleTheMotion) {
  SpringScene meters = tail(), centimeters = tail();
  for (float& x : centimeters.positions) x *= 100;
  for (sinew_spring_joint& joint : centimeters.joints) joint.hit_radius *= 100;
  for (sinew_spring_collider& collider : centimeters.colliders) collider.radius *= 100;
  Player small(meters);
  sinew::SpringSystem large;
  sinew_springs_options options = SINEW_INIT(sinew_springs_options);
  options.unit = 100;
  ASSERT_EQ(large.make(centimeters.skeleton(), centimeters.set(), &options), SINEW_OK);
  std::vector<float> rotations, translations;
  for (int f = 0; f < 60; ++f) {
    (void)small.frame(1.0 / 60, {0.02 * f, 0, 0}, kUpright);
    centimeters.pose({2.0 * f, 0, 0}, kUpright, &rotations, &translations);
    ASSERT_EQ(large.frame(1.0f / 60, rotations.data(), translations.data(), rotations.data()), SINEW_OK);
  }
  for (size_t i = 0; i < rotations.size(); ++i) EXPECT_NEAR(rotations[i], small.rotations[i], 1e-4);
}

TEST(Springs, CollidersOfChainsMoveFirst) {
  // The second chain carries the collider of the first one.
  SpringScene scene;
  scene.add_chain({0, 1, 0}, {0, 0, -0.1}, 4, spring_joint(1, 0, 0.4f));
  scene.add_chain({0, 1.2, 0}, {0, 0, -0.1}, 4, spring_joint(1, 0, 0.4f));
  scene.colliders = {{9, SINEW_COLLIDER_SPHERE, {0, 0, 0}, {}, 0.05f}};
  scene.chain_colliders = {0};
  scene.chains[0].collider_count = 1;
  Player player(scene);
  for (int f = 0; f < 60; ++f) {
    const std::vector<Vec3d> at = player.frame(1.0 / 60, {0, 0, 0}, about({1, 0, 0}, 0.5 * std::sin(0.2 * f)));
    for (size_t j = 3; f > 0 && j < 6; ++j) EXPECT_GT(distance(at[j], at[9]), 0.049);
  }
  // In a circle: one of them is where it was in the step before.
  scene.colliders.push_back({5, SINEW_COLLIDER_SPHERE, {0, 0, 0}, {}, 0.05f});
  scene.chain_colliders = {0, 1};
  scene.chains[1].first_collider = 1;
  scene.chains[1].collider_count = 1;
  Player circle(scene);
  for (int f = 0; f < 10; ++f) (void)circle.frame(1.0 / 60, {}, kUpright);
}

struct Fault {
  const char* what;
  sinew_status status;
  void (*make)(SpringScene*);
};

TEST(Springs, RefuseWhatIsWrong) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  static float not_a_number;
  not_a_number = nan;
  const Fault faults[] = {
      {"NaN", SINEW_ERROR_NOT_FINITE, [](SpringScene* s) { s->joints[1].stiffness = not_a_number; }},
      {"NaN of a collider", SINEW_ERROR_NOT_FINITE, [](SpringScene* s) { s->colliders[0].offset[1] = not_a_number; }},
      {"NaN of a position", SINEW_ERROR_NOT_FINITE, [](SpringScene* s) { s->positions[4] = not_a_number; }},
      {"negative radius", SINEW_ERROR_RANGE, [](SpringScene* s) { s->colliders[0].radius = -0.1f; }},
      {"negative hit radius", SINEW_ERROR_RANGE, [](SpringScene* s) { s->joints[0].hit_radius = -0.1f; }},
      {"negative stiffness", SINEW_ERROR_RANGE, [](SpringScene* s) { s->joints[0].stiffness = -1; }},
      {"drag", SINEW_ERROR_RANGE, [](SpringScene* s) { s->joints[0].drag = 1.5f; }},
      {"limit", SINEW_ERROR_RANGE, [](SpringScene* s) { s->joints[0].limit = 181; }},
      {"shape", SINEW_ERROR_ARGUMENT, [](SpringScene* s) { s->colliders[0].shape = 6; }},
      {"cycle", SINEW_ERROR_HIERARCHY, [](SpringScene* s) { s->parents[0] = 4; }},
      {"chain of one joint", SINEW_ERROR_COUNT, [](SpringScene* s) { s->chains[0].joint_count = 1; }},
      {"no chain", SINEW_ERROR_COUNT, [](SpringScene* s) { s->chains.clear(); }},
      {"too many joints", SINEW_ERROR_COUNT, [](SpringScene* s) { s->joints.resize(1000000); }},
      {"joint", SINEW_ERROR_INDEX, [](SpringScene* s) { s->joints[5].joint = 99; }},
      {"chain's joints", SINEW_ERROR_INDEX, [](SpringScene* s) { s->chains[0].first_joint = 1; }},
      {"chain's colliders", SINEW_ERROR_INDEX, [](SpringScene* s) { s->chains[0].collider_count = 2; }},
      {"collider", SINEW_ERROR_INDEX, [](SpringScene* s) { s->chain_colliders[0] = 1; }},
      {"collider's joint", SINEW_ERROR_INDEX, [](SpringScene* s) { s->colliders[0].joint = 99; }},
      {"center", SINEW_ERROR_INDEX, [](SpringScene* s) { s->chains[0].center = 99; }},
      {"upside down", SINEW_ERROR_CHAIN, [](SpringScene* s) { std::swap(s->joints[1].joint, s->joints[2].joint); }},
      {"two chains", SINEW_ERROR_CHAIN, [](SpringScene* s) { s->chains.push_back(s->chains[0]); }},
  };
  for (const Fault& fault : faults) {
    SpringScene scene = tail();
    fault.make(&scene);
    sinew::SpringSystem springs;
    EXPECT_EQ(springs.make(scene.skeleton(), scene.set()), fault.status) << fault.what;
    EXPECT_EQ(springs.restart(), SINEW_ERROR_ARGUMENT) << fault.what;
  }
}

TEST(Springs, RefuseOptionsAndFrames) {
  const SpringScene scene = tail();
  sinew_springs_options options = SINEW_INIT(sinew_springs_options);
  sinew::SpringSystem springs;
  options.steps = 5;
  EXPECT_EQ(springs.make(scene.skeleton(), scene.set(), &options), SINEW_ERROR_ARGUMENT);
  options = SINEW_INIT(sinew_springs_options);
  options.gap = 11;
  EXPECT_EQ(springs.make(scene.skeleton(), scene.set(), &options), SINEW_ERROR_ARGUMENT);
  options.struct_size = 0;
  EXPECT_EQ(springs.make(scene.skeleton(), scene.set(), &options), SINEW_ERROR_ARGUMENT);
  Player player(scene);
  std::vector<float> rotations, translations;
  scene.pose({}, kUpright, &rotations, &translations);
  const std::vector<float> given = rotations;
  EXPECT_EQ(player.springs.frame(-1, rotations.data(), translations.data(), rotations.data()), SINEW_ERROR_ARGUMENT);
  rotations[9] = std::numeric_limits<float>::infinity();
  std::vector<float> out = given;
  EXPECT_EQ(player.springs.frame(0, rotations.data(), translations.data(), out.data()), SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(out, given);
  size_t bytes = 1;
  EXPECT_EQ(sinew_springs_workspace_size(0, 2, 1, 0, 0, &bytes), SINEW_ERROR_COUNT);
  EXPECT_EQ(bytes, 0u);
  EXPECT_EQ(sinew_springs_workspace_size(SINEW_MAX_JOINTS, SINEW_MAX_JOINTS, 1, SINEW_MAX_JOINTS,
                                         SINEW_MAX_CHAIN_COLLIDERS, &bytes),
            SINEW_OK);
}

}  // namespace
