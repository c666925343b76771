// SPDX-License-Identifier: MIT
// Findings as lines, JSON and SARIF.
#include "sinew_character/check/check_output.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "check/rig_facts.hpp"
#include "sinew/sinew.h"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string dumped(const OrderedJson& json, int indent) {
  return json.dump(indent, ' ', false, OrderedJson::error_handler_t::replace);
}

OrderedJson finding_json(const CheckedFile& file, const RigFinding& f) {
  const auto name = [&](int joint) { return file.character.joints[static_cast<size_t>(joint)].name; };
  OrderedJson json = {{"rule", f.rule->name}, {"severity", severity_text(f.severity)}};
  if (f.joint >= 0) json["joint"] = name(f.joint);
  if (f.other >= 0) json["other"] = name(f.other);
  if (f.mesh >= 0) json["mesh"] = file.character.meshes[static_cast<size_t>(f.mesh)].name;
  if (!f.vertices.empty()) json["vertices"] = f.vertices;
  json["position"] = {f.position.x, f.position.y, f.position.z};
  json["radius"] = f.radius;
  json["value"] = f.value;
  json["bound"] = f.bound;
  if (!f.pose.empty()) json["pose"] = f.pose;
  if (!f.clip.empty()) {
    json["clip"] = f.clip;
    json["seconds"] = f.seconds;
  }
  json["what"] = f.what;
  json["cure"] = f.rule->cure;
  return json;
}

const char* sarif_level(CheckSeverity severity) {
  return severity_text(severity);
}  // error, warning, note: the same words

// A path as a URI reference: relative ones stay, bytes that a URI cannot have are escaped.
std::string uri_of(const std::string& file) {
  std::string out;
  for (const char c : std::filesystem::path(file).generic_string()) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string("-._~/").find(c) != std::string::npos;
    out += plain ? std::string(1, c) : print("%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return out;
}

OrderedJson sarif_result(const CheckedFile& file, const RigFinding& f, size_t rule, bool is_new) {
  OrderedJson logical = OrderedJson::array();
  for (const int joint : {f.joint, f.other})
    if (joint >= 0)
      logical.push_back({{"name", file.character.joints[static_cast<size_t>(joint)].name}, {"kind", "object"}});
  OrderedJson location = {{"physicalLocation", {{"artifactLocation", {{"uri", uri_of(file.file)}}}}}};
  if (!logical.empty()) location["logicalLocations"] = logical;
  const std::string shown = where_shown(f);
  OrderedJson result = {
      {"ruleId", f.rule->name},
      {"ruleIndex", rule},
      {"level", sarif_level(f.severity)},
      {"message", {{"text", f.what + (shown.empty() ? "" : " (" + shown + ")") + ". " + f.rule->cure}}},
      {"locations", OrderedJson::array({location})}};
  if (file.before) result["baselineState"] = is_new ? "new" : "unchanged";
  result["properties"] = {
      {"value", f.value}, {"bound", f.bound}, {"position", {f.position.x, f.position.y, f.position.z}}};
  return result;
}

}  // namespace

std::string where_shown(const RigFinding& f) {
  if (!f.clip.empty()) return "clip '" + f.clip + "'" + print(" at %.2f s", f.seconds);
  return f.pose.empty() ? "" : "posed: " + f.pose;
}

namespace {

constexpr size_t kToldEach = 3;  // findings of one kind that have one line each; of more only the worst has one

// "; and 26 more: 'Spine', 'LeftArm', ..." of findings from `begin` to before `end`.
std::string others_text(const CheckedFile& file, size_t begin, size_t end, const RigFinding& told) {
  constexpr size_t kNamed = 5;
  if (end - begin < 2) return "";
  std::vector<int> joints;
  for (size_t i = begin; i < end; ++i) {
    const int joint = file.check.findings[i].joint;
    if (joint >= 0 && joint != told.joint && std::find(joints.begin(), joints.end(), joint) == joints.end())
      joints.push_back(joint);
  }
  std::string text = print("; and %zu more", end - begin - 1);
  for (size_t k = 0; k < joints.size() && k < kNamed; ++k)
    text += (k == 0 ? ": '" : ", '") + file.character.joints[static_cast<size_t>(joints[k])].name + "'";
  return text + (joints.size() > kNamed ? ", ..." : "");
}

}  // namespace

std::string check_text(const CheckedFile& file) {
  const RigCheck& check = file.check;
  std::string text = print("%s: %zu vertices, %zu joints, %zu clips: ", file.file.c_str(),
                           file.character.vertices.size(), file.character.joints.size(), file.motion.clips.size());
  text += check.findings.empty()
              ? "0 findings"
              : print("%zu errors, %zu warnings, %zu notes", check.errors, check.warnings, check.notes);
  std::vector<char> is_new(check.findings.size(), 0);
  for (const size_t i : file.change.added) is_new[i] = 1;
  if (file.score) text += print("; score %.1f of 100", *file.score);
  for (size_t i = 0; i < check.findings.size();) {
    size_t end = i + 1;  // of those in one line
    while (end < check.findings.size() && check.findings[end].rule == check.findings[i].rule &&
           check.findings[end].severity == check.findings[i].severity && is_new[end] == is_new[i])
      ++end;
    if (end - i <= kToldEach) end = i + 1;
    const RigFinding& worst =
        *std::max_element(check.findings.begin() + static_cast<std::ptrdiff_t>(i),
                          check.findings.begin() + static_cast<std::ptrdiff_t>(end),
                          [](const RigFinding& a, const RigFinding& b) { return a.value < b.value; });
    const std::string shown = where_shown(worst);
    text += print("\n  %s%-7s %s: ", is_new[i] != 0 ? "new " : "", severity_text(worst.severity), worst.rule->name) +
            worst.what + (shown.empty() ? "" : " (" + shown + ")") + others_text(file, i, end, worst);
    if (end == check.findings.size() || check.findings[end].rule != worst.rule)
      text += std::string("\n          ") + worst.rule->cure;
    i = end;
  }
  for (const size_t i : file.change.removed)
    text += std::string("\n  fixed: ") + file.before->findings[i].rule->name + ": " + file.before->findings[i].what;
  return text;
}

std::string check_json(const CheckedFile& file) {
  const RigCheck& check = file.check;
  OrderedJson json = {{"sinew_check", 1},
                      {"file", file.file},
                      {"vertices", file.character.vertices.size()},
                      {"joints", file.character.joints.size()},
                      {"clips", file.motion.clips.size()},
                      {"errors", check.errors},
                      {"warnings", check.warnings},
                      {"notes", check.notes}};
  if (file.score) json["score"] = std::round(10 * *file.score) / 10;
  json["findings"] = OrderedJson::array();
  for (const RigFinding& f : check.findings) json["findings"].push_back(finding_json(file, f));
  if (file.before) {
    json["added"] = file.change.added;
    json["gone"] = OrderedJson::array();
    for (const size_t i : file.change.removed)
      json["gone"].push_back({{"rule", file.before->findings[i].rule->name}, {"what", file.before->findings[i].what}});
  }
  json["failures"] = file.failures;
  return dumped(json, -1);
}

std::string check_sarif(const std::vector<CheckedFile>& files) {
  OrderedJson rules = OrderedJson::array(), results = OrderedJson::array();
  for (const CheckRule& rule : check_rules())
    rules.push_back({{"id", rule.name},
                     {"shortDescription", {{"text", rule.title}}},
                     {"help", {{"text", rule.cure}}},
                     {"defaultConfiguration", {{"level", sarif_level(rule.severity)}}}});
  for (const CheckedFile& file : files) {
    std::vector<char> is_new(file.check.findings.size(), 0);
    for (const size_t i : file.change.added) is_new[i] = 1;
    for (size_t i = 0; i < file.check.findings.size(); ++i) {
      const RigFinding& f = file.check.findings[i];
      results.push_back(sarif_result(file, f, static_cast<size_t>(f.rule - check_rules().data()), is_new[i] != 0));
    }
  }
  const OrderedJson driver = {{"name", "sinew check"}, {"version", sinew_version()}, {"rules", rules}};
  const OrderedJson run = {{"tool", {{"driver", driver}}}, {"results", results}};
  const OrderedJson sarif = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                             {"version", "2.1.0"},
                             {"runs", OrderedJson::array({run})}};
  return dumped(sarif, 1) + "\n";
}

Character as_shown(const CheckedFile& file, const RigFinding& finding) {
  const Character& c = file.character;
  const size_t count = c.joints.size();
  if (!finding.clip.empty() && !c.influences.empty()) {
    for (const Clip& clip : file.motion.clips)
      if (clip.name == finding.clip)
        return apply_pose(c, motion_palette(file.motion, frame_at(clip, finding.seconds), count));
  }
  if (!finding.pose.empty()) {
    for (const TestPose& pose : test_poses(RigFacts(c)))
      if (pose.name == finding.pose) return apply_pose(c, pose.palette);
  }
  return c;
}

}  // namespace sinew
