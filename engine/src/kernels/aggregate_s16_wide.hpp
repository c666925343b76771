// SPDX-License-Identifier: MIT
// Aggregations over one-rings, candidates, parts and all rows, a register of channels at a time. Written once;
// aggregate_s16_avx2.cpp and its siblings include it with their own registers.
#ifndef SINEW_KERNELS_AGGREGATE_S16_WIDE_HPP
#define SINEW_KERNELS_AGGREGATE_S16_WIDE_HPP

#include "kernels/isolated.hpp"
#include "kernels/table.hpp"

namespace sinew {
namespace {

// Members of an instruction set ("Isa" below):
//   Int16                         a register of kWidth int16
//   load(int16*), store(int16*, Int16), largest(Int16, Int16)
//   Sums                          kWidth int32
//   zero_sums(), add(Sums, Int16), load_sums(int32*), store_sums(int32*, Sums)
//   Divider                       multiplier and offset of MeanDivision in registers
//   divider(MeanDivision), means(Divider, Sums)     round_mean() of each sum
//   kMeanRegisters                registers of channels that a mean sums up at once
//   find_of_8(uint16*, uint16)    the one of 8 joints that is this one, 8 when none is

// Rows of a usual one-ring, found once for all channels. A longer ring goes to the reference.
constexpr uint32_t kMostListed = 64;

// round_mean() of int32 sums. floor(D / 2n) with D = 2 (sum + 32768 n) + n <= 131073 n is (D m) >> 32 for
// m = floor(2^32 / 2n) + 1: the error D (m 2n - 2^32) / (2n 2^32) stays below 1 / 2n while D 2n < 2^32 (Granlund and
// Montgomery 1994), which holds for n < 128. The result is in 0..65535: the mean plus 32768.
struct MeanDivision {
  uint32_t multiplier, offset;
};
static_assert(131073ull * kMostListed * 2 * kMostListed < 1ull << 32, "a mean would be wrong");
SINEW_INLINE MeanDivision mean_division(uint32_t n) { return {0x80000000u / n + 1, 65537 * n}; }

// Candidate slot of `joint` at a vertex, or k when it is none of its candidates. A joint is in at most one slot.
template <class Isa>
SINEW_INLINE uint32_t find_slot(const uint16_t* joints, uint32_t k, uint16_t joint) {
  if (k == 8) return Isa::find_of_8(joints, joint);
  uint32_t slot = 0;
  while (slot < k && joints[slot] != joint) ++slot;
  return slot;
}

// mask != 0.
SINEW_INLINE uint32_t lowest_bit(uint32_t mask) {
#if defined(_MSC_VER)
  unsigned long bit;
  _BitScanForward(&bit, mask);
  return bit;
#else
  return static_cast<uint32_t>(__builtin_ctz(mask));
#endif
}

// The neighbors' rows one after another: Row(u) is a row's index, or kNoRow.
constexpr size_t kNoRow = ~static_cast<size_t>(0);
struct VertexRows {
  SINEW_INLINE size_t operator()(uint32_t u) const { return u; }
};
template <class Isa>
struct PairRows {
  const uint16_t* joints;
  uint32_t k;
  uint16_t joint;
  SINEW_INLINE size_t operator()(uint32_t u) const {
    const size_t first = static_cast<size_t>(u) * k;
    const uint32_t slot = find_slot<Isa>(joints + first, k, joint);
    return slot == k ? kNoRow : first + slot;
  }
};

// R registers of channels of all rows in `list`; the sums stay in registers.
template <class Isa, int R>
SINEW_INLINE void mean_of(const int16_t* const* list, uint32_t n, uint32_t channel,
                          const typename Isa::Divider& divider, int16_t* out) {
  typename Isa::Sums sums[R];
  SINEW_UNROLL for (int i = 0; i < R; ++i) sums[i] = Isa::zero_sums();
  for (uint32_t r = 0; r < n; ++r) {
    const int16_t* const row = list[r] + channel;
    SINEW_UNROLL for (int i = 0; i < R; ++i) sums[i] = Isa::add(sums[i], Isa::load(row + i * Isa::kWidth));
  }
  SINEW_UNROLL for (int i = 0; i < R; ++i) Isa::store(out + channel + i * Isa::kWidth, Isa::means(divider, sums[i]));
}
template <class Isa, int R>
SINEW_INLINE void max_of(const int16_t* const* list, uint32_t n, uint32_t channel, int16_t* out) {
  typename Isa::Int16 largest[R];
  SINEW_UNROLL for (int i = 0; i < R; ++i) largest[i] = Isa::load(list[0] + channel + i * Isa::kWidth);
  for (uint32_t r = 1; r < n; ++r) {
    const int16_t* const row = list[r] + channel;
    SINEW_UNROLL for (int i = 0; i < R; ++i) {
      largest[i] = Isa::largest(largest[i], Isa::load(row + i * Isa::kWidth));
    }
  }
  SINEW_UNROLL for (int i = 0; i < R; ++i) Isa::store(out + channel + i * Isa::kWidth, largest[i]);
}

template <class Row>
SINEW_INLINE void collect(const int16_t* values, size_t stride, const uint32_t* neighbors, uint32_t count, Row row,
                          const int16_t** list, uint32_t* found) {
  uint32_t n = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const size_t at = row(neighbors[i]);
    if (at != kNoRow) list[n++] = values + at * stride;
  }
  *found = n;
}

// Channels that fill no register.
SINEW_INLINE void mean_tail(const int16_t* const* list, uint32_t n, uint32_t channel, uint32_t channels, int16_t* out) {
  for (; channel < channels; ++channel) {
    int32_t sum = 0;
    for (uint32_t r = 0; r < n; ++r) sum += list[r][channel];
    const uint32_t dividend = 2u * static_cast<uint32_t>(sum + static_cast<int32_t>(n) * 32768) + n;
    out[channel] = static_cast<int16_t>(static_cast<int32_t>(dividend / (2 * n)) - 32768);
  }
}
SINEW_INLINE void max_tail(const int16_t* const* list, uint32_t n, uint32_t channel, uint32_t channels, int16_t* out) {
  for (; channel < channels; ++channel) {
    int16_t largest = list[0][channel];
    for (uint32_t r = 1; r < n; ++r) largest = list[r][channel] > largest ? list[r][channel] : largest;
    out[channel] = largest;
  }
}

SINEW_INLINE void zero(int16_t* out, uint32_t channels) {
  for (uint32_t c = 0; c < channels; ++c) out[c] = 0;
}

template <class Isa, bool kMean, class Row>
SINEW_INLINE void ring(const int16_t* values, size_t stride, uint32_t channels, const uint32_t* neighbors,
                       uint32_t count, Row row, int16_t* out) {
  constexpr uint32_t kWidth = Isa::kWidth, kMeans = Isa::kMeanRegisters;
  const int16_t* list[kMostListed];
  uint32_t n = 0;
  collect(values, stride, neighbors, count, row, list, &n);
  if (n == 0) return zero(out, channels);
  uint32_t c = 0;
  if constexpr (kMean) {
    const typename Isa::Divider divider = Isa::divider(mean_division(n));
    for (; c + kMeans * kWidth <= channels; c += kMeans * kWidth) mean_of<Isa, kMeans>(list, n, c, divider, out);
    for (; c + kWidth <= channels; c += kWidth) mean_of<Isa, 1>(list, n, c, divider, out);
    mean_tail(list, n, c, channels, out);
  } else {
    for (; c + 4 * kWidth <= channels; c += 4 * kWidth) max_of<Isa, 4>(list, n, c, out);
    for (; c + kWidth <= channels; c += kWidth) max_of<Isa, 1>(list, n, c, out);
    max_tail(list, n, c, channels, out);
  }
}

template <class Isa>
void ring_mean_vertex(RowsView values, uint32_t channels, const uint32_t* neighbors, uint32_t count, int16_t* out) {
  if (count > kMostListed) return ring_mean_vertex_s16_ref(values, channels, neighbors, count, out);
  ring<Isa, true>(values.data, values.stride, channels, neighbors, count, VertexRows(), out);
}

template <class Isa>
void ring_max_vertex(RowsView values, uint32_t channels, const uint32_t* neighbors, uint32_t count, int16_t* out) {
  if (count > kMostListed) return ring_max_vertex_s16_ref(values, channels, neighbors, count, out);
  ring<Isa, false>(values.data, values.stride, channels, neighbors, count, VertexRows(), out);
}

template <class Isa>
void ring_mean_pair(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k, uint16_t joint,
                    const uint32_t* neighbors, uint32_t count, int16_t* out) {
  if (count > kMostListed) {
    return ring_mean_pair_s16_ref(values, channels, joints, k, joint, neighbors, count, out);
  }
  ring<Isa, true>(values.data, values.stride, channels, neighbors, count, PairRows<Isa>{joints, k, joint}, out);
}

template <class Isa>
void ring_max_pair(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k, uint16_t joint,
                   const uint32_t* neighbors, uint32_t count, int16_t* out) {
  if (count > kMostListed) {
    return ring_max_pair_s16_ref(values, channels, joints, k, joint, neighbors, count, out);
  }
  ring<Isa, false>(values.data, values.stride, channels, neighbors, count, PairRows<Isa>{joints, k, joint}, out);
}

template <class Isa>
void candidate_max(RowsView values, bool by_joint, uint32_t channels, const uint16_t* joints, uint32_t k, int16_t* out,
                   uint32_t out_stride, uint32_t out_slots) {
  const int16_t* list[SINEW_MAX_CANDIDATES];
  uint32_t n = 0;
  for (uint32_t slot = 0; slot < k; ++slot) {
    const uint32_t row = by_joint ? joints[slot] : slot;
    if (joints[slot] != kNoJoint) list[n++] = values.data + static_cast<size_t>(row) * values.stride;
  }
  for (uint32_t slot = 0; n < k && slot < out_slots; ++slot) {
    if (joints[slot] == kNoJoint) zero(out + static_cast<size_t>(slot) * out_stride, channels);
  }
  if (n == 0) return;
  constexpr uint32_t kWidth = Isa::kWidth;
  uint32_t c = 0;
  for (; c + kWidth <= channels; c += kWidth) {
    typename Isa::Int16 largest = Isa::load(list[0] + c);
    for (uint32_t r = 1; r < n; ++r) largest = Isa::largest(largest, Isa::load(list[r] + c));
    for (uint32_t slot = 0; slot < out_slots; ++slot) {
      if (joints[slot] != kNoJoint) Isa::store(out + static_cast<size_t>(slot) * out_stride + c, largest);
    }
  }
  for (; c < channels; ++c) {
    int16_t largest = list[0][c];
    for (uint32_t r = 1; r < n; ++r) largest = list[r][c] > largest ? list[r][c] : largest;
    for (uint32_t slot = 0; slot < out_slots; ++slot) {
      if (joints[slot] != kNoJoint) out[static_cast<size_t>(slot) * out_stride + c] = largest;
    }
  }
}

// round_mean(), which is an inline function of a header and may not be called here.
SINEW_INLINE int16_t mean_of_sum(int64_t sum, uint32_t n) {
  const uint64_t dividend = 2 * static_cast<uint64_t>(sum + static_cast<int64_t>(n) * 32768) + n;
  return static_cast<int16_t>(static_cast<int64_t>(dividend / (2 * static_cast<uint64_t>(n))) - 32768);
}

template <class Isa>
SINEW_INLINE void add_row(const int16_t* row, uint32_t channels, int32_t* sums) {
  constexpr uint32_t kWidth = Isa::kWidth;
  uint32_t c = 0;
  for (; c + kWidth <= channels; c += kWidth) {
    Isa::store_sums(sums + c, Isa::add(Isa::load_sums(sums + c), Isa::load(row + c)));
  }
  for (; c < channels; ++c) sums[c] += row[c];
}

template <class Isa>
SINEW_INLINE void divide_row(const int32_t* sums, uint32_t channels, uint32_t n, int16_t* out) {
  constexpr uint32_t kWidth = Isa::kWidth;
  uint32_t c = 0;
  if (n <= kMostListed) {
    const typename Isa::Divider divider = Isa::divider(mean_division(n));
    for (; c + kWidth <= channels; c += kWidth) Isa::store(out + c, Isa::means(divider, Isa::load_sums(sums + c)));
  }
  for (; c < channels; ++c) out[c] = mean_of_sum(sums[c], n);
}

// As the reference, with int32 sums in the scratch: 65535 * 32768 < 2^31. A joint's first row is copied, so nothing is
// cleared, and a bit for every joint tells which rows to divide.
template <class Isa>
void part_mean_pair(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k, const uint32_t* vertices,
                    uint32_t count, int64_t* scratch, int16_t* out) {
  if (count > 65535) return part_mean_pair_s16_ref(values, channels, joints, k, vertices, count, scratch, out);
  int32_t* const sums = static_cast<int32_t*>(static_cast<void*>(scratch));
  constexpr uint32_t kWords = SINEW_MAX_JOINTS / 32;
  uint32_t met[kWords];
  for (uint32_t word = 0; word < kWords; ++word) met[word] = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const size_t first = static_cast<size_t>(vertices[i]) * k;
    for (uint32_t slot = 0; slot < k; ++slot) {
      const uint32_t joint = joints[first + slot];
      if (joint == kNoJoint) continue;
      int32_t* const joint_sums = sums + static_cast<size_t>(joint) * channels;
      const int16_t* const row = values.data + (first + slot) * values.stride;
      uint32_t& word = met[joint / 32];
      if ((word >> joint % 32 & 1) != 0) {
        add_row<Isa>(row, channels, joint_sums);
      } else {
        word |= 1u << joint % 32;
        for (uint32_t c = 0; c < channels; ++c) joint_sums[c] = row[c];
      }
    }
  }
  for (uint32_t joint = 0; joint < SINEW_MAX_JOINTS; joint += 32) {
    uint32_t rest = met[joint / 32];
    for (uint32_t own = joint; rest != 0; ++own, rest >>= 1) {
      if ((rest & 1) == 0) continue;
      divide_row<Isa>(sums + static_cast<size_t>(own) * channels, channels, count,
                      out + static_cast<size_t>(own) * channels);
    }
  }
}

template <class Isa>
void global_mean(RowsView values, uint32_t channels, const uint16_t* present, size_t rows, int64_t* sums,
                 int16_t* out) {
  constexpr uint32_t kChunk = 64, kMostRows = 65535;  // channels whose int32 sums stay close; rows before they overflow
  uint32_t n = 0;
  for (size_t r = 0; r < rows; ++r) n += present == nullptr || present[r] != kNoJoint ? 1 : 0;
  for (uint32_t c = 0; c < channels; ++c) sums[c] = 0;
  for (uint32_t first = 0; first < channels; first += kChunk) {
    const uint32_t width = channels - first < kChunk ? channels - first : kChunk;
    for (size_t begin = 0; begin < rows; begin += kMostRows) {
      const size_t end = rows - begin < kMostRows ? rows : begin + kMostRows;
      int32_t part[kChunk];
      for (uint32_t c = 0; c < kChunk; ++c) part[c] = 0;
      for (size_t r = begin; r < end; ++r) {
        if (present != nullptr && present[r] == kNoJoint) continue;
        add_row<Isa>(values.data + r * values.stride + first, width, part);
      }
      for (uint32_t c = 0; c < width; ++c) sums[first + c] += part[c];
    }
  }
  for (uint32_t c = 0; c < channels; ++c) out[c] = n == 0 ? static_cast<int16_t>(0) : mean_of_sum(sums[c], n);
}

// int32 sums in the scratch, as for pairs.
template <class Isa>
void part_mean_vertex(RowsView values, uint32_t channels, const uint32_t* vertices, uint32_t count, int64_t* scratch,
                      int16_t* out) {
  if (count > 65535) return part_mean_vertex_s16_ref(values, channels, vertices, count, scratch, out);
  int32_t* const sums = static_cast<int32_t*>(static_cast<void*>(scratch));
  for (uint32_t c = 0; c < channels; ++c) sums[c] = 0;
  for (uint32_t i = 0; i < count; ++i) {
    add_row<Isa>(values.data + static_cast<size_t>(vertices[i]) * values.stride, channels, sums);
  }
  divide_row<Isa>(sums, channels, count, out);
}

template <class Isa>
void global_max(RowsView values, uint32_t channels, const uint16_t* present, size_t rows, int16_t* out) {
  constexpr uint32_t kWidth = Isa::kWidth;
  size_t first = 0;
  while (first < rows && present != nullptr && present[first] == kNoJoint) ++first;
  if (first == rows) return zero(out, channels);
  for (uint32_t c = 0; c < channels; ++c) out[c] = values.data[first * values.stride + c];
  for (size_t r = first + 1; r < rows; ++r) {
    if (present != nullptr && present[r] == kNoJoint) continue;
    const int16_t* const row = values.data + r * values.stride;
    uint32_t c = 0;
    for (; c + kWidth <= channels; c += kWidth) {
      Isa::store(out + c, Isa::largest(Isa::load(out + c), Isa::load(row + c)));
    }
    for (; c < channels; ++c) out[c] = row[c] > out[c] ? row[c] : out[c];
  }
}

template <class Isa>
SINEW_INLINE void add_means(Kernels* kernels) {
  kernels->ring_mean_vertex = ring_mean_vertex<Isa>;
  kernels->ring_mean_pair = ring_mean_pair<Isa>;
  kernels->part_mean_vertex = part_mean_vertex<Isa>;
  kernels->part_mean_pair = part_mean_pair<Isa>;
  kernels->global_mean = global_mean<Isa>;
}

template <class Isa>
SINEW_INLINE void add_aggregates(Kernels* kernels) {
  add_means<Isa>(kernels);
  kernels->ring_max_vertex = ring_max_vertex<Isa>;
  kernels->ring_max_pair = ring_max_pair<Isa>;
  kernels->candidate_max = candidate_max<Isa>;
  kernels->global_max = global_max<Isa>;
}

}  // namespace
}  // namespace sinew
#endif
