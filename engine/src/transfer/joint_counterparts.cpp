// SPDX-License-Identifier: MIT
// Completes the caller's joint map up and down the two hierarchies.
#include "transfer/joint_counterparts.hpp"

namespace sinew::transferring {

bool JointCounterparts::allocate(Arena& arena, uint32_t source_joints, uint32_t target_joints) {
  same = arena.alloc<int32_t>(source_joints);
  target_of = arena.alloc<int32_t>(source_joints);
  head = arena.alloc<int32_t>(target_joints);
  is_new = arena.alloc<uint8_t>(target_joints);
  return arena.ok();
}

void JointCounterparts::complete(const int32_t* counterparts, const Skeleton& source, const Skeleton& target,
                                 uint32_t* scratch) {
  constexpr uint32_t kFar = 0xFFFFFFFFu;
  uint32_t* const steps = scratch;                       // down to the nearest mapped joint
  uint32_t* const below = scratch + source.joint_count;  // that joint
  const auto gives = [&](uint32_t j) { return same[j] >= 0 && target.usable[same[j]] != 0; };
  for (uint32_t j = 0; j < source.joint_count; ++j) {
    same[j] = counterparts[j];
    steps[j] = kFar;
    below[j] = 0;
  }
  for (uint32_t i = source.joint_count; i-- > 0;) {
    const uint32_t j = source.order[i];
    if (gives(j)) {
      steps[j] = 0;
      below[j] = j;
    }
    const int32_t parent = source.parents[j];
    if (parent < 0 || steps[j] == kFar) continue;
    if (steps[j] + 1 < steps[parent] || (steps[j] + 1 == steps[parent] && below[j] < below[parent])) {
      steps[parent] = steps[j] + 1;
      below[parent] = below[j];
    }
  }
  for (uint32_t i = 0; i < source.joint_count; ++i) {
    const uint32_t j = source.order[i];
    const int32_t parent = source.parents[j];
    target_of[j] = gives(j) ? same[j] : parent >= 0 ? target_of[parent] : -1;
  }
  for (uint32_t j = 0; j < source.joint_count; ++j) {
    if (target_of[j] < 0 && steps[j] != kFar) target_of[j] = same[below[j]];
  }
  for (uint32_t j = 0; j < target.joint_count; ++j) is_new[j] = 1;
  for (uint32_t j = 0; j < source.joint_count; ++j) {
    if (target_of[j] >= 0) is_new[target_of[j]] = 0;
  }
  for (uint32_t i = 0; i < target.joint_count; ++i) {
    const uint32_t j = target.order[i];
    const int32_t parent = target.parents[j];
    head[j] = is_new[j] == 0 || parent < 0 ? static_cast<int32_t>(j) : head[parent];
    if (is_new[j] != 0 && is_new[head[j]] != 0) head[j] = static_cast<int32_t>(j);  // no ancestor gets weight
  }
}

}  // namespace sinew::transferring
