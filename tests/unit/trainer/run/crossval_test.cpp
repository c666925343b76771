// SPDX-License-Identifier: MIT
// Means and files of a cross-family validation.
#include "sinew_trainer/crossval.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "temp_folder.hpp"

namespace sinew {
namespace {

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
  report.means = {{"old", {"men", "tank"}}, {"unseen", {"none"}}};
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
  ASSERT_EQ(m.named.size(), 1u) << "a mean without families is not shown";
  EXPECT_EQ(m.named[0].name, "old");
  EXPECT_EQ(m.named[0].characters, 5u);
  EXPECT_NEAR(m.named[0].figures.l1, (0.21 + 1.11) / 2, 1e-12);
  EXPECT_EQ(m.named[0].worst_family, "tank");
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
  EXPECT_NE(same.find("| 0.6600 | -1.5 % | tank +0.110 |"), std::string::npos) << same;
  EXPECT_NE(crossval_markdown(report).find("| **mean of the 2 of old** | | 5 | 0.660 | 0.650 |"), std::string::npos);
  EXPECT_EQ(same.find("Not comparable"), std::string::npos);
  EXPECT_NE(different.find("Not comparable: fewer has 2 families"), std::string::npos) << different;
  EXPECT_ERROR(read_crossval(folder.write("x.json", "{}")), "x.json", "not written by sinew-lab crossval");
  EXPECT_ERROR(read_crossval(folder.write("y.json", R"({"crossval": 1})")), "y.json", "label");
}

}  // namespace
}  // namespace sinew
