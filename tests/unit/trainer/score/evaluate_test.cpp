// SPDX-License-Identifier: MIT
// The yardstick's figures on a strip of three vertices, worked out by hand, and the means and tables made of them.
#include "sinew_trainer/evaluate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_trainer/fold_targets.hpp"

namespace sinew {
namespace {

using Prediction = std::vector<std::vector<Influence>>;

Character strip() {
  Character c;
  c.name = "F__x";
  c.joints = {{"a", {0, 0, 0}, -1}, {"b", {1, 0, 0}, 0}, {"e", {2, 0, 0}, 1}};
  c.vertices = {{0, 0.1f, 0}, {1, 0.1f, 0}, {2, 0.1f, 0}};
  c.face_offsets = {0, 3};
  c.face_vertices = {0, 1, 2};
  c.influences = {{{0, 1.0f}}, {{0, 0.5f}, {1, 0.5f}}, {{1, 1.0f}}};
  return c;
}

// Vertex 0 right (not normalized), vertex 1 all on a, vertex 2 split between b and the end joint e.
Prediction off() { return {{{0, 2.0f}}, {{0, 1.0f}}, {{1, 0.75f}, {2, 0.25f}}}; }

TEST(Measure, TheReferenceItselfIsPerfect) {
  const Character c = strip();
  const Metrics m = measure(c, c.influences, c.name);
  EXPECT_EQ(m.precision, 1);
  EXPECT_EQ(m.recall, 1);
  EXPECT_EQ(m.l1, 0);
  EXPECT_EQ(m.max_dist_all, 0);
  EXPECT_EQ(m.argmax, 1);
  EXPECT_EQ(m.kl, 0);
  EXPECT_EQ(m.vertices, 3u);
  EXPECT_EQ(m.joints, 3u);
}

TEST(Measure, EndJointsFoldAndTiesCount) {
  const Character c = strip();
  std::vector<float> errors;
  const Metrics m = measure(c, off(), c.name, 10, &errors);
  EXPECT_DOUBLE_EQ(m.precision, 1);
  EXPECT_DOUBLE_EQ(m.recall, 0.75);
  EXPECT_NEAR(m.l1, 1.0 / 3, 1e-7);
  EXPECT_NEAR(m.l1_file, (0 + 1 + 0.5) / 3, 1e-7) << "a quarter of vertex 2 lies on e";
  EXPECT_DOUBLE_EQ(m.bad, 1.0 / 3);
  EXPECT_DOUBLE_EQ(m.argmax, 1);
  EXPECT_DOUBLE_EQ(m.influences, 1);
  EXPECT_NEAR(m.kl, (0.5 * std::log(0.5) + 0.5 * std::log(0.5 / 1e-4)) / 3, 1e-7);
  EXPECT_EQ(errors, (std::vector<float>{0, 1, 0}));

  // Vertex 1 sits 0.05 (scaled) over joint b: half of b's turn reaches it in the reference, none in the prediction.
  double mean = 0, largest = 0;
  for (const auto& palette : random_poses(c, c.name, {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}})) {
    const Affine& b = palette[1];
    const double dx = b[1] * 0.05, dy = b[5] * 0.05 - 0.05, dz = b[9] * 0.05;
    const double moved = 0.5 * std::sqrt(dx * dx + dy * dy + dz * dz);
    mean += moved / 10;
    largest = std::max(largest, moved);
  }
  EXPECT_GT(mean, 1e-3);
  EXPECT_NEAR(m.max_dist, mean, 1e-8);
  EXPECT_NEAR(m.avg_dist, mean / 3, 1e-8);
  EXPECT_NEAR(m.max_dist_all, largest, 1e-8);
}

TEST(Measure, ABoundLeafIsNoEnd) {
  Character c = strip();
  c.influences[2] = {{1, 0.9f}, {2, 0.1f}};
  EXPECT_EQ(fold_targets(c), (std::vector<uint32_t>{0, 1, 2}));
  const Metrics m = measure(c, off(), c.name);
  EXPECT_NEAR(m.l1, (0 + 1 + 0.3) / 3, 1e-6);
  EXPECT_DOUBLE_EQ(m.l1_file, m.l1) << "there is nothing to fold";
}

TEST(Measure, AnEmptyRowCountsOneAndStays) {
  const Character c = strip();
  const Metrics m = measure(c, Prediction(3), c.name);
  EXPECT_DOUBLE_EQ(m.l1, 1);
  EXPECT_DOUBLE_EQ(m.unweighted, 1);
  EXPECT_DOUBLE_EQ(m.argmax, 0);
  EXPECT_DOUBLE_EQ(m.recall, 0);
  EXPECT_GT(m.avg_dist, 0);
}

TEST(Measure, VerticesWithoutReferenceAreLeftOut) {
  Character c = strip();
  c.influences[1].clear();
  const Metrics m = measure(c, off(), c.name);
  EXPECT_EQ(m.unbound, 1u);
  EXPECT_EQ(m.l1, 0);
}

TEST(Measure, AreaWeighsLargeFacesMore) {
  Character c = strip();
  c.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  c.face_offsets = {0, 3, 6};
  c.face_vertices = {0, 1, 2, 3, 4, 5};  // areas 2 and 0.5
  c.influences.assign(6, {{0, 0.5f}, {1, 0.5f}});
  Prediction wrong = c.influences;
  for (size_t v = 3; v < 6; ++v) wrong[v] = {{1, 1.0f}};
  EXPECT_DOUBLE_EQ(measure(c, wrong, c.name).l1, 0.5);
  EXPECT_DOUBLE_EQ(measure(c, wrong, c.name).l1_area, 0.5 / 2.5);
}

TEST(Measure, RefusesWhatDoesNotFit) {
  Character c = strip();
  EXPECT_THROW(measure(c, Prediction(2), c.name), Error);
  EXPECT_THROW(measure(c, {{{3, 1.0f}}, {}, {}}, c.name), Error);
  c.influences.assign(3, {});
  EXPECT_THROW(measure(c, off(), c.name), Error);
  c.influences.clear();
  EXPECT_THROW(measure(c, off(), c.name), Error);
}

Metrics with_l1(double l1, double seconds, size_t vertices) {
  Metrics m;
  m.l1 = l1;
  m.l1_file = 1.5 * l1;
  m.seconds = seconds;
  m.vertices = vertices;
  return m;
}

Scores four() {
  return summarize({{"b__2", with_l1(0.4, 4, 1000)},
                    {"a__1", with_l1(0.1, 1, 500)},
                    {"a__3", with_l1(0.2, 0, 10)},
                    {"a__2", with_l1(0.3, 2, 4000)}});
}

TEST(Scores, MeansOverCharactersAndOverFamilies) {
  const Scores s = four();
  EXPECT_EQ(s.characters.front().first, "a__1");
  EXPECT_DOUBLE_EQ(s.all.l1, 0.25);
  EXPECT_DOUBLE_EQ(s.families.at("a").l1, 0.2);
  EXPECT_DOUBLE_EQ(s.family_mean.l1, 0.3);
  EXPECT_DOUBLE_EQ(s.all.seconds, 2);  // the median of those that were timed
  EXPECT_DOUBLE_EQ(s.families.at("a").seconds, 1.5);
  EXPECT_TRUE(summarize({}).characters.empty());
}

TEST(Scores, MarkdownHasTheYardsticksColumnsAndTheFigureOfTheFile) {
  Scores s = four();
  s.failures["c__9"] = "no prediction";
  const std::string text = scores_markdown("our|binder", s);
  EXPECT_NE(
      text.find("| method | n | prec % | rec % | L1 | L1 in file | avg dist | max dist | argmax % | KL | L1>0.5 % | "
                "fail | s/char | s/1k vert |\n"),
      std::string::npos);
  EXPECT_NE(
      text.find(
          "| our\\|binder | 4 | 0.0 | 0.0 | 0.250 | 0.375 | 0.0000 | 0.000 | 0.0 | 0.00 | 0.0 | 1 | 2.00 | 2.00 |\n"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("**mean of the 3 families**"), std::string::npos);
  EXPECT_NE(text.find("| our\\|binder | 0 | - | - | - | - | - | - | - | - | - | 1 | - | - |\n"), std::string::npos)
      << text;
}

TEST(Scores, JsonHoldsEveryNumber) {
  Scores s = four();
  s.failures["c__9"] = "a \"quoted\" note";
  const auto json = nlohmann::json::parse(scores_json("x", s)).at("x");
  EXPECT_DOUBLE_EQ(json.at("all").at("l1"), 0.25);
  EXPECT_DOUBLE_EQ(json.at("all").at("l1_file"), 0.375);
  EXPECT_EQ(json.at("all").at("characters"), 4);
  EXPECT_DOUBLE_EQ(json.at("all").at("seconds_per_1000"), 2);
  EXPECT_DOUBLE_EQ(json.at("families").at("b").at("l1"), 0.4);
  EXPECT_EQ(json.at("characters").at("a__2").at("vertices"), 4000);
  EXPECT_TRUE(json.at("characters").at("a__3").at("seconds").is_null());
  EXPECT_EQ(json.at("failures").at("c__9"), "a \"quoted\" note");
  EXPECT_EQ(json.at("references"), 5);
}

}  // namespace
}  // namespace sinew
