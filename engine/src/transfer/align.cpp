// SPDX-License-Identifier: MIT
// One similarity a joint of the source, parents first.
#include "transfer/align.hpp"

namespace sinew::transferring {
namespace {

constexpr double kShortest = 1e-3;                     // of the longest side: a shorter bone has no direction
constexpr double kLeastScale = 0.6, kMostScale = 1.7;  // of a bone, against the whole
constexpr double kHold = 0.05;                         // how strongly several bones stay near the parent's rotation
constexpr double kTurned = 2.0;                        // trace of a rotation by 60 degrees
constexpr double kClearGap = 0.05;                     // of best_rotation(): joints on a line have no unique rotation

struct Whole {
  Vec3d source_mean, target_mean;
  double scale = 1;
  Mat3 rotation;
  uint32_t count = 0;
};

Whole fit_whole(const JointCounterparts& map, const Skeleton& source, const Skeleton& target) {
  Whole whole;
  for (uint32_t j = 0; j < source.joint_count; ++j) {
    if (map.same[j] < 0) continue;
    whole.source_mean = whole.source_mean + position_of(source.positions[j]);
    whole.target_mean = whole.target_mean + position_of(target.positions[map.same[j]]);
    ++whole.count;
  }
  if (whole.count == 0) return whole;
  const double share = 1.0 / whole.count;
  whole.source_mean = share * whole.source_mean;
  whole.target_mean = share * whole.target_mean;
  double source_spread = 0, target_spread = 0;
  Mat3 sums = {{0, 0, 0, 0, 0, 0, 0, 0, 0}};
  for (uint32_t j = 0; j < source.joint_count; ++j) {
    if (map.same[j] < 0) continue;
    const Vec3d u = position_of(source.positions[j]) - whole.source_mean;
    const Vec3d v = position_of(target.positions[map.same[j]]) - whole.target_mean;
    source_spread += dot(u, u);
    target_spread += dot(v, v);
    const double us[3] = {u.x, u.y, u.z}, vs[3] = {v.x, v.y, v.z};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) sums.m[3 * i + k] += vs[i] * us[k];
  }
  if (source_spread > kShortest * kShortest && target_spread > kShortest * kShortest) {
    whole.scale = root(target_spread / source_spread);
    double gap = 0;
    const Mat3 rotation = best_rotation(sums, &gap);
    if (gap > kClearGap && rotation.m[0] + rotation.m[4] + rotation.m[8] < kTurned) whole.rotation = rotation;
  }
  return whole;
}

}  // namespace

bool Alignment::allocate(Arena& arena, uint32_t source_joints) {
  joints = arena.alloc<Similarity>(source_joints);
  return arena.ok();
}

void Alignment::find(const JointCounterparts& map, const Skeleton& source, const Skeleton& target, uint32_t* scratch) {
  const uint32_t count = source.joint_count;
  const Whole whole = fit_whole(map, source, target);
  scale = whole.scale;
  Similarity start;
  start.rotation = whole.rotation;
  start.scale = scale;
  start.shift = whole.target_mean - scale * (whole.rotation * whole.source_mean);

  // The mapped joints below each mapped joint, without others between.
  uint32_t* const above = scratch;  // nearest mapped proper ancestor, or `count`
  uint32_t* const kids = scratch + count;
  uint32_t* const offsets = scratch + 2 * size_t{count};  // [count + 1]
  for (uint32_t j = 0; j <= count; ++j) offsets[j] = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t j = source.order[i];
    const int32_t parent = source.parents[j];
    above[j] = parent < 0 ? count : map.same[parent] >= 0 ? static_cast<uint32_t>(parent) : above[parent];
    if (map.same[j] >= 0 && above[j] < count) ++offsets[above[j]];
  }
  uint32_t total = 0;
  for (uint32_t j = 0; j <= count; ++j) {
    total += offsets[j];
    offsets[j] = total;
  }
  for (uint32_t j = count; j-- > 0;) {
    if (map.same[j] >= 0 && above[j] < count) kids[--offsets[above[j]]] = j;
  }

  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t j = source.order[i];
    const Similarity& parent = source.parents[j] >= 0 ? joints[source.parents[j]] : start;
    joints[j] = parent;
    if (map.same[j] < 0) continue;
    const Vec3d from = position_of(source.positions[j]), to = position_of(target.positions[map.same[j]]);
    Mat3 sums = {{0, 0, 0, 0, 0, 0, 0, 0, 0}};
    double source_sum = 0, target_sum = 0;
    uint32_t bones = 0;
    Vec3d u, v;
    for (uint32_t k = offsets[j]; k < offsets[j + 1]; ++k) {
      const Vec3d own = position_of(source.positions[kids[k]]) - from;
      const Vec3d other = position_of(target.positions[map.same[kids[k]]]) - to;
      if (length(own) <= kShortest || length(other) <= kShortest) continue;
      u = parent.rotation * own;
      v = other;
      ++bones;
      source_sum += dot(own, own);
      target_sum += dot(other, other);
      const double us[3] = {u.x, u.y, u.z}, vs[3] = {v.x, v.y, v.z};
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) sums.m[3 * a + b] += vs[a] * us[b];
    }
    Similarity& own = joints[j];
    if (bones == 1) {
      own.rotation = rotation_between(u, v) * parent.rotation;
    } else if (bones > 1) {
      const double hold = kHold * root(source_sum) * root(target_sum);
      for (int a = 0; a < 3; ++a) sums.m[4 * a] += hold;
      own.rotation = best_rotation(sums, nullptr) * parent.rotation;
    }
    if (bones > 0) own.scale = root(target_sum / source_sum);
    own.scale = clamped(own.scale, kLeastScale * scale, kMostScale * scale);
    own.shift = to - own.scale * (own.rotation * from);
  }
}

Vec3d Alignment::warp(Vec3d point, const uint16_t* row_joints, const uint32_t* row_weights) const {
  Vec3d sum;
  double whole = 0;
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    if (row_joints[i] == kNoJoint) continue;
    const double weight = row_weights[i];
    sum = sum + weight * joints[row_joints[i]](point);
    whole += weight;
  }
  return whole > 0 ? (1 / whole) * sum : joints[0](point);
}

}  // namespace sinew::transferring
