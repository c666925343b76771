// SPDX-License-Identifier: MIT
// How often families and their characters are drawn.
#include "data/family_queue.hpp"

#include <gtest/gtest.h>

#include <map>

namespace sinew {
namespace {

TEST(FamilyQueue, FamiliesAreDrawnByThePowerOfTheirSizeAndMembersEqually) {
  std::vector<std::string> families(100, "many");
  families.insert(families.end(), 4, "few");
  Random random(1);
  std::map<uint32_t, int> count;
  size_t draws = 0;
  for (int round = 0; round < 400; ++round) {
    for (uint32_t character : draw_round(families, 0.5, {}, &random)) {
      ++count[character];
      ++draws;
    }
  }
  int few = 0;
  for (uint32_t i = 100; i < 104; ++i) few += count[i];
  const double share = 2.0 / 12.0;  // sqrt(4) / (sqrt(100) + sqrt(4))
  EXPECT_NEAR(static_cast<double>(few) / static_cast<double>(draws), share, 0.005);
  for (uint32_t i = 100; i < 104; ++i) EXPECT_NEAR(count[i], few / 4.0, 0.1 * few / 4.0);
  for (uint32_t i = 0; i < 100; ++i) EXPECT_GT(count[i], 200);
}

TEST(FamilyQueue, ANamedFamilyHasItsShare) {
  std::vector<std::string> families(100, "many");
  families.insert(families.end(), 4, "few");
  families.insert(families.end(), 9, "some");
  Random random(2);
  std::map<std::string, int> count;
  size_t draws = 0;
  for (int round = 0; round < 400; ++round) {
    for (uint32_t character : draw_round(families, 0.5, {{"many", 0.25}, {"absent", 0.5}}, &random)) {
      ++count[families[character]];
      ++draws;
    }
  }
  const auto share = [&](const char* name) { return count[name] / static_cast<double>(draws); };
  EXPECT_NEAR(share("many"), 0.25, 0.005);
  EXPECT_NEAR(share("few"), 0.75 * 2 / 5, 0.005);
  EXPECT_NEAR(share("some"), 0.75 * 3 / 5, 0.005);
}

}  // namespace
}  // namespace sinew
