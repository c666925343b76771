// SPDX-License-Identifier: MIT
// Rows of weights of the welded vertices between the network (or the heat field) and the influences: what hints and
// symmetry change. They exist only when one of the two is asked for.
#ifndef SINEW_WEIGHTS_ROWS_HPP
#define SINEW_WEIGHTS_ROWS_HPP

#include "core/arena.hpp"
#include "core/counts.hpp"

namespace sinew {

constexpr uint32_t kRowSlots = 16;  // as many as the heat field keeps, and no fewer than candidates
constexpr uint32_t kWholeRow = 65536;
static_assert(kRowSlots >= SINEW_MAX_CANDIDATES && kRowSlots >= SINEW_MAX_INFLUENCES, "a row fits its slots");

// Slots in any order, no joint twice; unused = kNoJoint with weight 0. Weights Q16, a row sums to about kWholeRow.
struct Rows {
  uint16_t* joints = nullptr;   // [U x kRowSlots]
  uint32_t* weights = nullptr;  // [U x kRowSlots]

  bool allocate(Arena& arena, const Counts& counts) {
    const size_t slots = static_cast<size_t>(counts.vertices) * kRowSlots;
    joints = arena.alloc<uint16_t>(slots);
    weights = arena.alloc<uint32_t>(slots);
    return arena.ok();
  }
  uint16_t* joints_of(uint32_t vertex) const { return joints + static_cast<size_t>(vertex) * kRowSlots; }
  uint32_t* weights_of(uint32_t vertex) const { return weights + static_cast<size_t>(vertex) * kRowSlots; }
  void clear(uint32_t vertex) const {
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      joints_of(vertex)[i] = kNoJoint;
      weights_of(vertex)[i] = 0;
    }
  }
  void copy(uint32_t vertex, const Rows& from, uint32_t from_vertex) const {
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      joints_of(vertex)[i] = from.joints_of(from_vertex)[i];
      weights_of(vertex)[i] = from.weights_of(from_vertex)[i];
    }
  }
  uint32_t weight(uint32_t vertex, uint16_t joint) const {
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      if (joints_of(vertex)[i] == joint) return weights_of(vertex)[i];
    }
    return 0;
  }
  // Adds weight to the joint's slot or to a free one; in a full row it takes the place of the smallest weight (of equal
  // ones the highest joint) when it is larger.
  void add(uint32_t vertex, uint16_t joint, uint32_t weight) const {
    uint16_t* row = joints_of(vertex);
    uint32_t* values = weights_of(vertex);
    uint32_t position = kRowSlots, smallest = 0;
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      if (row[i] == joint) {
        values[i] += weight;
        return;
      }
      if (row[i] == kNoJoint) {
        if (position == kRowSlots) position = i;
        continue;
      }
      if (values[i] < values[smallest] || (values[i] == values[smallest] && row[i] > row[smallest])) smallest = i;
    }
    if (position == kRowSlots) {
      if (values[smallest] >= weight) return;
      position = smallest;
    }
    row[position] = joint;
    values[position] = weight;
  }
};

// Rows that the caller gave, gathered on welded vertices.
enum class GivenKind : uint8_t { kFree = 0, kKept = 1, kSteers = 2 };
struct GivenRows {
  GivenKind* kind = nullptr;  // [U]
  Rows rows;                  // of the vertices that are not free

  bool allocate(Arena& arena, const Counts& counts) {
    kind = arena.alloc<GivenKind>(counts.vertices);
    return rows.allocate(arena, counts);
  }
};

}  // namespace sinew
#endif
