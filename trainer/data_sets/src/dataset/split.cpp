// SPDX-License-Identifier: MIT
// The choice of whole units that comes closest to the wanted share.
#include "sinew_data_sets/split.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

// splitmix64 (Steele, Lea and Flood 2014): the standard library's shuffles differ between implementations.
uint64_t next_random(uint64_t* state) {
  uint64_t z = (*state += 0x9E3779B97F4A7C15ull);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

}  // namespace

std::vector<SplitUnit> split_units(const std::vector<std::string>& keys) {
  std::map<std::string, std::vector<size_t>> members;
  for (size_t i = 0; i < keys.size(); ++i) members[keys[i]].push_back(i);
  std::vector<SplitUnit> units;
  for (auto& [name, list] : members) units.push_back({name, std::move(list)});
  return units;
}

std::vector<bool> choose_validation(const std::vector<SplitUnit>& units, double share, uint64_t seed) {
  if (units.size() < 2) {
    throw Error("split: " + std::to_string(units.size()) +
                " unit cannot go to two sides; expected at least two families, groups or characters");
  }
  std::vector<size_t> order(units.size());
  std::iota(order.begin(), order.end(), size_t{0});
  uint64_t state = seed;
  for (size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[next_random(&state) % (i + 1)]);

  size_t total = 0;
  for (const SplitUnit& unit : units) total += unit.members.size();
  // last[s]: the unit that first reached the sum s, with units tried in drawn order (subset sums).
  constexpr size_t kNone = SIZE_MAX;
  std::vector<size_t> last(total + 1, kNone);
  std::vector<bool> reached(total + 1, false);
  reached[0] = true;
  for (size_t k = 0; k < order.size(); ++k) {
    const size_t size = units[order[k]].members.size();
    for (size_t sum = total; sum >= size && sum > 0; --sum) {
      if (size == 0 || reached[sum] || !reached[sum - size]) continue;
      reached[sum] = true;
      last[sum] = k;
    }
  }
  const double wanted = std::clamp(share, 0.0, 1.0) * static_cast<double>(total);
  size_t best = kNone;
  for (size_t sum = 1; sum < total; ++sum)
    if (reached[sum] &&
        (best == kNone || std::abs(static_cast<double>(sum) - wanted) < std::abs(static_cast<double>(best) - wanted)))
      best = sum;
  std::vector<bool> chosen(units.size(), false);
  for (size_t sum = best; sum > 0 && best != kNone; sum -= units[order[last[sum]]].members.size())
    chosen[order[last[sum]]] = true;
  return chosen;
}

}  // namespace sinew
