// SPDX-License-Identifier: MIT
// Differences between two results in 255ths.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sinew_formats/error.hpp"
#include "sinew_trainer/evaluate.hpp"

namespace sinew {

std::map<uint32_t, int> row_unorm8(const std::vector<Influence>& row) {
  constexpr int kOne = 255;
  std::map<uint32_t, double> exact;
  double sum = 0;
  for (const Influence& i : row) {
    if (!(i.weight > 0)) continue;
    exact[i.joint] += static_cast<double>(i.weight);
    sum += static_cast<double>(i.weight);
  }
  std::map<uint32_t, int> out;
  std::vector<std::pair<double, uint32_t>> remainders;
  int left = sum > 0 ? kOne : 0;
  for (const auto& [joint, weight] : exact) {
    const double scaled = weight / sum * kOne;
    out[joint] = static_cast<int>(scaled);
    left -= out[joint];
    remainders.emplace_back(static_cast<double>(out[joint]) - scaled, joint);
  }
  std::sort(remainders.begin(), remainders.end());
  for (size_t i = 0; left > 0 && i < remainders.size(); ++i, --left) ++out[remainders[i].second];
  std::erase_if(out, [](const auto& entry) { return entry.second == 0; });
  return out;
}

uint32_t strongest_joint(const std::vector<Influence>& row) {
  const Influence* best = nullptr;
  for (const Influence& i : row)
    if (best == nullptr || i.weight > best->weight || (i.weight == best->weight && i.joint < best->joint)) best = &i;
  return best == nullptr ? UINT32_MAX : best->joint;
}

void WeightDifference::add(const std::vector<std::vector<Influence>>& a, const std::vector<std::vector<Influence>>& b) {
  if (a.size() != b.size()) {
    throw Error("comparing weights: " + std::to_string(a.size()) + " rows against " + std::to_string(b.size()));
  }
  for (size_t v = 0; v < a.size(); ++v) {
    std::map<uint32_t, int> difference = row_unorm8(a[v]);
    for (const auto& [joint, weight] : row_unorm8(b[v])) difference[joint] -= weight;
    for (const auto& [joint, value] : difference) {
      const int size = std::abs(value);
      size_t step = static_cast<size_t>(std::min(size, 3));
      for (int limit = 4; size >= limit && step + 1 < kSteps; limit *= 2) ++step;
      ++steps[step];
    }
    flips += strongest_joint(a[v]) != strongest_joint(b[v]) ? 1 : 0;
    ++vertices;
  }
}

size_t WeightDifference::weights() const {
  size_t sum = 0;
  for (const size_t count : steps) sum += count;
  return sum;
}

double WeightDifference::close_share() const {
  return weights() ? static_cast<double>(steps[0] + steps[1]) / static_cast<double>(weights()) : 1;
}

double WeightDifference::flip_share() const {
  return vertices ? static_cast<double>(flips) / static_cast<double>(vertices) : 0;
}

const char* WeightDifference::step_name(size_t step) {
  constexpr std::array<const char*, kSteps> names = {"0", "1", "2", "3", "4-7", "8-15", "16-31", "32+"};
  return names[step];
}

}  // namespace sinew
