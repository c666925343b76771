// SPDX-License-Identifier: MIT
// The page of a folder that was bound, and that of checked files.
#include "sinew_character/page/pages.hpp"

#include <algorithm>
#include <cmath>

#include "sinew_character/page/html.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

std::string remarks(const BoundRow& row) {
  std::string out;
  if (!row.error.empty()) out += "<div class=\"warn\">" + html::escape(row.error) + "</div>";
  if (!row.doubts.empty()) out += "<div>" + html::escape(row.doubts) + "</div>";
  for (const std::string& note : row.notes) out += "<div>" + html::escape(note) + "</div>";
  // Cells keep words on one line; remarks are sentences.
  return "<div style=\"white-space:normal;overflow-wrap:anywhere;min-width:200px\">" + out + "</div>";
}

std::vector<html::Cell> cells(const BoundRow& row) {
  const std::string picture =
      row.png.empty() ? "" : "<div style=\"width:160px\">" + html::image(row.png, row.name, true) + "</div>";
  html::Cell name{row.name};
  if (!row.error.empty()) name = {"<span class=\"warn\">" + html::escape(row.name) + "</span>", false, true};
  if (!row.error.empty()) return {{picture, false, true}, name, {""}, {""}, {""}, {""}, {remarks(row), false, true}};
  return {{picture, false, true},         name,
          {html::count(row.vertices)},    {html::count(row.joints)},
          {html::count(row.joints_used)}, {html::number(row.seconds, 2)},
          {remarks(row), false, true}};
}

}  // namespace

std::string bind_html(const std::string& folder, const std::string& method, const std::vector<BoundRow>& rows) {
  size_t failed = 0, doubted = 0, vertices = 0;
  double seconds = 0;
  std::vector<std::vector<html::Cell>> table;
  for (const BoundRow& row : rows) {
    failed += row.error.empty() ? 0 : 1;
    doubted += row.doubts.empty() ? 0 : 1;
    vertices += row.vertices;
    seconds += row.seconds;
    table.push_back(cells(row));
  }
  const auto figure = [](const std::string& value, const std::string& what) {
    return "<div><b>" + value + "</b><span>" + what + "</span></div>";
  };
  std::string out = "<h1>Bound: " + html::escape(folder) + "</h1>\n<p class=\"soft\">With " + html::escape(method) +
                    ". One color per joint, blended by weight.</p>\n<div class=\"figures\">" +
                    figure(html::count(rows.size() - failed), "files bound") +
                    figure(html::count(failed), failed == 1 ? "file failed" : "files failed") +
                    figure(html::count(doubted), doubted == 1 ? "file with doubts" : "files with doubts") +
                    figure(html::count(vertices), "vertices") +
                    figure(html::number(seconds, 1) + " s", "of binding in total") + "</div>\n";
  out += html::card(
      "Files",
      html::table(
          {{"", true}, {"file", true}, {"vertices"}, {"joints"}, {"with weight"}, {"seconds"}, {"to check", true}},
          table));
  return html::page("Bound: " + folder, out);
}

namespace {

constexpr size_t kMostPictures = 40, kMostRings = 200;

Vec3 middle(const Box& box) {
  return {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2, (box.low.z + box.high.z) / 2};
}

std::string severity_cell(CheckSeverity severity) {
  return severity == CheckSeverity::kNote ? severity_text(severity)
                                          : "<span class=\"warn\">" + std::string(severity_text(severity)) + "</span>";
}

std::vector<html::Cell> cells(const CheckedFile& file, size_t number) {
  const RigFinding& f = file.check.findings[number];
  std::string picture;
  if (number < kMostPictures && !file.character.vertices.empty())
    picture = "<div style=\"width:240px\">" + html::image(encode_png(finding_picture(file, f)), f.rule->name, true) +
              "</div>";
  const bool is_new = std::find(file.change.added.begin(), file.change.added.end(), number) != file.change.added.end();
  const std::string shown = where_shown(f);
  std::string text = "<div>" + html::escape(f.what) + "</div>";
  if (!shown.empty()) text += "<div class=\"soft\">" + html::escape(shown) + "</div>";
  text += "<div class=\"soft\">" + html::escape(f.rule->cure) + "</div>";
  return {{picture, false, true},
          {severity_cell(f.severity) + (is_new ? " (new)" : ""), false, true},
          {f.rule->name},
          {print("%.3g", f.value)},
          {print("%.3g", f.bound)},
          {"<div style=\"white-space:normal;overflow-wrap:anywhere;min-width:200px\">" + text + "</div>", false, true}};
}

std::string file_card(const CheckedFile& file) {
  std::vector<std::vector<html::Cell>> rows;
  for (size_t i = 0; i < file.check.findings.size(); ++i) rows.push_back(cells(file, i));
  std::string note = print("%zu vertices, %zu joints, %zu clips", file.character.vertices.size(),
                           file.character.joints.size(), file.motion.clips.size());
  for (const std::string& line : file.failures) note += "; gate: " + line;
  for (const size_t i : file.change.removed) note += "; fixed: " + file.before->findings[i].what;
  const std::string content =
      rows.empty() ? "<p>0 findings</p>"
                   : html::table({{"", true}, {"", true}, {"rule", true}, {"value"}, {"bound"}, {"what", true}}, rows);
  return html::card(file.file, content, note);
}

}  // namespace

Image finding_picture(const CheckedFile& file, const RigFinding& finding) {
  const Character shown = as_shown(file, finding);
  RenderOptions options;
  options.width = options.height = 420;
  std::vector<Vec3> positions;
  for (const uint32_t v : finding.vertices) positions.push_back(shown.vertices[v]);
  if (positions.empty() && finding.joint >= 0)
    positions.push_back(shown.joints[static_cast<size_t>(finding.joint)].position);
  if (positions.empty() && finding.other >= 0)
    positions.push_back(shown.joints[static_cast<size_t>(finding.other)].position);
  const Box whole = box_of(shown.vertices);
  if (!positions.empty()) {
    const Box box = box_of(positions);
    options.focus = middle(box);
    options.focus_radius = std::max(1.3F * box.longest_side(), 0.18F * whole.longest_side());
    // From the side on which it lies.
    const Vec3 center = middle(whole);
    const float dx = options.focus.x - center.x, dz = options.focus.z - center.z;
    if (std::hypot(dx, dz) > 0.05F * whole.longest_side()) options.yaw_degrees = std::atan2(dx, dz) * 57.29578F;
  }
  const size_t step = 1 + positions.size() / kMostRings;  // thousands of rings would hide what they mark
  for (size_t i = 0; i < positions.size(); i += step) options.marks.push_back({positions[i]});
  return render(shown, weight_colors(shown), options);
}

std::string check_html(const std::vector<CheckedFile>& files) {
  size_t errors = 0, warnings = 0, notes = 0, clean = 0;
  std::string cards;
  for (const CheckedFile& file : files) {
    errors += file.check.errors;
    warnings += file.check.warnings;
    notes += file.check.notes;
    clean += file.check.findings.empty() ? 1 : 0;
    cards += file_card(file);
  }
  const auto figure = [](size_t value, const std::string& what) {
    return "<div><b>" + html::count(value) + "</b><span>" + what + "</span></div>";
  };
  const std::string head = "<h1>Checked rigs</h1>\n<div class=\"figures\">" + figure(files.size(), "files") +
                           figure(clean, "without findings") + figure(errors, "errors") + figure(warnings, "warnings") +
                           figure(notes, "notes") + "</div>\n";
  return html::page("Checked rigs", head + cards);
}

}  // namespace sinew
