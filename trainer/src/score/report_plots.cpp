// SPDX-License-Identifier: MIT
// Plots of the report.
#include <algorithm>
#include <cmath>

#include "score/report_parts.hpp"
#include "sinew_character/page/html.hpp"
#include "sinew_data_sets/plots.hpp"

namespace sinew {

std::string family_bars(const ReportData& data, double Metrics::*figure, int digits, double factor) {
  std::vector<html::BarRow> rows = {{"all characters", {}}};
  for (const ReportVariant& v : data.variants) rows[0].values.emplace_back(factor * (v.scores.all.*figure));
  const std::vector<std::string> families = report_families(data);
  if (families.size() > 1) {
    for (const std::string& family : families) {
      html::BarRow row{family, {}};
      for (const ReportVariant& v : data.variants) {
        const Metrics* m = family_metrics(v, family);
        row.values.push_back(m ? std::optional<double>(factor * (m->*figure)) : std::nullopt);
      }
      rows.push_back(std::move(row));
    }
  }
  html::BarOptions options;
  options.digits = digits;
  options.all_values = data.variants.size() <= 3;
  return html::bars(variant_labels(data), rows, options);
}

// A line through the variants that have bits, a dashed level for those that have none of their own (heat).
std::string bits_plot(const ReportData& data) {
  std::vector<size_t> order;
  double low = INFINITY, high = -INFINITY;
  for (size_t i = 0; i < data.variants.size(); ++i) {
    if (data.variants[i].bits == 0) continue;
    order.push_back(i);
    low = std::min(low, data.variants[i].scores.all.l1);
    high = std::max(high, data.variants[i].scores.all.l1);
  }
  if (order.size() < 2) return "";
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return data.variants[a].bits < data.variants[b].bits; });
  html::LineOptions options;
  for (const ReportVariant& v : data.variants) {
    // A level far away would squeeze the line that the plot is about.
    if (v.bits > 0 || v.scores.all.l1 > high + 0.1) continue;
    options.levels.emplace_back(v.scores.all.l1, v.label + " " + html::number(v.scores.all.l1, 4));
    low = std::min(low, v.scores.all.l1);
    high = std::max(high, v.scores.all.l1);
  }
  const double room = std::max(0.15 * (high - low), 1e-4), step = html::tick_step(high - low + 2 * room);
  // Equal steps for each variant: float's 32 bits would squeeze the rest on a true axis.
  options.x_low = -0.5;
  options.x_high = static_cast<double>(order.size()) - 0.5;
  options.y_low = std::max(0.0, std::floor((low - room) / step) * step);
  options.y_high = std::ceil((high + room) / step) * step;
  options.x_label = "bits of the weights";
  options.y_label = "L1 (lower is better)";
  html::Series line{"L1", {}, 0, true, true, 5};
  for (size_t k = 0; k < order.size(); ++k) {
    line.points.emplace_back(static_cast<double>(k), data.variants[order[k]].scores.all.l1);
    options.x_ticks.emplace_back(static_cast<double>(k), std::to_string(data.variants[order[k]].bits));
  }
  return html::lines({line}, options);
}

// L1 of each variant's characters from best to worst: where a variant loses, the middle or the tail.
std::string sorted_plot(const ReportData& data) {
  html::LineOptions options;
  options.x_high = 100;
  options.x_label = "characters from best to worst, %";
  options.y_label = "L1 (lower is better)";
  std::vector<html::Series> series;
  for (size_t i = 0; i < data.variants.size(); ++i) {
    std::vector<double> values;
    for (const auto& [name, m] : data.variants[i].scores.characters) values.push_back(m.l1);
    std::sort(values.begin(), values.end());
    html::Series line{data.variants[i].label, {}, i};
    for (size_t k = 0; k < values.size(); ++k)
      line.points.emplace_back(100 * (static_cast<double>(k) + 0.5) / static_cast<double>(values.size()), values[k]);
    series.push_back(std::move(line));
  }
  return html::lines(series, options);
}

// Every character of the main variant in every pose, in the order of its mean; the means of heat beside it, if it is
// there.
std::string deformation_plot(const ReportData& data) {
  const ReportVariant& main = data.variants[data.main_variant];
  if (main.pose_distances.empty()) return "";
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v / static_cast<double>(values.size());
    return sum;
  };
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [name, distances] : main.pose_distances) order.emplace_back(mean(distances), name);
  std::sort(order.begin(), order.end());
  html::Series poses{main.label + ", one pose", {}, data.main_variant, true, false, 1.8};
  html::Series means{main.label + ", mean", {}, data.main_variant};
  std::vector<html::Series> series;
  for (size_t k = 0; k < order.size(); ++k) {
    const double x = static_cast<double>(k) + 1;
    means.points.emplace_back(x, order[k].first);
    for (const double d : main.pose_distances.at(order[k].second)) poses.points.emplace_back(x, d);
  }
  series.push_back(poses);
  for (size_t i = 0; i < data.variants.size(); ++i) {
    if (i == data.main_variant || data.variants[i].label != "heat") continue;
    html::Series heat{"heat, mean", {}, i, true, false, 3.2};
    for (size_t k = 0; k < order.size(); ++k) {
      const auto found = data.variants[i].pose_distances.find(order[k].second);
      if (found != data.variants[i].pose_distances.end())
        heat.points.emplace_back(static_cast<double>(k) + 1, mean(found->second));
    }
    series.push_back(std::move(heat));
  }
  series.push_back(means);
  html::LineOptions options;
  options.x_low = 0;
  options.x_high = static_cast<double>(order.size()) + 1;
  options.x_label = "characters, from the best to the worst deformed";
  options.y_label = "distance, longest side = 1";
  return html::lines(series, options);
}

std::string difference_plot(const WeightDifference& difference) {
  std::vector<std::pair<std::string, double>> values;
  for (size_t step = 0; step < WeightDifference::kSteps; ++step) {
    values.emplace_back(WeightDifference::step_name(step),
                        difference.weights()
                            ? static_cast<double>(difference.steps[step]) / static_cast<double>(difference.weights())
                            : 0);
  }
  html::ColumnOptions options;
  options.x_label = "difference of a weight in 255ths";
  options.y_label = "% of the weights";
  options.factor = 100;
  options.digits = 3;
  options.high = 100;
  return html::columns(values, options);
}

}  // namespace sinew
