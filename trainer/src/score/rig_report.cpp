// SPDX-License-Identifier: MIT
// Figures, families, and every character's two skeletons beside each other, as HTML.

#include <algorithm>
#include <cmath>
#include <map>

#include "sinew_character/page/html.hpp"
#include "sinew_trainer/rig_score.hpp"

namespace sinew {
namespace {

using html::escape;

std::string percent(double value, int digits) { return std::isnan(value) ? "-" : html::number(100 * value, digits); }

std::string key_figures(const RigScores& scores) {
  std::string out = "<div class=\"figures\">";
  const auto add = [&](const std::string& value, const std::string& what, const std::string& beside) {
    out += "<div><b>" + value + "</b><span>" + escape(what) + "</span><span>" + beside + "</span></div>";
  };
  const auto figure = [&](double RigScore::*value, int digits, const char* what) {
    add(percent(scores.all.*value, digits), what, "families: " + percent(scores.family_mean.*value, digits));
  };
  figure(&RigScore::j2j, 2, "J2J x 100, mean of characters (lower is better)");
  figure(&RigScore::b2b, 2, "B2B x 100 (lower is better)");
  figure(&RigScore::iou, 1, "IoU of joints, % (higher is better)");
  figure(&RigScore::joined, 1, "bones joined as in the reference, % (higher is better)");
  const auto complete = std::count_if(scores.humanoids.begin(), scores.humanoids.end(),
                                      [](const auto& one) { return one.second.empty(); });
  if (!scores.humanoids.empty())
    add(std::to_string(complete) + " of " + std::to_string(scores.humanoids.size()),
        "humanoids have all 15 bones, once each and in order", "");
  return out + "</div>\n";
}

using NamedScore = std::pair<std::string, RigScore>;

std::string table(const char* heading, const std::vector<NamedScore>& rows) {
  std::vector<html::Column> columns = {{heading, true}};
  for (const RigFigure& figure : kRigFigures) columns.push_back({figure.key});
  std::vector<std::vector<html::Cell>> cells;
  for (const auto& [name, score] : rows) {
    cells.push_back({{name}});
    for (const RigFigure& figure : kRigFigures) cells.back().push_back({percent(score.*figure.value, 2)});
  }
  return html::table(columns, cells);
}

std::vector<NamedScore> worst_first(const RigScores& scores) {
  std::vector<NamedScore> order = scores.characters;
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.second.j2j > b.second.j2j; });
  return order;
}

std::string pictures(const RigReport& report) {
  std::map<std::string, const RigReportPicture*> by_name;
  for (const RigReportPicture& picture : report.pictures) by_name[picture.character] = &picture;
  if (by_name.empty()) return "";
  std::string out =
      "<h2>Every character</h2>\n<p class=\"soft\">The worst first. Left the reference, right the prediction.</p>\n";
  for (const auto& [name, score] : worst_first(report.scores)) {
    const auto found = by_name.find(name);
    if (found == by_name.end()) continue;
    std::string note = "J2J " + percent(score.j2j, 2) + ", IoU " + percent(score.iou, 1) + " %";
    const auto humanoid = report.scores.humanoids.find(name);
    if (humanoid != report.scores.humanoids.end()) {
      for (size_t i = 0; i < humanoid->second.size(); ++i) note += (i == 0 ? "; " : ", ") + humanoid->second[i];
    }
    const auto panel = [&](const std::vector<uint8_t>& png, const char* caption) {
      return "<figure>" + html::image(png, name + ", " + caption, true) + "<figcaption>" + caption +
             "</figcaption></figure>\n";
    };
    out += "<div class=\"card character\"><h3>" + escape(name) + "<span>" + escape(note) +
           "</span></h3><div class=\"panels\">\n" + panel(found->second->reference, "reference") +
           panel(found->second->predicted, "prediction") + "</div></div>\n";
  }
  return out;
}

constexpr const char* kRigMeaning =
    "Everything times 100. The reference is the target skeleton that sinew-lab dataset target writes; bone ends count "
    "as "
    "joints. Lengths are shares of the mesh's longest side. J2J, J2B, B2B: between joints, joints and bones, bones, "
    "nearest, in both directions. Precision, recall, IoU: joints in pairs, one to one, at most 0.05 apart. Joined: "
    "bones "
    "between pairs that the prediction has too. Class: pairs of one class. Symmetric: skeletons that are their own "
    "mirror image.";

}  // namespace

RigReportPicture rig_report_picture(const Character& character, const TargetSkeleton& reference,
                                    const std::vector<Joint>& predicted, int side) {
  RenderOptions view;
  view.width = view.height = side;
  const auto draw = [&](std::vector<Joint> joints) {
    Character shown = character;
    shown.joints = std::move(joints);
    shown.influences.clear();
    return encode_png(render(shown, std::vector<std::array<uint8_t, 3>>(shown.vertices.size(), {176, 184, 196}), view));
  };
  return {character.name, draw(target_joints(reference)), draw(predicted)};
}

std::string rig_report_html(const RigReport& report) {
  const RigScores& scores = report.scores;
  std::string out = "<h1>" + escape(report.title) + "</h1>\n" + key_figures(scores);
  std::vector<NamedScore> families(scores.families.begin(), scores.families.end());
  families.emplace_back("mean of families", scores.family_mean);
  families.emplace_back("mean of characters", scores.all);
  out += html::card("Families", table("family", families)) + pictures(report);
  if (!scores.failures.empty()) {
    std::vector<std::vector<html::Cell>> rows;
    for (const auto& [name, why] : scores.failures) rows.push_back({{name}, {why}});
    out += html::card("Failures", html::table({{"character", true}, {"why", true}}, rows));
  }
  out += "<h2>All figures</h2>\n<details class=\"card\"><summary>" + std::to_string(scores.characters.size()) +
         " characters</summary>\n" + table("character", worst_first(scores)) +
         "</details>\n<h2>How the numbers were made</h2>\n" + html::facts(report.facts) + "<p class=\"soft\">" +
         kRigMeaning + "</p>\n";
  return html::page(report.title, out);
}

}  // namespace sinew
