// SPDX-License-Identifier: MIT
// Reference aggregations over neighbors, candidates, parts and all rows. Sums of integers: no order matters.
#include "kernels/kernels.hpp"

namespace sinew {
namespace {

constexpr uint32_t kChunk = 64;  // channels per pass: their sums stay in registers and the first-level cache

inline const int16_t* row_at(RowsView values, size_t row) { return values.data + row * values.stride; }

// Row of `joint` at vertex u, or null when it is none of u's candidates.
inline const int16_t* pair_row(RowsView values, const uint16_t* joints, uint32_t k, uint16_t joint, uint32_t u) {
  const size_t first = static_cast<size_t>(u) * k;
  for (uint32_t slot = 0; slot < k; ++slot) {
    if (joints[first + slot] == joint) return row_at(values, first + slot);
  }
  return nullptr;
}

// RowOf(neighbor) gives the neighbor's row or null. Sum is int32 where 65536 neighbors cannot overflow it, else
// int64.
template <class Sum, class RowOf>
void ring_mean(uint32_t channels, const uint32_t* neighbors, uint32_t count, RowOf row_of, int16_t* out) {
  for (uint32_t first = 0; first < channels; first += kChunk) {
    const uint32_t width = channels - first < kChunk ? channels - first : kChunk;
    Sum sums[kChunk] = {};
    uint32_t n = 0;
    for (uint32_t i = 0; i < count; ++i) {
      const int16_t* row = row_of(neighbors[i]);
      if (row == nullptr) continue;
      ++n;
      for (uint32_t c = 0; c < width; ++c) sums[c] += row[first + c];
    }
    for (uint32_t c = 0; c < width; ++c) out[first + c] = n == 0 ? static_cast<int16_t>(0) : round_mean(sums[c], n);
  }
}

template <class RowOf>
void ring_mean_any(uint32_t channels, const uint32_t* neighbors, uint32_t count, RowOf row_of, int16_t* out) {
  if (count <= 65535) {  // 65535 * 32768 < 2^31
    ring_mean<int32_t>(channels, neighbors, count, row_of, out);
  } else {
    ring_mean<int64_t>(channels, neighbors, count, row_of, out);
  }
}

template <class RowOf>
void ring_max(uint32_t channels, const uint32_t* neighbors, uint32_t count, RowOf row_of, int16_t* out) {
  bool any = false;
  for (uint32_t i = 0; i < count; ++i) {
    const int16_t* row = row_of(neighbors[i]);
    if (row == nullptr) continue;
    for (uint32_t c = 0; c < channels; ++c) out[c] = !any || row[c] > out[c] ? row[c] : out[c];
    any = true;
  }
  for (uint32_t c = 0; !any && c < channels; ++c) out[c] = 0;
}

inline void add_row(const int16_t* row, uint32_t channels, int64_t* sums) {
  for (uint32_t c = 0; c < channels; ++c) sums[c] += row[c];
}

inline void divide_row(const int64_t* sums, uint32_t channels, uint32_t n, int16_t* out) {
  for (uint32_t c = 0; c < channels; ++c) out[c] = round_mean(sums[c], n);
}

}  // namespace

void ring_mean_vertex_s16_ref(RowsView values, uint32_t channels, const uint32_t* neighbors, uint32_t count,
                              int16_t* out) {
  ring_mean_any(
      channels, neighbors, count, [&](uint32_t u) { return row_at(values, u); }, out);
}

void ring_max_vertex_s16_ref(RowsView values, uint32_t channels, const uint32_t* neighbors, uint32_t count,
                             int16_t* out) {
  ring_max(
      channels, neighbors, count, [&](uint32_t u) { return row_at(values, u); }, out);
}

void ring_mean_pair_s16_ref(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k, uint16_t joint,
                            const uint32_t* neighbors, uint32_t count, int16_t* out) {
  ring_mean_any(
      channels, neighbors, count, [&](uint32_t u) { return pair_row(values, joints, k, joint, u); }, out);
}

void ring_max_pair_s16_ref(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k, uint16_t joint,
                           const uint32_t* neighbors, uint32_t count, int16_t* out) {
  ring_max(
      channels, neighbors, count, [&](uint32_t u) { return pair_row(values, joints, k, joint, u); }, out);
}

void candidate_max_s16_ref(RowsView values, bool by_joint, uint32_t channels, const uint16_t* joints, uint32_t k,
                           int16_t* out, uint32_t out_stride, uint32_t out_slots) {
  const int16_t* collected = nullptr;  // the first present slot's output row collects the maximum, the others copy it
  for (uint32_t slot = 0; slot < out_slots; ++slot) {
    int16_t* const to = out + static_cast<size_t>(slot) * out_stride;
    if (joints[slot] == kNoJoint || collected != nullptr) {
      for (uint32_t c = 0; c < channels; ++c) to[c] = joints[slot] == kNoJoint ? static_cast<int16_t>(0) : collected[c];
      continue;
    }
    collected = to;
    for (uint32_t other = slot; other < k; ++other) {  // those before it are absent
      if (joints[other] == kNoJoint) continue;
      const int16_t* const row = row_at(values, by_joint ? joints[other] : other);
      for (uint32_t c = 0; c < channels; ++c) to[c] = other == slot || row[c] > to[c] ? row[c] : to[c];
    }
  }
}

void part_mean_vertex_s16_ref(RowsView values, uint32_t channels, const uint32_t* vertices, uint32_t count,
                              int64_t* sums, int16_t* out) {
  for (uint32_t c = 0; c < channels; ++c) sums[c] = 0;
  for (uint32_t i = 0; i < count; ++i) add_row(row_at(values, vertices[i]), channels, sums);
  divide_row(sums, channels, count, out);
}

void part_mean_pair_s16_ref(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k,
                            const uint32_t* vertices, uint32_t count, int64_t* sums, int16_t* out) {
  // Three passes over the part's pairs instead of over the table: clear, add, divide. Dividing marks a row as done by
  // setting its first sum to a value no sum can have.
  constexpr int64_t kDone = INT64_MIN;
  for (uint32_t pass = 0; pass < 3; ++pass) {
    for (uint32_t i = 0; i < count; ++i) {
      const size_t first = static_cast<size_t>(vertices[i]) * k;
      for (uint32_t slot = 0; slot < k; ++slot) {
        const uint16_t joint = joints[first + slot];
        if (joint == kNoJoint) continue;
        int64_t* joint_sums = sums + static_cast<size_t>(joint) * channels;
        if (pass == 0) {
          for (uint32_t c = 0; c < channels; ++c) joint_sums[c] = 0;
        } else if (pass == 1) {
          add_row(row_at(values, first + slot), channels, joint_sums);
        } else if (joint_sums[0] != kDone) {
          divide_row(joint_sums, channels, count, out + static_cast<size_t>(joint) * channels);
          joint_sums[0] = kDone;
        }
      }
    }
  }
}

void global_mean_s16_ref(RowsView values, uint32_t channels, const uint16_t* present, size_t rows, int64_t* sums,
                         int16_t* out) {
  uint32_t n = 0;
  for (uint32_t c = 0; c < channels; ++c) sums[c] = 0;
  for (size_t r = 0; r < rows; ++r) {
    if (present != nullptr && present[r] == kNoJoint) continue;
    ++n;
    add_row(row_at(values, r), channels, sums);
  }
  for (uint32_t c = 0; c < channels; ++c) out[c] = n == 0 ? static_cast<int16_t>(0) : round_mean(sums[c], n);
}

void global_max_s16_ref(RowsView values, uint32_t channels, const uint16_t* present, size_t rows, int16_t* out) {
  bool any = false;
  for (size_t r = 0; r < rows; ++r) {
    if (present != nullptr && present[r] == kNoJoint) continue;
    const int16_t* row = row_at(values, r);
    for (uint32_t c = 0; c < channels; ++c) out[c] = !any || row[c] > out[c] ? row[c] : out[c];
    any = true;
  }
  for (uint32_t c = 0; !any && c < channels; ++c) out[c] = 0;
}

}  // namespace sinew
