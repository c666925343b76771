// SPDX-License-Identifier: MIT
// A hierarchy for a flat list of joints: the shortest tree through them (Prim), bent by what their names say.
#include <algorithm>
#include <cmath>
#include <limits>

#include "names/joint_name.hpp"
#include "sinew/sinew.h"
#include "sinew_character/rig/skeleton_repair.hpp"

namespace sinew {
namespace {

using ReadName = names::JointName;

double edge_cost(const Joint& a, const ReadName& at_a, const Joint& b, const ReadName& at_b) {
  const double distance = static_cast<double>(
      std::hypot(a.position.x - b.position.x, a.position.y - b.position.y, a.position.z - b.position.z));
  if (at_a.side * at_b.side < 0) return distance * 4;
  const bool row = at_a.stem == at_b.stem && at_a.side == at_b.side && at_a.own_number >= 0 && at_b.own_number >= 0 &&
                   std::abs(at_a.own_number - at_b.own_number) == 1;
  if (row) return distance * 0.25;
  if (at_a.side != at_b.side) return distance * 1.2;  // joints in the middle have parents in the middle
  return at_a.side != 0 ? distance * 0.9 : distance;
}

// The middle of a body by its name; otherwise the joint from which the largest branch is smallest.
size_t choose_root(const std::vector<ReadName>& said, const std::vector<std::vector<size_t>>& neighbors) {
  const size_t count = said.size();
  for (const auto& wanted : {+[](const ReadName& name) { return name.root; },
                             +[](const ReadName& name) { return name.part == names::Part::kHips; },
                             +[](const ReadName& name) { return name.part == names::Part::kSpine; }}) {
    for (size_t j = 0; j < count; ++j)
      if (said[j].side == 0 && wanted(said[j])) return j;
  }
  std::vector<size_t> order, parent(count, SIZE_MAX), below(count, 1);
  for (size_t j = 0; j < count && order.empty(); ++j)
    if (!neighbors[j].empty()) order.push_back(j);
  for (size_t next = 0; next < order.size(); ++next)
    for (const size_t k : neighbors[order[next]])
      if (k != parent[order[next]]) parent[k] = order[next], order.push_back(k);
  size_t best = 0, smallest = SIZE_MAX;
  for (size_t i = order.size(); i-- > 0;) {
    const size_t j = order[i];
    size_t largest = order.size();
    for (const size_t k : neighbors[j])
      if (k != parent[j]) below[j] += below[k];
    largest -= below[j];
    for (const size_t k : neighbors[j])
      if (k != parent[j]) largest = std::max(largest, below[k]);
    if (largest < smallest) smallest = largest, best = j;
  }
  return best;
}

size_t top_of(const std::vector<Joint>& joints, size_t joint) {
  for (size_t steps = 0; joints[joint].parent >= 0 && steps < joints.size(); ++steps)
    joint = static_cast<size_t>(joints[joint].parent);
  return joint;
}

// Leaves with a parent that only end its bone: all of a hierarchy that a flat list may contain; no parents for other
// joints.
std::vector<char> tips_of(const std::vector<Joint>& joints, const std::vector<ReadName>& said) {
  std::vector<char> tips(joints.size(), 0);
  for (size_t j = 0; j < joints.size(); ++j)
    tips[j] = joints[j].parent >= 0 && said[j].has(names::kEnd | names::kNub | names::kTip) ? 1 : 0;
  for (const Joint& joint : joints)
    if (joint.parent >= 0) tips[static_cast<size_t>(joint.parent)] = 0;
  return tips;
}

}  // namespace

size_t infer_parents(std::vector<Joint>* joints) {
  const size_t count = joints->size();
  std::vector<ReadName> said;
  for (const Joint& joint : *joints) said.push_back(names::read_joint_name(joint.name.c_str()));
  const std::vector<char> tips = tips_of(*joints, said);
  const size_t tip_count = static_cast<size_t>(std::count(tips.begin(), tips.end(), char{1}));
  const size_t tops = static_cast<size_t>(
      std::count_if(joints->begin(), joints->end(), [](const Joint& joint) { return joint.parent < 0; }));
  if (count - tip_count < 4 || tops * 2 <= count - tip_count || count > SINEW_MAX_JOINTS) return 0;

  // Prim's tree; the parents that are there cost nothing.
  std::vector<std::vector<size_t>> neighbors(count);
  std::vector<double> cost(count, std::numeric_limits<double>::infinity());
  std::vector<size_t> from(count, SIZE_MAX);
  std::vector<char> done = tips;
  size_t next = static_cast<size_t>(std::find(tips.begin(), tips.end(), char{0}) - tips.begin());
  for (size_t step = tip_count; step < count; ++step) {
    done[next] = 1;
    if (from[next] != SIZE_MAX) {
      neighbors[next].push_back(from[next]);
      neighbors[from[next]].push_back(next);
    }
    size_t nearest = SIZE_MAX;
    for (size_t j = 0; j < count; ++j) {
      if (done[j] != 0) continue;
      const bool bound = (*joints)[j].parent == static_cast<int>(next) || (*joints)[next].parent == static_cast<int>(j);
      const double c = bound ? 0 : edge_cost((*joints)[next], said[next], (*joints)[j], said[j]);
      if (c < cost[j]) cost[j] = c, from[j] = next;
      if (nearest == SIZE_MAX || cost[j] < cost[nearest]) nearest = j;
    }
    next = nearest;
  }

  // Away from the root; a group of joints that has parents keeps them; only its top gets a parent.
  const size_t root = top_of(*joints, choose_root(said, neighbors));
  size_t given = 0;
  std::vector<char> seen(count, 0);
  std::vector<size_t> order = {root};
  seen[root] = 1;
  for (size_t i = 0; i < order.size(); ++i) {
    for (const size_t k : neighbors[order[i]]) {
      if (seen[k] != 0) continue;
      seen[k] = 1;
      order.push_back(k);
      const size_t top = top_of(*joints, k);
      if (top == top_of(*joints, order[i])) continue;
      (*joints)[top].parent = static_cast<int>(order[i]);
      ++given;
    }
  }
  return given;
}

}  // namespace sinew
