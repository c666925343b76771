// SPDX-License-Identifier: MIT
// Groups of families, by rule and by file, how they are dealt to folds, and how often they and their characters are drawn.
#include "sinew_trainer/family_groups.hpp"

#include <gtest/gtest.h>

#include <map>

#include "core/random.hpp"
#include "expect_error.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

TEST(FamilyGroups, TheRuleStripsDigitsAndKeepsMakeHumanTogether) {
  const FamilyGroups groups;
  EXPECT_EQ(groups.group("q_men19"), "q_men");
  EXPECT_EQ(groups.group("q_men"), "q_men");
  EXPECT_EQ(groups.group("mh_train"), groups.group("mh_ponytail_val"));
  EXPECT_EQ(groups.group("2024"), "2024");
}

TEST(FamilyGroups, AFileOverrulesTheRule) {
  const TempFolder folder;
  const FamilyGroups groups =
      read_family_groups(folder.write("groups.json", R"({"groups": {"men": ["q_men", "q_knight"]}, "apart": ["men"],
          "means": {"people": ["men", "women"]}})"));
  EXPECT_EQ(groups.group("q_knight"), "men");
  EXPECT_EQ(groups.group("q_men19"), "q_men");
  EXPECT_EQ(groups.apart, std::set<std::string>{"men"});
  EXPECT_EQ(groups.means.at("people"), (std::set<std::string>{"men", "women"}));
  EXPECT_ERROR(read_family_groups(folder.write("m.json", R"({"means": {"people": []}})")), "mean people",
               "at least one group");
  EXPECT_ERROR(read_family_groups(folder.write("a.json", R"({"groups": {"a": ["x"], "b": ["x"]}})")), "a.json",
               "group b", "x is in a too");
  EXPECT_ERROR(read_family_groups(folder.write("b.json", R"({"group": {}})")), "unknown key \"group\"");
  EXPECT_ERROR(read_family_groups(folder.write("c.json", R"({"groups": {"a": "x"}})")), "group a", "list of names");
  EXPECT_ERROR(read_family_groups(folder.write("d.json", "{")), "d.json: not JSON");
}

TEST(FamilyGroups, TheShippedFileIsReadable) {
  const FamilyGroups groups = read_family_groups(SINEW_SOURCE_DIR "/trainer/configs/groups.json");
  EXPECT_EQ(groups.group("q_man17"), groups.group("q_men"));
  EXPECT_EQ(groups.apart.count(groups.group("mh_train")), 1u);
  EXPECT_EQ(groups.means.at("old").count(groups.group("q_man17")), 1u);
  EXPECT_EQ(groups.means.at("old").count(groups.group("rocketbox")), 0u);
}

TEST(Folds, KeepGroupsWholeAndHoldAboutAsManyFamilies) {
  std::map<std::string, size_t> families = {{"mh_a", 100}, {"mh_b", 10}, {"men", 9},  {"men19", 4}, {"men20", 1},
                                            {"cube", 13},  {"fish", 3},  {"tank", 2}, {"robot", 1}};
  const FamilyGroups groups;
  const auto folds = make_folds(families, groups, 3);
  EXPECT_EQ(folds, make_folds(families, groups, 3));
  ASSERT_EQ(folds.size(), 3u);
  std::map<std::string, size_t> fold_of_group;
  size_t count = 0;
  for (size_t f = 0; f < folds.size(); ++f) {
    EXPECT_EQ(folds[f].size(), 3u);
    for (const std::string& family : folds[f]) {
      ++count;
      EXPECT_EQ(fold_of_group.try_emplace(groups.group(family), f).first->second, f) << family;
    }
  }
  EXPECT_EQ(count, families.size());
  EXPECT_ERROR(make_folds(families, groups, 7), "7 folds", "found 6");
  EXPECT_ERROR(make_folds(families, groups, 1), "at least 2");
}

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
