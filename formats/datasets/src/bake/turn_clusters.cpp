// SPDX-License-Identifier: MIT
// k-means of rotations, on one half of the sphere of quaternions each.
#include "bake/turn_clusters.hpp"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

// 1 for the same rotation, 0 for one that is half a turn apart.
double nearness(const Quaternion& a, const Quaternion& b) {
  return std::abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]);
}

}  // namespace

std::vector<Quaternion> turn_clusters(const std::vector<Quaternion>& turns, size_t count) {
  constexpr double kSame = 1 - 1e-6;  // 0.16 degrees
  constexpr size_t kRounds = 30;
  std::vector<double> nearest;
  for (const Quaternion& turn : turns) nearest.push_back(nearness(turn, kNoTurn4));
  std::vector<Quaternion> centres;
  while (centres.size() < count) {
    const auto farthest = std::min_element(nearest.begin(), nearest.end());
    if (farthest == nearest.end() || *farthest > kSame) break;
    centres.push_back(turns[static_cast<size_t>(farthest - nearest.begin())]);
    for (size_t t = 0; t < turns.size(); ++t) nearest[t] = std::max(nearest[t], nearness(turns[t], centres.back()));
  }
  for (size_t round = 0; round < kRounds && !centres.empty(); ++round) {
    std::vector<Quaternion> sums(centres.size(), Quaternion{});
    for (const Quaternion& turn : turns) {
      size_t best = 0;
      for (size_t c = 1; c < centres.size(); ++c)
        if (nearness(turn, centres[c]) > nearness(turn, centres[best])) best = c;
      double side = 0;
      for (size_t i = 0; i < 4; ++i) side += turn[i] * centres[best][i];
      for (size_t i = 0; i < 4; ++i) sums[best][i] += side < 0 ? -turn[i] : turn[i];
    }
    for (size_t c = 0; c < centres.size(); ++c) {
      double square = 0;
      for (const double x : sums[c]) square += x * x;
      if (!(square > 0)) continue;  // nothing is nearest to it: it stays
      for (size_t i = 0; i < 4; ++i) centres[c][i] = sums[c][i] / std::sqrt(square);
    }
  }
  return centres;
}

}  // namespace sinew
