// SPDX-License-Identifier: MIT
// The statistics of a data set as a text table, JSON and a page with plots and pictures.
#include "sinew_data_sets/dataset_page.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "sinew_character/page/html.hpp"
#include "sinew_data_sets/plots.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

using Level = CheckFinding::Level;
using Members = std::vector<const CharacterStats*>;

struct Size {
  const char* heading;
  const char* key;
  std::function<size_t(const CharacterStats&)> value;
  bool logarithmic;
};
const std::vector<Size>& sizes() {
  static const std::vector<Size> list = {
      {"vertices", "vertices", [](const CharacterStats& c) { return c.report.vertices; }, true},
      {"faces", "faces", [](const CharacterStats& c) { return c.report.faces; }, true},
      {"parts", "parts", [](const CharacterStats& c) { return c.report.parts; }, true},
      {"joints", "joints", [](const CharacterStats& c) { return c.report.joints; }, false},
      {"joints with weight", "bound_joints", [](const CharacterStats& c) { return c.bound_joints; }, false},
      {"most influences", "max_influences", [](const CharacterStats& c) { return c.report.max_influences; }, false}};
  return list;
}

std::map<std::string, Members> by_family(const DatasetStats& stats) {
  std::map<std::string, Members> families;
  for (const CharacterStats& c : stats.characters) families[c.family].push_back(&c);
  return families;
}

Members everyone(const DatasetStats& stats) {
  Members all;
  for (const CharacterStats& c : stats.characters) all.push_back(&c);
  return all;
}

std::array<size_t, 3> span(const Members& members, const Size& size) {
  std::vector<size_t> values;
  for (const CharacterStats* c : members) values.push_back(size.value(*c));
  std::sort(values.begin(), values.end());
  return {values.front(), values[values.size() / 2], values.back()};
}

double mean(const Members& members, const std::function<double(const CharacterStats&)>& value) {
  double sum = 0;
  for (const CharacterStats* c : members) sum += value(*c);
  return sum / static_cast<double>(members.size());
}

// Negative if no recall is known: a character without weights has none.
double mean_recall(const Members& members, size_t k) {
  double sum = 0;
  size_t known = 0;
  for (const CharacterStats* c : members) {
    if (k >= c->recall.size()) continue;
    sum += c->recall[k];
    ++known;
  }
  return known ? sum / static_cast<double>(known) : -1;
}

size_t warnings(const CharacterStats& c) {
  return static_cast<size_t>(std::count_if(c.report.findings.begin(), c.report.findings.end(),
                                           [](const CheckFinding& f) { return f.level != Level::kNote; }));
}

std::string percent(double share) { return share < 0 ? "-" : html::number(100 * share, 2); }

std::string padded(const std::string& text, size_t width, bool left = false) {
  const std::string space(text.size() < width ? width - text.size() : 0, ' ');
  return left ? text + space : space + text;
}

std::string family_section(const std::string& family, const Members& members, const std::vector<uint32_t>& counts) {
  std::string out = "<h2>" + html::escape(family) + "</h2>\n<div class=\"card\"><div class=\"gallery\">\n";
  for (const CharacterStats* c : members) {
    out += "<figure>";
    if (!c->png.empty()) out += html::image(c->png, c->name, true);
    const size_t at = c->name.find("__");
    out += "<figcaption><b>" + html::escape(at == std::string::npos ? c->name : c->name.substr(at + 2)) + "</b><br />" +
           html::count(c->report.vertices) + " vertices, " + std::to_string(c->bound_joints) + " of " +
           std::to_string(c->report.joints) + " joints, " + html::number(c->influences_per_vertex(), 1) + " influences";
    for (size_t k = 0; k < c->recall.size(); ++k)
      if (counts[k] == 8) out += ", recall " + html::number(100 * c->recall[k], 1) + " %";
    if (warnings(*c) > 0) {
      out += "<details><summary class=\"warn\">" + std::to_string(warnings(*c)) +
             (warnings(*c) == 1 ? " warning" : " warnings") + "</summary>";
      for (const CheckFinding& f : c->report.findings)
        if (f.level != Level::kNote) out += "<div>" + html::escape(f.code) + ": " + html::escape(f.text) + "</div>";
      out += "</details>";
    }
    out += "</figcaption></figure>\n";
  }
  return out + "</div></div>\n";
}

std::string family_table(const DatasetStats& stats, const std::map<std::string, Members>& families) {
  // Faces go with vertices and have their own plot: the table has to fit a page of 1,200 pixels.
  std::vector<Size> shown;
  for (const Size& size : sizes())
    if (std::string(size.key) != "faces") shown.push_back(size);
  std::vector<html::Column> columns = {{"family", true}, {"n"}};
  for (const Size& size : shown) columns.push_back({size.heading});
  columns.push_back({"per vertex"});
  for (const uint32_t k : stats.candidate_counts) columns.push_back({"recall % at " + std::to_string(k)});
  columns.push_back({"warned"});
  std::vector<std::vector<html::Cell>> rows;
  const auto add = [&](const std::string& name, const Members& members) {
    std::vector<html::Cell> row = {{name}, {std::to_string(members.size())}};
    for (const Size& size : shown) {
      const auto s = span(members, size);
      row.push_back({s[0] == s[2] ? html::count(s[0])
                                  : html::count(s[0]) + " / " + html::count(s[1]) + " / " + html::count(s[2])});
    }
    row.push_back({html::number(mean(members, [](const CharacterStats& c) { return c.influences_per_vertex(); }), 2)});
    for (size_t k = 0; k < stats.candidate_counts.size(); ++k) row.push_back({percent(mean_recall(members, k))});
    const auto warned =
        std::count_if(members.begin(), members.end(), [](const CharacterStats* c) { return warnings(*c) > 0; });
    row.push_back({warned > 0 ? std::to_string(warned) : ""});
    rows.push_back(std::move(row));
  };
  for (const auto& [family, members] : families) add(family, members);
  if (families.size() > 1) add("all", everyone(stats));
  return html::table(columns, rows);
}

std::string influence_columns(const DatasetStats& stats) {
  std::array<size_t, 13> sums = {};
  size_t total = 0, most = 1;
  for (const CharacterStats& c : stats.characters)
    for (size_t i = 0; i < sums.size(); ++i) {
      sums[i] += c.vertices_with[i];
      total += c.vertices_with[i];
      if (c.vertices_with[i] > 0) most = std::max(most, i);
    }
  std::vector<std::pair<std::string, double>> values;
  for (size_t i = 0; i <= most; ++i)
    values.emplace_back(std::to_string(i) + (i == 12 ? "+" : ""),
                        static_cast<double>(sums[i]) / static_cast<double>(std::max<size_t>(1, total)));
  html::ColumnOptions options;
  options.x_label = "influences of a vertex (0: unbound)";
  options.y_label = "% of all vertices";
  options.factor = 100;
  options.digits = 1;
  return html::columns(values, options);
}

}  // namespace

double CharacterStats::influences_per_vertex() const {
  size_t sum = 0, bound = 0;
  for (size_t i = 1; i < vertices_with.size(); ++i) {
    sum += i * vertices_with[i];
    bound += vertices_with[i];
  }
  return bound ? static_cast<double>(sum) / static_cast<double>(bound) : 0;
}

CharacterStats character_stats(const Character& character) {
  CharacterStats stats;
  stats.name = character.name;
  stats.family = family_of(character.name);
  stats.report = check_training_character(character);
  std::vector<uint8_t> bound(character.joints.size(), 0);
  for (const auto& row : character.influences) {
    size_t count = 0;
    for (const Influence& i : row) {
      if (!(i.weight > 1e-4f) || i.joint >= bound.size()) continue;
      bound[i.joint] = 1;
      ++count;
    }
    ++stats.vertices_with[std::min(count, stats.vertices_with.size() - 1)];
  }
  stats.bound_joints = static_cast<size_t>(std::count(bound.begin(), bound.end(), 1));
  return stats;
}

std::string dataset_table(const DatasetStats& stats) {
  std::vector<std::vector<std::string>> cells(1);
  cells[0] = {"family", "chars"};
  for (const Size& size : sizes()) cells[0].push_back(size.heading);
  cells[0].push_back("per vertex");
  for (const uint32_t k : stats.candidate_counts) cells[0].push_back("recall@" + std::to_string(k));
  cells[0].push_back("warned");
  std::map<std::string, Members> families = by_family(stats);
  const auto add = [&](const std::string& name, const Members& members) {
    std::vector<std::string> row = {name, std::to_string(members.size())};
    for (const Size& size : sizes()) {
      const auto s = span(members, size);
      row.push_back(std::to_string(s[0]) + " / " + std::to_string(s[1]) + " / " + std::to_string(s[2]));
    }
    row.push_back(html::number(mean(members, [](const CharacterStats& c) { return c.influences_per_vertex(); }), 2));
    for (size_t k = 0; k < stats.candidate_counts.size(); ++k) row.push_back(percent(mean_recall(members, k)));
    row.push_back(std::to_string(
        std::count_if(members.begin(), members.end(), [](const CharacterStats* c) { return warnings(*c) > 0; })));
    cells.push_back(std::move(row));
  };
  for (const auto& [family, members] : families) add(family, members);
  if (!stats.characters.empty()) add("(all)", everyone(stats));
  std::vector<size_t> widths(cells[0].size(), 0);
  for (const auto& row : cells)
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string out = "smallest / median / largest of each family; influences per vertex and recall (%) are means\n";
  for (const auto& row : cells) {
    for (size_t i = 0; i < row.size(); ++i) out += (i ? "  " : "") + padded(row[i], widths[i], i == 0);
    out += "\n";
  }
  for (const auto& [file, why] : stats.unreadable) out += "unreadable: " + why + "\n";
  return out;
}

std::string dataset_json(const DatasetStats& stats) {
  using Json = nlohmann::ordered_json;
  Json all = Json::object();
  const auto add = [&](const std::string& name, const Members& members) {
    Json row = {{"characters", members.size()}};
    for (const Size& size : sizes()) row[size.key] = span(members, size);
    row["influences_per_vertex"] = mean(members, [](const CharacterStats& c) { return c.influences_per_vertex(); });
    for (size_t k = 0; k < stats.candidate_counts.size(); ++k) {
      const double recall = mean_recall(members, k);
      row["recall"][std::to_string(stats.candidate_counts[k])] = recall < 0 ? Json(nullptr) : Json(recall);
    }
    row["warned"] =
        std::count_if(members.begin(), members.end(), [](const CharacterStats* c) { return warnings(*c) > 0; });
    all[name] = std::move(row);
  };
  for (const auto& [family, members] : by_family(stats)) add(family, members);
  if (!stats.characters.empty()) add("(all)", everyone(stats));
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string dataset_html(const DatasetStats& stats) {
  if (stats.characters.empty()) throw Error(stats.folder + ": no character to show");
  const std::map<std::string, Members> families = by_family(stats);
  const Members all = everyone(stats);
  size_t vertices = 0, warned = 0;
  for (const CharacterStats& c : stats.characters) {
    vertices += c.report.vertices;
    warned += warnings(c) > 0 ? 1 : 0;
  }
  const auto figure = [](const std::string& value, const std::string& what) {
    return "<div><b>" + value + "</b><span>" + what + "</span></div>";
  };
  std::string out = "<h1>Data set: " + html::escape(stats.folder) + "</h1>\n<div class=\"figures\">" +
                    figure(html::count(all.size()), "characters") + figure(html::count(families.size()), "families") +
                    figure(html::count(vertices), "vertices") +
                    figure(html::count(warned), warned == 1 ? "character with warnings" : "characters with warnings");
  for (size_t k = 0; k < stats.candidate_counts.size(); ++k)
    if (stats.candidate_counts[k] == 8 && mean_recall(all, k) >= 0)
      out += figure(percent(mean_recall(all, k)) + " %", "of the weight is on the 8 candidates");
  out +=
      "</div>\n<h2>Families</h2>\n<p class=\"soft\">Smallest / median / largest; influences per vertex and recall are "
      "means. Recall: the share of the artist's weight that lieson the K joints that the network may choose from "
      "(higher is better).</p>\n<div class=\"card\">" +
      family_table(stats, families) + "</div>\n<div class=\"grid\">\n";
  std::vector<std::pair<std::string, double>> counts;
  std::vector<html::BarRow> bars;
  for (const auto& [family, members] : families) bars.push_back({family, {static_cast<double>(members.size())}});
  html::BarOptions bar_options;
  bar_options.digits = 0;
  out += html::card("Characters of each family", html::bars({"characters"}, bars, bar_options));
  if (!stats.candidate_counts.empty() && mean_recall(all, 0) >= 0) {
    for (size_t k = 0; k < stats.candidate_counts.size(); ++k)
      counts.emplace_back(std::to_string(stats.candidate_counts[k]), 1 - mean_recall(all, k));
    html::ColumnOptions options;
    options.x_label = "candidates per vertex";
    options.y_label = "% of the weight on none of them";
    options.factor = 100;
    options.digits = 2;
    out += html::card("What the candidates miss (lower is better)", html::columns(counts, options));
  }
  out += html::card("Influences of a vertex", influence_columns(stats));
  for (const Size& size : sizes()) {
    std::vector<double> values;
    for (const CharacterStats* c : all) values.push_back(static_cast<double>(size.value(*c)));
    html::HistogramOptions options;
    options.x_label = std::string(size.heading) + (size.logarithmic ? " (logarithmic)" : "");
    options.logarithmic = size.logarithmic;
    std::string heading = size.heading;
    heading[0] = static_cast<char>(heading[0] - 'a' + 'A');
    out += html::card(heading, html::histogram(values, options));
  }
  out += "</div>\n";
  if (!stats.unreadable.empty()) {
    std::vector<std::vector<html::Cell>> rows;
    for (const auto& [file, why] : stats.unreadable) rows.push_back({{file}, {why}});
    out += html::card("Unreadable", html::table({{"file", true}, {"why", true}}, rows));
  }
  out +=
      "<p class=\"soft\" style=\"margin-top:36px\">Below, every character with its reference weights: one color per "
      "joint, blended by weight; gray is unbound.</p>\n";
  for (const auto& [family, members] : families)
    out += family_section(family + " (" + std::to_string(members.size()) + ")", members, stats.candidate_counts);
  return html::page("Data set " + stats.folder, out);
}

}  // namespace sinew
