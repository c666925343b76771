// SPDX-License-Identifier: MIT
// Rows of weights as the integers that files of glTF hold.
#ifndef SINEW_FORMATS_GLTF_FIXED_WEIGHTS_HPP
#define SINEW_FORMATS_GLTF_FIXED_WEIGHTS_HPP

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

struct FixedInfluence {
  uint32_t joint = 0;
  uint32_t weight = 0;
};
using FixedRow = std::vector<FixedInfluence>;

// Weights as integers that sum to exactly `one`, sorted falling, ties to the lower joint; the remainder goes to the
// largest. Flooring keeps the remainder positive, so the order holds; the 0.01 lets weights that were k/one in float
// stay k.
inline FixedRow to_fixed(const std::vector<Influence>& row, uint32_t one) {
  std::map<uint32_t, double> merged;
  double total = 0;
  for (const Influence& influence : row)
    if (influence.weight > 0) {
      merged[influence.joint] += static_cast<double>(influence.weight);
      total += static_cast<double>(influence.weight);
    }
  FixedRow fixed;
  uint32_t sum = 0;
  for (const auto& [joint, weight] : merged) {
    const uint32_t value = static_cast<uint32_t>(weight / total * one + 0.01);
    fixed.push_back({joint, value});
    sum += value;
  }
  std::stable_sort(fixed.begin(), fixed.end(),
                   [](const FixedInfluence& a, const FixedInfluence& b) { return a.weight > b.weight; });
  if (!fixed.empty()) fixed.front().weight += one - sum;
  while (!fixed.empty() && fixed.back().weight == 0) fixed.pop_back();
  return fixed;
}

}  // namespace sinew
#endif
