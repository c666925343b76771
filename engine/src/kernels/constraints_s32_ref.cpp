// SPDX-License-Identifier: MIT
// The definition of a soft edge and of a hard volume in integers.
#include "kernels/constraint_steps.hpp"

namespace sinew {
namespace {

int64_t sum_of_sides(Vec3i v) { return abs64(v.x) + abs64(v.y) + abs64(v.z); }

template <class One>
void each(uint32_t begin, uint32_t end, bool backwards, const One& one) {
  if (backwards) {
    for (uint32_t k = end; k-- > begin;) one(k);
  } else {
    for (uint32_t k = begin; k < end; ++k) one(k);
  }
}

}  // namespace

void solve_edge_ref(const EdgeList& list, uint32_t edge) {
  SolverNode &a = list.nodes[list.ends[2 * static_cast<size_t>(edge)]],
             &b = list.nodes[list.ends[2 * static_cast<size_t>(edge) + 1]];
  const Vec3i d = clamped(a.position - b.position, kLongEdge);
  const int64_t now = isqrt64(static_cast<uint64_t>(dot(d, d)) << 8);  // Q4
  if (now < 16) return;
  int32_t& lambda = list.lambdas[edge];
  const int64_t error = (list.rests[edge] - now) * 256 - list.rates.softness * lambda;
  const int32_t change = rounded(error * list.rates.inverse[a.moves != 0 && b.moves != 0 ? 1 : 0], 24);
  lambda += change;
  const int64_t ratio = (static_cast<int64_t>(change) * (1 << 20)) / now;  // Q20
  if (a.moves != 0) step(&a.position, ratio, d, 20);
  if (b.moves != 0) step(&b.position, -ratio, d, 20);
}

void solve_volume_ref(const VolumeList& list, uint32_t entry) {
  const uint32_t* const at = list.corners + 4 * static_cast<size_t>(entry);
  SolverNode* const nodes[4] = {list.nodes + at[0], list.nodes + at[1], list.nodes + at[2], list.nodes + at[3]};
  const Vec3i origin = nodes[0]->position;
  const Vec3i b = clamped(nodes[1]->position - origin, kLongSide), c = clamped(nodes[2]->position - origin, kLongSide),
              d = clamped(nodes[3]->position - origin, kLongSide);
  Vec3i gradient[4];
  gradient[1] = over_cell(cross(c, d));
  gradient[2] = over_cell(cross(d, b));
  gradient[3] = over_cell(cross(b, c));
  gradient[0] = {-(gradient[1].x + gradient[2].x + gradient[3].x), -(gradient[1].y + gradient[2].y + gradient[3].y),
                 -(gradient[1].z + gradient[2].z + gradient[3].z)};
  const int64_t error = rest_volume(list.flags[entry]) - dot(b, gradient[1]);
  int64_t denominator = 0, largest = 0;
  for (int k = 0; k < 4; ++k) {
    if (nodes[k]->moves == 0) continue;
    denominator += dot(gradient[k], gradient[k]);
    const int64_t bound = sum_of_sides(gradient[k]);
    largest = bound > largest ? bound : largest;
  }
  if (denominator < kLeastDenominator) denominator = kLeastDenominator;
  int64_t ratio = (error * (1 << 12)) / (denominator >> 6);
  // No node moves by more than a quarter of a cell. The sum of a vector's sides bounds its length, and most steps are short.
  const int64_t size = ratio < 0 ? -ratio : ratio;
  if ((size * largest) >> kRatioBits > kLongestStep) {
    int64_t square = 0;
    for (int k = 0; k < 4; ++k) {
      const int64_t own = nodes[k]->moves != 0 ? dot(gradient[k], gradient[k]) : 0;
      square = own > square ? own : square;
    }
    const int64_t moved = (size * isqrt64(static_cast<uint64_t>(square))) >> kRatioBits;
    if (moved > kLongestStep) ratio = ratio * kLongestStep / moved;
  }
  for (int k = 0; k < 4; ++k) {
    if (nodes[k]->moves != 0) step(&nodes[k]->position, ratio, gradient[k], kRatioBits);
  }
}

void solve_edges_ref(const EdgeList& list, uint32_t begin, uint32_t end, bool backwards) {
  each(begin, end, backwards, [&list](uint32_t e) { solve_edge_ref(list, e); });
}

void solve_volumes_ref(const VolumeList& list, uint32_t begin, uint32_t end, bool backwards) {
  each(begin, end, backwards, [&list](uint32_t i) { solve_volume_ref(list, i); });
}

}  // namespace sinew
