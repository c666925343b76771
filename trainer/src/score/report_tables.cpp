// SPDX-License-Identifier: MIT
// Tables of the report, as HTML and as Markdown.
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "score/report_parts.hpp"
#include "sinew_character/page/html.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

using html::number;

struct Column {
  const char* heading;
  int digits;
  double factor;
  bool lower_is_better;
  std::function<std::optional<double>(const ReportVariant&)> value;
};

std::optional<double> size_of(const ReportVariant& v) {
  return v.size_bytes ? std::optional<double>(static_cast<double>(v.size_bytes)) : std::nullopt;
}

const std::vector<Column>& variant_columns() {
  static const std::vector<Column> columns = {
      {"L1", 4, 1, true, [](const ReportVariant& v) { return v.scores.all.l1; }},
      {"L1 (families)", 4, 1, true, [](const ReportVariant& v) { return v.scores.family_mean.l1; }},
      {"L1 in file", 4, 1, true, [](const ReportVariant& v) { return v.scores.all.l1_file; }},
      {"in file (families)", 4, 1, true, [](const ReportVariant& v) { return v.scores.family_mean.l1_file; }},
      {"avg dist", 4, 1, true, [](const ReportVariant& v) { return v.scores.all.avg_dist; }},
      {"max dist", 3, 1, true, [](const ReportVariant& v) { return v.scores.all.max_dist; }},
      {"argmax %", 2, 100, false, [](const ReportVariant& v) { return v.scores.all.argmax; }},
      {"KL", 3, 1, true, [](const ReportVariant& v) { return v.scores.all.kl; }},
      {"L1>0.5 %", 1, 100, true, [](const ReportVariant& v) { return v.scores.all.bad; }},
      {"flips %", 3, 100, true, [](const ReportVariant& v) { return v.argmax_flips; }},
      {"within 1/255 %", 2, 100, false, [](const ReportVariant& v) { return v.close_unorm8; }},
      {"logit SNR dB", 1, 1, false, [](const ReportVariant& v) { return v.logit_snr_db; }},
      {"bytes", 0, 1, true, size_of},
  };
  return columns;
}

// Columns that no variant has a value for are left out.
std::vector<Column> used_columns(const ReportData& data) {
  std::vector<Column> used;
  for (const Column& column : variant_columns()) {
    if (std::any_of(data.variants.begin(), data.variants.end(),
                    [&](const ReportVariant& v) { return column.value(v).has_value(); }))
      used.push_back(column);
  }
  return used;
}

}  // namespace

const std::pair<std::string, Metrics>* worst_character(const Scores& scores) {
  const auto worst = std::max_element(scores.characters.begin(), scores.characters.end(),
                                      [](const auto& a, const auto& b) { return a.second.l1 < b.second.l1; });
  return worst == scores.characters.end() ? nullptr : &*worst;
}

std::vector<std::string> report_families(const ReportData& data) {
  std::set<std::string> names;
  for (const ReportVariant& v : data.variants)
    for (const auto& [family, m] : v.scores.families) names.insert(family);
  return {names.begin(), names.end()};
}

std::vector<std::string> variant_labels(const ReportData& data) {
  std::vector<std::string> labels;
  for (const ReportVariant& v : data.variants) labels.push_back(v.label);
  return labels;
}

const Metrics* family_metrics(const ReportVariant& v, const std::string& family) {
  const auto found = v.scores.families.find(family);
  return found == v.scores.families.end() ? nullptr : &found->second;
}

std::string variant_table(const ReportData& data) {
  const std::vector<Column> columns = used_columns(data);
  std::string out =
      "<table class=\"wide\"><thead><tr><th class=\"name\">variant, its worst character (L1)</th><th>n</th>";
  for (const Column& column : columns)
    out += "<th>" + html::escape(column.heading) + (column.lower_is_better ? "\u00a0↓" : "\u00a0↑") + "</th>";
  out += "<th>failed</th></tr></thead><tbody>\n";
  for (size_t i = 0; i < data.variants.size(); ++i) {
    const ReportVariant& v = data.variants[i];
    const auto* worst = worst_character(v.scores);
    out += "<tr><td class=\"name\"><i class=\"key\" style=\"background:" + html::color(i) + "\"></i>" +
           html::escape(v.label) +
           (worst ? "<small>" + html::escape(worst->first) + " (" + number(worst->second.l1, 3) + ")</small>" : "") +
           "</td><td>" + std::to_string(v.scores.characters.size()) + "</td>";
    for (const Column& column : columns) {
      const std::optional<double> value = column.value(v);
      bool best = value.has_value() && data.variants.size() > 1;
      for (const ReportVariant& other : data.variants) {
        const std::optional<double> theirs = column.value(other);
        if (value && theirs && (column.lower_is_better ? *theirs < *value : *theirs > *value)) best = false;
      }
      out += std::string("<td") + (best ? " class=\"best\">" : ">") +
             (value ? number(*value * column.factor, column.digits) : "–") + "</td>";
    }
    out += "<td>" + std::to_string(v.scores.failures.size()) + "</td></tr>\n";
  }
  return out + "</tbody></table>\n";
}

std::string family_table(const ReportData& data, double Metrics::*figure, int digits, double factor,
                         bool lower_is_better) {
  std::vector<html::Column> columns = {{"family", true}, {"n"}};
  for (const ReportVariant& v : data.variants) columns.push_back({v.label});
  std::vector<std::vector<html::Cell>> rows;
  const auto add = [&](const std::string& name, size_t count, const std::vector<const Metrics*>& metrics) {
    std::vector<html::Cell> row = {{name}, {std::to_string(count)}};
    for (const Metrics* m : metrics) {
      bool best = m != nullptr && metrics.size() > 1;
      for (const Metrics* other : metrics)
        if (m && other && (lower_is_better ? other->*figure < m->*figure : other->*figure > m->*figure)) best = false;
      row.push_back({m ? number(factor * (m->*figure), digits) : "–", best});
    }
    rows.push_back(std::move(row));
  };
  const Scores& main = data.variants[data.main_variant].scores;
  for (const std::string& family : report_families(data)) {
    size_t count = 0;
    for (const auto& [name, m] : main.characters) count += family_of(name) == family ? 1 : 0;
    std::vector<const Metrics*> metrics;
    for (const ReportVariant& v : data.variants) metrics.push_back(family_metrics(v, family));
    add(family, count, metrics);
  }
  std::vector<const Metrics*> families, characters;
  for (const ReportVariant& v : data.variants) {
    families.push_back(&v.scores.family_mean);
    characters.push_back(&v.scores.all);
  }
  add("mean of families", main.families.size(), families);
  add("mean of characters", main.characters.size(), characters);
  return html::table(columns, rows);
}

std::string worst_table(const ReportData& data, size_t count) {
  std::vector<html::Column> columns = {{"character", true}};
  for (const ReportVariant& v : data.variants) columns.push_back({v.label});
  auto order = data.variants[data.main_variant].scores.characters;
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second.l1 > b.second.l1; });
  std::vector<std::vector<html::Cell>> rows;
  for (size_t i = 0; i < std::min(count, order.size()); ++i) {
    std::vector<html::Cell> row = {{order[i].first}};
    std::vector<std::optional<double>> values;
    for (const ReportVariant& v : data.variants) {
      values.emplace_back();
      for (const auto& [name, m] : v.scores.characters)
        if (name == order[i].first) values.back() = m.l1;
    }
    for (const auto& value : values) {
      const bool best =
          value && values.size() > 1 &&
          std::none_of(values.begin(), values.end(), [&](const auto& other) { return other && *other < *value; });
      row.push_back({value ? number(*value, 3) : "–", best});
    }
    rows.push_back(std::move(row));
  }
  return html::table(columns, rows);
}

std::string character_table(const ReportVariant& v) {
  std::vector<std::vector<html::Cell>> rows;
  for (const auto& [name, m] : v.scores.characters) {
    rows.push_back({{name},
                    {std::to_string(m.vertices)},
                    {std::to_string(m.joints)},
                    {number(m.l1, 4)},
                    {number(m.l1_file, 4)},
                    {number(m.avg_dist, 4)},
                    {number(m.max_dist, 3)},
                    {number(100 * m.argmax, 1)},
                    {number(m.kl, 3)},
                    {number(100 * m.precision, 1)},
                    {number(100 * m.recall, 1)}});
  }
  return html::table({{"character", true},
                      {"vertices"},
                      {"joints"},
                      {"L1 ↓"},
                      {"L1 in file ↓"},
                      {"avg dist ↓"},
                      {"max dist ↓"},
                      {"argmax % ↑"},
                      {"KL ↓"},
                      {"precision % ↑"},
                      {"recall % ↑"}},
                     rows);
}

std::string failure_table(const ReportData& data) {
  std::vector<std::vector<html::Cell>> rows;
  for (const ReportVariant& v : data.variants)
    for (const auto& [name, note] : v.scores.failures) rows.push_back({{v.label}, {name}, {note}});
  if (rows.empty()) return "";
  return html::table({{"variant", true}, {"character", true}, {"what went wrong", true}}, rows);
}

std::string beaten_table(const ReportData& data) {
  std::vector<std::vector<html::Cell>> rows;
  for (const auto& [name, loss] : *data.beaten_by_nearest) rows.push_back({{name}, {number(loss, 4)}});
  if (rows.empty()) return "<p>None: nearest bone is better on no character.</p>\n";
  return html::table({{"character", true}, {"L1 above nearest bone"}}, rows);
}

std::string quantization_table_markdown(const ReportData& data) {
  if (data.variants.empty()) throw Error("report: no variant to report on");
  const auto cell = [](std::string text) {
    for (size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, 1, '\\');
    return text;
  };
  const std::vector<Column> columns = used_columns(data);
  std::string head = "| variant |", rule = "|---|";
  for (const Column& column : columns) {
    head += std::string(" ") + column.heading + " |";
    rule += "---:|";
  }
  std::string out = head + " worst character |\n" + rule + "---|\n";
  for (const ReportVariant& v : data.variants) {
    out.append("| ").append(cell(v.label)).append(" |");
    for (const Column& column : columns) {
      const std::optional<double> value = column.value(v);
      out.append(" ").append(value ? number(*value * column.factor, column.digits) : "-").append(" |");
    }
    const auto* worst = worst_character(v.scores);
    out.append(" ").append(worst ? cell(worst->first) + " (" + number(worst->second.l1, 3) + ")" : "-").append(" |\n");
  }
  return out;
}

}  // namespace sinew
