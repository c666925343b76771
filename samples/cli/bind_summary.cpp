// SPDX-License-Identifier: MIT
// Old weights beside new ones, the least sure vertices, and all of it as text and JSON.
#include "bind_summary.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "sinew_formats/print.hpp"
#include "support.hpp"

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
  return print("replaced the weights of %s vertices (mean L1 difference %.2f)", thousands(replaced.vertices).c_str(),
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

Doubts find_doubts(const Character& character, const std::vector<uint8_t>& confidence) {
  constexpr double kSureEnough = 0.98;
  Doubts doubts;
  std::vector<std::tuple<uint8_t, float, size_t>> order;
  for (size_t v = 0; v < confidence.size(); ++v) {
    if (!character.influences[v].empty()) order.emplace_back(confidence[v], character.influences[v][0].weight, v);
  }
  const size_t tenth = (order.size() + 9) / 10;
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(tenth), order.end());
  std::vector<std::pair<size_t, size_t>> counts(character.joints.size());  // vertices, joints in reverse for ties
  for (size_t j = 0; j < counts.size(); ++j) counts[j].second = counts.size() - 1 - j;
  for (size_t i = 0; i < tenth; ++i) {
    const auto& [sure, weight, vertex] = order[i];
    doubts.vertices.push_back(vertex);
    doubts.sure += sure / 255.0 / static_cast<double>(tenth);
    ++counts[character.influences[vertex][0].joint].first;
  }
  if (doubts.sure >= kSureEnough) return {};
  std::sort(counts.rbegin(), counts.rend());
  for (size_t i = 0; i < counts.size() && i < 3 && counts[i].first > 0; ++i)
    doubts.joints.push_back(character.joints[counts.size() - 1 - counts[i].second].name);
  return doubts;
}

void count_weights(const Character& character, BindSummary* summary) {
  summary->vertices = character.vertices.size();
  summary->faces = character.face_count();
  summary->joints = character.joints.size();
  size_t pairs = 0;
  std::vector<bool> used(character.joints.size(), false);
  for (const std::vector<Influence>& row : character.influences) {
    pairs += row.size();
    for (const Influence& i : row) used[i.joint] = true;
  }
  summary->joints_used = static_cast<size_t>(std::count(used.begin(), used.end(), true));
  summary->mean_influences =
      static_cast<double>(pairs) / static_cast<double>(std::max<size_t>(1, character.vertices.size()));
}

std::string doubts_text(const Doubts& doubts) {
  if (doubts.vertices.empty()) return "";
  return print("check first: %zu vertices (the least certain tenth; %.0f %% confidence on average), mostly on ",
               doubts.vertices.size(), 100 * doubts.sure) +
         joined(doubts.joints);
}

std::vector<std::string> summary_lines(const BindSummary& s) {
  std::vector<std::string> lines;
  lines.push_back(print("%s: %zu vertices, %zu faces, %zu joints (%zu used)", s.name.c_str(), s.vertices, s.faces,
                        s.joints, s.joints_used));
  if (s.locked_vertices > 0 && s.locked_vertices == s.vertices)
    lines.push_back(print("kept all weights, %.2f influences per vertex", s.mean_influences));
  else
    lines.push_back(print("bound with %s in %.3f s, %.1f MB workspace (%.1f MB used), %.2f influences per vertex",
                          s.method.c_str(), s.seconds, static_cast<double>(s.workspace_bytes) / 1e6,
                          static_cast<double>(s.workspace_used_bytes) / 1e6, s.mean_influences));
  if (s.replaced.vertices > 0) lines.push_back(replaced_text(s.replaced));
  if (s.compare && s.replaced.vertices > 0) {
    const std::vector<std::string> changes = change_lines(s.replaced);
    lines.insert(lines.end(), changes.begin(), changes.end());
  } else if (s.compare) {
    lines.push_back("nothing to compare with: the file has no weights");
  }
  lines.insert(lines.end(), s.notes.begin(), s.notes.end());
  if (s.symmetric && s.symmetric_vertices > 0) {
    lines.push_back(print("%zu of %zu vertices mirrored", s.symmetric_vertices, s.vertices));
  } else if (s.symmetric) {
    lines.push_back("not symmetric: too few vertices or joints have a mirror image; no weights were mirrored");
  }
  if (!s.doubts.vertices.empty()) lines.push_back(doubts_text(s.doubts));
  if (s.answers > 0)
    lines.push_back(
        print("answers about parts: %zu applied, %zu of them from the style file", s.answers, s.answers_by_style));
  for (const PartQuestion& part : s.questions) lines.push_back(question_text(part));
  if (!s.questions.empty())
    lines.push_back(print("answer with --answer %u=%s, or --answer %u=rigid:JOINT for any joint", s.questions[0].vertex,
                          s.questions[0].alternatives[0].first.c_str(), s.questions[0].vertex));
  std::string written = s.output == "-" ? "standard output" : s.output;
  for (const std::string& picture : {s.png, s.png_confidence, s.style})
    written += picture.empty() ? "" : " and " + picture;
  lines.push_back("wrote " + written);
  return lines;
}

nlohmann::ordered_json seams_json(const std::vector<Joint>& joints, const Seams& seams) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Seam& seam : seams.seams)
    json.push_back({{"joints", {joints[seam.joints[0]].name, joints[seam.joints[1]].name}},
                    {"position", {seam.position.x, seam.position.y, seam.position.z}},
                    {"length", seam.length}});
  return json;
}

nlohmann::ordered_json summary_json(const BindSummary& s) {
  nlohmann::ordered_json json = {{"sinew_bind", 1},
                                 {"mesh", s.mesh},
                                 {"method", s.method},
                                 {"vertices", s.vertices},
                                 {"faces", s.faces},
                                 {"joints", s.joints},
                                 {"joints_used", s.joints_used},
                                 {"influences", s.influences},
                                 {"mean_influences", s.mean_influences},
                                 {"seconds", s.seconds},
                                 {"workspace_bytes", s.workspace_bytes},
                                 {"workspace_used_bytes", s.workspace_used_bytes},
                                 {"hash", s.hash},
                                 {"output", s.output}};
  if (!s.png.empty()) json["png"] = s.png;
  if (!s.png_confidence.empty()) json["png_confidence"] = s.png_confidence;
  constexpr size_t kMostListed = 1000;
  std::vector<size_t> first = s.doubts.vertices;
  if (first.size() > kMostListed) first.resize(kMostListed);
  json["to_look_at"] = {{"vertices", s.doubts.vertices.size()},
                        {"sure", s.doubts.sure},
                        {"joints", s.doubts.joints},
                        {"first", std::move(first)}};
  if (s.answers > 0) {
    json["answers"] = s.answers;
    json["answers_by_style"] = s.answers_by_style;
  }
  if (!s.style.empty()) json["style"] = s.style;
  for (const PartQuestion& part : s.questions) json["questions"].push_back(question_json(part));
  if (s.symmetric) json["symmetric_vertices"] = s.symmetric_vertices;
  if (s.replaced.vertices > 0) json["replaced"] = replaced_json(s.replaced, s.compare);
  for (const auto& [joint, why] : s.left_out) json["left_out"].push_back({{"joint", joint}, {"why", why}});
  json["seams"] = s.seams;
  if (!s.notes.empty()) json["notes"] = s.notes;
  return json;
}

}  // namespace sinew::cli
