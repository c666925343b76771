// SPDX-License-Identifier: MIT
// Groups of families, how they are dealt to folds, and the means and files of a cross-family validation.
#include "sinew_trainer/crossval.hpp"

#include <gtest/gtest.h>

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
  const FamilyGroups groups = read_family_groups(
      folder.write("groups.json", R"({"groups": {"men": ["q_men", "q_knight"]}, "apart": ["men"]})"));
  EXPECT_EQ(groups.group("q_knight"), "men");
  EXPECT_EQ(groups.group("q_men19"), "q_men");
  EXPECT_EQ(groups.apart, std::set<std::string>{"men"});
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

CrossvalReport two_seeds() {
  CrossvalReport report;
  report.label = "a|b";
  report.config_json = "{}";
  report.fold_count = 2;
  for (uint64_t s = 1; s <= 2; ++s) {
    CrossvalSeed seed;
    seed.seed = s;
    const double shift = s == 1 ? 0 : 0.02;
    seed.families = {{"men", "men", 1, 4, {0.2 + shift, 0.9, 0.002, 0.3, 0.8, 0.003}},
                     {"mh_train", "mh", 2, 100, {0.5 + shift, 0.7, 0.004, 0.6, 0.6, 0.005}},
                     {"tank", "tank", 2, 1, {1.1 + shift, 0.3, 0.01, 1.0, 0.4, 0.02}}};
    seed.val = {{"alien", "alien", 0, 1, {0.1, 0.95, 0.001, 0.2, 0.9, 0.002}},
                {"dino", "dino", 0, 3, {0.3, 0.75, 0.003, 0.4, 0.7, 0.004}}};
    report.seeds.push_back(seed);
  }
  report.apart = {"mh"};
  return report;
}

TEST(CrossvalReport, MeansCountEachFamilyOnce) {
  const CrossvalMeans m = crossval_means(two_seeds());
  EXPECT_EQ(m.families, 3u);
  EXPECT_NEAR(m.all.l1, 1.83 / 3, 1e-12);
  EXPECT_NEAR(m.all.heat_l1, 1.9 / 3, 1e-12);
  EXPECT_NEAR(m.outside.l1, (0.21 + 1.11) / 2, 1e-12);
  EXPECT_NEAR(m.outside.argmax, 0.6, 1e-12);
  EXPECT_EQ(m.worse, 1u);
  EXPECT_EQ(m.worst_family, "tank");
  EXPECT_NEAR(m.worst_difference, 0.11, 1e-12);
  EXPECT_NEAR(m.spread, 0.02, 1e-12);
  EXPECT_NEAR(m.val.l1, 0.25, 1e-12) << "mean of 4 characters";
  EXPECT_NEAR(m.val_families.l1, 0.2, 1e-12);
}

TEST(CrossvalReport, JsonComesBackAndCompares) {
  const TempFolder folder;
  const CrossvalReport report = two_seeds();
  const CrossvalReport back = read_crossval(folder.write("crossval.json", crossval_json(report)));
  EXPECT_EQ(crossval_markdown(back), crossval_markdown(report));
  EXPECT_EQ(crossval_csv(back), crossval_csv(report));
  EXPECT_EQ(crossval_json(read_crossval(folder.path())), crossval_json(report)) << "a folder stands for its report";

  CrossvalReport other = report;
  other.label = "fewer";
  for (CrossvalSeed& seed : other.seeds) seed.families.pop_back();
  const std::string same = crossval_comparison({report, back}), different = crossval_comparison({report, other});
  EXPECT_NE(same.find("| a\\|b | 2 | 0.6100 ± 0.0100 | 3.7 %"), std::string::npos) << same;
  EXPECT_EQ(same.find("Not comparable"), std::string::npos);
  EXPECT_NE(different.find("Not comparable: fewer has 2 families"), std::string::npos) << different;
  EXPECT_ERROR(read_crossval(folder.write("x.json", "{}")), "x.json", "not written by sinew crossval");
  EXPECT_ERROR(read_crossval(folder.write("y.json", R"({"crossval": 1})")), "y.json", "label");
}

}  // namespace
}  // namespace sinew
