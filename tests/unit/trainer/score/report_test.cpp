// SPDX-License-Identifier: MIT
// The report page: well formed, needs nothing from a network, shows every variant and character, whatever their names.
#include "sinew_trainer/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

Metrics with_l1(double l1) {
  Metrics m;
  m.l1 = l1;
  m.avg_dist = l1 / 10;
  m.argmax = 1 - l1;
  m.vertices = 100;
  return m;
}

ReportVariant variant(const std::string& label, int bits, double worse) {
  ReportVariant v;
  v.label = label;
  v.bits = bits;
  v.scores = summarize({{"robots__one", with_l1(0.2 + worse)},
                        {"robots__<b>two</b>", with_l1(0.5 + worse)},
                        {"fish & co__three", with_l1(0.1 + worse)}});
  if (bits > 0 && bits < 32) v.argmax_flips = worse;
  return v;
}

ReportData full() {
  ReportData data;
  data.summary = "What <fewer> bits cost.";
  data.facts = {{"data", "val & more"}};
  data.variants = {variant("float \"checkpoint\"", 32, 0), variant("int16 model", 16, 0.001),
                   variant("8 bits", 8, 0.03), variant("heat", 0, 0.1)};
  data.variants[1].size_bytes = 44000;
  data.variants[1].logit_snr_db = 61.25;
  data.variants[2].scores.failures["robots__<b>bad</b>"] = "no <influences>";
  data.variants[0].pose_distances = {{"robots__one", {0.01, 0.02}}, {"fish & co__three", {0.005, 0.001}}};
  data.variants[3].pose_distances = {{"robots__one", {0.03, 0.04}}};
  data.reliability = reliability({{"robots", {230, 204, 77}, {1, 1, 0}}});
  data.confidence = "the <largest> weight";
  data.integers.emplace();
  data.integers->add({{{0, 1.0f}}}, {{{0, 0.9f}, {1, 0.1f}}});
  data.beaten_by_nearest = {{"robots__<b>two</b>", 0.0314}};
  data.pictures = {{"best", "fish & co__three", "L1 0.1", {{"reference weights", {1, 2, 3, 4}}}}};
  return data;
}

// Every tag that is opened is closed in order; text holds no stray angle bracket. Returns what is wrong.
std::string first_fault(const std::string& html) {
  std::vector<std::string> open;
  size_t at = 0;
  if (html.compare(0, 15, "<!DOCTYPE html>") == 0) at = 15;
  for (; at < html.size(); ++at) {
    if (html[at] == '>') return "stray > near " + html.substr(at > 40 ? at - 40 : 0, 60);
    if (html[at] == '&') {
      const size_t end = html.find(';', at);
      if (end == std::string::npos || end - at > 7) return "bare & near " + html.substr(at, 40);
    }
    if (html[at] != '<') continue;
    const size_t end = html.find('>', at);
    if (end == std::string::npos) return "tag without end";
    const std::string tag = html.substr(at + 1, end - at - 1);
    if (tag.empty() || tag.find('<') != std::string::npos) return "stray < near " + html.substr(at, 40);
    if (std::count(tag.begin(), tag.end(), '"') % 2) return "odd quotes in <" + tag + ">";
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return "unexpected <" + tag + ">";
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
      if (open.back() == "style") {  // CSS is not markup
        at = html.find("</style>", end) - 1;
        continue;
      }
    }
    at = end;
  }
  return open.empty() ? "" : "never closed: <" + open.back() + ">";
}

TEST(Report, IsWellFormedAndSelfContained) {
  const std::string html = report_html(full());
  EXPECT_EQ(first_fault(html), "");
  for (const char* outside : {"http:", "https:", "src=\"//", "<script", "<link", "@import", "url("})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  EXPECT_NE(html.find("data:image/png;base64,AQIDBA=="), std::string::npos);
}

TEST(Report, CheckerOfThisTestFindsFaults) {
  EXPECT_NE(first_fault("<p><b>x</p></b>"), "");
  EXPECT_NE(first_fault("<p>a < b</p>"), "");
  EXPECT_NE(first_fault("<p>a & b</p>"), "");
  EXPECT_NE(first_fault("<p>"), "");
  EXPECT_EQ(first_fault("<p>x<br />&amp;</p>"), "");
}

TEST(Report, ShowsEveryVariantAndCharacterEscaped) {
  const std::string html = report_html(full());
  for (const char* text :
       {"float &quot;checkpoint&quot;", "int16 model", "8 bits", "heat", "robots__one",
        "robots__&lt;b&gt;two&lt;/b&gt;", "fish &amp; co__three", "What &lt;fewer&gt; bits cost.", "val &amp; more",
        "the &lt;largest&gt; weight", "Deformation of every character", "int16 against float", "0.0314",
        "no &lt;influences&gt;", "robots__&lt;b&gt;bad&lt;/b&gt;", "61.2", "44000"})
    EXPECT_NE(html.find(text), std::string::npos) << text;
  EXPECT_NE(html.find("L1 against bits"), std::string::npos);
  EXPECT_NE(html.find("stroke-dasharray"), std::string::npos) << "the level of the variant without bits";
}

TEST(Report, WorksWithOneVariantOneCharacterAndNone) {
  ReportData data;
  EXPECT_THROW(report_html(data), Error);
  data.variants.resize(1);
  data.variants[0].label = "only";
  EXPECT_EQ(first_fault(report_html(data)), "");
  data.variants[0].scores = summarize({{"lonely", with_l1(0.3)}});
  const std::string html = report_html(data);
  EXPECT_EQ(first_fault(html), "");
  EXPECT_NE(html.find("lonely"), std::string::npos);
  EXPECT_EQ(html.find("L1 against bits"), std::string::npos);
  EXPECT_EQ(html.find("flips %"), std::string::npos) << "a column that nobody fills";
  EXPECT_EQ(html.find("nan"), std::string::npos);
  EXPECT_EQ(html.find("int16 against float"), std::string::npos);
  EXPECT_EQ(html.find("honest"), std::string::npos);
  EXPECT_EQ(html.find("Where nearest bone"), std::string::npos);
  data.beaten_by_nearest.emplace();
  EXPECT_NE(report_html(data).find("better on no character"), std::string::npos);
  data.main_variant = 1;
  EXPECT_THROW(report_html(data), Error);
}

TEST(Report, PicksBestMedianAndWorst) {
  const auto picked = best_median_worst(variant("v", 0, 0).scores);
  ASSERT_EQ(picked.size(), 3u);
  EXPECT_EQ(picked[0], (std::pair<std::string, std::string>{"best", "fish & co__three"}));
  EXPECT_EQ(picked[1].second, "robots__one");
  EXPECT_EQ(picked[2].second, "robots__<b>two</b>");
  EXPECT_TRUE(best_median_worst({}).empty());
}

TEST(Report, MarkdownTableNamesTheWorstCharacter) {
  ReportData data = full();
  data.variants[0].label = "a|b";
  const std::string text = quantization_table_markdown(data);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 6);
  EXPECT_NE(text.find("| a\\|b | 0.2667 |"), std::string::npos) << text;
  EXPECT_NE(text.find("robots__<b>two</b> (0.501) |\n"), std::string::npos) << text;
  EXPECT_NE(text.find("| 61.2 | 44000 |"), std::string::npos) << text;
}

TEST(Report, DrawsACharacterInSixPanels) {
  Character c;
  c.name = "F__x";
  c.joints = {{"a", {0, 0, 0}, -1}, {"b", {1, 0, 0}, 0}};
  c.vertices = {{0, 0.1f, 0}, {1, 0.1f, 0}, {2, 0.4f, 0}};
  c.face_offsets = {0, 3};
  c.face_vertices = {0, 1, 2};
  c.influences = {{{0, 1.0f}}, {{0, 0.5f}, {1, 0.5f}}, {{1, 1.0f}}};
  const ReportPicture picture = report_picture(c, {{{0, 1.0f}}, {{0, 1.0f}}, {{1, 1.0f}}}, "worst", Axis::kY, 64);
  EXPECT_EQ(picture.character, "F__x");
  EXPECT_NE(picture.note.find("L1 0.333"), std::string::npos) << picture.note;
  ASSERT_EQ(picture.panels.size(), 6u);
  for (const auto& panel : picture.panels) {
    ASSERT_GT(panel.png.size(), 100u);
    EXPECT_EQ(std::memcmp(panel.png.data() + 1, "PNG", 3), 0);
  }
  EXPECT_NE(picture.panels[0].png, picture.panels[1].png);
  EXPECT_NE(picture.panels[3].png, picture.panels[4].png) << "other weights, another skin";
  const ReportPicture perfect = report_picture(c, c.influences, "best", Axis::kY, 64);
  EXPECT_EQ(perfect.panels[0].png, perfect.panels[1].png);
  EXPECT_EQ(perfect.panels[3].png, perfect.panels[4].png);
}

}  // namespace
}  // namespace sinew
