// SPDX-License-Identifier: MIT
// Bends of a surface, by its skin weights and the tree of its joints.
#include <algorithm>
#include <cmath>
#include <map>

#include "bake/bake_steps.hpp"
#include "sinew_character/pose/pose.hpp"

namespace sinew {
namespace {

// Joints that some row moves in part only, a vertex's or a face's: between vertices of rigid parts skin is stretched as well.
std::vector<size_t> bending_joints(const Character& character) {
  std::vector<char> bends(character.joints.size(), 0);
  std::map<size_t, double> below;  // by joint: weight of its subtree
  double total = 0;
  const auto add = [&](const std::vector<Influence>& row) {
    for (const Influence& influence : row) {
      total += static_cast<double>(influence.weight);
      size_t steps = 0;
      for (int j = static_cast<int>(influence.joint); j >= 0 && steps <= bends.size(); ++steps) {
        below[static_cast<size_t>(j)] += static_cast<double>(influence.weight);
        j = character.joints[static_cast<size_t>(j)].parent;
      }
    }
  };
  const auto finish = [&] {
    for (const auto& [joint, weight] : below)
      if (weight > 0.01 * total && weight < 0.99 * total && character.joints[joint].parent >= 0) bends[joint] = 1;
    below.clear();
    total = 0;
  };
  for (const std::vector<Influence>& row : character.influences) {
    add(row);
    finish();
  }
  for (size_t f = 0; f < character.face_count(); ++f) {
    for (uint32_t c = character.face_offsets[f]; c < character.face_offsets[f + 1]; ++c)
      add(character.influences[character.face_vertices[c]]);
    finish();
  }
  std::vector<size_t> out;
  for (size_t j = 0; j < bends.size(); ++j)
    if (bends[j] != 0) out.push_back(j);
  return out;
}

// [J] What follows the bend's joint is 0 away, what follows its parent 0.5: a vertex is first of the bend that moves it.
std::vector<double> distances_from(const std::vector<Joint>& joints, const std::vector<size_t>& order, size_t bend) {
  std::vector<double> above(joints.size(), -1), out(joints.size(), 0);  // above: of the bend's ancestors
  double steps = 0.5;
  size_t guard = 0;
  for (int j = joints[bend].parent; j >= 0 && guard <= joints.size();
       j = joints[static_cast<size_t>(j)].parent, ++guard)
    above[static_cast<size_t>(j)] = steps++;
  for (const size_t j : order) {  // parents first
    const int parent = joints[j].parent;
    if (j == bend)
      out[j] = 0;
    else if (above[j] >= 0)
      out[j] = above[j];
    else
      out[j] = parent < 0 ? static_cast<double>(joints.size()) : out[static_cast<size_t>(parent)] + 1;
  }
  return out;
}

}  // namespace

Bends find_bends(const Character& character, size_t most_of_a_vertex) {
  constexpr double kFade = 0.4;    // of concern, a joint further
  constexpr double kLeast = 0.02;  // concern of a bend that is not the nearest
  Bends bends;
  bends.joints = bending_joints(character);
  const std::vector<size_t> order = joint_tree(character).parents_first;
  for (const size_t joint : bends.joints) bends.distances.push_back(distances_from(character.joints, order, joint));
  for (const std::vector<Influence>& row : character.influences) {
    std::vector<std::pair<double, size_t>> concern;
    for (size_t b = 0; b < bends.joints.size(); ++b) {
      double sum = 0;
      for (const Influence& influence : row)
        sum += static_cast<double>(influence.weight) * std::pow(kFade, bends.distances[b][influence.joint]);
      concern.emplace_back(-sum, b);
    }
    std::sort(concern.begin(), concern.end());
    std::vector<size_t> near;
    for (const auto& [sum, b] : concern)
      if (near.size() < most_of_a_vertex && (near.empty() || -sum > kLeast)) near.push_back(b);
    bends.of_vertex.push_back(std::move(near));
  }
  return bends;
}

}  // namespace sinew
