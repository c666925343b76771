// SPDX-License-Identifier: MIT
// The accuracy report as one HTML page: tables, SVG plots and pictures, nothing loaded from anywhere.
#include "sinew_trainer/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <set>

#include "sinew_formats/error.hpp"
#include "sinew_formats/image.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/pose.hpp"

namespace sinew {
namespace {

// How many series colours the style sheet has; further variants start over.
constexpr size_t kSeries = 8;

constexpr const char* kStyle = R"css(
:root { color-scheme: light dark; --page: #f7f7f8; --card: #ffffff; --text: #1d2026; --soft: #5d6470; --rule: #dfe2e7;
  --s0: #2f6fde; --s1: #e0752b; --s2: #1f9e77; --s3: #b04ac0; --s4: #c9a21a; --s5: #d23f57; --s6: #4fb3c8; --s7: #7b7f8a; }
@media (prefers-color-scheme: dark) { :root { --page: #15171b; --card: #1e2127; --text: #e8eaee; --soft: #a0a7b4; --rule: #343943;
  --s0: #6ea0ff; --s1: #ff9c57; --s2: #45c99d; --s3: #d886e6; --s4: #e6c44a; --s5: #ff7387; --s6: #7ad4e6; --s7: #a4a9b5; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--text); font: 15px/1.5 system-ui, "Segoe UI", Roboto, "Helvetica Neue", sans-serif; }
main { max-width: 1360px; margin: 0 auto; padding: 32px 24px 64px; }
h1 { font-size: 26px; margin: 0 0 4px; letter-spacing: -0.01em; }
h2 { font-size: 18px; margin: 36px 0 10px; }
p { margin: 4px 0 12px; max-width: 75ch; }
.soft { color: var(--soft); }
.card { background: var(--card); border: 1px solid var(--rule); border-radius: 10px; padding: 16px 18px; overflow-x: auto; }
.facts { display: grid; grid-template-columns: max-content 1fr; gap: 2px 18px; margin: 14px 0 0; font-size: 14px; }
.facts dt { color: var(--soft); } .facts dd { margin: 0; overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; font-size: 13.5px; font-variant-numeric: tabular-nums; }
th { font-weight: 600; color: var(--soft); text-align: right; padding: 5px 8px; border-bottom: 1px solid var(--rule); white-space: nowrap; }
td { text-align: right; padding: 5px 8px; border-bottom: 1px solid var(--rule); white-space: nowrap; }
tr:last-child td { border-bottom: 0; }
th.name, td.name { text-align: left; }
td.best { font-weight: 700; }
td.long { text-align: left; white-space: normal; overflow-wrap: anywhere; min-width: 150px; font-size: 12.5px; line-height: 1.3; }
.key { display: inline-block; width: 10px; height: 10px; border-radius: 3px; margin-right: 8px; }
.grid { display: grid; grid-template-columns: repeat(auto-fit, minmax(460px, 1fr)); gap: 16px; }
svg { width: 100%; height: auto; display: block; font: 12px system-ui, "Segoe UI", Roboto, sans-serif; }
svg text { fill: var(--text); } svg .tick { fill: var(--soft); } svg .value { fill: var(--soft); font-size: 9.5px; } svg .rule { stroke: var(--rule); stroke-width: 1; }
.legend { display: flex; flex-wrap: wrap; gap: 4px 18px; font-size: 13px; margin: 0 0 8px; }
.legend span { white-space: nowrap; }
.panels { display: grid; grid-template-columns: repeat(4, 1fr); gap: 10px; }
@media (max-width: 800px) { .panels { grid-template-columns: repeat(2, 1fr); } .grid { grid-template-columns: 1fr; } }
figure { margin: 0; } figure img { width: 100%; height: auto; border-radius: 8px; display: block; }
figcaption { font-size: 13px; color: var(--soft); margin-top: 4px; }
.character { margin-bottom: 16px; }
.character h3 { font-size: 15px; margin: 0 0 10px; } .character h3 span { font-weight: 400; color: var(--soft); margin-left: 10px; }
summary { cursor: pointer; }
)css";

std::string escaped(const std::string& text) {
  std::string out;
  for (char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string number(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string base64(const std::vector<uint8_t>& bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t left = std::min<size_t>(3, bytes.size() - i);
    uint32_t word = static_cast<uint32_t>(bytes[i]) << 16;
    if (left > 1) word |= static_cast<uint32_t>(bytes[i + 1]) << 8;
    if (left > 2) word |= bytes[i + 2];
    for (size_t k = 0; k < 4; ++k) out += k <= left ? letters[(word >> (18 - 6 * k)) & 63] : '=';
  }
  return out;
}

const std::pair<std::string, Metrics>* worst_character(const Scores& scores) {
  const auto worst = std::max_element(scores.characters.begin(), scores.characters.end(),
                                      [](const auto& a, const auto& b) { return a.second.l1 < b.second.l1; });
  return worst == scores.characters.end() ? nullptr : &*worst;
}

std::string colour(size_t series) {
  return std::string("var(--s").append(std::to_string(series % kSeries)).append(")");
}

// ---- tables

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
      {"avg dist", 4, 1, true, [](const ReportVariant& v) { return v.scores.all.avg_dist; }},
      {"max dist", 3, 1, true, [](const ReportVariant& v) { return v.scores.all.max_dist; }},
      {"argmax %", 2, 100, false, [](const ReportVariant& v) { return v.scores.all.argmax; }},
      {"KL", 3, 1, true, [](const ReportVariant& v) { return v.scores.all.kl; }},
      {"L1>0.5 %", 1, 100, true, [](const ReportVariant& v) { return v.scores.all.bad; }},
      {"flips %", 3, 100, true, [](const ReportVariant& v) { return v.argmax_flips; }},
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

std::string variant_table(const ReportData& data) {
  const std::vector<Column> columns = used_columns(data);
  std::string out = "<table><thead><tr><th class=\"name\">variant</th><th>n</th>";
  for (const Column& column : columns) out += "<th>" + escaped(column.heading) + "</th>";
  out += "<th>failed</th><th class=\"name\">worst character (L1)</th></tr></thead><tbody>\n";
  for (size_t i = 0; i < data.variants.size(); ++i) {
    const ReportVariant& v = data.variants[i];
    out += "<tr><td class=\"name\"><i class=\"key\" style=\"background:" + colour(i) + "\"></i>" + escaped(v.label) +
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
    const auto* worst = worst_character(v.scores);
    out += "<td>" + std::to_string(v.scores.failures.size()) + "</td><td class=\"long\">" +
           (worst ? escaped(worst->first) + " (" + number(worst->second.l1, 3) + ")" : "–") + "</td></tr>\n";
  }
  return out + "</tbody></table>\n";
}

std::vector<std::string> all_families(const ReportData& data) {
  std::set<std::string> names;
  for (const ReportVariant& v : data.variants)
    for (const auto& [family, m] : v.scores.families) names.insert(family);
  return {names.begin(), names.end()};
}

const Metrics* family_metrics(const ReportVariant& v, const std::string& family) {
  const auto found = v.scores.families.find(family);
  return found == v.scores.families.end() ? nullptr : &found->second;
}

std::string family_table(const ReportData& data) {
  std::string out = "<table><thead><tr><th class=\"name\">family</th><th>n</th>";
  for (const ReportVariant& v : data.variants) out += "<th>" + escaped(v.label) + "</th>";
  out += "</tr></thead><tbody>\n";
  for (const std::string& family : all_families(data)) {
    size_t count = 0;
    for (const auto& [name, m] : data.variants[data.main_variant].scores.characters) count += family_of(name) == family;
    double least = INFINITY;
    for (const ReportVariant& v : data.variants)
      if (const Metrics* m = family_metrics(v, family)) least = std::min(least, m->l1);
    out += "<tr><td class=\"name\">" + escaped(family) + "</td><td>" + std::to_string(count) + "</td>";
    for (const ReportVariant& v : data.variants) {
      const Metrics* m = family_metrics(v, family);
      const bool best = m && data.variants.size() > 1 && m->l1 <= least;
      out += std::string("<td") + (best ? " class=\"best\">" : ">") + (m ? number(m->l1, 4) : "–") + "</td>";
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table>\n";
}

std::string character_table(const ReportVariant& v) {
  std::string out =
      "<table><thead><tr><th class=\"name\">character</th><th>vertices</th><th>joints</th><th>L1</th><th>avg "
      "dist</th><th>max dist</th>"
      "<th>argmax %</th><th>KL</th><th>precision %</th><th>recall %</th></tr></thead><tbody>\n";
  for (const auto& [name, m] : v.scores.characters) {
    out += "<tr><td class=\"name\">" + escaped(name) + "</td><td>" + std::to_string(m.vertices) + "</td><td>" +
           std::to_string(m.joints) + "</td><td>" + number(m.l1, 4) + "</td><td>" + number(m.avg_dist, 4) +
           "</td><td>" + number(m.max_dist, 3) + "</td><td>" + number(100 * m.argmax, 1) + "</td><td>" +
           number(m.kl, 3) + "</td><td>" + number(100 * m.precision, 1) + "</td><td>" + number(100 * m.recall, 1) +
           "</td></tr>\n";
  }
  return out + "</tbody></table>\n";
}

std::string failure_list(const ReportData& data) {
  std::string out;
  for (const ReportVariant& v : data.variants)
    for (const auto& [name, note] : v.scores.failures)
      out += "<tr><td class=\"name\">" + escaped(v.label) + "</td><td class=\"name\">" + escaped(name) +
             "</td><td class=\"name\">" + escaped(note) + "</td></tr>\n";
  if (out.empty()) return out;
  return "<h2>Failures</h2>\n<div class=\"card\"><table><thead><tr><th class=\"name\">variant</th><th "
         "class=\"name\">character</th>"
         "<th class=\"name\">what went wrong</th></tr></thead><tbody>\n" +
         out + "</tbody></table></div>\n";
}

// ---- plots

std::string legend(const ReportData& data) {
  std::string out = "<div class=\"legend\">";
  for (size_t i = 0; i < data.variants.size(); ++i)
    out += "<span><i class=\"key\" style=\"background:" + colour(i) + "\"></i>" + escaped(data.variants[i].label) +
           "</span>";
  return out + "</div>\n";
}

// The step between ticks, 1, 2 or 5 times a power of ten, so that there are about five of them.
double tick_step(double span) {
  if (!(span > 0)) return 1;
  const double raw = span / 5, power = std::pow(10, std::floor(std::log10(raw)));
  for (double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power * 1.0001) return factor * power;
  return 10 * power;
}

int tick_digits(double step) { return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6); }

std::string text_at(double x, double y, const std::string& anchor, const std::string& text,
                    const std::string& style = "") {
  return std::string("<text") + (style.empty() ? "" : " class=\"" + style + "\"") + " x=\"" + number(x, 1) + "\" y=\"" +
         number(y, 1) + "\" text-anchor=\"" + anchor + "\">" + escaped(text) + "</text>";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& rest) {
  return "<line x1=\"" + number(x1, 1) + "\" y1=\"" + number(y1, 1) + "\" x2=\"" + number(x2, 1) + "\" y2=\"" +
         number(y2, 1) + "\" " + rest + "></line>";
}

// Rows of bars, one bar per variant: rows are families, so names stay readable however many there are.
std::string family_bars(const ReportData& data, double Metrics::*figure, int digits) {
  struct Row {
    std::string name;
    std::vector<std::optional<double>> values;
  };
  std::vector<Row> rows;
  Row total{"all characters", {}};
  for (const ReportVariant& v : data.variants) total.values.push_back(v.scores.all.*figure);
  rows.push_back(total);
  const std::vector<std::string> families = all_families(data);
  if (families.size() > 1) {
    for (const std::string& family : families) {
      Row row{family, {}};
      for (const ReportVariant& v : data.variants) {
        const Metrics* m = family_metrics(v, family);
        row.values.push_back(m ? std::optional<double>(m->*figure) : std::nullopt);
      }
      rows.push_back(row);
    }
  }
  double largest = 0;
  size_t longest_name = 0;
  for (const Row& row : rows) {
    longest_name = std::max(longest_name, row.name.size());
    for (const auto& value : row.values) largest = std::max(largest, value.value_or(0));
  }
  const double step = tick_step(largest), end = std::max(step, std::ceil(largest / step - 1e-9) * step);
  const double bar = 11, gap = 12, top = 6;
  const double left = 14 + 6.8 * static_cast<double>(longest_name), width = std::max(560.0, left + 300), right = 48;
  const double row_height = bar * static_cast<double>(data.variants.size()) + gap;
  const double bottom = top + row_height * static_cast<double>(rows.size());
  const auto x_of = [&](double value) { return left + (width - left - right) * value / end; };

  std::string out = "<svg viewBox=\"0 0 " + number(width, 0) + " " + number(bottom + 24, 0) + "\" role=\"img\">\n";
  for (int t = 0; t * step <= end * 1.0001; ++t) {
    const double x = x_of(t * step);
    out += line(x, top, x, bottom, "class=\"rule\"") +
           text_at(x, bottom + 16, "middle", number(t * step, tick_digits(step)), "tick") + "\n";
  }
  for (size_t r = 0; r < rows.size(); ++r) {
    const double y0 = top + row_height * static_cast<double>(r) + gap / 2;
    out += text_at(left - 8, y0 + (row_height - gap) / 2 + 4, "end", rows[r].name) + "\n";
    for (size_t i = 0; i < rows[r].values.size(); ++i) {
      if (!rows[r].values[i]) continue;
      const double value = *rows[r].values[i], y = y0 + bar * static_cast<double>(i);
      out += "<rect x=\"" + number(left, 1) + "\" y=\"" + number(y, 1) + "\" width=\"" +
             number(std::max(0.5, x_of(value) - left), 1) + "\" height=\"" + number(bar - 1.5, 1) +
             "\" rx=\"1.5\" style=\"fill:" + colour(i) + "\"><title>" +
             escaped(data.variants[i].label + ", " + rows[r].name + ": " + number(value, digits)) + "</title></rect>";
      if (data.variants.size() <= 3 || r == 0)
        out += text_at(x_of(value) + 5, y + bar - 2.2, "start", number(value, digits), "value");
      out += "\n";
    }
  }
  return out + "</svg>\n";
}

struct Axes {
  double x_low, x_high, y_low, y_high;
  double width = 560, height = 300, left = 58, right = 18, top = 12, bottom = 42;
  double x(double v) const { return left + (width - left - right) * (v - x_low) / (x_high - x_low); }
  double y(double v) const { return height - bottom - (height - top - bottom) * (v - y_low) / (y_high - y_low); }
  std::string frame(const std::string& x_label, int y_digits, double y_step) const {
    std::string out = "<svg viewBox=\"0 0 " + number(width, 0) + " " + number(height, 0) + "\" role=\"img\">\n";
    for (int t = 0; y_low + t * y_step <= y_high + 1e-9 * y_step; ++t) {
      const double at = y(y_low + t * y_step);
      out += line(left, at, width - right, at, "class=\"rule\"") +
             text_at(left - 7, at + 4, "end", number(y_low + t * y_step, y_digits), "tick") + "\n";
    }
    return out + text_at((left + width - right) / 2, height - 6, "middle", x_label, "tick") + "\n";
  }
};

// A line through the variants that have bits, a dashed level for those that have none of their own (heat).
std::string bits_plot(const ReportData& data) {
  std::vector<size_t> order;
  double low = INFINITY, high = -INFINITY;
  for (size_t i = 0; i < data.variants.size(); ++i) {
    const double l1 = data.variants[i].scores.all.l1;
    low = std::min(low, l1);
    high = std::max(high, l1);
    if (data.variants[i].bits > 0) order.push_back(i);
  }
  if (order.size() < 2) return "";
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return data.variants[a].bits < data.variants[b].bits; });
  const double room = std::max(0.15 * (high - low), 1e-4), step = tick_step(high - low + 2 * room);
  // Equal steps for each variant: float's 32 bits would squeeze the rest on a true axis.
  const double count = static_cast<double>(order.size());
  Axes axes{-0.5, count - 0.5, std::max(0.0, std::floor((low - room) / step) * step),
            std::ceil((high + room) / step) * step};
  std::string out = axes.frame("bits of the weights", tick_digits(step), step);
  for (size_t i = 0; i < data.variants.size(); ++i) {
    const ReportVariant& v = data.variants[i];
    if (v.bits > 0) continue;
    const double y = axes.y(v.scores.all.l1);
    out += line(axes.left, y, axes.width - axes.right, y,
                "style=\"stroke:" + colour(i) + ";stroke-width:1.5;stroke-dasharray:5 4\"") +
           text_at(axes.width - axes.right - 4, y - 5, "end", v.label + " " + number(v.scores.all.l1, 4)) + "\n";
  }
  std::string points, marks;
  for (size_t k = 0; k < order.size(); ++k) {
    const ReportVariant& v = data.variants[order[k]];
    const double x = axes.x(static_cast<double>(k)), y = axes.y(v.scores.all.l1);
    points += number(x, 1) + "," + number(y, 1) + " ";
    marks += "<circle cx=\"" + number(x, 1) + "\" cy=\"" + number(y, 1) +
             "\" r=\"5\" style=\"fill:" + colour(order[k]) + "\"><title>" +
             escaped(v.label + ": " + number(v.scores.all.l1, 5)) + "</title></circle>" +
             text_at(x, y - 11, "middle", number(v.scores.all.l1, 4)) +
             text_at(x, axes.height - axes.bottom + 17, "middle", std::to_string(v.bits), "tick") + "\n";
  }
  out += "<polyline points=\"" + points + "\" style=\"fill:none;stroke:var(--soft);stroke-width:1.5\"></polyline>\n" +
         marks;
  return out + "</svg>\n";
}

// L1 of each variant's characters from best to worst: where a variant loses, the middle or the tail.
std::string sorted_plot(const ReportData& data) {
  double highest = 0;
  for (const ReportVariant& v : data.variants)
    for (const auto& [name, m] : v.scores.characters) highest = std::max(highest, m.l1);
  const double step = tick_step(highest), top = std::max(step, std::ceil(highest / step - 1e-9) * step);
  Axes axes{0, 100, 0, top};
  std::string out = axes.frame("characters from best to worst, %", tick_digits(step), step);
  for (int t = 0; t <= 100; t += 25)
    out += text_at(axes.x(t), axes.height - axes.bottom + 17, "middle", std::to_string(t), "tick");
  for (size_t i = 0; i < data.variants.size(); ++i) {
    std::vector<double> values;
    for (const auto& [name, m] : data.variants[i].scores.characters) values.push_back(m.l1);
    std::sort(values.begin(), values.end());
    std::string points;
    for (size_t k = 0; k < values.size(); ++k) {
      const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(values.size());
      points += number(axes.x(100 * share), 1) + "," + number(axes.y(values[k]), 1) + " ";
    }
    out += "\n<polyline points=\"" + points + "\" style=\"fill:none;stroke:" + colour(i) +
           ";stroke-width:1.8;stroke-linejoin:round\"><title>" + escaped(data.variants[i].label) +
           "</title></polyline>";
    if (values.size() == 1)
      out += "<circle cx=\"" + number(axes.x(50), 1) + "\" cy=\"" + number(axes.y(values[0]), 1) +
             "\" r=\"4\" style=\"fill:" + colour(i) + "\"></circle>";
  }
  return out + "\n</svg>\n";
}

std::string card(const std::string& heading, const std::string& content) {
  return "<div><h2>" + escaped(heading) + "</h2>\n<div class=\"card\">" + content + "</div></div>\n";
}

std::string pictures(const ReportData& data) {
  if (data.pictures.empty()) return "";
  std::string out = "<h2>Characters</h2>\n<p class=\"soft\">Drawn with the weights of " +
                    escaped(data.variants[data.main_variant].label) +
                    ". One colour per joint, blended by weight; the error runs from dark blue (0) over yellow to red "
                    "(L1 of 1 or more).</p>\n";
  for (const ReportPicture& picture : data.pictures) {
    out += "<div class=\"card character\"><h3>" + escaped(picture.heading) + ": " + escaped(picture.character) +
           "<span>" + escaped(picture.note) + "</span></h3><div class=\"panels\">\n";
    for (const ReportPicture::Panel& panel : picture.panels)
      out += "<figure><img alt=\"" + escaped(picture.character + ", " + panel.caption) +
             "\" src=\"data:image/png;base64," + base64(panel.png) + "\" /><figcaption>" + escaped(panel.caption) +
             "</figcaption></figure>\n";
    out += "</div></div>\n";
  }
  return out;
}

void check(const ReportData& data) {
  if (data.variants.empty()) throw Error("report: there is no variant to report on");
  if (data.main_variant >= data.variants.size()) {
    throw Error("report: the main variant is number " + std::to_string(data.main_variant) + ", but there are " +
                std::to_string(data.variants.size()));
  }
}

}  // namespace

std::vector<std::pair<std::string, std::string>> best_median_worst(const Scores& scores) {
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [name, m] : scores.characters) order.emplace_back(m.l1, name);
  std::sort(order.begin(), order.end());
  std::vector<std::pair<std::string, std::string>> out;
  if (order.empty()) return out;
  out.emplace_back("best", order.front().second);
  if (order.size() > 2) out.emplace_back("median", order[order.size() / 2].second);
  if (order.size() > 1) out.emplace_back("worst", order.back().second);
  return out;
}

ReportPicture report_picture(const Character& reference, const std::vector<std::vector<Influence>>& predicted,
                             const std::string& heading, bool up_z, int side) {
  std::vector<float> errors;
  const Metrics m = measure(reference, predicted, reference.name, 10, &errors);
  Character bound = reference;
  bound.influences = predicted;

  RenderOptions options;
  options.width = options.height = side;
  options.up_z = up_z;
  options.draw_skeleton = false;
  RenderOptions with_skeleton = options;
  with_skeleton.draw_skeleton = true;
  std::vector<std::array<double, 3>> positions;
  for (const Joint& joint : reference.joints) {
    positions.push_back({static_cast<double>(joint.position.x), static_cast<double>(joint.position.y),
                         static_cast<double>(joint.position.z)});
  }
  const Character posed = apply_pose(bound, random_poses(reference, reference.name, positions).front());

  ReportPicture picture;
  picture.heading = heading;
  picture.character = reference.name;
  picture.note =
      "L1 " + number(m.l1, 3) + ", argmax " + number(100 * m.argmax, 1) + " %, avg dist " + number(m.avg_dist, 4);
  picture.panels = {{"reference weights", encode_png(render(reference, weight_colours(reference), with_skeleton))},
                    {"predicted weights", encode_png(render(bound, weight_colours(bound), with_skeleton))},
                    {"L1 error per vertex", encode_png(render(bound, heat_colours(errors, 1.0f), options))},
                    {"posed with the prediction", encode_png(render(posed, weight_colours(posed), options))}};
  return picture;
}

std::string quantisation_table_markdown(const ReportData& data) {
  check(data);
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

std::string report_html(const ReportData& data) {
  check(data);
  const ReportVariant& main = data.variants[data.main_variant];
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\" />"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" /><title>" +
      escaped(data.title) + "</title><style>" + kStyle + "</style></head>\n<body><main>\n<h1>" + escaped(data.title) +
      "</h1>\n";
  if (!data.summary.empty()) out += "<p>" + escaped(data.summary) + "</p>\n";
  if (!data.facts.empty()) {
    out += "<dl class=\"facts\">";
    for (const auto& [term, fact] : data.facts) out += "<dt>" + escaped(term) + "</dt><dd>" + escaped(fact) + "</dd>";
    out += "</dl>\n";
  }
  out +=
      "<h2>Variants</h2>\n<p class=\"soft\">Means over characters; L1 (families) counts each family the same. L1: sum "
      "over joints of |predicted - reference| per vertex (0 to 2). "
      "Distances: skinned vertices in 10 random poses, longest side of the mesh = 1. Flips: vertices whose strongest "
      "joint differs "
      "from the float variant's.</p>\n<div class=\"card\">" +
      variant_table(data) + "</div>\n";
  const std::string bits = bits_plot(data);
  out += "<div class=\"grid\">\n";
  if (!bits.empty()) out += card("L1 against bits", bits);
  out += card("L1 of every character, sorted", legend(data) + sorted_plot(data));
  out += card("L1 by family", legend(data) + family_bars(data, &Metrics::l1, 3));
  out += card("Deformation by family (mean distance)", legend(data) + family_bars(data, &Metrics::avg_dist, 4));
  out += "</div>\n" + pictures(data);
  if (all_families(data).size() > 1) out += card("Table of families (L1)", family_table(data));
  out += failure_list(data);
  out += "<h2>Every character</h2>\n<details class=\"card\"><summary>" + escaped(main.label) + ": " +
         std::to_string(main.scores.characters.size()) + " characters</summary>\n" + character_table(main) +
         "</details>\n";
  return out + "</main></body></html>\n";
}

}  // namespace sinew
