// SPDX-License-Identifier: MIT
// Joints by their positions and by what they move.
#include <algorithm>
#include <cmath>

#include "check/findings.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_character/rig/skeleton_repair.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

// Joints in another part of the body than theirs are no eyesore outside, but as wrong: they count at this share of their distance.
constexpr double kInside = 0.5;
// A trunk is thick, so that a joint of it is never far from its vertices: out of the body, its distance counts that many times.
constexpr double kTrunk = 2;
constexpr double kShortestBone = 1e-4;  // of the size

void apart(const RigFacts& facts, Findings* findings) {
  if (facts.character.vertices.empty()) return;
  const std::optional<SkeletonFit> fit = find_skeleton_fit(facts.character);
  if (!fit) return;
  RigFinding finding;
  finding.value = 1;
  finding.what = fit->what;
  findings->add("skeleton-apart", std::move(finding));
}

// Distance to the nearest vertex of the joint, its parent and its children.
double distance_to_own(const RigFacts& facts, size_t joint) {
  double nearest = -1;
  const Point3 at = point(facts.character.joints[joint].position);
  const auto look = [&](size_t other) {
    for (const uint32_t v : facts.moves[other]) {
      const double d = length(point(facts.character.vertices[v]) - at);
      if (nearest < 0 || d < nearest) nearest = d;
    }
  };
  look(joint);
  if (facts.character.joints[joint].parent >= 0) look(static_cast<size_t>(facts.character.joints[joint].parent));
  for (const uint32_t child : facts.tree.children[joint]) look(child);
  return nearest;
}

void outside(const RigFacts& facts, Findings* findings) {
  const double bound = findings->bound("joint-outside");
  for (size_t j = 0; j < facts.moves.size(); ++j) {
    const uint8_t part = facts.verdicts.classes[j];
    const bool trunk =
        facts.is_body(j) && (part == SINEW_CLASS_SPINE || part == SINEW_CLASS_PELVIS || part == SINEW_CLASS_NECK);
    if (facts.moves[j].empty() || !(trunk || facts.is_limb(j))) continue;
    const double distance = distance_to_own(facts, j) / facts.size;
    if (!(distance > bound / (trunk ? kTrunk : 1))) continue;
    const bool inside = directions_with_mesh(facts.character, facts.character.joints[j].position) > kMostHitsOutside;
    RigFinding finding;
    finding.joint = static_cast<int>(j);
    finding.value = (inside ? kInside : trunk ? kTrunk : 1) * distance;
    finding.what = findings->quoted(finding.joint) +
                   print(" is %.2f of the size away from everything it moves, ", distance) +
                   (inside ? "in another part of the mesh" : "outside the mesh");
    findings->add("joint-outside", std::move(finding));
  }
}

void zero_length(const RigFacts& facts, Findings* findings) {
  for (size_t j = 0; j < facts.moves.size(); ++j) {
    const int parent = facts.character.joints[j].parent;
    if (parent < 0 || !facts.is_limb(j) || !facts.is_body(static_cast<size_t>(parent))) continue;
    if (facts.moves[j].empty() || facts.moves[static_cast<size_t>(parent)].empty()) continue;
    const double bone = length(point(facts.character.joints[j].position) -
                               point(facts.character.joints[static_cast<size_t>(parent)].position));
    if (bone > kShortestBone * facts.size) continue;
    RigFinding finding;
    finding.joint = static_cast<int>(j);
    finding.other = parent;
    finding.value = 1;
    finding.what = findings->quoted(finding.joint) + " is at the position of its parent " + findings->quoted(parent) +
                   ", and both move the mesh";
    findings->add("zero-length", std::move(finding));
  }
}

// Limbs amid joints that move the mesh. Twins of which one moves it are check_labels()'s.
void dead(const RigFacts& facts, Findings* findings) {
  for (size_t j = 0; j < facts.moves.size(); ++j) {
    const int parent = facts.character.joints[j].parent;
    if (facts.weight[j] > 0 || parent < 0 || facts.weight[static_cast<size_t>(parent)] <= 0) continue;
    if (!facts.is_limb(j) || !facts.is_single(j)) continue;
    bool below = false;
    for (const uint32_t child : facts.tree.children[j]) below = below || facts.weight[child] > 0;
    if (!below) continue;
    RigFinding finding;
    finding.joint = static_cast<int>(j);
    finding.value = 1;
    finding.what = findings->quoted(finding.joint) + " moves nothing, but its parent and its children do";
    // Both sides alike, as in creatures whose arms are two bones of a person's three.
    const int32_t twin = facts.verdicts.partners[j];
    findings->add("dead-joint", std::move(finding), twin >= 0 && facts.weight[static_cast<size_t>(twin)] <= 0);
  }
}

}  // namespace

void check_joints(const RigFacts& facts, Findings* findings) {
  apart(facts, findings);
  if (!facts.bound) return;
  outside(facts, findings);
  zero_length(facts, findings);
  dead(facts, findings);
}

}  // namespace sinew
