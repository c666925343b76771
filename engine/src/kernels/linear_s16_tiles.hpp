// SPDX-License-Identifier: MIT
// The linear layer for instruction sets with a multiply-add of int16 pairs: register tiles over packed weights. Written
// once; linear_s16_avx2.cpp and its siblings include it with their own registers.
#ifndef SINEW_KERNELS_LINEAR_S16_TILES_HPP
#define SINEW_KERNELS_LINEAR_S16_TILES_HPP

#include <string.h>

#include "kernels/isolated.hpp"
#include "kernels/kernels.hpp"

namespace sinew {
namespace {

// Members of an instruction set ("Isa" below):
//   Int32                      a register of kWidth int32 sums; kWidth divides kPackOutputs
//   kRows[c]                   rows of the widest tile for c groups of outputs (c = 1 .. kGroups), chosen so that sums,
//                              weights and one input fit the registers
//   zero(), load(int32*), store(int32*, Int32), add(Int32, Int32)
//   broadcast(int32)           the same pair of int16 everywhere, of whatever type dot() takes
//   load_pairs(int16*)         kWidth pairs of weights
//   dot(sum, weights, input)   sum + w[0] x[0] + w[1] x[1] each; wraps
//   kFinish                    groups that finish() takes at once
//   finish(sums*, shift*, residual factor* or null, residual*, low, high, count, out*)   requantizes them into count
//                              outputs; reads no residual and touches no output behind them, but reads the shifts and
//                              factors of all of them

SINEW_INLINE int32_t pair_at(const int16_t* x) {
  int32_t pair;
  memcpy(&pair, x, sizeof(pair));
  return pair;
}
// The last column of an odd block has no second half, and behind a row's last column there may be no memory at all.
SINEW_INLINE int32_t half_pair_at(const int16_t* x) { return static_cast<int32_t>(static_cast<uint16_t>(*x)); }

// One step of a tile: V registers of weights against the pair of each of R rows.
template <class Isa, int R, int V>
SINEW_INLINE void step(const int16_t* const (&weights)[V], size_t at, const int32_t (&pairs)[R],
                       typename Isa::Int32 (&sums)[R][V]) {
  typename Isa::Pairs w[V];
  SINEW_UNROLL for (int v = 0; v < V; ++v) w[v] = Isa::load_pairs(weights[v] + at);
  SINEW_UNROLL for (int r = 0; r < R; ++r) {
    const auto x = Isa::broadcast(pairs[r]);
    SINEW_UNROLL for (int v = 0; v < V; ++v) sums[r][v] = Isa::dot(sums[r][v], w[v], x);
  }
}

// Adds the products of `count` columns to the sums. Any order is exact: the reader proved every partial sum.
template <class Isa, int R, int V>
SINEW_INLINE void add_block(const int16_t* x, size_t stride, uint32_t count, const int16_t* const (&weights)[V],
                            typename Isa::Int32 (&sums)[R][V]) {
  const size_t whole = count / 2;
  for (size_t p = 0; p < whole; ++p) {
    int32_t pairs[R];
    SINEW_UNROLL for (int r = 0; r < R; ++r) pairs[r] = pair_at(x + static_cast<size_t>(r) * stride + 2 * p);
    step<Isa, R, V>(weights, p * 2 * kPackOutputs, pairs, sums);
  }
  if (count % 2 != 0) {
    int32_t pairs[R];
    SINEW_UNROLL for (int r = 0; r < R; ++r) pairs[r] = half_pair_at(x + static_cast<size_t>(r) * stride + 2 * whole);
    step<Isa, R, V>(weights, whole * 2 * kPackOutputs, pairs, sums);
  }
}

// Where a tile stands.
struct TileRows {
  const int16_t* in;
  size_t in_stride;
  const int16_t* residual;
  size_t residual_stride;
  const uint16_t* present;  // or null
  int16_t* out;
  size_t out_stride;
  uint32_t first_row;  // of the tile, counted from the layer's first row
};

SINEW_INLINE bool absent(const TileRows& rows, int r) { return rows.present != nullptr && rows.present[r] == kNoJoint; }

// R rows x G groups of outputs, class N: int32 sums all the way.
template <class Isa, int R, int G>
SINEW_INLINE void narrow_sums(const LinearView& linear, const TileRows& rows, uint32_t group,
                              typename Isa::Int32 (&sums)[R][G * static_cast<int>(kPackOutputs) / Isa::kWidth]) {
  constexpr int kPerGroup = static_cast<int>(kPackOutputs) / Isa::kWidth, V = G * kPerGroup;
  const int16_t* weights[V];
  SINEW_UNROLL for (int v = 0; v < V; ++v) {
    const size_t g = group + static_cast<size_t>(v / kPerGroup);
    weights[v] = linear.packed.weights + g * linear.packed.pairs * 2 * kPackOutputs + v % kPerGroup * Isa::kWidth * 2;
  }
  const size_t outputs = (linear.out + kPackOutputs - 1) / kPackOutputs * kPackOutputs;
  if (linear.packed.starts == nullptr) {
    const int32_t* const bias_at = linear.packed.bias;
    SINEW_UNROLL for (int v = 0; v < V; ++v) {
      const typename Isa::Int32 bias =
          bias_at == nullptr ? Isa::zero() : Isa::load(bias_at + group * kPackOutputs + v * Isa::kWidth);
      SINEW_UNROLL for (int r = 0; r < R; ++r) sums[r][v] = bias;
    }
  } else {
    SINEW_UNROLL for (int r = 0; r < R; ++r) {
      const uint32_t row = (rows.first_row + static_cast<uint32_t>(r)) / linear.packed.rows_per_start;
      const int32_t* const start = linear.packed.starts + row * outputs + group * kPackOutputs;
      SINEW_UNROLL for (int v = 0; v < V; ++v) sums[r][v] = Isa::load(start + v * Isa::kWidth);
    }
  }
  const bool by_joint = linear.packed.joint_starts != nullptr;
  SINEW_UNROLL for (int r = 0; r < R; ++r) {
    if (!by_joint || absent(rows, r)) continue;
    const int32_t* const start = linear.packed.joint_starts + rows.present[r] * outputs + group * kPackOutputs;
    SINEW_UNROLL for (int v = 0; v < V; ++v) sums[r][v] = Isa::add(sums[r][v], Isa::load(start + v * Isa::kWidth));
  }
  const bool all = linear.packed.range_count == 0 && linear.packed.starts == nullptr && !by_joint;
  const uint32_t ranges = all ? 1 : linear.packed.range_count;
  for (uint32_t i = 0; i < ranges; ++i) {
    const uint32_t first = all ? 0 : linear.packed.ranges[i].first;
    const uint32_t count = all ? linear.in : linear.packed.ranges[i].count;
    const int16_t* from[V];
    SINEW_UNROLL for (int v = 0; v < V; ++v) from[v] = weights[v] + static_cast<size_t>(first / 2) * 2 * kPackOutputs;
    add_block<Isa, R, V>(rows.in + first, rows.in_stride, count, from, sums);
  }
}

SINEW_INLINE void clear(int16_t* out, uint32_t count) {
  for (uint32_t n = 0; n < count; ++n) out[n] = 0;
}

// The same from group `group` on, requantized into the output.
template <class Isa, int R, int G>
SINEW_INLINE void narrow_tile(const LinearView& linear, const TileRows& rows, uint32_t group) {
  constexpr int kPerGroup = static_cast<int>(kPackOutputs) / Isa::kWidth, V = G * kPerGroup;
  const uint32_t first = group * kPackOutputs;
  typename Isa::Int32 sums[R][V];
  narrow_sums<Isa, R, G>(linear, rows, group, sums);
  SINEW_UNROLL for (int g = 0; g < G; g += Isa::kFinish) {
    constexpr uint32_t kOutputs = Isa::kFinish * kPackOutputs;
    const uint32_t n = first + static_cast<uint32_t>(g) * kPackOutputs;
    if (n >= linear.out) break;
    const uint32_t count = linear.out - n < kOutputs ? linear.out - n : kOutputs;
    const int32_t* const factors = linear.residual != nullptr ? linear.packed.residual + n : nullptr;
    SINEW_UNROLL for (int r = 0; r < R; ++r) {
      int16_t* const out = rows.out + static_cast<size_t>(r) * rows.out_stride + n;
      if (absent(rows, r)) {
        clear(out, count);
        continue;
      }
      // An odd last group is finished beside a copy of itself, of which `count` keeps nothing.
      typename Isa::Int32 part[Isa::kFinish * kPerGroup];
      SINEW_UNROLL for (int i = 0; i < Isa::kFinish * kPerGroup; ++i) {
        part[i] = sums[r][g * kPerGroup + (g + i / kPerGroup < G ? i : i % kPerGroup)];
      }
      const int16_t* const residual =
          factors != nullptr ? rows.residual + static_cast<size_t>(r) * rows.residual_stride + n : nullptr;
      Isa::finish(part, linear.packed.shifts + n, factors, residual, linear.low, linear.high, count, out);
    }
  }
}

// The same, class W: int32 sums inside a block, int64 between blocks. Rare, so the int64 part is plain loops, which the
// compiler turns into vectors.
template <class Isa, int R, int G>
SINEW_INLINE void wide_tile(const LinearView& linear, const TileRows& rows, uint32_t group) {
  constexpr int kPerGroup = static_cast<int>(kPackOutputs) / Isa::kWidth, V = G * kPerGroup;
  constexpr uint32_t kOutputs = static_cast<uint32_t>(G) * kPackOutputs;
  const uint32_t first = group * kPackOutputs;
  int64_t totals[R][kOutputs];
  for (int r = 0; r < R; ++r) memcpy(totals[r], linear.packed.wide_bias + first, sizeof(totals[r]));
  const int16_t* weights[V];
  for (int v = 0; v < V; ++v) {
    const size_t g = group + static_cast<size_t>(v / kPerGroup);
    weights[v] = linear.packed.weights + g * linear.packed.pairs * 2 * kPackOutputs + v % kPerGroup * Isa::kWidth * 2;
  }
  for (uint32_t k = 0; k < linear.in; k += linear.block) {
    const uint32_t rest = linear.in - k, count = rest < linear.block ? rest : linear.block;
    typename Isa::Int32 sums[R][V];
    SINEW_UNROLL for (int r = 0; r < R; ++r) { SINEW_UNROLL for (int v = 0; v < V; ++v) sums[r][v] = Isa::zero(); }
    add_block<Isa, R, V>(rows.in + k, rows.in_stride, count, weights, sums);
    for (int v = 0; v < V; ++v) weights[v] += static_cast<size_t>((count + 1) / 2) * 2 * kPackOutputs;
    int32_t narrow[R][kOutputs];
    SINEW_UNROLL for (int r = 0; r < R; ++r) {
      SINEW_UNROLL for (int v = 0; v < V; ++v) Isa::store(&narrow[r][v * Isa::kWidth], sums[r][v]);
    }
    for (int r = 0; r < R; ++r) {
      for (uint32_t n = 0; n < kOutputs; ++n) totals[r][n] += narrow[r][n];
    }
  }
  const uint32_t count = linear.out - first < kOutputs ? linear.out - first : kOutputs;
  for (int r = 0; r < R; ++r) {
    int16_t* const out = rows.out + static_cast<size_t>(r) * rows.out_stride + first;
    if (absent(rows, r)) {
      clear(out, count);
      continue;
    }
    if (linear.residual != nullptr) {
      const int16_t* const residual = rows.residual + static_cast<size_t>(r) * rows.residual_stride + first;
      const int32_t* const factors = linear.packed.residual + first;
      for (uint32_t n = 0; n < count; ++n) totals[r][n] += residual[n] * factors[n];
    }
    const int32_t* const shifts = linear.packed.shifts + first;
    for (uint32_t n = 0; n < count; ++n) {
      const int64_t value = totals[r][n] >> shifts[n];
      out[n] = static_cast<int16_t>(value < linear.low ? linear.low : value > linear.high ? linear.high : value);
    }
  }
}

SINEW_INLINE TileRows rows_from(const TileRows& all, uint32_t begin) {
  TileRows tile = all;
  tile.in += begin * all.in_stride;
  if (tile.residual != nullptr) tile.residual += begin * all.residual_stride;
  tile.out += begin * all.out_stride;
  if (tile.present != nullptr) tile.present += begin;
  tile.first_row += begin;
  return tile;
}

// Rows from `begin` on in tiles of R against G groups of outputs; returns the first row not done. One function per
// shape, so that the compiler allots registers for one inner loop at a time.
template <class Isa, int R, int G>
SINEW_NOINLINE uint32_t run_narrow(const LinearView& linear, const TileRows& all, uint32_t begin, uint32_t rows,
                                   uint32_t group) {
  for (; begin + R <= rows; begin += R) narrow_tile<Isa, R, G>(linear, rows_from(all, begin), group);
  return begin;
}
template <class Isa, int R>
SINEW_NOINLINE uint32_t run_wide(const LinearView& linear, const TileRows& all, uint32_t begin, uint32_t rows,
                                 uint32_t group) {
  for (; begin + R <= rows; begin += R) wide_tile<Isa, R, 1>(linear, rows_from(all, begin), group);
  return begin;
}

// The tallest tiles, then those of 4, 2 and 1 rows for the rest.
template <class Isa, int G>
SINEW_INLINE void run_groups(const LinearView& linear, const TileRows& all, uint32_t rows, uint32_t group) {
  uint32_t done = run_narrow<Isa, Isa::kRows[G], G>(linear, all, 0, rows, group);
  if constexpr (Isa::kRows[G] > 4) done = run_narrow<Isa, 4, G>(linear, all, done, rows, group);
  if constexpr (Isa::kRows[G] > 2) done = run_narrow<Isa, 2, G>(linear, all, done, rows, group);
  run_narrow<Isa, 1, G>(linear, all, done, rows, group);
}

template <class Isa, int R>
SINEW_NOINLINE uint32_t run_sums(const LinearView& linear, const TileRows& all, uint32_t begin, uint32_t rows,
                                 int32_t* to) {
  constexpr int V = static_cast<int>(kPackOutputs) / Isa::kWidth;
  const uint32_t groups = (linear.out + kPackOutputs - 1) / kPackOutputs;
  for (; begin + R <= rows; begin += R) {
    for (uint32_t group = 0; group < groups; ++group) {
      typename Isa::Int32 sums[R][V];
      narrow_sums<Isa, R, 1>(linear, rows_from(all, begin), group, sums);
      SINEW_UNROLL for (int r = 0; r < R; ++r) {
        int32_t* const row =
            to + (static_cast<size_t>(begin + static_cast<uint32_t>(r)) * groups + group) * kPackOutputs;
        SINEW_UNROLL for (int v = 0; v < V; ++v) Isa::store(row + v * Isa::kWidth, sums[r][v]);
      }
    }
  }
  return begin;
}

// See LinearSumsKernel.
template <class Isa>
SINEW_INLINE void linear_sums_tiled(const LinearView& linear, const int16_t* in, uint32_t in_stride, uint32_t rows,
                                    int32_t* sums) {
  const TileRows all = {in, in_stride, nullptr, 0, nullptr, nullptr, 0, 0};
  const uint32_t done = run_sums<Isa, Isa::kRows[1]>(linear, all, 0, rows, sums);
  run_sums<Isa, 1>(linear, all, done, rows, sums);
}

// linear_s16_ref()'s contract over linear.packed. Rows in blocks whose inputs stay in the first two cache levels while
// the groups of outputs go by.
template <class Isa>
SINEW_INLINE void linear_tiled(const LinearView& linear, const int16_t* in, uint32_t in_stride, const int16_t* residual,
                               uint32_t residual_stride, const uint16_t* present, uint32_t rows, int16_t* out,
                               uint32_t out_stride) {
  constexpr uint32_t kRowBlock = 192;
  const uint32_t groups = (linear.out + kPackOutputs - 1) / kPackOutputs;
  for (uint32_t first = 0; first < rows; first += kRowBlock) {
    const uint32_t count = rows - first < kRowBlock ? rows - first : kRowBlock;
    const TileRows tile = {in + static_cast<size_t>(first) * in_stride,
                           in_stride,
                           residual + static_cast<size_t>(first) * residual_stride,
                           residual_stride,
                           present == nullptr ? nullptr : present + first,
                           out + static_cast<size_t>(first) * out_stride,
                           out_stride,
                           first};
    uint32_t group = 0;
    if (linear.wide) {
      for (; group < groups; ++group) {
        const uint32_t done = run_wide<Isa, Isa::kRows[1]>(linear, tile, 0, count, group);
        run_wide<Isa, 1>(linear, tile, done, count, group);
      }
      continue;
    }
    for (; group + Isa::kGroups <= groups; group += Isa::kGroups) {
      run_groups<Isa, Isa::kGroups>(linear, tile, count, group);
    }
    if constexpr (Isa::kGroups > 3) {
      if (groups - group == 3) run_groups<Isa, 3>(linear, tile, count, group);
    }
    if constexpr (Isa::kGroups > 2) {
      if (groups - group == 2) run_groups<Isa, 2>(linear, tile, count, group);
    }
    if constexpr (Isa::kGroups > 1) {
      if (groups - group == 1) run_groups<Isa, 1>(linear, tile, count, group);
    }
  }
}

}  // namespace
}  // namespace sinew
#endif
