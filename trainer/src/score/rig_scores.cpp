// SPDX-License-Identifier: MIT
// The user's view of a predicted skeleton: which part of the surface moves with which bone. Means of rig scores over
// characters and families, and their table as Markdown and JSON.
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "sinew_formats/base/box.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_formats/vertex_areas.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/rig_score.hpp"

namespace sinew {
namespace {

constexpr double kMiddle = 0.01;  // of the longest side

// The joint of most weight where `to` says whom each joint's weight is for; -1 without any.
template <class To>
int strongest(const std::vector<Influence>& influences, size_t joints, std::vector<double>* sums, To&& to) {
  if (influences.empty()) return -1;
  sums->assign(joints, 0.0);
  for (const Influence& influence : influences) (*sums)[to(influence.joint)] += influence.weight;
  return static_cast<int>(std::max_element(sums->begin(), sums->end()) - sums->begin());
}

}  // namespace

double owned_surface(const BoundSkeleton& bound, const Character& character, const TargetSkeleton& reference) {
  const double limit = kMiddle * box_of(character.vertices).longest_side();
  const auto side = [&](double across) {
    return std::fabs(across - bound.plane) < limit ? 0 : across < bound.plane ? -1 : 1;
  };
  const std::vector<double> area = vertex_areas(character);
  std::vector<double> sums;
  double all = 0, right = 0;
  for (size_t v = 0; v < character.vertices.size(); ++v) {
    const int theirs = strongest(character.influences[v], reference.joints.size(), &sums,
                                 [&](uint32_t joint) { return reference.owners[joint]; });
    if (theirs < 0) continue;
    all += area[v];
    const int ours = strongest(bound.influences[v], bound.joints.size(), &sums, [](uint32_t joint) { return joint; });
    if (ours < 0) continue;
    const TargetJoint& a = reference.joints[static_cast<size_t>(theirs)];
    const Joint& b = bound.joints[static_cast<size_t>(ours)];
    const double across = bound.axis == 0 ? b.position.x : b.position.z;
    if (a.joint_class == bound.classes[static_cast<size_t>(ours)] &&
        side(a.position[static_cast<size_t>(bound.axis)]) == side(across)) {
      right += area[v];
    }
  }
  return all > 0 ? right / all : 0;
}

namespace {

using Json = nlohmann::ordered_json;

// Scores without anything to count are ignored.
RigScore mean(const std::vector<RigScore>& rows) {
  RigScore out;
  for (const RigFigure& figure : kRigFigures) {
    double sum = 0;
    size_t count = 0;
    for (const RigScore& row : rows) {
      if (std::isnan(row.*figure.value)) continue;
      sum += row.*figure.value;
      ++count;
    }
    out.*figure.value = count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::quiet_NaN();
  }
  return out;
}

std::string table_row(std::string label, const std::string& count, const RigScore& score) {
  std::string row = "| " + markdown_cell(std::move(label)) + " | " + count + " |";
  for (const RigFigure& figure : kRigFigures) {
    const double value = 100 * (score.*figure.value);
    row += std::isnan(value) ? " - |" : print(" %.2f |", value);
  }
  return row + "\n";
}

Json figures_json(const RigScore& score) {
  Json out = Json::object();
  for (const RigFigure& figure : kRigFigures) {
    const double value = score.*figure.value;
    out[figure.key] = std::isnan(value) ? Json(nullptr) : Json(value);
  }
  return out;
}

size_t complete_humanoids(const RigScores& scores) {
  return static_cast<size_t>(std::count_if(scores.humanoids.begin(), scores.humanoids.end(),
                                           [](const auto& one) { return one.second.empty(); }));
}

// Over characters, over families.
std::pair<double, double> mean_owned(const RigScores& scores) {
  std::map<std::string, std::pair<double, size_t>> families;
  double all = 0, means = 0;
  for (const auto& [name, owned] : scores.owned) {
    auto& [sum, count] = families[family_of(name)];
    sum += owned;
    ++count;
    all += owned;
  }
  for (const auto& [family, sum] : families) means += sum.first / static_cast<double>(sum.second);
  return {all / static_cast<double>(scores.owned.size()), means / static_cast<double>(families.size())};
}

}  // namespace

RigScores summarize(std::vector<std::pair<std::string, RigScore>> characters) {
  std::sort(characters.begin(), characters.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  RigScores scores;
  std::map<std::string, std::vector<RigScore>> members;
  std::vector<RigScore> everyone, families;
  for (const auto& [name, score] : characters) {
    members[family_of(name)].push_back(score);
    everyone.push_back(score);
  }
  for (const auto& [family, rows] : members) {
    scores.families[family] = mean(rows);
    scores.family_sizes[family] = rows.size();
    families.push_back(scores.families[family]);
  }
  scores.all = mean(everyone);
  scores.family_mean = mean(families);
  scores.characters = std::move(characters);
  return scores;
}

std::string rig_scores_markdown(const RigScores& scores) {
  std::string head = "| x 100 | n |", rule = "|---|---|";
  for (const RigFigure& figure : kRigFigures) {
    head += std::string(" ") + figure.key + " |";
    rule += "---|";
  }
  std::string table = head + "\n" + rule + "\n";
  for (const auto& [family, score] : scores.families)
    table += table_row(family, std::to_string(scores.family_sizes.at(family)), score);
  table += table_row("mean of characters", std::to_string(scores.characters.size()), scores.all);
  table += table_row("mean of families", std::to_string(scores.families.size()), scores.family_mean);
  if (!scores.humanoids.empty())
    table += print("\nhumanoids with all 15 bones: %zu of %zu\n", complete_humanoids(scores), scores.humanoids.size());
  for (const auto& [name, gaps] : scores.humanoids) {
    for (size_t i = 0; i < gaps.size(); ++i) table += (i == 0 ? "  " + name + ": " : ", ") + gaps[i];
    if (!gaps.empty()) table += "\n";
  }
  if (!scores.owned.empty()) {
    const auto [all, families] = mean_owned(scores);
    table += print("\nsurface that moves with the reference's class and side after a bind: %.2f, families %.2f\n",
                   100 * all, 100 * families);
  }
  if (!scores.failures.empty()) {
    table += print("\nfailed %zu:", scores.failures.size());
    for (const auto& [name, why] : scores.failures) table += " " + name;
    table += "\n";
  }
  return table;
}

std::string rig_scores_json(const RigScores& scores) {
  Json out;
  out["families"] = Json::object();
  for (const auto& [family, score] : scores.families) {
    out["families"][family] = figures_json(score);
    out["families"][family]["characters"] = scores.family_sizes.at(family);
  }
  out["characters_mean"] = figures_json(scores.all);
  out["families_mean"] = figures_json(scores.family_mean);
  out["failed"] = Json::array();
  for (const auto& [name, why] : scores.failures) out["failed"].push_back(name);
  out["failures"] = scores.failures;
  out["humanoids"] = {{"asked", scores.humanoids.size()}, {"complete", complete_humanoids(scores)}};
  out["characters"] = Json::object();
  for (const auto& [name, score] : scores.characters) {
    out["characters"][name] = figures_json(score);
    const auto humanoid = scores.humanoids.find(name);
    if (humanoid != scores.humanoids.end()) out["characters"][name]["humanoid_gaps"] = humanoid->second;
    const auto owned = scores.owned.find(name);
    if (owned != scores.owned.end()) out["characters"][name]["owned"] = owned->second;
  }
  return out.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace sinew
