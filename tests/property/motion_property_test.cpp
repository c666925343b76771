// SPDX-License-Identifier: MIT
// Thousands of random pairs of skeletons, maps, classes and poses: every plan is made or refused with its cause, every frame
// is finite with turns of length 1, bones keep their length, and the order of joints does not matter.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "motion_scene.hpp"

namespace {

using namespace sinew_test;

// A chain, a star, a random tree, joints at one position, of one to eighty joints in any size.
MotionScene random_rig(std::mt19937& random, uint32_t most) {
  MotionScene scene;
  const uint32_t count = 1 + static_cast<uint32_t>(random()) % most, kind = static_cast<uint32_t>(random()) % 4;
  const double size = std::pow(10.0, static_cast<double>(random() % 7) - 3);
  const auto draw = [&] { return size * (static_cast<double>(random()) / 2147483648.0 - 1); };
  for (uint32_t j = 0; j < count; ++j) {
    const int32_t before = static_cast<int32_t>(j) - 1;
    const int32_t parent = j == 0      ? -1
                           : kind == 0 ? before
                           : kind == 1 ? 0
                                       : static_cast<int32_t>(random() % (j + 1)) - 1;
    const Vec3d position = kind == 3 && random() % 2 == 0 ? Vec3d{0, 0, 0} : Vec3d{draw(), draw(), draw()};
    scene.add(position, parent, static_cast<uint8_t>(random() % 26));
  }
  if (random() % 2 == 0) {
    for (uint32_t i = 0; i < 4 * count; ++i) scene.rotations.push_back(static_cast<float>(draw() / size));
  }
  return scene;
}

TEST(MotionProperty, RandomRigsGiveFinitePosesOfTheirOwnBones) {
  std::mt19937 random(1);
  for (int round = 0; round < 3000; ++round) {
    SCOPED_TRACE(round);
    MotionScene source = random_rig(random, 80), target = random_rig(random, 80);
    std::vector<int32_t> map;
    for (uint32_t t = 0; t < target.count(); ++t)
      map.push_back(random() % 4 == 0 ? -1 : static_cast<int32_t>(random() % source.count()));
    const bool any = std::any_of(map.begin(), map.end(), [](int32_t s) { return s >= 0; });
    sinew::RetargetSettings settings;
    source.up = static_cast<uint32_t>(random()) % 4;
    target.up = static_cast<uint32_t>(random()) % 4;
    settings.in_place = static_cast<uint32_t>(random()) % 2;
    settings.arm_spread = static_cast<float>(random() % 181) - 90;
    const auto size_of = [](const MotionScene& scene) {
      float most = 0;
      for (const float x : scene.positions) most = std::max(most, std::abs(x));
      return most;
    };
    settings.scale = size_of(target) / std::max(size_of(source), 1e-6f);  // bones of a random map say nothing about it
    sinew::RetargetPlan plan;
    const sinew_status made = plan.make(source.view(), target.view(), map.data(),
                                        random() % 8 == 0 ? nullptr : target.classes.data(), settings);
    ASSERT_EQ(made, any ? SINEW_OK : SINEW_ERROR_NO_JOINT);
    if (!any) continue;
    Pose pose = random_pose(source, static_cast<uint32_t>(round), 3, {1, 2, 3}), out(target.count());
    float height = 0, ground = 0;
    ASSERT_EQ(plan.height(pose.rotations.data(), pose.translations.data(), &height), SINEW_OK);
    ASSERT_EQ(plan.ground(&height, 1, &ground), SINEW_OK);
    ASSERT_EQ(plan.frame(pose.rotations.data(), pose.translations.data(), ground, out.rotations.data(),
                         out.translations.data()),
              SINEW_OK);
    for (const float x : out.translations) ASSERT_TRUE(std::isfinite(x));
    double size = 0;
    for (const float x : target.positions) size = std::max(size, std::abs(double{x}));
    uint32_t moved = 0;
    for (uint32_t t = 0; t < target.count(); ++t) {
      const Quat q = quat(&out.rotations[4 * t]);
      ASSERT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1, 1e-5);
      // Feet and hands that hang elsewhere go with their limbs.
      if (target.parents[t] < 0 || target.classes[t] == SINEW_CLASS_FOOT || target.classes[t] == SINEW_CLASS_HAND)
        continue;
      const double own = distance(target.at(t), target.at(static_cast<size_t>(target.parents[t])));
      const double found = std::sqrt(sinew::dot(vec(&out.translations[3 * t]), vec(&out.translations[3 * t])));
      moved += std::abs(found - own) > 1e-3 * size ? 1 : 0;
    }
    ASSERT_LE(moved, 1u) << "only the joint that takes the translation may leave its place";

    if (std::count(target.parents.begin(), target.parents.end(), -1) != 1) continue;  // which root walks depends on it
    std::vector<uint32_t> order(
        target.count());  // the same joints in another order; no limbs, of which a random rig may have two in one
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<int32_t> new_index(order.size()), shuffled_map;
    for (size_t i = 0; i < order.size(); ++i) new_index[order[i]] = static_cast<int32_t>(i);
    MotionScene shuffled;
    shuffled.up = target.up;
    for (const uint32_t t : order) {
      const int32_t parent = target.parents[t];
      shuffled.add(target.at(t), parent < 0 ? -1 : new_index[static_cast<size_t>(parent)], target.classes[t]);
      if (!target.rotations.empty())
        shuffled.rotations.insert(shuffled.rotations.end(), &target.rotations[4 * t], &target.rotations[4 * t] + 4);
      shuffled_map.push_back(map[t]);
    }
    sinew::RetargetPlan other;
    ASSERT_EQ(other.make(source.view(), shuffled.view(), shuffled_map.data(), nullptr, settings), SINEW_OK);
    ASSERT_EQ(plan.make(source.view(), target.view(), map.data(), nullptr, settings), SINEW_OK);
    Pose found(target.count());
    ASSERT_EQ(
        plan.frame(pose.rotations.data(), pose.translations.data(), 0, out.rotations.data(), out.translations.data()),
        SINEW_OK);
    ASSERT_EQ(other.frame(pose.rotations.data(), pose.translations.data(), 0, found.rotations.data(),
                          found.translations.data()),
              SINEW_OK);
    double largest = size;
    for (const float x : out.translations) largest = std::max(largest, std::abs(double{x}));
    for (size_t i = 0; i < order.size(); ++i) {
      const Quat a = quat(&out.rotations[4 * order[i]]), b = quat(&found.rotations[4 * i]);
      ASSERT_NEAR(std::abs(a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w), 1, 1e-4);
      ASSERT_LT(distance(vec(&out.translations[3 * order[i]]), vec(&found.translations[3 * i])), 1e-4 * largest);
    }
  }
}

TEST(MotionProperty, TheLargestRigsFit) {
  MotionScene chain;
  for (uint32_t j = 0; j < SINEW_MAX_JOINTS; ++j)
    chain.add({0, 0.01 * j, 0}, static_cast<int32_t>(j) - 1, SINEW_CLASS_SPINE);
  sinew::RetargetPlan plan;
  ASSERT_EQ(plan.make(chain.view(), chain.view(), one_to_one(SINEW_MAX_JOINTS).data(), chain.classes.data()), SINEW_OK);
  const Pose pose = rest_pose(chain);
  Pose out(SINEW_MAX_JOINTS);
  ASSERT_EQ(
      plan.frame(pose.rotations.data(), pose.translations.data(), 0, out.rotations.data(), out.translations.data()),
      SINEW_OK);
  EXPECT_NEAR(out.translations.back(), 0, 1e-3);
  chain.add({0, 0, 0}, 0, 0);
  EXPECT_EQ(plan.make(chain.view(), chain.view(), one_to_one(SINEW_MAX_JOINTS + 1).data(), nullptr), SINEW_ERROR_COUNT);
}

}  // namespace
