// SPDX-License-Identifier: MIT
// Tables of one part, from the heat of its vertices and of its host's.
#include "features/part_tables.hpp"

#include <string.h>

#include "core/sort.hpp"

namespace sinew::features {
namespace {

constexpr int32_t kWeightOne = 1 << 15;  // heat weights are Q15

}  // namespace

void PartTableBuilder::sum_rule_rows(uint32_t c) {
  const uint32_t joints = skeleton_.joint_count;
  const uint32_t first = mesh_.part_offsets[c], size = mesh_.part_sizes[c];
  memset(t_.own, 0, joints * sizeof(int64_t));
  memset(t_.host, 0, joints * sizeof(int64_t));
  for (uint32_t i = 0; i < size; ++i) add_rule_row(mesh_.part_vertices[first + i], t_.own);

  t_.host_total = 0;
  t_.contact = 0;
  if (parts_.host_vertex[mesh_.part_vertices[first]] != kNoVertex) {
    for (uint32_t i = 0; i < size; ++i) {
      const uint32_t v = mesh_.part_vertices[first + i];
      keys_[i] = static_cast<uint64_t>(parts_.host_distance[v]) << 32 | v;
    }
    sort_ascending(keys_, size);
    const uint32_t closest = (size + 3) / 4;
    uint64_t distance = 0;
    for (uint32_t i = 0; i < closest; ++i) {
      add_rule_row(parts_.host_vertex[static_cast<uint32_t>(keys_[i])], t_.host);
      distance += keys_[i] >> 32;
    }
    t_.contact = static_cast<uint32_t>(distance / closest);
    for (uint32_t j = 0; j < joints; ++j) t_.host_total += t_.host[j];
  }
  sum_subtrees(t_.own, t_.subtree);
  sum_subtrees(t_.host, t_.host_subtree);
}

void PartTableBuilder::find_box(uint32_t c) {
  const Vec3i lo = parts_.box_min[c], hi = parts_.box_max[c];
  t_.center = {(lo.x + hi.x) / 2, (lo.y + hi.y) / 2, (lo.z + hi.z) / 2};
  const Vec3i side = hi - lo;
  t_.extent = side.x > side.y ? side.x : side.y;
  t_.extent = side.z > t_.extent ? side.z : t_.extent;
  t_.extent = t_.extent < 1 ? 1 : t_.extent;
  t_.thickness = side.x < side.y ? side.x : side.y;
  t_.thickness = side.z < t_.thickness ? side.z : t_.thickness;
}

// Where the joints lie, and which of them represent the part.
void PartTableBuilder::mark_joints(uint32_t c) {
  const uint32_t joints = skeleton_.joint_count, size = mesh_.part_sizes[c];
  const Vec3i lo = parts_.box_min[c], hi = parts_.box_max[c];
  const int32_t slack = t_.extent / 64;
  memset(t_.deepest, 0, joints);
  for (uint32_t i = 0; i < joints; ++i) {  // parents first
    const uint32_t j = skeleton_.order[i];
    const Vec3i p = skeleton_.positions[j];
    const int32_t parent = skeleton_.parents[j];
    t_.in_box[j] = p.x >= lo.x - slack && p.x <= hi.x + slack && p.y >= lo.y - slack && p.y <= hi.y + slack &&
                   p.z >= lo.z - slack && p.z <= hi.z + slack;
    const bool above = parent >= 0 && t_.covered[parent] != 0;
    t_.topmost[j] = t_.in_box[j] != 0 && !above;
    t_.covered[j] = t_.in_box[j] != 0 || above;
    const int64_t enough = static_cast<int64_t>(size) * (kWeightOne / 10 * 9);
    if (t_.subtree[j] >= enough) {
      t_.deepest[j] = 1;
      if (parent >= 0) t_.deepest[parent] = 0;
    }
  }
  t_.own_top = argmax(t_.own);
  t_.host_top = argmax(t_.host);
  t_.box_top = kNoJoint;
  for (uint32_t j = 0; j < joints; ++j) {
    if (t_.topmost[j] == 0 || skeleton_.usable[j] == 0) continue;
    if (t_.box_top == kNoJoint || t_.subtree[j] > t_.subtree[t_.box_top]) t_.box_top = static_cast<uint16_t>(j);
  }
}

void PartTableBuilder::fill(uint32_t c) {
  sum_rule_rows(c);
  find_box(c);
  mark_joints(c);
  write_part_row(c);
  const uint32_t joints = skeleton_.joint_count;
  memset(t_.paired, 0, joints);
  for (uint32_t j = 0; j < joints && mesh_.part_sizes[c] >= kSmallPart; ++j) (void)channels(j, c);
}

uint16_t PartTableBuilder::argmax(const int64_t* table) const {
  uint16_t best = kNoJoint;
  for (uint32_t j = 0; j < skeleton_.joint_count; ++j) {
    if (table[j] > 0 && (best == kNoJoint || table[j] > table[best])) best = static_cast<uint16_t>(j);
  }
  return best;
}

void PartTableBuilder::add_rule_row(uint32_t vertex, int64_t* table) {
  HeatRow row;
  row.load(heat_.field[kFieldRule], vertex);
  for (uint32_t i = 0; i < row.count; ++i) table[row.joints[i]] += row.weights[i];
}

void PartTableBuilder::sum_subtrees(const int64_t* own, int64_t* subtree) const {
  for (uint32_t j = 0; j < skeleton_.joint_count; ++j) subtree[j] = own[j];
  for (uint32_t i = skeleton_.joint_count; i-- > 0;) {
    const uint32_t j = skeleton_.order[i];
    if (skeleton_.parents[j] >= 0) subtree[skeleton_.parents[j]] += subtree[j];
  }
}

// The channels that all vertices of a part share; the others 0.
void PartTableBuilder::write_part_row(uint32_t c) {
  const uint32_t size = mesh_.part_sizes[c];
  int16_t* const f = t_.vertex;
  memset(f, 0, kVertexFeatureCount * sizeof(int16_t));
  f[kV_part_share_log] = q13((log2_q16(size) - log2_q16(mesh_.welded_count)) >> 6);
  f[kV_part_source_share] = ratio_q13(parts_.source_count[c], size);
  f[kV_part_count_log] = log_q13(mesh_.part_count, 0, 3);
  f[kV_joint_count_log] = log_q13(skeleton_.joint_count, 0, 3);
  f[kV_vertex_count_log] = log_q13(mesh_.welded_count, 8 << 16, 3);
  f[kV_part_boundary_share] = ratio_q13(parts_.boundary_count[c], size);
  f[kV_is_largest_part] = c == 0 ? kOne : 0;
  f[kV_part_extent] = side_ratio_q13(t_.extent);
  f[kV_part_flatness] = ratio_q13(t_.thickness, t_.extent);
  f[kV_part_purity] = t_.own_top == kNoJoint ? int16_t{0} : share_q13(t_.own[t_.own_top], size);
  f[kV_rule_is_parts] = heat_.part_rule[c] == 1 ? kOne : 0;
  f[kV_rule_is_open] = heat_.part_rule[c] == 2 ? kOne : 0;
  f[kV_host_purity] = t_.host_top == kNoJoint ? int16_t{0} : ratio_q13(t_.host[t_.host_top], t_.host_total);
  f[kV_loose_share] = ratio_q13(mesh_.welded_count - mesh_.part_sizes[0], mesh_.welded_count);
  f[kV_part_contact] = c == 0 ? int16_t{0} : log_q13(t_.contact + uint64_t{kSoftLength}, 12 << 16, 2);
}

void PartTableBuilder::make_channels(uint32_t j, uint32_t c) {
  const uint32_t size = mesh_.part_sizes[c];
  const int32_t parent = skeleton_.parents[j];
  int16_t f[kPairFeatureCount] = {};
  if (t_.host_total > 0) {
    f[kP_host_share] = ratio_q13(t_.host[j], t_.host_total);
    f[kP_host_subtree] = ratio_q13(t_.host_subtree[j], t_.host_total);
    f[kP_is_host_top] = t_.host_top == j ? kOne : 0;
  }
  f[kP_part_share] = share_q13(t_.own[j], size);
  f[kP_part_subtree] = share_q13(t_.subtree[j], size);
  f[kP_part_parent_subtree] = parent < 0 ? kOne : share_q13(t_.subtree[parent], size);
  f[kP_is_part_top] = t_.own_top == j ? kOne : 0;
  f[kP_joint_in_box] = t_.in_box[j] != 0 ? kOne : 0;
  f[kP_topmost_in_box] = t_.topmost[j] != 0 ? kOne : 0;
  f[kP_deepest_of_part] = t_.deepest[j] != 0 ? kOne : 0;
  const Vec3i to_center = t_.center - skeleton_.positions[j];
  const uint32_t centre_distance = isqrt64(static_cast<uint64_t>(dot(to_center, to_center)));
  f[kP_centre_distance] = side_ratio_q13(2 * static_cast<int64_t>(centre_distance));
  f[kP_centre_ratio] = log_q13(static_cast<uint64_t>(centre_distance) + kSoftLength,
                               log2_q16(static_cast<uint64_t>(t_.extent) + kSoftLength), 2);
  f[kP_territory] = log_q13(candidates_.territory[j] + uint64_t{16}, 16 << 16, 3);
  f[kP_is_source] = heat_.source_joints[j] != 0 ? kOne : 0;
  f[kP_is_root] = parent < 0 ? kOne : 0;
  memcpy(t_.pair + static_cast<size_t>(j) * kPartChannels, f + kFirstPartChannel, kPartChannels * sizeof(int16_t));
  t_.paired[j] = 1;
}

}  // namespace sinew::features
