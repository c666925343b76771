// SPDX-License-Identifier: MIT
// Rigid or soft parts and the softness of blending, on rows before hints and symmetry.
#include <string.h>

#include "core/fixed.hpp"
#include "weights/users_say.hpp"

namespace sinew {
namespace {

constexpr uint32_t kRowOne = 1u << 16;

struct StyleScratch {
  uint64_t* sums = nullptr;  // [J] weight of one part, Q16

  bool allocate(Arena& arena, const Counts& counts) {
    sums = arena.alloc<uint64_t>(counts.joints);
    return arena.ok();
  }
};

// Sums per joint over a part of what `row` gives; returns the joint with most (ties: the lower) or kNoJoint.
template <class RowOf>
uint16_t favorite(const Mesh& mesh, uint32_t part, uint32_t joints, const RowOf& row, uint64_t* sums, uint64_t* total) {
  memset(sums, 0, joints * sizeof(uint64_t));
  *total = 0;
  for (uint32_t i = mesh.part_offsets[part]; i < mesh.part_offsets[part + 1]; ++i) {
    row(mesh.part_vertices[i], [&](uint16_t joint, uint32_t weight) {
      sums[joint] += weight;
      *total += weight;
    });
  }
  uint16_t best = kNoJoint;
  for (uint32_t j = 0; j < joints; ++j) {
    if (sums[j] > 0 && (best == kNoJoint || sums[j] > sums[best])) best = static_cast<uint16_t>(j);
  }
  return best;
}

template <class Add>
void add_row(Rows* rows, uint32_t vertex, const Add& add) {
  const uint16_t* joints = rows->joints_of(vertex);
  const uint32_t* weights = rows->weights_of(vertex);
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    if (joints[i] != kNoJoint) add(joints[i], weights[i]);
  }
}

void set_row(Rows* rows, uint32_t vertex, const uint16_t* joints, const uint16_t* weights_q15, uint32_t count) {
  uint16_t* const out_joints = rows->joints_of(vertex);
  uint32_t* const out_weights = rows->weights_of(vertex);
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    out_joints[i] = i < count ? joints[i] : kNoJoint;
    out_weights[i] = i < count ? 2u * weights_q15[i] : 0;
  }
}

bool is_rigid(uint64_t of_favorite, uint64_t total) { return of_favorite * 20 >= total * 19; }

}  // namespace

sinew_status make_parts_rigid(const Mesh& mesh, const Counts& counts, Arena& arena, Rows* rows) {
  const ArenaScope scope(arena);
  StyleScratch scratch;
  if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  for (uint32_t c = 0; c < mesh.part_count; ++c) {
    uint64_t total;
    const uint16_t best = favorite(
        mesh, c, counts.joints, [&](uint32_t v, const auto& add) { add_row(rows, v, add); }, scratch.sums, &total);
    if (best == kNoJoint) continue;
    constexpr uint16_t kWhole = kRowOne / 2;
    for (uint32_t i = mesh.part_offsets[c]; i < mesh.part_offsets[c + 1]; ++i)
      set_row(rows, mesh.part_vertices[i], &best, &kWhole, 1);
  }
  return SINEW_OK;
}

sinew_status make_parts_soft(const Mesh& mesh, const HeatField& heat, const Counts& counts, Arena& arena, Rows* rows) {
  const ArenaScope scope(arena);
  StyleScratch scratch;
  if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  const auto heat_row = [&](uint32_t v, const auto& add) {
    uint16_t joints[kHeatSlots], weights[kHeatSlots];
    const uint32_t count = finish_heat_row(heat, v, joints, weights);
    for (uint32_t i = 0; i < count; ++i) add(joints[i], 2u * weights[i]);
  };
  for (uint32_t c = 0; c < mesh.part_count; ++c) {
    uint64_t total;
    uint16_t best = favorite(
        mesh, c, counts.joints, [&](uint32_t v, const auto& add) { add_row(rows, v, add); }, scratch.sums, &total);
    if (best == kNoJoint || !is_rigid(scratch.sums[best], total)) continue;
    best = favorite(mesh, c, counts.joints, heat_row, scratch.sums, &total);
    if (is_rigid(scratch.sums[best], total)) continue;
    for (uint32_t i = mesh.part_offsets[c]; i < mesh.part_offsets[c + 1]; ++i) {
      const uint32_t v = mesh.part_vertices[i];
      uint16_t joints[kHeatSlots], weights[kHeatSlots];
      const uint32_t count = finish_heat_row(heat, v, joints, weights);
      set_row(rows, v, joints, weights, count);
    }
  }
  return SINEW_OK;
}

void soften_logits(const int16_t* logits, const uint16_t* joints, uint32_t count, uint32_t softness_percent,
                   int16_t* out) {
  int32_t largest = INT32_MIN;
  for (uint32_t i = 0; i < count; ++i) {
    if (joints[i] != kNoJoint && logits[i] > largest) largest = logits[i];
  }
  for (uint32_t i = 0; i < count; ++i) {
    // An absent slot's logit may lie above the largest; softmax does not look at it.
    const int32_t below = joints[i] == kNoJoint ? 0 : largest - logits[i];  // 0 .. 65535
    out[i] = clamp16(-(static_cast<int64_t>(below) * 100 / softness_percent), INT16_MIN, 0);
  }
}

}  // namespace sinew
