// SPDX-License-Identifier: MIT
// The page on skeletons: every character with both pictures, the worst first, whatever the names.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sinew_trainer/rig_score.hpp"

namespace sinew {
namespace {

RigScore with_j2j(double j2j) {
  RigScore score;
  score.j2j = j2j;
  score.joined = std::numeric_limits<double>::quiet_NaN();
  return score;
}

size_t count_of(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(RigReport, ShowsEveryCharacterTheWorstFirst) {
  RigReport report;
  report.scores = summarize({{"toys__good", with_j2j(0.01)}, {"toys__<b>bad</b>", with_j2j(0.09)}});
  report.scores.humanoids["toys__good"] = {"no head in the middle"};
  report.scores.failures["toys__gone"] = "gone.obj: not there & never was";
  report.facts = {{"command", "sinew-lab eval toys --task rig"}};
  report.pictures = {{"toys__good", {1, 2, 3}, {4, 5, 6}}, {"toys__<b>bad</b>", {7}, {8}}};
  const std::string page = rig_report_html(report);
  EXPECT_EQ(page.find("<b>bad</b>"), std::string::npos) << "names are text";
  EXPECT_EQ(count_of(page, "<figure>"), 4u);
  EXPECT_LT(page.find("<h3>toys__&lt;b&gt;bad"), page.find("<h3>toys__good"));
  EXPECT_NE(page.find("J2J 9.00"), std::string::npos);
  EXPECT_NE(page.find("no head in the middle"), std::string::npos);
  EXPECT_NE(page.find("0 of 1"), std::string::npos);
  EXPECT_NE(page.find("not there &amp; never was"), std::string::npos);
  EXPECT_EQ(page.find("nan"), std::string::npos) << "what there was nothing to count for is a dash";
  EXPECT_EQ(page, rig_report_html(report));
}

TEST(RigReport, PicturesOfTwoSkeletonsDiffer) {
  Character character;
  character.name = "one";
  character.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  character.face_vertices = {0, 1, 2};
  character.face_offsets = {0, 3};
  TargetSkeleton reference;
  reference.joints.resize(2);
  reference.joints[0].name = "low";
  reference.joints[1] = {"high", {0.2, 1, 0}, 0, rigging::kClassOther, false, 0, 0};
  const RigReportPicture same =
      rig_report_picture(character, reference, {{"low", {0, 0, 0}, -1}, {"high", {0.2f, 1, 0}, 0}}, 64);
  EXPECT_EQ(same.character, "one");
  EXPECT_EQ(same.reference, same.predicted);
  const RigReportPicture other =
      rig_report_picture(character, reference, {{"low", {0.4f, 0, 0}, -1}, {"high", {0.2f, 1, 0}, 0}}, 64);
  EXPECT_EQ(other.reference, same.reference);
  EXPECT_NE(other.reference, other.predicted);
}

}  // namespace
}  // namespace sinew
