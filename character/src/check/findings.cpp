// SPDX-License-Identifier: MIT
// Collects findings, computes their positions, and sorts them.
#include "check/findings.hpp"

#include <algorithm>
#include <cmath>

#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

size_t number_of(const CheckRule* rule) { return static_cast<size_t>(rule - check_rules().data()); }

Vec3 middle(const Box& box) {
  return {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2, (box.low.z + box.high.z) / 2};
}

}  // namespace

Findings::Findings(const Character& character, const CheckOptions& options) : character_(character), options_(options) {
  std::vector<Vec3> points = character.vertices;
  if (points.empty())
    for (const Joint& joint : character.joints) points.push_back(joint.position);
  const double side = static_cast<double>(box_of(points).longest_side());
  if (side > 0) size_ = side;
}

double Findings::bound(const char* rule) const {
  const auto own = options_.bounds.find(rule);
  return own == options_.bounds.end() ? check_rule(rule).bound : own->second;
}

void Findings::add(const char* rule, RigFinding finding, bool meant) {
  finding.rule = &check_rule(rule);
  finding.severity = meant ? CheckSeverity::kNote : finding.rule->severity;
  finding.bound = bound(rule);
  if (!(finding.value > finding.bound)) return;
  std::sort(finding.vertices.begin(), finding.vertices.end());
  if (!finding.vertices.empty()) {
    Box box = {character_.vertices[finding.vertices[0]], character_.vertices[finding.vertices[0]]};
    for (const uint32_t v : finding.vertices) box.add(character_.vertices[v]);
    finding.position = middle(box);
    finding.radius = static_cast<double>(box.longest_side()) / 2;
    finding.mesh = mesh_of(finding.vertices);
  } else if (finding.joint >= 0) {
    finding.position = character_.joints[static_cast<size_t>(finding.joint)].position;
  } else if (!character_.vertices.empty()) {
    const Box box = box_of(character_.vertices);
    finding.position = middle(box);
    finding.radius = size_ / 2;
  }
  finding.radius = std::max(finding.radius, 0.05 * size_);
  findings_.push_back(std::move(finding));
}

int Findings::mesh_of(const std::vector<uint32_t>& vertices) const {
  if (character_.vertex_meshes.size() != character_.vertices.size()) return -1;
  const uint32_t mesh = character_.vertex_meshes[vertices[0]];
  for (const uint32_t v : vertices)
    if (character_.vertex_meshes[v] != mesh) return -1;
  return static_cast<int>(mesh);
}

RigCheck Findings::take() {
  RigCheck out;
  std::stable_sort(findings_.begin(), findings_.end(), [](const RigFinding& a, const RigFinding& b) {
    return a.severity != b.severity ? a.severity > b.severity : number_of(a.rule) < number_of(b.rule);
  });
  for (const RigFinding& finding : findings_) {
    out.errors += finding.severity == CheckSeverity::kError ? 1 : 0;
    out.warnings += finding.severity == CheckSeverity::kWarning ? 1 : 0;
    out.notes += finding.severity == CheckSeverity::kNote ? 1 : 0;
  }
  out.findings = std::move(findings_);
  return out;
}

const std::string& Findings::name_of(int joint) const { return character_.joints[static_cast<size_t>(joint)].name; }

std::string Findings::quoted(int joint) const { return "'" + name_of(joint) + "'"; }

std::string first_of(const std::vector<uint32_t>& numbers) {
  std::string text;
  for (size_t i = 0; i < numbers.size() && i < 5; ++i) text += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  return text + (numbers.size() > 5 ? ", ..." : "");
}

std::string vertices_text(size_t count) { return std::to_string(count) + (count == 1 ? " vertex" : " vertices"); }

}  // namespace sinew
