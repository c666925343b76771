// SPDX-License-Identifier: MIT
// Statistics of a data set, and the page that shows them.
#include "sinew_data_sets/dataset_page.hpp"

#include <gtest/gtest.h>

#include "expect_error.hpp"
#include "sinew_data_sets/synthesize.hpp"

namespace sinew {
namespace {

Character made(uint64_t seed) { return synthesize({BodyPlan::kQuadruped, seed, 24}); }

TEST(DatasetPage, ShowsFamiliesCharactersAndWarningsEscaped) {
  DatasetStats stats;
  stats.folder = "a <folder>";
  stats.candidate_counts = {6, 8};
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    CharacterStats one = character_stats(made(seed));
    one.family = seed == 3 ? "b&b" : "a";
    one.name = one.family + "__" + std::to_string(seed);
    one.recall = {0.5, 0.75};
    stats.characters.push_back(one);
  }
  stats.characters[0].png = {1, 2, 3};
  stats.characters[0].report.findings.push_back({CheckFinding::Level::kWarning, "odd-vertex", 1, "<one>"});
  stats.unreadable = {{"c.obj", "c.obj: line 1"}};
  const std::string html = dataset_html(stats);
  for (const char* text : {"a &lt;folder&gt;", "b&amp;b (1)", "a (2)", "odd-vertex: &lt;one&gt;", "75.00", "AQID",
                           "c.obj: line 1", "1 warning"})
    EXPECT_NE(html.find(text), std::string::npos) << text;
  for (const char* outside : {"http:", "https:", "<script", "<link", "url(", "nan", "inf\""})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  const std::string table = dataset_table(stats);
  EXPECT_NE(table.find("recall@8"), std::string::npos);
  EXPECT_NE(table.find("(all)"), std::string::npos);
  EXPECT_NE(dataset_json(stats).find("\"8\": 0.75"), std::string::npos) << dataset_json(stats);
  EXPECT_ERROR(dataset_html({}), "no character");
}

TEST(DatasetPage, CountsInfluences) {
  Character c = made(1);
  c.influences.assign(c.vertices.size(), {{0, 0.5f}, {1, 0.5f}});
  c.influences[0].clear();
  c.influences[1] = {{2, 1.0f}};
  const CharacterStats stats = character_stats(c);
  EXPECT_EQ(stats.bound_joints, 3u);
  EXPECT_EQ(stats.vertices_with[0], 1u);
  EXPECT_EQ(stats.vertices_with[1], 1u);
  EXPECT_EQ(stats.vertices_with[2], c.vertices.size() - 2);
  EXPECT_NEAR(stats.influences_per_vertex(), 2, 0.01);
}

}  // namespace
}  // namespace sinew
