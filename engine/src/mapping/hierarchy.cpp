// SPDX-License-Identifier: MIT
// The caller's rig, checked: children in rows, the order that keeps subtrees together, counts and reaches.
#include "mapping/hierarchy.hpp"

namespace sinew::mapping {
namespace {

bool is_finite(double a) { return a - a == 0; }

}  // namespace

bool Hierarchy::allocate(Arena& arena, uint32_t joints) {
  n = static_cast<int32_t>(joints);
  at = arena.alloc<Point>(joints);
  parent = arena.alloc<int32_t>(joints);
  kid_offsets = arena.alloc<int32_t>(size_t{joints} + 2);
  kids = arena.alloc<int32_t>(joints);
  order = arena.alloc<int32_t>(joints);
  position = arena.alloc<int32_t>(joints);
  depth = arena.alloc<int32_t>(joints);
  count = arena.alloc<int32_t>(joints);
  reach = arena.alloc<double>(joints);
  end = arena.alloc<uint8_t>(joints);
  names = arena.alloc<JointName>(joints);
  return arena.ok();
}

sinew_status Hierarchy::build(const sinew_skeleton& rig, bool with_names) {
  n = static_cast<int32_t>(rig.joint_count);
  has_names = with_names;
  has_ends = rig.ends != nullptr;  // or names tell of some, see below
  Point low, high;
  for (int32_t i = 0; i < n; ++i) {
    const float* const p = rig.positions + size_t{3} * static_cast<size_t>(i);
    at[i] = {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    if (!is_finite(at[i].x) || !is_finite(at[i].y) || !is_finite(at[i].z)) return SINEW_ERROR_NOT_FINITE;
    if (i == 0) low = high = at[0];
    low = {lesser(low.x, at[i].x), lesser(low.y, at[i].y), lesser(low.z, at[i].z)};
    high = {greater(high.x, at[i].x), greater(high.y, at[i].y), greater(high.z, at[i].z)};
    parent[i] = rig.parents[i];
    if (parent[i] < -1 || parent[i] >= n) return SINEW_ERROR_INDEX;
  }
  size = distance(low, high);
  if (!(size > 0)) size = 1;
  for (int32_t i = 0; i <= n + 1; ++i) kid_offsets[i] = 0;
  for (int32_t i = 0; i < n; ++i) ++kid_offsets[(parent[i] >= 0 ? parent[i] : n) + 1];
  for (int32_t i = 0; i <= n; ++i) kid_offsets[i + 1] += kid_offsets[i];
  for (int32_t i = 0; i < n; ++i) position[i] = 0;  // how many children of a joint have their index
  int32_t roots = 0;
  for (int32_t i = 0; i < n; ++i) {
    const int32_t p = parent[i];
    kids[kid_offsets[p >= 0 ? p : n] + (p >= 0 ? position[p]++ : roots++)] = i;
  }
  // Down to the first child, else on to the next sibling of the joint or of one above it.
  int32_t placed = 0;
  for (int32_t r = 0; r < roots; ++r) {
    int32_t i = kids[kid_offsets[n] + r];
    depth[i] = 0;
    for (bool down = true; i >= 0;) {
      if (down) {
        position[i] = placed;
        order[placed++] = i;
        count[i] = 0;  // children that were visited, until the subtree is done
      }
      if (count[i] < kid_count(i)) {
        const int32_t next = kid(i, count[i]++);
        depth[next] = depth[i] + 1;
        i = next;
        down = true;
      } else {
        i = parent[i];
        down = false;
      }
    }
  }
  if (placed != n) return SINEW_ERROR_HIERARCHY;  // what no root reaches goes round in a circle
  for (int32_t i = 0; i < n; ++i) {
    count[i] = 1;
    reach[i] = 0;
  }
  for (int32_t k = n - 1; k >= 0; --k) {
    const int32_t i = order[k], p = parent[i];
    if (p < 0) continue;
    count[p] += count[i];
    reach[p] = greater(reach[p], reach[i] + bone(i, p));
  }
  for (int32_t i = 0; i < n; ++i) {
    end[i] = rig.ends != nullptr && rig.ends[i] != 0 && parent[i] >= 0 ? 1 : 0;
    names[i] = JointName();
    if (!with_names) continue;
    names[i] = names::read_joint_name(rig.names[i]);
    if (names[i].is_end_of_map() && kid_count(i) == 0) {
      end[i] = 1;
      has_ends = true;
    }
  }
  return SINEW_OK;
}

void Hierarchy::take_leaves_as_ends(bool yes) {
  for (int32_t i = 0; i < n && !has_ends; ++i) end[i] = yes && kid_count(i) == 0 && parent[i] >= 0 ? 1 : 0;
}

}  // namespace sinew::mapping
