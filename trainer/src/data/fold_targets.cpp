// SPDX-License-Identifier: MIT
// Weights go back to the decimals of their files, rows are added in numpy's order. End joints are found from the leaves up,
// until a joint is bound or has another child.
#include "sinew_trainer/fold_targets.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

// Files hold round decimals, so errors of exactly 0.5 and weights of exactly 1e-4 are common, and the last bit decides
// on which side of a threshold they fall. To fall where the yardstick's do, weights go back to the decimal that the
// float was read from, and rows are added in numpy's order. (Without this `bad` was off by up to 6e-4 on single
// characters.)
double decimal_value(float weight) {
  std::array<char, 32> text;
  const auto printed = std::to_chars(text.data(), text.data() + text.size(), weight);
  double value = 0;
  std::from_chars(text.data(), printed.ptr, value);
  return value;
}

}  // namespace

double numpy_sum(const double* values, size_t count) {
  double sum = 0;
  if (count < 8) {
    for (size_t i = 0; i < count; ++i) sum += values[i];
    return sum;
  }
  if (count > 128) {
    const size_t half = count / 2 - count / 2 % 8;
    return numpy_sum(values, half) + numpy_sum(values + half, count - half);
  }
  std::array<double, 8> lanes;
  std::copy_n(values, 8, lanes.begin());
  size_t i = 8;
  for (; i + 8 <= count; i += 8)
    for (size_t k = 0; k < 8; ++k) lanes[k] += values[i + k];
  sum = ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) + ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
  for (; i < count; ++i) sum += values[i];
  return sum;
}

DenseRows normalized_rows(const std::vector<std::vector<Influence>>& influences, size_t joint_count,
                          const std::string& name) {
  DenseRows rows(influences.size(), std::vector<double>(joint_count, 0.0));
  for (size_t v = 0; v < rows.size(); ++v) {
    for (const Influence& influence : influences[v]) {
      if (influence.joint >= joint_count) {
        throw Error(name + ": vertex " + std::to_string(v) + " has weight for joint " +
                    std::to_string(influence.joint) + ", but there are " + std::to_string(joint_count) + " joints");
      }
      if (!(influence.weight > 0)) continue;
      rows[v][influence.joint] += decimal_value(influence.weight);
    }
    const double sum = numpy_sum(rows[v].data(), joint_count);
    for (double& w : rows[v]) w = sum > 1e-12 ? w / sum : 0;
  }
  return rows;
}

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
  return fold_targets(reference, normalized_rows(reference.influences, reference.joints.size(), reference.name));
}

}  // namespace sinew
