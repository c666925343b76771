// SPDX-License-Identifier: MIT
#include "sinew_character/check/rig_gate.hpp"

#include <gtest/gtest.h>

#include <array>

namespace sinew {
namespace {

// A strip of `steps` squares of a tenth along x with a joint for each unit of it.
Character strip(uint32_t steps) {
  Character strip;
  strip.name = "strip";
  for (uint32_t i = 0; i <= steps; ++i)
    for (const float z : {0.0f, 0.1f}) strip.vertices.push_back({0.1f * static_cast<float>(i), 0, z});
  for (uint32_t i = 0; i < steps; ++i) {
    for (const uint32_t corner : {2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2}) strip.face_vertices.push_back(corner);
    strip.face_offsets.push_back(static_cast<uint32_t>(strip.face_vertices.size()));
  }
  for (uint32_t j = 0; j <= steps / 10; ++j)
    strip.joints.push_back({"joint" + std::to_string(j), {static_cast<float>(j), 0, 0.05f}, static_cast<int>(j) - 1});
  return strip;
}

void bind_to(Character* character, bool near) {
  const auto joints = static_cast<uint32_t>(character->joints.size());
  for (size_t v = 0; v < character->vertices.size(); ++v) {
    const auto nearest = static_cast<uint32_t>(character->vertices[v].x);
    character->influences.push_back({{near ? nearest : static_cast<uint32_t>(v * 5) % joints, 1.0f}});
  }
}

PredictedSkeleton sure(const Character& character) {
  PredictedSkeleton skeleton;
  skeleton.joints = character.joints;
  skeleton.ends.assign(character.joints.size(), 0);
  skeleton.parent_confidence.assign(character.joints.size(), 1.0f);
  skeleton.usable = 0.9f;
  return skeleton;
}

TEST(RigGate, PassesWhatFollowsItsJoints) {
  Character character = strip(60);
  bind_to(&character, true);
  const GateFigures figures = gate_figures(character, sure(character));
  EXPECT_EQ(figures.unweighted, 0);
  EXPECT_EQ(figures.weak_parents, 0);
  EXPECT_LT(figures.exploded, kMostExploded);
  EXPECT_TRUE(gate_failures(figures, true).empty());
}

TEST(RigGate, SeesWeightsOfJointsElsewhere) {
  Character character = strip(60);
  bind_to(&character, false);
  const GateFigures figures = gate_figures(character, sure(character));
  EXPECT_GT(figures.exploded, 10 * kMostExploded);
  ASSERT_EQ(gate_failures(figures, true).size(), 1u);
  EXPECT_NE(gate_failures(figures, true)[0].find("tear"), std::string::npos);
  EXPECT_TRUE(gate_failures(figures, false).empty());
}

TEST(RigGate, SeesWhatHasNoWeightAndWhatIsDoubted) {
  Character character = strip(60);
  bind_to(&character, true);
  character.influences[3].clear();
  PredictedSkeleton skeleton = sure(character);
  skeleton.usable = 0.3f;
  skeleton.front_confidence = 0.5f;
  for (size_t j = 1; j < 5; ++j) skeleton.parent_confidence[j] = 0.01f;
  const GateFigures figures = gate_figures(character, skeleton);
  EXPECT_DOUBLE_EQ(figures.unweighted, 1.0 / 122);
  EXPECT_DOUBLE_EQ(figures.weak_parents, 4.0 / 6);
  EXPECT_EQ(gate_failures(figures, true).size(), 4u);
  EXPECT_EQ(gate_failures(figures, false).size(), 3u);
}

TEST(RigGate, TakesAMeshWithoutWeightsOrEdges) {
  Character points;
  points.vertices = {{0, 0, 0}, {1, 0, 0}};
  points.joints = {{"root", {0, 0, 0}, -1}};
  EXPECT_EQ(exploded_share(points), 0);
  points.influences = {{{0, 1.0f}}, {{0, 1.0f}}};
  EXPECT_EQ(exploded_share(points), 0);
}

}  // namespace
}  // namespace sinew
