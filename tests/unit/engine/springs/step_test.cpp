// SPDX-License-Identifier: MIT
// A step is the published pseudocode, colliders keep their distance, and limits hold.
#include <gtest/gtest.h>

#include <algorithm>

#include "spring_scene.hpp"

namespace {

using namespace sinew_test;

// The pseudocode of VRMC_springBone-1.0 word by word, with matrices as rotations and positions, for one chain that hangs on joint 1 and
// is pushed by spheres and capsules of joint 1.
class Pseudocode {
 public:
  explicit Pseudocode(const SpringScene& scene) : scene_(scene) {
    for (size_t i = 0; i < scene.joints.size(); ++i) {
      const size_t j = scene.joints[i].joint;
      tails_.push_back(
          {double{scene.positions[3 * j]}, double{scene.positions[3 * j + 1]}, double{scene.positions[3 * j + 2]}});
      previous_ = tails_;
    }
  }
  // Positions of the chain's joints.
  std::vector<Vec3d> step(Vec3d root, Quat head, double seconds) {
    Vec3d position = root + Vec3d{0, 1, 0};
    Quat rotation = head;
    const Vec3d head_at = position;
    std::vector<Vec3d> out;
    for (size_t i = 0; i < scene_.joints.size(); ++i) {
      position = position + sinew::motion::rotate(rotation, rest(i) - (i == 0 ? Vec3d{0, 1, 0} : rest(i - 1)));
      out.push_back(position);
      if (i + 1 == scene_.joints.size()) return out;
      const sinew_spring_joint& own = scene_.joints[i];
      const Vec3d axis = rest(i + 1) - rest(i);
      const double bone = distance(axis, {});
      const Vec3d goal = sinew::motion::rotate(rotation, (1 / bone) * axis);
      Vec3d next = tails_[i + 1] + (1 - double{own.drag}) * (tails_[i + 1] - previous_[i + 1]) +
                   (seconds * double{own.stiffness}) * goal + (seconds * double{own.gravity_power}) * Vec3d{0, -1, 0};
      const auto keep_length = [&] { next = position + (bone / distance(next, position)) * (next - position); };
      keep_length();
      for (const sinew_spring_collider& c : scene_.colliders) {
        const auto in_world = [&](const float(&v)[3]) {
          return head_at + sinew::motion::rotate(head, {double{v[0]}, double{v[1]}, double{v[2]}});
        };
        const Vec3d start = in_world(c.offset), along = in_world(c.tail) - start;
        Vec3d delta = next - start;
        if (c.shape == SINEW_COLLIDER_CAPSULE)
          delta = delta - std::clamp(sinew::dot(along, delta) / sinew::dot(along, along), 0.0, 1.0) * along;
        const double gap = distance(delta, {}) - double{c.radius} - double{own.hit_radius};
        if (gap >= 0) continue;
        next = next - (gap / distance(delta, {})) * delta;
        keep_length();
      }
      previous_[i + 1] = tails_[i + 1];
      tails_[i + 1] = next;
      rotation = sinew::motion::shortest_arc(goal, next - position) * rotation;
    }
    return out;
  }

 private:
  Vec3d rest(size_t i) const {
    const size_t j = scene_.joints[i].joint;
    return {double{scene_.positions[3 * j]}, double{scene_.positions[3 * j + 1]}, double{scene_.positions[3 * j + 2]}};
  }
  const SpringScene& scene_;
  std::vector<Vec3d> tails_, previous_;
};

SpringScene ponytail(const sinew_spring_joint& like) {
  SpringScene scene;
  scene.add_chain({0, 1, -0.1}, {0, -0.05, -0.09}, 6, like);
  scene.colliders = {{1, SINEW_COLLIDER_SPHERE, {0, 0.05f, 0}, {}, 0.06f},
                     {1, SINEW_COLLIDER_CAPSULE, {0, -0.6f, -0.1f}, {0, -0.1f, -0.1f}, 0.08f}};
  scene.share_colliders();
  return scene;
}

TEST(SpringStep, IsThePublishedPseudocode) {
  const SpringScene scene = ponytail(spring_joint(0.8f, 0.3f, 0.3f, 0.02f));
  sinew::SpringSystem springs;
  ASSERT_EQ(springs.make(scene.skeleton(), scene.set()), SINEW_OK);
  Pseudocode published(scene);
  std::vector<float> rotations, translations;
  double worst = 0, farthest = 0;
  for (int f = 0; f < 300; ++f) {
    const double t = f / 60.0;
    const Vec3d root = {0.3 * std::sin(3 * t), 0.05 * std::sin(8 * t), 0};
    const Quat head = about({0.2, 1, 0.1}, f == 0 ? 0 : 0.9 * std::sin(4 * t));
    scene.pose(f == 0 ? Vec3d{} : root, head, &rotations, &translations);
    ASSERT_EQ(springs.frame(1.0f / 60, rotations.data(), translations.data(), rotations.data()), SINEW_OK);
    if (f == 0) continue;
    const std::vector<Vec3d> here = scene.worlds(rotations, translations), there = published.step(root, head, 1.0 / 60);
    for (size_t i = 0; i < there.size(); ++i) worst = std::max(worst, distance(here[scene.joints[i].joint], there[i]));
    farthest = std::max(farthest, std::abs(there.back().x - root.x));
  }
  EXPECT_LT(worst, 1e-5);
  EXPECT_GT(farthest, 0.1);  // it swings at all
}

TEST(SpringStep, CollidersKeepTheirDistance) {
  for (const uint32_t shape : {SINEW_COLLIDER_SPHERE, SINEW_COLLIDER_CAPSULE, SINEW_COLLIDER_PLANE}) {
    SpringScene scene;
    scene.add_chain({0, 1, -0.3}, {0, 0, -0.2}, 4, spring_joint(0.2f, 0.8f, 0.4f, 0.02f));
    // Below the chain, which falls onto it.
    scene.colliders = {{0, shape, {0, 0.6f, -0.5f}, {0, 1, 0}, 0.2f}};
    if (shape == SINEW_COLLIDER_CAPSULE) scene.colliders[0].tail[2] = -0.9f, scene.colliders[0].tail[1] = 0.6f;
    scene.share_colliders();
    sinew::SpringSystem springs;
    ASSERT_EQ(springs.make(scene.skeleton(), scene.set()), SINEW_OK);
    std::vector<float> rotations, translations;
    scene.pose({}, {0, 0, 0, 1}, &rotations, &translations);
    double least = 1;
    for (int f = 0; f < 200; ++f) {
      std::vector<float> out(rotations.size());
      ASSERT_EQ(springs.frame(1.0f / 60, rotations.data(), translations.data(), out.data()), SINEW_OK);
      const std::vector<Vec3d> at = scene.worlds(out, translations);
      for (size_t i = 1; i < 4; ++i) {
        const Vec3d p = at[2 + i];
        double gap = p.y - 0.6;
        if (shape == SINEW_COLLIDER_SPHERE) gap = distance(p, {0, 0.6, -0.5}) - 0.2;
        if (shape == SINEW_COLLIDER_CAPSULE) gap = distance(p, {0, 0.6, std::clamp(p.z, -0.9, -0.5)}) - 0.2;
        least = std::min(least, gap);
      }
    }
    // A tail is pushed, then kept at its length: what that takes back is a part of a step.
    EXPECT_GT(least, 0.005) << shape;
    EXPECT_LT(least, 0.05) << shape;
  }
}

TEST(SpringStep, InsideShapesHoldChains) {
  SpringScene scene;
  scene.add_chain({0, 1, 0}, {0, -0.1, 0}, 3, spring_joint(0, 1, 0.2f, 0.01f));
  scene.colliders = {{1, SINEW_COLLIDER_INSIDE_SPHERE, {0, 0, 0}, {}, 0.25f},
                     {0, SINEW_COLLIDER_INSIDE_CAPSULE, {0, 0.5f, 0}, {0, 1.2f, 0}, 0.06f}};
  scene.share_colliders();
  sinew::SpringSystem springs;
  ASSERT_EQ(springs.make(scene.skeleton(), scene.set()), SINEW_OK);
  std::vector<float> rotations, translations;
  for (int f = 0; f < 120; ++f) {
    scene.pose({}, about({0, 0, 1}, 1.2 * std::sin(f * 0.1)), &rotations, &translations);
    ASSERT_EQ(springs.frame(1.0f / 60, rotations.data(), translations.data(), rotations.data()), SINEW_OK);
    const std::vector<Vec3d> at = scene.worlds(rotations, translations);
    if (f > 0) {
      EXPECT_LT(std::abs(at[3].x), 0.06);
    }
  }
}

TEST(SpringStep, LimitsHoldAngles) {
  SpringScene scene;
  scene.add_chain({0, 1, 0}, {0.2, 0, 0}, 5, spring_joint(0, 5, 0.1f, 0, 20));
  sinew::SpringSystem springs;
  ASSERT_EQ(springs.make(scene.skeleton(), scene.set()), SINEW_OK);
  std::vector<float> rotations, translations;
  scene.pose({}, {0, 0, 0, 1}, &rotations, &translations);
  const double least = std::cos(10.001 * 3.14159265358979 / 180);  // of half the angle
  double reached = 1;
  for (int f = 0; f < 100; ++f) {
    std::vector<float> out(rotations.size());
    ASSERT_EQ(springs.frame(1.0f / 60, rotations.data(), translations.data(), out.data()), SINEW_OK);
    for (size_t j = 2; j < 6; ++j) {
      EXPECT_GE(double{out[4 * j + 3]}, least);
      reached = std::min(reached, double{out[4 * j + 3]});
    }
  }
  EXPECT_LT(reached, std::cos(9.9 * 3.14159265358979 / 180));
}

// A panel that hangs down before a leg, which comes from the side and then from behind.
TEST(SpringStep, HingesTurnAboutTheirAxis) {
  SpringScene scene;
  scene.add_chain({0, 0.9, 0.1}, {0, -0.2, 0}, 3, spring_joint(0.5f, 0, 0.4f, 0.01f));
  scene.hinges = {1, 0.3f, 0, 1, 0, 0, 0, 0, 0};  // what lies along the bone does not count
  scene.colliders = {{0, SINEW_COLLIDER_CAPSULE, {0, 0, 0}, {0, 1, 0}, 0.05f}};
  scene.share_colliders();
  sinew::SpringSystem springs;
  ASSERT_EQ(springs.make(scene.skeleton(), scene.set()), SINEW_OK);
  std::vector<float> rotations, translations;
  double out_most = 0;
  for (int f = 0; f < 80; ++f) {
    // The whole figure but for its second joint moves to the front: the chain's joint stays, the leg comes.
    scene.pose({0.02, 0, 0.002 * f}, {0, 0, 0, 1}, &rotations, &translations);
    translations[5] -= 0.002f * static_cast<float>(f);
    std::vector<float> out(rotations.size());
    ASSERT_EQ(springs.frame(1.0f / 60, rotations.data(), translations.data(), out.data()), SINEW_OK);
    const std::vector<Vec3d> at = scene.worlds(out, translations);
    for (size_t j = 3; j < 5; ++j) EXPECT_NEAR(at[j].x, at[2].x, 1e-5) << f;  // never aside
    out_most = std::max(out_most, at[3].z - at[2].z);
    const double away = std::hypot(at[4].x - 0.02, at[4].z - 0.002 * f);
    EXPECT_GT(away, 0.058) << f;  // of 0.06
  }
  EXPECT_GT(out_most, 0.05);
}

TEST(SpringStep, AChainWithACenterDoesNotFeelItsMotion) {
  std::vector<double> swings;
  for (const int32_t center : {-1, 0}) {
    SpringScene scene;
    scene.add_chain({0, 1, 0}, {0, -0.1, 0}, 4, spring_joint(1, 0, 0.4f));
    scene.chains[0].center = center;
    sinew::SpringSystem springs;
    ASSERT_EQ(springs.make(scene.skeleton(), scene.set()), SINEW_OK);
    std::vector<float> rotations, translations;
    double swing = 0;
    for (int f = 0; f < 60; ++f) {
      scene.pose({0.02 * f, 0, 0}, {0, 0, 0, 1}, &rotations, &translations);
      ASSERT_EQ(springs.frame(1.0f / 60, rotations.data(), translations.data(), rotations.data()), SINEW_OK);
      const std::vector<Vec3d> at = scene.worlds(rotations, translations);
      swing = std::max(swing, std::abs(at[5].x - at[2].x));
    }
    swings.push_back(swing);
  }
  EXPECT_GT(swings[0], 0.05);
  EXPECT_LT(swings[1], 1e-6);
}

}  // namespace
