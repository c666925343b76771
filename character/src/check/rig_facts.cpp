// SPDX-License-Identifier: MIT
// Neighbors, pieces of the surface, strongest joints.
#include "check/rig_facts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sinew_character/pose/pose.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

bool finite(const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

void check_sound(const Character& c) {
  if (c.joints.empty()) throw Error(c.name + ": no skeleton to check; make one with sinew rig");
  for (const Joint& joint : c.joints)
    if (!finite(joint.position)) throw Error(c.name + ": joint '" + joint.name + "' has a position that is not finite");
  for (size_t v = 0; v < c.vertices.size(); ++v)
    if (!finite(c.vertices[v]))
      throw Error(c.name + ": vertex " + std::to_string(v) + " has a position that is not finite");
  for (const uint32_t v : c.face_vertices)
    if (v >= c.vertices.size())
      throw Error(c.name + ": a face names vertex " + std::to_string(v) + ", which does not exist");
  for (size_t v = 0; v < c.influences.size(); ++v)
    for (const Influence& i : c.influences[v])
      if (i.joint >= c.joints.size() || !std::isfinite(i.weight))
        throw Error(c.name + ": vertex " + std::to_string(v) +
                    " has a weight that is not finite, or of a joint that does not exist");
}

double sum_of(const std::vector<Influence>& row) {
  double sum = 0;
  for (const Influence& i : row) sum += std::max(0.0, static_cast<double>(i.weight));
  return sum;
}

std::vector<uint32_t> parts_of(const std::vector<uint32_t>& first, const std::vector<std::vector<uint32_t>>& rings) {
  std::vector<uint32_t> parts(first.size(), UINT32_MAX);
  uint32_t count = 0;
  for (uint32_t start = 0; start < first.size(); ++start) {
    if (first[start] != start || parts[start] != UINT32_MAX) continue;
    std::vector<uint32_t> open = {start};
    parts[start] = count;
    for (size_t k = 0; k < open.size(); ++k)
      for (const uint32_t n : rings[open[k]])
        if (parts[n] == UINT32_MAX) parts[n] = count, open.push_back(n);
    ++count;
  }
  for (uint32_t v = 0; v < first.size(); ++v) parts[v] = parts[first[v]];
  return parts;
}

}  // namespace

RigFacts::RigFacts(const Character& c) : character(c) {
  check_sound(c);
  tree = joint_tree(c);
  std::vector<Vec3> points = c.vertices;
  if (points.empty())
    for (const Joint& joint : c.joints) points.push_back(joint.position);
  const double side = static_cast<double>(box_of(points).longest_side());
  if (side > 0) size = side;
  bound = !c.influences.empty() && c.influences.size() == c.vertices.size();
  verdicts = joint_verdicts(c.joints, bound ? follows_of(c) : std::vector<uint8_t>());
  first = first_at_position(c);
  rings = welded_rings(c, first);
  parts = parts_of(first, rings);
  strongest.assign(c.vertices.size(), kNoOne);
  moves.resize(c.joints.size());
  weight.assign(c.joints.size(), 0);
  if (!bound) return;
  for (uint32_t v = 0; v < c.vertices.size(); ++v) {
    const double sum = sum_of(c.influences[v]);
    if (!(sum > 0)) continue;
    const Influence* best = nullptr;
    for (const Influence& i : c.influences[v]) {
      if (!(i.weight > 0)) continue;
      weight[i.joint] += static_cast<double>(i.weight) / sum;
      if (best == nullptr || i.weight > best->weight) best = &i;
    }
    strongest[v] = best->joint;
    moves[best->joint].push_back(v);
  }
}

double RigFacts::weight_of(uint32_t vertex, uint32_t joint) const {
  const auto& row = character.influences[vertex];
  const double sum = sum_of(row);
  double own = 0;
  for (const Influence& i : row)
    if (i.joint == joint && i.weight > 0) own += static_cast<double>(i.weight);
  return sum > 0 ? own / sum : 0;
}

double RigFacts::difference(uint32_t a, uint32_t b) const {
  double apart = 0;
  const auto& row = character.influences[a];
  for (const Influence& i : row) apart += std::abs(weight_of(a, i.joint) - weight_of(b, i.joint));
  for (const Influence& i : character.influences[b]) {
    const bool known = std::any_of(row.begin(), row.end(), [&](const Influence& o) { return o.joint == i.joint; });
    if (!known) apart += weight_of(b, i.joint);
  }
  return apart;
}

bool RigFacts::is_below(size_t joint, size_t above) const {
  for (int j = static_cast<int>(joint); j >= 0; j = character.joints[static_cast<size_t>(j)].parent)
    if (static_cast<size_t>(j) == above) return true;
  return false;
}

bool RigFacts::is_limb(size_t joint) const {
  const uint8_t one = verdicts.classes[joint];
  const bool limb = one == SINEW_CLASS_UPPER_ARM || one == SINEW_CLASS_FOREARM || one == SINEW_CLASS_HAND ||
                    one == SINEW_CLASS_THIGH || one == SINEW_CLASS_CALF || one == SINEW_CLASS_FOOT;
  return limb && verdicts.roles[joint] == SINEW_ROLE_DEFORMS;
}

bool RigFacts::is_single(size_t joint) const {
  size_t others = 0;
  for (size_t other = 0; other < character.joints.size(); ++other)
    others += other != joint && verdicts.classes[other] == verdicts.classes[joint] &&
                      verdicts.sides[other] == verdicts.sides[joint] && verdicts.roles[other] == SINEW_ROLE_DEFORMS
                  ? 1
                  : 0;
  return others <= 1;
}

bool RigFacts::is_body(size_t joint) const {
  return verdicts.classes[joint] <= SINEW_CLASS_WING && verdicts.roles[joint] == SINEW_ROLE_DEFORMS;
}

}  // namespace sinew
