// SPDX-License-Identifier: MIT
// Springs of the file: what they name, which joints they share, where they begin, whether anything follows them.
#include <algorithm>
#include <cmath>

#include "check/findings.hpp"
#include "sinew_formats/base/segment.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_formats/springs.hpp"

namespace sinew {
namespace {

// How deep a tail at rest is in a collider, of its radius; 0 outside, and for shapes that hold from inside.
double depth_in(const Character& character, const SpringCollider& c, double hit_radius, const Point3& tail) {
  if ((c.shape != ColliderShape::kSphere && c.shape != ColliderShape::kCapsule) || !(c.radius > 0)) return 0;
  const Point3 a = point(character.joints[c.joint].position) + c.offset;
  const Point3 along = c.shape == ColliderShape::kCapsule ? c.tail - c.offset : Point3{};
  return (c.radius + hit_radius - segment_distance(tail, a, a + along)) / c.radius;
}

void check_begin(const Character& character, const Springs& springs, const SpringChain& chain, Findings* findings) {
  RigFinding worst;
  const SpringCollider* in = nullptr;
  for (size_t i = 0; i < chain.turning_joints(); ++i) {
    const Point3 tail = tail_at_rest(chain, i, character.joints);
    for (const size_t group : chain.groups)
      for (const size_t number : springs.groups[group].colliders) {
        const SpringCollider& one = springs.colliders[number];
        const double depth = depth_in(character, one, chain.joints[i].hit_radius, tail);
        if (depth <= worst.value) continue;
        worst.value = depth;
        worst.joint = static_cast<int>(chain.joints[i].joint);
        worst.other = static_cast<int>(one.joint);
        in = &one;
      }
  }
  if (in == nullptr) return;
  worst.what = findings->quoted(worst.joint) + " starts in a collider of " + findings->quoted(worst.other) +
               print(" at rest, by %.0f %% of its radius, so it is pushed out of the pose", 100 * worst.value);
  findings->add("springs-inside", std::move(worst));
}

}  // namespace

void check_spring_chains(const RigFacts& facts, Findings* findings) {
  const Character& character = facts.character;
  std::optional<Springs> springs;
  try {
    springs = read_springs("", character);
  } catch (const Error& error) {
    RigFinding finding;
    finding.value = 1;
    finding.what = std::string(error.what()).substr(2);  // without the empty name of the file
    findings->add("springs-broken", std::move(finding));
  }
  if (!springs) return;
  std::vector<int> turned_by(character.joints.size(), -1);
  for (size_t c = 0; c < springs->chains.size(); ++c) {
    const SpringChain& chain = springs->chains[c];
    bool moves = false;
    for (size_t i = 0; i < chain.turning_joints(); ++i) {
      const size_t j = chain.joints[i].joint;
      moves = moves || !facts.moves[j].empty() || facts.weight[j] > 0;
      if (turned_by[j] >= 0 && turned_by[j] != static_cast<int>(c)) {
        RigFinding finding;
        finding.joint = static_cast<int>(j);
        finding.value = 1;
        finding.what = findings->quoted(finding.joint) + " is rotated by two chains, " +
                       springs->chains[static_cast<size_t>(turned_by[j])].name + " and " + chain.name;
        findings->add("springs-shared", std::move(finding));
      }
      turned_by[j] = static_cast<int>(c);
    }
    if (facts.bound && !moves) {
      RigFinding finding;
      finding.joint = static_cast<int>(chain.joints[0].joint);
      finding.value = 1;
      finding.what = "no vertex follows the chain of " + findings->quoted(finding.joint);
      findings->add("springs-skinless", std::move(finding));
    }
    check_begin(character, *springs, chain, findings);
  }
}

}  // namespace sinew
