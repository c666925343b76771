// SPDX-License-Identifier: MIT
// Aggregations over one-rings, candidates, parts and all rows with AVX2, 16 channels at a time.
#include "kernels/variants.hpp"

#if defined(__AVX2__)
#include <immintrin.h>

#include "kernels/isolated.hpp"

namespace sinew {
namespace {

constexpr uint32_t kLanes = 16;  // int16 of a register
// Rows of a usual one-ring, found once for all channels. A longer ring goes to the reference.
constexpr uint32_t kMostListed = 64;

SINEW_INLINE __m256i load(const int16_t* from) {
  return _mm256_loadu_si256(static_cast<const __m256i*>(static_cast<const void*>(from)));
}
SINEW_INLINE void store(int16_t* to, __m256i value) {
  _mm256_storeu_si256(static_cast<__m256i*>(static_cast<void*>(to)), value);
}
SINEW_INLINE __m256i low_half(__m256i values) { return _mm256_cvtepi16_epi32(_mm256_castsi256_si128(values)); }
SINEW_INLINE __m256i high_half(__m256i values) { return _mm256_cvtepi16_epi32(_mm256_extracti128_si256(values, 1)); }

// round_mean() of 8 sums. floor(D / 2n) with D = 2 (sum + 32768 n) + n <= 131073 n is (D m) >> k for
// m = floor(2^k / 2n) + 1: the error D (m 2n - 2^k) / (2n 2^k) stays below 1 / 2n while D 2n < 2^k (Granlund and
// Montgomery 1994). With n <= 2^b, k = 19 + 2b does it; m < 2^(20 + b) and D < 2^(17 + b) fit 32 bits for n <=
// kMostListed.
struct Divider {
  __m256i multiplier, offset;
  __m128i shift;

  SINEW_INLINE explicit Divider(uint32_t n) {
    uint32_t bits = 0;
    while ((1u << bits) < n) ++bits;
    const uint32_t k = 19 + 2 * bits;
    multiplier = _mm256_set1_epi32(static_cast<int32_t>((static_cast<uint64_t>(1) << k) / (2 * n) + 1));
    offset = _mm256_set1_epi32(static_cast<int32_t>(65537 * n));
    shift = _mm_cvtsi32_si128(static_cast<int32_t>(k));
  }
  // In 0..65535: the mean plus 32768.
  SINEW_INLINE __m256i divide(__m256i sums) const {
    const __m256i dividend = _mm256_add_epi32(_mm256_add_epi32(sums, sums), offset);
    const __m256i even = _mm256_srl_epi64(_mm256_mul_epu32(dividend, multiplier), shift);
    const __m256i odd = _mm256_srl_epi64(_mm256_mul_epu32(_mm256_srli_epi64(dividend, 32), multiplier), shift);
    return _mm256_or_si256(even, _mm256_slli_epi64(odd, 32));
  }
  SINEW_INLINE __m256i means(__m256i low, __m256i high) const {
    const __m256i biased = _mm256_permute4x64_epi64(_mm256_packus_epi32(divide(low), divide(high)), 0xD8);
    return _mm256_xor_si256(biased, _mm256_set1_epi16(INT16_MIN));
  }
};

SINEW_INLINE uint32_t lowest_bit(uint32_t mask) {
#if defined(_MSC_VER)
  unsigned long bit;
  _BitScanForward(&bit, mask);
  return bit;
#else
  return static_cast<uint32_t>(__builtin_ctz(mask));
#endif
}

// Candidate slot of `joint` at a vertex, or k when it is none of its candidates. A joint stands in one slot at most.
SINEW_INLINE uint32_t find_slot(const uint16_t* joints, uint32_t k, uint16_t joint) {
  if (k == 8) {
    const __m128i row = _mm_loadu_si128(static_cast<const __m128i*>(static_cast<const void*>(joints)));
    const __m128i equal = _mm_cmpeq_epi16(row, _mm_set1_epi16(static_cast<int16_t>(joint)));
    const uint32_t mask = static_cast<uint32_t>(_mm_movemask_epi8(equal));
    return mask == 0 ? k : lowest_bit(mask) / 2;
  }
  uint32_t slot = 0;
  while (slot < k && joints[slot] != joint) ++slot;
  return slot;
}

// The neighbours' rows one after another: Row(u) is a row's index, or kNone.
constexpr size_t kNone = ~static_cast<size_t>(0);
struct VertexRows {
  SINEW_INLINE size_t operator()(uint32_t u) const { return u; }
};
struct PairRows {
  const uint16_t* joints;
  uint32_t k;
  uint16_t joint;
  SINEW_INLINE size_t operator()(uint32_t u) const {
    const size_t first = static_cast<size_t>(u) * k;
    const uint32_t slot = find_slot(joints + first, k, joint);
    return slot == k ? kNone : first + slot;
  }
};

// Up to R registers of channels of all rows in `list`; the sums stay in registers.
template <int R>
SINEW_INLINE void mean_of(const int16_t* const* list, uint32_t n, uint32_t channel, const Divider& divider,
                          int16_t* out) {
  __m256i low[R], high[R];
  for (int i = 0; i < R; ++i) low[i] = high[i] = _mm256_setzero_si256();
  for (uint32_t r = 0; r < n; ++r) {
    for (int i = 0; i < R; ++i) {
      const __m256i values = load(list[r] + channel + static_cast<uint32_t>(i) * kLanes);
      low[i] = _mm256_add_epi32(low[i], low_half(values));
      high[i] = _mm256_add_epi32(high[i], high_half(values));
    }
  }
  for (int i = 0; i < R; ++i) store(out + channel + static_cast<uint32_t>(i) * kLanes, divider.means(low[i], high[i]));
}
template <int R>
SINEW_INLINE void max_of(const int16_t* const* list, uint32_t n, uint32_t channel, int16_t* out) {
  __m256i largest[R];
  for (int i = 0; i < R; ++i) largest[i] = load(list[0] + channel + static_cast<uint32_t>(i) * kLanes);
  for (uint32_t r = 1; r < n; ++r) {
    for (int i = 0; i < R; ++i)
      largest[i] = _mm256_max_epi16(largest[i], load(list[r] + channel + static_cast<uint32_t>(i) * kLanes));
  }
  for (int i = 0; i < R; ++i) store(out + channel + static_cast<uint32_t>(i) * kLanes, largest[i]);
}

template <class Row>
SINEW_INLINE void collect(const int16_t* values, size_t stride, const uint32_t* neighbours, uint32_t count, Row row,
                          const int16_t** list, uint32_t* found) {
  uint32_t n = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const size_t at = row(neighbours[i]);
    if (at != kNone) list[n++] = values + at * stride;
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

template <bool kMean, class Row>
SINEW_INLINE void ring(const int16_t* values, size_t stride, uint32_t channels, const uint32_t* neighbours,
                       uint32_t count, Row row, int16_t* out) {
  const int16_t* list[kMostListed];
  uint32_t n = 0;
  collect(values, stride, neighbours, count, row, list, &n);
  if (n == 0) return zero(out, channels);
  uint32_t c = 0;
  if constexpr (kMean) {
    const Divider divider(n);
    for (; c + 3 * kLanes <= channels; c += 3 * kLanes) mean_of<3>(list, n, c, divider, out);
    for (; c + kLanes <= channels; c += kLanes) mean_of<1>(list, n, c, divider, out);
    mean_tail(list, n, c, channels, out);
  } else {
    for (; c + 4 * kLanes <= channels; c += 4 * kLanes) max_of<4>(list, n, c, out);
    for (; c + kLanes <= channels; c += kLanes) max_of<1>(list, n, c, out);
    max_tail(list, n, c, channels, out);
  }
}

void ring_mean_vertex_s16_avx2(RowsView values, uint32_t channels, const uint32_t* neighbours, uint32_t count,
                               int16_t* out) {
  if (count > kMostListed) return ring_mean_vertex_s16_ref(values, channels, neighbours, count, out);
  ring<true>(values.data, values.stride, channels, neighbours, count, VertexRows(), out);
}

void ring_max_vertex_s16_avx2(RowsView values, uint32_t channels, const uint32_t* neighbours, uint32_t count,
                              int16_t* out) {
  if (count > kMostListed) return ring_max_vertex_s16_ref(values, channels, neighbours, count, out);
  ring<false>(values.data, values.stride, channels, neighbours, count, VertexRows(), out);
}

void ring_mean_pair_s16_avx2(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k, uint16_t joint,
                             const uint32_t* neighbours, uint32_t count, int16_t* out) {
  if (count > kMostListed) {
    return ring_mean_pair_s16_ref(values, channels, joints, k, joint, neighbours, count, out);
  }
  ring<true>(values.data, values.stride, channels, neighbours, count, PairRows{joints, k, joint}, out);
}

void ring_max_pair_s16_avx2(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k, uint16_t joint,
                            const uint32_t* neighbours, uint32_t count, int16_t* out) {
  if (count > kMostListed) {
    return ring_max_pair_s16_ref(values, channels, joints, k, joint, neighbours, count, out);
  }
  ring<false>(values.data, values.stride, channels, neighbours, count, PairRows{joints, k, joint}, out);
}

void candidate_max_s16_avx2(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k, int16_t* out,
                            uint32_t out_stride) {
  const int16_t* list[SINEW_MAX_CANDIDATES];
  uint32_t n = 0;
  for (uint32_t slot = 0; slot < k; ++slot) {
    if (joints[slot] != kNoJoint) list[n++] = values.data + static_cast<size_t>(slot) * values.stride;
  }
  for (uint32_t slot = 0; n < k && slot < k; ++slot) {
    if (joints[slot] == kNoJoint) zero(out + static_cast<size_t>(slot) * out_stride, channels);
  }
  if (n == 0) return;
  uint32_t c = 0;
  for (; c + kLanes <= channels; c += kLanes) {
    __m256i largest = load(list[0] + c);
    for (uint32_t r = 1; r < n; ++r) largest = _mm256_max_epi16(largest, load(list[r] + c));
    for (uint32_t slot = 0; slot < k; ++slot) {
      if (joints[slot] != kNoJoint) store(out + static_cast<size_t>(slot) * out_stride + c, largest);
    }
  }
  for (; c < channels; ++c) {
    int16_t largest = list[0][c];
    for (uint32_t r = 1; r < n; ++r) largest = list[r][c] > largest ? list[r][c] : largest;
    for (uint32_t slot = 0; slot < k; ++slot) {
      if (joints[slot] != kNoJoint) out[static_cast<size_t>(slot) * out_stride + c] = largest;
    }
  }
}

// round_mean(), which is an inline function of a header and may not be called here.
SINEW_INLINE int16_t mean_of_sum(int64_t sum, uint32_t n) {
  const uint64_t dividend = 2 * static_cast<uint64_t>(sum + static_cast<int64_t>(n) * 32768) + n;
  return static_cast<int16_t>(static_cast<int64_t>(dividend / (2 * static_cast<uint64_t>(n))) - 32768);
}

SINEW_INLINE __m256i load32(const int32_t* from) {
  return _mm256_loadu_si256(static_cast<const __m256i*>(static_cast<const void*>(from)));
}
SINEW_INLINE void store32(int32_t* to, __m256i value) {
  _mm256_storeu_si256(static_cast<__m256i*>(static_cast<void*>(to)), value);
}

SINEW_INLINE void add_row(const int16_t* row, uint32_t channels, int32_t* sums) {
  uint32_t c = 0;
  for (; c + kLanes <= channels; c += kLanes) {
    const __m256i values = load(row + c);
    store32(sums + c, _mm256_add_epi32(load32(sums + c), low_half(values)));
    store32(sums + c + 8, _mm256_add_epi32(load32(sums + c + 8), high_half(values)));
  }
  for (; c < channels; ++c) sums[c] += row[c];
}

SINEW_INLINE void divide_row(const int32_t* sums, uint32_t channels, uint32_t n, int16_t* out) {
  uint32_t c = 0;
  if (n <= kMostListed) {
    const Divider divider(n);
    for (; c + kLanes <= channels; c += kLanes) store(out + c, divider.means(load32(sums + c), load32(sums + c + 8)));
  }
  for (; c < channels; ++c) out[c] = mean_of_sum(sums[c], n);
}

// As the reference, with int32 sums in the scratch: 65535 * 32768 < 2^31.
void part_mean_pair_s16_avx2(RowsView values, uint32_t channels, const uint16_t* joints, uint32_t k,
                             const uint32_t* vertices, uint32_t count, int64_t* scratch, int16_t* out) {
  if (count > 65535) return part_mean_pair_s16_ref(values, channels, joints, k, vertices, count, scratch, out);
  constexpr int32_t kDone = INT32_MIN;  // no sum reaches it
  int32_t* const sums = static_cast<int32_t*>(static_cast<void*>(scratch));
  for (uint32_t pass = 0; pass < 3; ++pass) {
    for (uint32_t i = 0; i < count; ++i) {
      const size_t first = static_cast<size_t>(vertices[i]) * k;
      for (uint32_t slot = 0; slot < k; ++slot) {
        const uint16_t joint = joints[first + slot];
        if (joint == kNoJoint) continue;
        int32_t* const joint_sums = sums + static_cast<size_t>(joint) * channels;
        if (pass == 0) {
          for (uint32_t c = 0; c < channels; ++c) joint_sums[c] = 0;
        } else if (pass == 1) {
          add_row(values.data + (first + slot) * values.stride, channels, joint_sums);
        } else if (joint_sums[0] != kDone) {
          divide_row(joint_sums, channels, count, out + static_cast<size_t>(joint) * channels);
          joint_sums[0] = kDone;
        }
      }
    }
  }
}

void global_mean_s16_avx2(RowsView values, uint32_t channels, const uint16_t* present, size_t rows, int64_t* sums,
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
        add_row(values.data + r * values.stride + first, width, part);
      }
      for (uint32_t c = 0; c < width; ++c) sums[first + c] += part[c];
    }
  }
  for (uint32_t c = 0; c < channels; ++c) out[c] = n == 0 ? static_cast<int16_t>(0) : mean_of_sum(sums[c], n);
}

}  // namespace

bool add_aggregates_s16_avx2(Kernels* kernels) {
  kernels->ring_mean_vertex = ring_mean_vertex_s16_avx2;
  kernels->ring_max_vertex = ring_max_vertex_s16_avx2;
  kernels->ring_mean_pair = ring_mean_pair_s16_avx2;
  kernels->ring_max_pair = ring_max_pair_s16_avx2;
  kernels->candidate_max = candidate_max_s16_avx2;
  kernels->part_mean_pair = part_mean_pair_s16_avx2;
  kernels->global_mean = global_mean_s16_avx2;
  return true;
}

}  // namespace sinew
#else
namespace sinew {
bool add_aggregates_s16_avx2(Kernels*) { return false; }
}  // namespace sinew
#endif
