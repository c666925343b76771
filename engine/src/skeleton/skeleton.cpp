// SPDX-License-Identifier: MIT
// Checks the joint hierarchy, orders it and finds where each joint's bone ends.
#include "skeleton/skeleton.hpp"

#include "core/vector_math.hpp"

namespace sinew {
namespace {

constexpr uint16_t kNoDepth = 0xFFFF;

// False when the parents form a cycle. Every joint is walked up to the first joint of known depth, then once more to
// write.
bool find_depths(Skeleton* skeleton) {
  const uint32_t count = skeleton->joint_count;
  for (uint32_t j = 0; j < count; ++j) skeleton->depth[j] = kNoDepth;
  for (uint32_t j = 0; j < count; ++j) {
    uint32_t steps = 0;
    int32_t at = static_cast<int32_t>(j);
    while (at >= 0 && skeleton->depth[at] == kNoDepth) {
      if (++steps > count) return false;
      at = skeleton->parents[at];
    }
    uint32_t depth = (at >= 0 ? skeleton->depth[at] + 1u : 0u) + steps;  // one more than the depth of j
    for (at = static_cast<int32_t>(j); at >= 0 && skeleton->depth[at] == kNoDepth; at = skeleton->parents[at]) {
      skeleton->depth[at] = static_cast<uint16_t>(--depth);
    }
  }
  return true;
}

// Parents before children: by depth, then by index. Counting sort over depths, one pass per depth that occurs.
void order_joints(Skeleton* skeleton) {
  uint32_t used = 0;
  for (uint32_t depth = 0; used < skeleton->joint_count; ++depth) {
    for (uint32_t j = 0; j < skeleton->joint_count; ++j) {
      if (skeleton->depth[j] == depth) skeleton->order[used++] = j;
    }
  }
}

bool is_deform_known(const uint8_t* flags, uint32_t count) {
  for (uint32_t j = 0; j < count && flags != nullptr; ++j) {
    if ((flags[j] & SINEW_JOINT_DEFORMS) != 0) return true;
  }
  return false;
}

bool is_forbidden(uint32_t flag, bool deform_known) {
  return (flag & SINEW_JOINT_NEVER) != 0 || (deform_known && (flag & SINEW_JOINT_DEFORMS) == 0);
}

bool find_usable(const uint8_t* flags, Skeleton* skeleton) {
  const uint32_t count = skeleton->joint_count;
  skeleton->deform_known = is_deform_known(flags, count);
  bool any = false;
  for (uint32_t j = 0; j < count; ++j) {
    const bool never = is_forbidden(flags != nullptr ? flags[j] : 0, skeleton->deform_known);
    skeleton->usable[j] = never ? 0 : 1;
    any = any || !never;
  }
  return any;
}

// Longest side of the joints' box.
int64_t skeleton_size(const Skeleton& skeleton) {
  Vec3i low = skeleton.positions[0], high = low;
  for (uint32_t j = 1; j < skeleton.joint_count; ++j) grow(skeleton.positions[j], &low, &high);
  return extent(high - low);
}

// A leaf's bone: half its parent bone on in the same direction, at most a tenth of the skeleton's size.
Vec3i leaf_tail(const Skeleton& skeleton, uint32_t leaf, int64_t size) {
  const Vec3i head = skeleton.positions[leaf];
  if (skeleton.parents[leaf] < 0) return head;
  const Vec3i along = head - skeleton.positions[skeleton.parents[leaf]];
  const int64_t bone = static_cast<int64_t>(length(along));
  if (bone == 0) return head;
  // The stub is min(bone / 2, size / 10) long; both are compared in twentieths to stay exact.
  const bool limited = 5 * bone > size;
  const int64_t numerator = limited ? size : 1;
  const int64_t denominator = limited ? 10 * bone : 2;
  return head + round_div(Vec3l{along.x * numerator, along.y * numerator, along.z * numerator}, denominator);
}

// 4095 children of 2^22 units pass 32 bits, so the sum is 64-bit and local. The search stops at the last child; even
// 4096 joints cost only a few million comparisons.
Vec3i mean_of_children(const Skeleton& skeleton, uint32_t joint) {
  Vec3l sum = {0, 0, 0};
  uint32_t left = skeleton.child_count[joint];
  for (uint32_t j = 0; left > 0; ++j) {
    if (skeleton.parents[j] != static_cast<int32_t>(joint)) continue;
    sum.x += skeleton.positions[j].x;
    sum.y += skeleton.positions[j].y;
    sum.z += skeleton.positions[j].z;
    --left;
  }
  return round_div(sum, skeleton.child_count[joint]);
}

void lay_bones(Skeleton* skeleton) {
  const uint32_t count = skeleton->joint_count;
  for (uint32_t j = 0; j < count; ++j) skeleton->child_count[j] = 0;
  for (uint32_t j = 0; j < count; ++j) {
    if (skeleton->parents[j] >= 0) ++skeleton->child_count[skeleton->parents[j]];
  }
  const int64_t size = skeleton_size(*skeleton);
  for (uint32_t j = 0; j < count; ++j) {
    skeleton->bone_tail[j] =
        skeleton->child_count[j] > 0 ? mean_of_children(*skeleton, j) : leaf_tail(*skeleton, j, size);
  }
}

}  // namespace

bool Skeleton::allocate(Arena& arena, const Counts& counts) {
  const size_t count = counts.joints;
  positions = arena.alloc<Vec3i>(count);
  parents = arena.alloc<int32_t>(count);
  order = arena.alloc<uint32_t>(count);
  child_count = arena.alloc<uint16_t>(count);
  depth = arena.alloc<uint16_t>(count);
  usable = arena.alloc<uint8_t>(count);
  bone_tail = arena.alloc<Vec3i>(count);
  return arena.ok();
}

bool may_get_weight(const sinew_skeleton& input, uint32_t joint) {
  if (joint >= input.joint_count) return false;
  return input.flags == nullptr || !is_forbidden(input.flags[joint], is_deform_known(input.flags, input.joint_count));
}

sinew_status build_skeleton(const sinew_skeleton& input, const GridQuantizer& quantizer, Skeleton* skeleton) {
  const uint32_t count = input.joint_count;
  skeleton->joint_count = count;
  for (uint32_t j = 0; j < count; ++j) {
    if (!is_finite_point(input.positions + 3 * static_cast<size_t>(j))) return SINEW_ERROR_NOT_FINITE;
    skeleton->positions[j] = quantize_point(quantizer, input.positions + 3 * static_cast<size_t>(j));
  }
  for (uint32_t j = 0; j < count; ++j) {
    if (input.parents[j] < -1 || input.parents[j] >= static_cast<int32_t>(count)) return SINEW_ERROR_INDEX;
    skeleton->parents[j] = input.parents[j];
  }
  if (!find_depths(skeleton)) return SINEW_ERROR_HIERARCHY;
  if (!find_usable(input.flags, skeleton)) return SINEW_ERROR_NO_JOINT;
  order_joints(skeleton);
  lay_bones(skeleton);
  return SINEW_OK;
}

}  // namespace sinew
