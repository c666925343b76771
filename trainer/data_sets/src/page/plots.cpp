// SPDX-License-Identifier: MIT
// Bars, lines, histograms and columns drawn as SVG; numbers in the markup have one decimal, so pages stay small.
#include "sinew_data_sets/plots.hpp"

#include <algorithm>
#include <cmath>

#include "sinew_character/page/html.hpp"

namespace sinew::html {
namespace {

std::string text_at(double x, double y, const std::string& anchor, const std::string& text,
                    const std::string& style = "") {
  return std::string("<text") + (style.empty() ? "" : " class=\"" + style + "\"") + " x=\"" + number(x, 1) + "\" y=\"" +
         number(y, 1) + "\" text-anchor=\"" + anchor + "\">" + escape(text) + "</text>";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& rest) {
  return "<line x1=\"" + number(x1, 1) + "\" y1=\"" + number(y1, 1) + "\" x2=\"" + number(x2, 1) + "\" y2=\"" +
         number(y2, 1) + "\" " + rest + "></line>";
}

std::string box(double x, double y, double width, double height, size_t series, const std::string& title) {
  return "<rect x=\"" + number(x, 1) + "\" y=\"" + number(y, 1) + "\" width=\"" + number(width, 1) + "\" height=\"" +
         number(height, 1) + "\" rx=\"1.5\" style=\"fill:" + color(series) + "\"><title>" + escape(title) +
         "</title></rect>";
}

std::string open_svg(double width, double height) {
  return "<svg viewBox=\"0 0 " + number(width, 0) + " " + number(height, 0) + "\" role=\"img\">\n";
}

struct Axes {
  double x_low, x_high, y_low, y_high;
  double width = 560, height = 300, left = 62, right = 18, top = 14, bottom = 42;
  double x(double v) const { return left + (width - left - right) * (v - x_low) / (x_high - x_low); }
  double y(double v) const { return height - bottom - (height - top - bottom) * (v - y_low) / (y_high - y_low); }
  double below() const { return height - bottom + 17; }
  // Opens the picture: horizontal rules with their numbers, names of both axes.
  std::string frame(const std::string& x_label, const std::string& y_label, double y_step) const {
    std::string out = open_svg(width, height);
    for (int t = 0; y_low + t * y_step <= y_high + 1e-9 * y_step; ++t) {
      const double at = y(y_low + t * y_step);
      out += line(left, at, width - right, at, "class=\"rule\"") +
             text_at(left - 7, at + 4, "end", number(y_low + t * y_step, tick_digits(y_step)), "tick") + "\n";
    }
    if (!y_label.empty()) {
      const std::string x_at = number(13, 1), y_at = number((top + height - bottom) / 2, 1);
      out += "<text class=\"tick\" text-anchor=\"middle\" transform=\"rotate(-90 " + x_at + " " + y_at + ")\" x=\"" +
             x_at + "\" y=\"" + y_at + "\">" + escape(y_label) + "</text>\n";
    }
    return out + text_at((left + width - right) / 2, height - 6, "middle", x_label, "tick") + "\n";
  }
};

double round_up(double value, double step) { return std::max(step, std::ceil(value / step - 1e-9) * step); }

std::string short_number(double value) {
  if (value >= 1e6) return number(value / 1e6, value < 1e7 ? 1 : 0) + " M";
  if (value >= 1e4) return number(value / 1e3, 0) + " k";
  if (value >= 1e3) return number(value / 1e3, 1) + " k";
  return number(value, value == std::floor(value) ? 0 : 1);
}

}  // namespace

double tick_step(double span) {
  if (!(span > 0)) return 1;
  const double raw = span / 5, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power * 1.0001) return factor * power;
  return 10 * power;
}

int tick_digits(double step) { return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6); }

std::string bars(const std::vector<std::string>& series, const std::vector<BarRow>& rows, const BarOptions& options) {
  double largest = options.low;
  size_t longest_name = 0;
  for (const BarRow& row : rows) {
    longest_name = std::max(longest_name, row.name.size());
    for (const auto& value : row.values) largest = std::max(largest, value.value_or(0));
  }
  const double step = tick_step((options.high > 0 ? options.high : largest) - options.low);
  const double end = options.high > 0 ? options.high : options.low + round_up(largest - options.low, step);
  const double bar = 11, gap = 12, top = 6;
  const double left = 14 + 6.8 * static_cast<double>(longest_name), width = std::max(560.0, left + 300), right = 48;
  const double row_height = bar * static_cast<double>(series.size()) + gap;
  const double bottom = top + row_height * static_cast<double>(rows.size());
  const auto x_of = [&](double value) {
    return left + (width - left - right) * (std::max(value, options.low) - options.low) / (end - options.low);
  };
  std::string out = open_svg(width, bottom + 24);
  for (int t = 0; options.low + t * step <= end + 1e-4 * step; ++t) {
    const double x = x_of(options.low + t * step);
    out += line(x, top, x, bottom, "class=\"rule\"") +
           text_at(x, bottom + 16, "middle", number(options.low + t * step, tick_digits(step)), "tick") + "\n";
  }
  for (size_t r = 0; r < rows.size(); ++r) {
    const double y0 = top + row_height * static_cast<double>(r) + gap / 2;
    out += text_at(left - 8, y0 + (row_height - gap) / 2 + 4, "end", rows[r].name) + "\n";
    for (size_t i = 0; i < rows[r].values.size(); ++i) {
      if (!rows[r].values[i]) continue;
      const double value = *rows[r].values[i], y = y0 + bar * static_cast<double>(i);
      out += box(left, y, std::max(0.5, x_of(value) - left), bar - 1.5, i,
                 series[i] + ", " + rows[r].name + ": " + number(value, options.digits));
      if (options.all_values || r == 0)
        out += text_at(x_of(value) + 5, y + bar - 2.2, "start", number(value, options.digits), "value");
      out += "\n";
    }
  }
  return out + "</svg>\n";
}

std::string lines(const std::vector<Series>& series, const LineOptions& options) {
  double highest = options.y_low;
  for (const Series& s : series)
    for (const auto& [x, y] : s.points) highest = std::max(highest, y);
  for (const auto& [level, name] : options.levels) highest = std::max(highest, level);
  const double step = tick_step((options.y_high > 0 ? options.y_high : highest) - options.y_low);
  const Axes axes{options.x_low, options.x_high, options.y_low,
                  options.y_high > 0 ? options.y_high : options.y_low + round_up(highest - options.y_low, step)};
  std::string out = axes.frame(options.x_label, options.y_label, step);
  if (options.x_ticks.empty()) {
    const double x_step = tick_step(options.x_high - options.x_low);
    for (int t = 0; options.x_low + t * x_step <= options.x_high + 1e-9 * x_step; ++t)
      out += text_at(axes.x(options.x_low + t * x_step), axes.below(), "middle",
                     number(options.x_low + t * x_step, tick_digits(x_step)), "tick");
  }
  for (const auto& [x, name] : options.x_ticks) out += text_at(axes.x(x), axes.below(), "middle", name, "tick");
  if (options.diagonal) {
    const double low = std::max(options.x_low, axes.y_low), high = std::min(options.x_high, axes.y_high);
    out += line(axes.x(low), axes.y(low), axes.x(high), axes.y(high),
                "style=\"stroke:var(--soft);stroke-width:1.2;stroke-dasharray:5 4\"");
  }
  for (const auto& [level, name] : options.levels) {
    out += line(axes.left, axes.y(level), axes.width - axes.right, axes.y(level),
                "style=\"stroke:var(--soft);stroke-width:1.2;stroke-dasharray:5 4\"") +
           text_at(axes.width - axes.right - 4, axes.y(level) - 5, "end", name);
  }
  for (const Series& s : series) {
    if (s.line && s.points.size() > 1) {
      std::string points;
      for (const auto& [x, y] : s.points) points += number(axes.x(x), 1) + "," + number(axes.y(y), 1) + " ";
      out += "\n<polyline points=\"" + points + "\" style=\"fill:none;stroke:" + color(s.color) +
             ";stroke-width:1.8;stroke-linejoin:round\"><title>" + escape(s.label) + "</title></polyline>";
    }
    if (!s.dots && s.points.size() > 1) continue;
    for (const auto& [x, y] : s.points)
      out += "<circle cx=\"" + number(axes.x(x), 1) + "\" cy=\"" + number(axes.y(y), 1) + "\" r=\"" +
             number(s.dot_radius, 1) + "\" style=\"fill:" + color(s.color) + (s.line ? "" : ";fill-opacity:0.55") +
             "\"></circle>";
  }
  return out + "\n</svg>\n";
}

std::string columns(const std::vector<std::pair<std::string, double>>& values, const ColumnOptions& options) {
  double highest = 0;
  for (const auto& [name, value] : values) highest = std::max(highest, options.factor * value);
  const double step = tick_step(options.high > 0 ? options.high : highest);
  const Axes axes{0, std::max(1.0, static_cast<double>(values.size())), 0,
                  options.high > 0 ? options.high : round_up(highest, step)};
  std::string out = axes.frame(options.x_label, options.y_label, step);
  for (size_t i = 0; i < values.size(); ++i) {
    const double value = options.factor * values[i].second;
    const double left = axes.x(static_cast<double>(i) + 0.12), right = axes.x(static_cast<double>(i) + 0.88);
    const std::string text = number(value, options.digits);
    if (value > 0)
      out += box(left, axes.y(value), right - left, axes.y(0) - axes.y(value), 0, values[i].first + ": " + text);
    if (options.numbers) out += text_at((left + right) / 2, axes.y(value) - 4, "middle", text, "value");
    out += text_at((left + right) / 2, axes.below(), "middle", values[i].first, "tick") + "\n";
  }
  return out + "</svg>\n";
}

std::string histogram(const std::vector<double>& values, const HistogramOptions& options) {
  if (values.empty()) return "";
  const bool logs = options.logarithmic && *std::min_element(values.begin(), values.end()) > 0;
  const auto position = [&](double v) { return logs ? std::log10(v) : v; };
  double low = INFINITY, high = -INFINITY;
  for (const double v : values) {
    low = std::min(low, position(v));
    high = std::max(high, position(v));
  }
  // Whole numbers get whole bins: a bin that holds one more integer than its neighbors would look like a peak.
  double width = (high - low) / static_cast<double>(options.bins);
  if (logs) {
    width = std::max(width, 0.05);
  } else {
    width = std::max(1.0, std::ceil(width - 1e-9));
    low = std::floor(low);
  }
  const auto bin_count = std::max<size_t>(1, static_cast<size_t>(std::floor((high - low) / width + 1e-9)) + 1);
  std::vector<size_t> bins(bin_count, 0);
  for (const double v : values)
    ++bins[std::min(bin_count - 1, static_cast<size_t>(std::max(0.0, (position(v) - low) / width + 1e-9)))];
  const double end = low + width * static_cast<double>(bin_count);
  const size_t highest = *std::max_element(bins.begin(), bins.end());
  const double step = std::max(1.0, tick_step(static_cast<double>(highest)));
  const Axes axes{low, end, 0, round_up(static_cast<double>(highest), step)};
  std::string out = axes.frame(options.x_label, "characters", step);
  for (size_t b = 0; b < bin_count; ++b) {
    if (bins[b] == 0) continue;
    const double from = low + width * static_cast<double>(b), to = from + width;
    const double shown_from = logs ? std::pow(10, from) : from, shown_to = logs ? std::pow(10, to) : to - 1;
    const double height = static_cast<double>(bins[b]);
    out += box(axes.x(from) + 1, axes.y(height), axes.x(to) - axes.x(from) - 2, axes.y(0) - axes.y(height), 0,
               std::to_string(bins[b]) + " from " + short_number(shown_from) + " to " + short_number(shown_to)) +
           "\n";
  }
  if (logs) {
    for (int decade = static_cast<int>(std::floor(low)); decade <= static_cast<int>(std::ceil(end)); ++decade) {
      for (const double factor : {1.0, 2.0, 5.0}) {
        const double at = decade + std::log10(factor);
        if (at < low || at > end) continue;
        out += text_at(axes.x(at), axes.below(), "middle", short_number(factor * std::pow(10, decade)), "tick");
      }
    }
  } else {
    const double x_step = std::max(1.0, tick_step(end - low));
    for (double at = std::ceil(low / x_step) * x_step; at < end; at += x_step)
      out += text_at(axes.x(at + (width <= 1 ? 0.5 : 0)), axes.below(), "middle", short_number(at), "tick");
  }
  return out + "\n</svg>\n";
}

}  // namespace sinew::html
