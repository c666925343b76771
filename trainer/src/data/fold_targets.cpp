// SPDX-License-Identifier: MIT
// End joints are found from the leaves up, until a joint is bound or has another child.
#include "sinew_trainer/fold_targets.hpp"

#include "data/dense_rows.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

std::vector<uint32_t> fold_targets(const Character& reference, const std::vector<std::vector<double>>& rows) {
  const size_t joint_count = reference.joints.size();
  std::vector<uint8_t> bound(joint_count, 0), folded(joint_count, 0);
  for (const std::vector<double>& row : rows)
    for (size_t j = 0; j < joint_count; ++j)
      if (row[j] > kInfluenceThreshold) bound[j] = 1;
  std::vector<size_t> child_count(joint_count, 0);
  for (const Joint& joint : reference.joints) {
    if (joint.parent >= static_cast<int>(joint_count)) {
      throw Error(reference.name + ": joint '" + joint.name + "' names a parent that does not exist");
    }
    if (joint.parent >= 0) ++child_count[static_cast<size_t>(joint.parent)];
  }
  const auto is_end = [&](size_t j) { return child_count[j] == 0 && !bound[j] && reference.joints[j].parent >= 0; };
  // Children are folded before their parents, so a target is found by walking up through what is folded.
  std::vector<size_t> todo;
  for (size_t j = 0; j < joint_count; ++j)
    if (is_end(j)) todo.push_back(j);
  while (!todo.empty()) {
    const size_t j = todo.back();
    todo.pop_back();
    folded[j] = 1;
    const auto parent = static_cast<size_t>(reference.joints[j].parent);
    --child_count[parent];
    if (is_end(parent)) todo.push_back(parent);
  }
  std::vector<uint32_t> targets(joint_count);
  for (size_t j = 0; j < joint_count; ++j) {
    size_t target = j;
    while (folded[target]) target = static_cast<size_t>(reference.joints[target].parent);
    targets[j] = static_cast<uint32_t>(target);
  }
  return targets;
}

std::vector<uint32_t> fold_targets(const Character& reference) {
  return fold_targets(reference, normalised_rows(reference.influences, reference.joints.size(), reference.name));
}

}  // namespace sinew
