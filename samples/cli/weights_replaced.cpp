// SPDX-License-Identifier: MIT
// Old weights beside new ones.
#include "weights_replaced.hpp"

#include <algorithm>
#include <cmath>

#include "sinew_formats/print.hpp"

namespace sinew::cli {
namespace {

constexpr size_t kShown = 10;

double sum_of(const std::vector<Influence>& row) {
  double sum = 0;
  for (const Influence& i : row) sum += static_cast<double>(i.weight);
  return sum;
}

// Adds a row's weights times `factor` to differences [J], and notes the joints it touched.
void add_row(const std::vector<Influence>& row, double factor, std::vector<double>* differences,
             std::vector<uint32_t>* touched) {
  for (const Influence& i : row) {
    (*differences)[i.joint] += factor * static_cast<double>(i.weight);
    touched->push_back(i.joint);
  }
}

std::string thousands(size_t value) {
  std::string text = std::to_string(value);
  for (size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

}  // namespace

WeightsReplaced compare_weights(const std::vector<Joint>& joints, const std::vector<std::vector<Influence>>& before,
                                const std::vector<std::vector<Influence>>& after, const std::vector<uint8_t>& kept) {
  WeightsReplaced out;
  std::vector<JointChange> changes(joints.size());
  std::vector<double> differences(joints.size(), 0);
  std::vector<uint32_t> touched;
  for (size_t v = 0; v < std::min(before.size(), after.size()); ++v) {
    const double sum = sum_of(before[v]);
    if (!(sum > 0) || after[v].empty() || (!kept.empty() && kept[v] != 0)) continue;
    touched.clear();
    add_row(after[v], 1, &differences, &touched);
    add_row(before[v], -1 / sum, &differences, &touched);
    double l1 = 0;
    for (const uint32_t joint : touched) {
      l1 += std::fabs(differences[joint]);
      differences[joint] = 0;
    }
    const auto strongest = std::max_element(before[v].begin(), before[v].end(),
                                            [](const Influence& a, const Influence& b) { return a.weight < b.weight; });
    changes[strongest->joint].l1 += l1;
    ++changes[strongest->joint].vertices;
    out.l1 += l1;
    ++out.vertices;
  }
  if (out.vertices > 0) out.l1 /= static_cast<double>(out.vertices);
  for (size_t j = 0; j < changes.size(); ++j) {
    if (changes[j].vertices == 0) continue;
    changes[j].joint = joints[j].name;
    changes[j].l1 /= static_cast<double>(changes[j].vertices);
    out.changes.push_back(changes[j]);
  }
  std::stable_sort(out.changes.begin(), out.changes.end(),
                   [](const JointChange& a, const JointChange& b) { return a.l1 > b.l1; });
  return out;
}

std::string replaced_text(const WeightsReplaced& replaced) {
  if (replaced.vertices == 0) return "";
  return print("replaced the weights of %s vertices; they were L1 %.2f away", thousands(replaced.vertices).c_str(),
               replaced.l1);
}

std::vector<std::string> change_lines(const WeightsReplaced& replaced) {
  std::vector<std::string> lines;
  size_t width = 5;
  const size_t count = std::min(kShown, replaced.changes.size());
  for (size_t i = 0; i < count; ++i) width = std::max(width, replaced.changes[i].joint.size());
  const int columns = static_cast<int>(std::min<size_t>(width, 40));
  lines.push_back(print("  %-*s  vertices  mean L1", columns, "joint"));
  for (size_t i = 0; i < count; ++i) {
    const JointChange& change = replaced.changes[i];
    lines.push_back(print("  %-*s  %8zu  %7.2f", columns, change.joint.c_str(), change.vertices, change.l1));
  }
  return lines;
}

nlohmann::ordered_json replaced_json(const WeightsReplaced& replaced, bool with_joints) {
  nlohmann::ordered_json json = {{"vertices", replaced.vertices}, {"l1", replaced.l1}};
  if (!with_joints) return json;
  json["joints"] = nlohmann::ordered_json::array();
  for (size_t i = 0; i < std::min(kShown, replaced.changes.size()); ++i) {
    const JointChange& change = replaced.changes[i];
    json["joints"].push_back({{"joint", change.joint}, {"vertices", change.vertices}, {"l1", change.l1}});
  }
  return json;
}

}  // namespace sinew::cli
