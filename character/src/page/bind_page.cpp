// SPDX-License-Identifier: MIT
// The page of a folder that was bound.
#include "sinew_character/page/bind_page.hpp"

#include "sinew_character/page/html.hpp"

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
                    ". One colour per joint, blended by weight.</p>\n<div class=\"figures\">" +
                    figure(html::count(rows.size() - failed), "files bound") +
                    figure(html::count(failed), failed == 1 ? "file failed" : "files failed") +
                    figure(html::count(doubted), doubted == 1 ? "file with doubts" : "files with doubts") +
                    figure(html::count(vertices), "vertices") +
                    figure(html::number(seconds, 1) + " s", "of binding, added up") + "</div>\n";
  out += html::card(
      "Files",
      html::table(
          {{"", true}, {"file", true}, {"vertices"}, {"joints"}, {"with weight"}, {"seconds"}, {"to look at", true}},
          table));
  return html::page("Bound: " + folder, out);
}

}  // namespace sinew
