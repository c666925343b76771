// SPDX-License-Identifier: MIT
// A bind of a Character: raw rows and influences agree, given rows stay, refusals name the character.
#include "sinew_character/bind/bind.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "expect_error.hpp"

namespace sinew {
namespace {

// A bar of `rings` squares along x, with a chain of three joints inside.
Character bar(uint32_t rings) {
  Character c;
  c.name = "bar";
  for (uint32_t r = 0; r < rings; ++r) {
    const float x = 2.0f * static_cast<float>(r) / static_cast<float>(rings - 1);
    for (const auto& [y, z] : {std::pair{0.1f, 0.1f}, {-0.1f, 0.1f}, {-0.1f, -0.1f}, {0.1f, -0.1f}})
      c.vertices.push_back({x, y, z});
  }
  for (uint32_t r = 0; r + 1 < rings; ++r) {
    for (uint32_t i = 0; i < 4; ++i) {
      const uint32_t a = 4 * r + i, b = 4 * r + (i + 1) % 4;
      c.face_vertices.insert(c.face_vertices.end(), {a, b, b + 4, a + 4});
      c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
    }
  }
  c.joints = {{"a", {0, 0, 0}, -1}, {"b", {1, 0, 0}, 0}, {"c", {2, 0, 0}, 1}};
  return c;
}

TEST(Bind, InfluencesSayWhatTheRawRowsSay) {
  const Character character = bar(9);
  BindOptions options;
  options.influence_count = 2;
  const BindResult result = bind(character, options);
  ASSERT_EQ(result.joints.size(), 2 * character.vertices.size());
  ASSERT_EQ(result.weights.size(), result.joints.size());
  ASSERT_EQ(result.influences.size(), character.vertices.size());
  ASSERT_EQ(result.confidence.size(), character.vertices.size());
  for (size_t v = 0; v < character.vertices.size(); ++v) {
    const std::vector<Influence>& row = result.influences[v];
    EXPECT_EQ(row.size(), result.weights[2 * v + 1] == 0 ? 1u : 2u);
    EXPECT_EQ(result.weights[2 * v] + result.weights[2 * v + 1], 65535);
    for (size_t i = 0; i < row.size(); ++i) {
      EXPECT_EQ(row[i].joint, result.joints[2 * v + i]);
      EXPECT_EQ(row[i].weight, static_cast<float>(result.weights[2 * v + i]) / 65535.0f);
    }
  }
  EXPECT_GT(result.used_bytes, 0u);
  EXPECT_LE(result.used_bytes, result.workspace_bytes);
}

TEST(Bind, LockedAndHintedRowsStay) {
  Character character = bar(9);
  character.influences.assign(character.vertices.size(), {});
  character.influences[5] = {{0, 1.0f}, {2, 3.0f}};
  character.influences[30] = {{0, 0.5f}};
  BindOptions options;
  options.locked.assign(character.vertices.size(), 0);
  options.hints = options.locked;
  options.locked[5] = options.hints[30] = 1;
  const BindResult result = bind(character, options);
  ASSERT_EQ(result.influences[5].size(), 2u);
  EXPECT_EQ(result.influences[5][0].joint, 2u);
  EXPECT_NEAR(result.influences[5][0].weight, 0.75f, 1e-4f);
  ASSERT_EQ(result.influences[30].size(), 1u);
  EXPECT_EQ(result.influences[30][0].joint, 0u);
  EXPECT_EQ(result.confidence[5], 255);
  EXPECT_EQ(result.confidence[30], 255);
}

TEST(Bind, RefusalsNameTheCharacter) {
  Character character = bar(9);
  BindOptions options;
  options.locked.assign(character.vertices.size(), 1);
  EXPECT_ERROR(bind(character, options), "bar: ", "the mesh has no weights");
  options.locked.clear();
  options.influence_count = SINEW_MAX_INFLUENCES + 1;
  EXPECT_ERROR(bind(character, options), "bar: ", sinew_status_text(SINEW_ERROR_ARGUMENT));
  character.joints.clear();
  EXPECT_ERROR(bind(character, {}), "bar: ", "no skeleton");
}

// The environment is put back, whatever the test finds.
class KernelFromEnvironment : public testing::Test {
 protected:
  void SetUp() override {
    const char* const before = std::getenv("SINEW_KERNEL");
    if (before != nullptr) before_ = before;
  }
  void TearDown() override { set(before_); }
  static void set(const std::string& kernel) { setenv("SINEW_KERNEL", kernel.c_str(), 1); }

 private:
  std::string before_;
};

TEST_F(KernelFromEnvironment, NamesOrRefuses) {
  set("");
  EXPECT_EQ(kernel_from_environment(), uint32_t{SINEW_KERNEL_AUTO});
  set("ref");
  EXPECT_EQ(kernel_from_environment(), uint32_t{SINEW_KERNEL_REF});
  set("abacus");
  EXPECT_ERROR(kernel_from_environment(), "SINEW_KERNEL=abacus", "expected one of", "ref");
  EXPECT_ERROR(bind(bar(3), {}), "abacus");
}

// Rows cut and rounded as the engine does it: exact sums, falling weights, nothing from nothing.

int units(const Influence& influence) { return static_cast<int>(std::lround(influence.weight * 65535.0f)); }

TEST(RoundInfluences, KeepsTheLargestWithAnExactSum) {
  const std::vector<Influence> rounded = round_influences({{7, 0.1f}, {3, 0.3f}, {9, 0.05f}, {1, 0.3f}}, 3);
  ASSERT_EQ(rounded.size(), 3u);
  EXPECT_EQ(rounded[0].joint, 1u);  // ties by the lower joint
  EXPECT_EQ(rounded[1].joint, 3u);
  EXPECT_EQ(rounded[2].joint, 7u);
  EXPECT_EQ(units(rounded[0]) + units(rounded[1]) + units(rounded[2]), 65535);
  EXPECT_NEAR(units(rounded[2]), 65535 / 7, 1);
}

// Weights of a bind that a file gave back stay as they are, whatever is locked.
TEST(RoundInfluences, ExactRowsStayAsTheyAre) {
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    std::vector<int> cuts = {0, 65535};
    for (int i = 0; i < 3; ++i) cuts.push_back(static_cast<int>(random() % 65536));
    std::sort(cuts.begin(), cuts.end());
    std::vector<int> expected(5, 0);
    std::vector<Influence> row;
    for (size_t i = 0; i < 4; ++i) {
      expected[i] = cuts[i + 1] - cuts[i];
      row.push_back({static_cast<uint32_t>(i), static_cast<float>(expected[i]) / 65535.0f});
    }
    for (const Influence& influence : round_influences(row, 4))
      ASSERT_EQ(units(influence), expected[influence.joint]) << "row " << round << ", joint " << influence.joint;
  }
}

TEST(RoundInfluences, OneJointGetsEverything) {
  const std::vector<Influence> rounded = round_influences({{4, 0.02f}}, 4);
  ASSERT_EQ(rounded.size(), 1u);
  EXPECT_EQ(rounded[0].joint, 4u);
  EXPECT_EQ(rounded[0].weight, 1.0f);
}

TEST(RoundInfluences, NothingFromNothing) {
  EXPECT_TRUE(round_influences({}, 4).empty());
  EXPECT_TRUE(round_influences({{2, 0.0f}}, 4).empty());
}

}  // namespace
}  // namespace sinew
