// SPDX-License-Identifier: MIT
// Means over characters and families, and the tables of the yardstick as Markdown and JSON.
#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_trainer/evaluate.hpp"

namespace sinew {
namespace {

using Named = std::pair<std::string, Metrics>;

struct MetricFigure {
  const char* key;  // as in the yardstick's JSON, which has l1_file as l1 with --ends keep
  double Metrics::*value;
};
constexpr std::array<MetricFigure, 13> kMetricFigures = {{{"precision", &Metrics::precision},
                                                          {"recall", &Metrics::recall},
                                                          {"l1", &Metrics::l1},
                                                          {"l1_file", &Metrics::l1_file},
                                                          {"avg_dist", &Metrics::avg_dist},
                                                          {"max_dist", &Metrics::max_dist},
                                                          {"argmax", &Metrics::argmax},
                                                          {"kl", &Metrics::kl},
                                                          {"bad", &Metrics::bad},
                                                          {"l1_area", &Metrics::l1_area},
                                                          {"max_dist_all", &Metrics::max_dist_all},
                                                          {"infl", &Metrics::influences},
                                                          {"unweighted", &Metrics::unweighted}}};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

// Run times are medians: one slow character would say nothing about the rest. 0 = not timed.
double median_seconds(const std::vector<Named>& characters) {
  std::vector<double> times;
  for (const auto& [name, m] : characters)
    if (m.seconds > 0) times.push_back(m.seconds);
  return median(times);
}

double median_seconds_per_1000(const std::vector<Named>& characters) {
  std::vector<double> times;
  for (const auto& [name, m] : characters)
    if (m.seconds > 0) times.push_back(1000 * m.seconds / static_cast<double>(std::max<size_t>(1, m.vertices)));
  return median(times);
}

Metrics mean(const std::vector<Named>& rows) {
  Metrics out;
  for (const auto& [name, m] : rows) {
    for (const MetricFigure& figure : kMetricFigures)
      out.*figure.value += m.*figure.value / static_cast<double>(rows.size());
    out.vertices += m.vertices;
    out.unbound += m.unbound;
    out.joints += m.joints;
  }
  out.seconds = median_seconds(rows);
  return out;
}

std::vector<Named> members(const Scores& scores, const std::string& family) {
  std::vector<Named> out;
  for (const Named& character : scores.characters)
    if (family_of(character.first) == family) out.push_back(character);
  return out;
}

std::set<std::string> family_names(const Scores& scores) {
  std::set<std::string> names;
  for (const auto& [name, m] : scores.characters) names.insert(family_of(name));
  for (const auto& [name, note] : scores.failures) names.insert(family_of(name));
  return names;
}

constexpr const char* kColumns =
    "| method | n | prec % | rec % | L1 | L1 in file | avg dist | max dist | argmax % | KL | L1>0.5 % | fail | s/char "
    "| "
    "s/1k vert |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";

std::string seconds_text(double seconds) {
  if (seconds <= 0) return "-";
  return print("%.2f", seconds);
}

std::string table_row(std::string label, const Metrics& m, const std::vector<Named>& characters, size_t failures) {
  label = markdown_cell(std::move(label));
  if (characters.empty())
    return "| " + label + " | 0 | - | - | - | - | - | - | - | - | - | " + std::to_string(failures) + " | - | - |\n";
  const std::string text = print(" | %zu | %.1f | %.1f | %.3f | %.3f | %.4f | %.3f | %.1f | %.2f | %.1f | %zu | ",
                                 characters.size(), 100 * m.precision, 100 * m.recall, m.l1, m.l1_file, m.avg_dist,
                                 m.max_dist, 100 * m.argmax, m.kl, 100 * m.bad, failures);
  return "| " + label + text + seconds_text(m.seconds) + " | " + seconds_text(median_seconds_per_1000(characters)) +
         " |\n";
}

nlohmann::json figures_json(const Metrics& m) {
  nlohmann::json out;
  for (const MetricFigure& figure : kMetricFigures) out[figure.key] = m.*figure.value;
  return out;
}

nlohmann::json seconds_json(double seconds) { return seconds > 0 ? nlohmann::json(seconds) : nlohmann::json(nullptr); }

nlohmann::json mean_json(const Metrics& m, const std::vector<Named>& characters) {
  nlohmann::json out = figures_json(m);
  out["characters"] = characters.size();
  out["seconds"] = seconds_json(m.seconds);
  out["seconds_per_1000"] = seconds_json(median_seconds_per_1000(characters));
  return out;
}

}  // namespace

Scores summarize(std::vector<std::pair<std::string, Metrics>> characters) {
  Scores scores;
  scores.characters = std::move(characters);
  std::sort(scores.characters.begin(), scores.characters.end(),
            [](const Named& a, const Named& b) { return a.first < b.first; });
  scores.all = mean(scores.characters);
  std::vector<Named> families;
  for (const std::string& family : family_names(scores)) {
    const Metrics m = mean(members(scores, family));
    scores.families[family] = m;
    families.emplace_back(family, m);
  }
  scores.family_mean = mean(families);
  scores.family_mean.seconds = scores.all.seconds;
  return scores;
}

std::vector<std::pair<std::string, double>> beaten_by(const Scores& scores, const Scores& other) {
  std::map<std::string, double> theirs;
  for (const auto& [name, m] : other.characters) theirs[name] = m.l1;
  std::vector<std::pair<std::string, double>> out;
  for (const auto& [name, m] : scores.characters) {
    const auto found = theirs.find(name);
    if (found != theirs.end() && found->second < m.l1) out.emplace_back(name, m.l1 - found->second);
  }
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  return out;
}

std::string scores_markdown(const std::string& label, const Scores& scores) {
  std::string out = kColumns + table_row(label, scores.all, scores.characters, scores.failures.size());
  const std::set<std::string> families = family_names(scores);
  if (families.size() > 1) {
    out += "\n**mean of the " + std::to_string(families.size()) + " families** (each family counts the same)\n\n";
    out += kColumns + table_row(label, scores.family_mean, scores.characters, scores.failures.size());
  }
  if (families.empty() || families == std::set<std::string>{"all"}) return out;
  for (const std::string& family : families) {
    const std::vector<Named> rows = members(scores, family);
    const auto failures = static_cast<size_t>(std::count_if(
        scores.failures.begin(), scores.failures.end(), [&](const auto& f) { return family_of(f.first) == family; }));
    out += "\n**" + family + "**\n\n" + kColumns;
    out += table_row(label, rows.empty() ? Metrics{} : scores.families.at(family), rows, failures);
  }
  return out;
}

std::string scores_json(const std::string& label, const Scores& scores) {
  nlohmann::json out;
  out["characters"] = nlohmann::json::object();
  for (const auto& [name, m] : scores.characters) {
    nlohmann::json row = figures_json(m);
    row["vertices"] = m.vertices;
    row["unbound"] = m.unbound;
    row["joints"] = m.joints;
    row["seconds"] = seconds_json(m.seconds);
    out["characters"][name] = row;
  }
  out["families"] = nlohmann::json::object();
  for (const auto& [family, m] : scores.families) out["families"][family] = mean_json(m, members(scores, family));
  out["all"] = mean_json(scores.all, scores.characters);
  out["family_mean"] = scores.families.empty() ? nlohmann::json::object() : figures_json(scores.family_mean);
  out["failures"] = scores.failures;
  out["references"] = scores.characters.size() + scores.failures.size();
  return nlohmann::json{{label, out}}.dump(1) + "\n";
}

}  // namespace sinew
