// SPDX-License-Identifier: MIT
// Shares by style and mismatch, or by distance, and rows by shares.
#include "transfer/balance.hpp"

namespace sinew::transferring {
namespace {

constexpr double kStyleFactor = 1.5;    // style counts more: the mismatch holds what the binder gets wrong, too
constexpr double kGarmentReach = 0.06;  // of the longest side: farther cloth is rebound
constexpr uint32_t kSmoothingRounds = 5;

double squared(double v) { return v * v; }

}  // namespace

bool Balance::allocate(Arena& arena, const Counts& target) {
  double** const arrays[] = {&style, &mismatch, &carried, &scratch};
  for (double** array : arrays) *array = arena.alloc<double>(target.vertices);
  matched = arena.alloc<uint8_t>(target.vertices);
  return arena.ok();
}

void Balance::smooth(const Mesh& mesh, double* values) const {
  for (uint32_t round = 0; round < kSmoothingRounds; ++round) {
    for (uint32_t v = 0; v < mesh.welded_count; ++v) scratch[v] = values[v];
    for (uint32_t v = 0; v < mesh.welded_count; ++v) {
      const uint32_t begin = mesh.row_offsets[v], end = mesh.row_offsets[v + 1];
      if (begin == end) continue;
      double sum = 0;
      for (uint32_t e = begin; e < end; ++e) sum += scratch[mesh.col_indices[e]];
      values[v] = 0.5 * scratch[v] + 0.5 * sum / (end - begin);
    }
  }
}

void Balance::weigh(const Mesh& mesh) {
  double style_mean = 0, mismatch_mean = 0;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    style_mean += style[v];
    mismatch_mean += mismatch[v];
  }
  style_mean /= mesh.welded_count;
  mismatch_mean /= mesh.welded_count;
  const double whole_style = squared(squared(kStyleFactor * style_mean)),
               whole_mismatch = squared(squared(mismatch_mean));
  const double whole = whole_style / (whole_style + whole_mismatch + 1e-12);
  smooth(mesh, style);
  smooth(mesh, mismatch);
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    const double own = squared(kStyleFactor * style[v]) + 1e-6;
    carried[v] = root(own / (own + squared(mismatch[v]) + 1e-6) * whole);
  }
}

void Balance::weigh_by_distance(const Mesh& mesh, const Match& match) {
  for (uint32_t v = 0; v < mesh.welded_count; ++v) carried[v] = clamped(match.points[v].distance / kGarmentReach, 0, 1);
  smooth(mesh, carried);
  for (uint32_t v = 0; v < mesh.welded_count; ++v) carried[v] = 1 - carried[v];
}

void share_with_new_joints(const JointCounterparts& map, const Rows& bound, uint32_t vertex, const Rows& carried) {
  const uint16_t* const joints = bound.joints_of(vertex);
  const uint32_t* const weights = bound.weights_of(vertex);
  bool any = false;
  for (uint32_t i = 0; i < kRowSlots; ++i) any = any || (joints[i] != kNoJoint && map.head[joints[i]] != joints[i]);
  if (!any) return;
  uint16_t old_joints[kRowSlots];
  uint32_t old_weights[kRowSlots];
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    old_joints[i] = carried.joints_of(vertex)[i];
    old_weights[i] = carried.weights_of(vertex)[i];
  }
  carried.clear(vertex);
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    if (old_joints[i] == kNoJoint) continue;
    uint64_t sum = 0;
    for (uint32_t k = 0; k < kRowSlots; ++k)
      sum += joints[k] != kNoJoint && map.head[joints[k]] == old_joints[i] ? weights[k] : 0;
    if (sum == 0) {
      carried.add(vertex, old_joints[i], old_weights[i]);
      continue;
    }
    for (uint32_t k = 0; k < kRowSlots; ++k) {
      if (joints[k] == kNoJoint || map.head[joints[k]] != old_joints[i]) continue;
      carried.add(vertex, joints[k],
                  static_cast<uint32_t>((static_cast<uint64_t>(old_weights[i]) * weights[k] + sum / 2) / sum));
    }
  }
}

void fold_new_joints(const JointCounterparts& map, const Rows& bound, uint32_t vertex, const Rows& out,
                     uint32_t out_vertex) {
  out.clear(out_vertex);
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    const uint16_t joint = bound.joints_of(vertex)[i];
    if (joint != kNoJoint) out.add(out_vertex, static_cast<uint16_t>(map.head[joint]), bound.weights_of(vertex)[i]);
  }
}

void mix_rows(const Rows& bound, double share, uint32_t vertex, const Rows& carried) {
  uint32_t* const weights = carried.weights_of(vertex);
  for (uint32_t i = 0; i < kRowSlots; ++i) weights[i] = static_cast<uint32_t>(share * weights[i] + 0.5);
  const uint16_t* const joints = bound.joints_of(vertex);
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    if (joints[i] == kNoJoint) continue;
    const uint32_t weight = static_cast<uint32_t>((1 - share) * bound.weights_of(vertex)[i] + 0.5);
    if (weight > 0) carried.add(vertex, joints[i], weight);
  }
  make_whole(carried, vertex);
}

}  // namespace sinew::transferring
