// SPDX-License-Identifier: MIT
// The order in which training draws characters, so that many look-alikes do not drown the few.
#include "data/family_queue.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace sinew {
namespace {

void shuffle(std::vector<uint32_t>* items, Random* random) {
  for (size_t i = items->size(); i > 1; --i)
    std::swap((*items)[i - 1], (*items)[random->below(static_cast<uint32_t>(i))]);
}

}  // namespace

std::vector<uint32_t> draw_round(const std::vector<std::string>& families, double power,
                                 const std::map<std::string, double>& shares, Random* random) {
  std::map<std::string, std::vector<uint32_t>> members;
  for (uint32_t i = 0; i < families.size(); ++i) members[families[i]].push_back(i);
  double sum = 0, rest = 1;  // of the families without a share of their own
  for (const auto& [name, characters] : members) {
    if (const auto given = shares.find(name); given != shares.end()) {
      rest -= given->second;
    } else {
      sum += std::pow(static_cast<double>(characters.size()), power);
    }
  }
  std::vector<uint32_t> round;
  for (auto& [name, characters] : members) {
    const auto given = shares.find(name);
    const double share =
        given != shares.end() ? given->second : rest * std::pow(static_cast<double>(characters.size()), power) / sum;
    size_t quota = static_cast<size_t>(share * static_cast<double>(families.size()) + random->uniform());
    while (quota > 0) {
      shuffle(&characters, random);
      const size_t take = std::min(quota, characters.size());
      round.insert(round.end(), characters.begin(), characters.begin() + static_cast<std::ptrdiff_t>(take));
      quota -= take;
    }
  }
  shuffle(&round, random);
  return round;
}

}  // namespace sinew
