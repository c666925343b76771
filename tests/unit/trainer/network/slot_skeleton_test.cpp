// SPDX-License-Identifier: MIT
// Skeletons of slots: sound for any network, and the same wherever the mesh stands.
#include "sinew_trainer/slot_skeleton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "expect_error.hpp"
#include "network/slot_network.hpp"
#include "sinew_datasets/dataset.hpp"
#include "sinew_datasets/synthesize.hpp"

namespace sinew {
namespace {

// Untrained, but for which slots hold a joint: all.
FloatNetwork everything() {
  FloatNetwork network = make_slot_network({8, 3}, 2);
  LinearParameters& joints = network.parameters[network.parameters.size() - 4];
  for (uint32_t slot = 0; slot < kSlots; ++slot) joints.bias[slot * kSlotNumbers + kSlotPresence] = 30;
  return network;
}

Character figure(BodyPlan plan = BodyPlan::kBiped) {
  SynthesizeOptions options;
  options.plan = plan;
  options.resolution = 24;
  Character character = synthesize(options);
  character.joints.clear();
  character.influences.clear();
  return character;
}

void expect_sound(const PredictedSkeleton& s) {
  const size_t count = s.joints.size();
  ASSERT_GE(count, 1u);
  EXPECT_EQ(s.classes.size(), count);
  EXPECT_EQ(s.partners, std::vector<int32_t>(count, -1));
  std::set<std::string> names;
  for (size_t j = 0; j < count; ++j) {
    names.insert(s.joints[j].name);
    EXPECT_EQ(s.joints[j].parent < 0, j == 0) << "one root, first";
    EXPECT_LT(s.joints[j].parent, static_cast<int>(j));
    EXPECT_EQ(s.joints[j].deforms, std::optional<bool>(s.ends[j] == 0));
    if (s.joints[j].parent >= 0) {
      EXPECT_EQ(s.ends[static_cast<size_t>(s.joints[j].parent)], 0);
    }
    for (const float share : {s.confidence[j], s.parent_confidence[j]}) {
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
    }
  }
  EXPECT_EQ(names.size(), count);
}

TEST(SlotSkeleton, EverySlotBecomesAJointOfOneTree) {
  const FloatNetwork network = everything();
  const PredictedSkeleton all = predict_slots(figure(), network, {});
  expect_sound(all);
  EXPECT_EQ(all.joints.size(), kSlots);
  EXPECT_EQ(all.joints[0].name, "Hips");
  EXPECT_EQ(std::count_if(all.joints.begin(), all.joints.end(),
                          [](const Joint& j) { return j.name.find("_end") != std::string::npos; }),
            8);
}

TEST(SlotSkeleton, OptionsTakeSlotsAway) {
  const FloatNetwork network = everything();
  SlotSkeletonOptions options;
  options.ends = false;
  PredictedSkeleton s = predict_slots(figure(), network, options);
  expect_sound(s);
  EXPECT_EQ(s.joints.size(), kSlots - 8);
  options.toes = false;
  s = predict_slots(figure(), network, options);
  EXPECT_EQ(s.joints.size(), kSlots - 10);
  EXPECT_EQ(std::count(s.classes.begin(), s.classes.end(), kClassToe), 0);
  options = {};
  options.category = SlotCategory::kFish;
  s = predict_slots(figure(), network, options);
  expect_sound(s);
  EXPECT_EQ(s.joints.size(), 9u + 5 + 6);
  EXPECT_EQ(std::count(s.classes.begin(), s.classes.end(), kClassThigh), 0);
}

TEST(SlotSkeleton, NothingPresentIsOneJoint) {
  FloatNetwork network = make_slot_network({8, 3}, 2);
  LinearParameters& joints = network.parameters[network.parameters.size() - 4];
  for (uint32_t slot = 0; slot < kSlots; ++slot) joints.bias[slot * kSlotNumbers + kSlotPresence] = -30;
  const PredictedSkeleton s = predict_slots(figure(), network, {});
  expect_sound(s);
  EXPECT_EQ(s.joints.size(), 1u);
}

TEST(SlotSkeleton, RisesScalesAndTurnsWithTheMesh) {
  const FloatNetwork network = everything();
  Character character = figure(BodyPlan::kQuadruped);
  // A mesh that is not decimated: what goes first may hang on the last bits of its vertices.
  character = decimate(character, 500.0 / static_cast<double>(character.vertices.size()));
  ASSERT_LE(character.vertices.size(), 800u);
  const PredictedSkeleton at_home = predict_slots(character, network, {});
  SlotSkeletonOptions options;
  options.up_axis = 1;
  for (Vec3& v : character.vertices) v = {8 * v.x, 8 * -v.z, 8 * v.y + 64};  // z up
  const PredictedSkeleton away = predict_slots(character, network, options);
  ASSERT_EQ(away.joints.size(), at_home.joints.size());
  for (size_t j = 0; j < away.joints.size(); ++j) {
    const Vec3 p = at_home.joints[j].position, q = away.joints[j].position;
    EXPECT_EQ(away.joints[j].parent, at_home.joints[j].parent);
    EXPECT_NEAR(q.x, 8 * p.x, 1e-4) << j;
    EXPECT_NEAR(q.y, 8 * -p.z, 1e-4) << j;
    EXPECT_NEAR(q.z, 8 * p.y + 64, 1e-4) << j;
  }
}

TEST(SlotSkeleton, MeshesWithoutASurfaceAreRefused) {
  const FloatNetwork network = everything();
  Character points;
  points.name = "points";
  points.vertices = {{0, 0, 0}, {1, 0, 0}};
  points.face_offsets = {0};
  EXPECT_ERROR(predict_slots(points, network, {}), "points: no faces");
}

}  // namespace
}  // namespace sinew
