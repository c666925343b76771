// SPDX-License-Identifier: MIT
// Tips give their weight to their parents, as artists bind them.
#include <algorithm>
#include <cmath>
#include <map>

#include "sinew_character/bind/bind_character.hpp"
#include "sinew_character/rig/mesh_surface.hpp"

namespace sinew {
namespace {

// Joints named twice become one; falling weights, ties by the lower joint. Weights are whole steps of 1 / 65535.
void merge(std::vector<Influence>* row) {
  std::vector<Influence> merged;
  for (const Influence& influence : *row) {
    const auto same = std::find_if(merged.begin(), merged.end(),
                                   [&](const Influence& other) { return other.joint == influence.joint; });
    if (same == merged.end())
      merged.push_back(influence);
    else
      same->weight = static_cast<float>(std::lround((same->weight + influence.weight) * 65535.0f)) / 65535.0f;
  }
  std::stable_sort(merged.begin(), merged.end(), [](const Influence& a, const Influence& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
  });
  *row = std::move(merged);
}

// Tips that most of a connected piece of the mesh belongs to, a horn or a shoe of its own, and whose parents have more
// of the mesh without them: a head in one piece is the head's, even where head_end is in its middle.
std::vector<uint32_t> tips_with_a_part(const Character& whole, const JointChoice& choice,
                                       const std::vector<std::vector<Influence>>& rows) {
  VertexGroups parts(whole.vertices.size());
  for (size_t f = 0; f < whole.face_count(); ++f)
    for (size_t c = whole.face_offsets[f] + 1; c < whole.face_offsets[f + 1]; ++c)
      parts.join(whole.face_vertices[c], whole.face_vertices[whole.face_offsets[f]]);
  std::map<uint32_t, std::map<uint32_t, size_t>> strongest;  // part -> joint -> vertices
  std::map<uint32_t, size_t> sizes;
  std::vector<double> sums(whole.joints.size(), 0);
  for (size_t v = 0; v < rows.size(); ++v) {
    const uint32_t at = parts.of(static_cast<uint32_t>(v));
    ++sizes[at];
    for (const Influence& influence : rows[v]) sums[influence.joint] += static_cast<double>(influence.weight);
    if (!rows[v].empty()) ++strongest[at][rows[v].front().joint];
  }
  std::vector<uint32_t> tips;
  for (const size_t tip : choice.tips) {
    if (sums[tip] >= sums[static_cast<size_t>(whole.joints[tip].parent)]) continue;
    for (const auto& [at, joints] : strongest) {
      const auto mine = joints.find(static_cast<uint32_t>(tip));
      if (mine != joints.end() && mine->second * 2 > sizes[at] && sizes[at] > 3)
        tips.push_back(static_cast<uint32_t>(tip));
    }
  }
  return tips;
}

}  // namespace

size_t fold_tips(const Character& whole, const JointChoice& choice, const std::vector<bool>& kept,
                 std::vector<std::vector<Influence>>* rows) {
  std::vector<uint32_t> to(whole.joints.size());
  for (size_t j = 0; j < to.size(); ++j) to[j] = static_cast<uint32_t>(j);
  std::vector<char> is_tip(to.size(), 0);
  for (const size_t tip : choice.tips) is_tip[tip] = 1;
  for (const size_t tip : choice.tips) {
    int parent = whole.joints[tip].parent;
    while (parent >= 0 && is_tip[static_cast<size_t>(parent)] != 0)
      parent = whole.joints[static_cast<size_t>(parent)].parent;
    if (parent < 0 || (choice.flags[static_cast<size_t>(parent)] & SINEW_JOINT_NEVER) != 0) continue;
    to[tip] = static_cast<uint32_t>(parent);
  }
  for (const uint32_t tip : tips_with_a_part(whole, choice, *rows)) to[tip] = tip;
  std::vector<char> folded(to.size(), 0);
  for (size_t v = 0; v < rows->size(); ++v) {
    if (!kept.empty() && kept[whole.vertex_meshes.empty() ? 0 : whole.vertex_meshes[v]]) continue;
    std::vector<Influence>& row = (*rows)[v];
    bool changed = false;
    for (Influence& influence : row) {
      if (to[influence.joint] == influence.joint) continue;
      folded[influence.joint] = 1;
      influence.joint = to[influence.joint];
      changed = true;
    }
    if (changed) merge(&row);
  }
  return static_cast<size_t>(std::count(folded.begin(), folded.end(), char{1}));
}

}  // namespace sinew
