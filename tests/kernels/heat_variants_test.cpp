// SPDX-License-Identifier: MIT
// The variants of the heat stage's inner loops against their definition, bit for bit, over sizes with and without tails
// and values up to the extremes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "kernels/boxes.hpp"
#include "kernels/front.hpp"
#include "kernels/select.hpp"
#include "sinew/sinew.h"

namespace {

using namespace sinew;

struct Variant {
  const char* name;
  FrontKernels kernels;
  BoxKernel boxes_met;
};

// Those that were built and run here; a processor that has the instructions must find them built.
std::vector<Variant> variants() {
  std::vector<Variant> out;
  const Cpu cpu = detect_cpu();
  const auto add = [&out](const char* name, bool runs_here, auto add_front, auto add_boxes) {
    FrontKernels kernels;
    BoxKernel boxes_met = boxes_met_ref;
    if (add_front(&kernels) && add_boxes(&boxes_met) && runs_here) out.push_back({name, kernels, boxes_met});
  };
  add("avx2", cpu.avx2, add_front_s32_avx2, add_boxes_s32_avx2);
  add("vnni", cpu.vnni, add_front_s32_avx512, add_boxes_s32_avx512);
  add("simd128", true, add_front_s32_simd128, add_boxes_s32_simd128);
  add("neon", true, add_front_s32_neon, add_boxes_s32_neon);
#if defined(__wasm_simd128__) || (defined(__aarch64__) && !defined(__ARM_BIG_ENDIAN))
  EXPECT_EQ(out.size(), 1u);
#elif defined(__x86_64__)
  EXPECT_EQ(out.size(), size_t{cpu.avx2} + size_t{cpu.vnni});
#endif
  return out;
}

// Small, usual and largest values; sums may wrap, and must then wrap alike.
class Values {
 public:
  int32_t next(int kind) {
    if (kind == 2) return (random_() & 1) != 0 ? 0x7FFFFFFF : -0x7FFFFFFF;
    return static_cast<int32_t>(random_()) >> (kind == 0 ? 24 : 2);
  }
  std::vector<int32_t> take(size_t count, int kind) {
    std::vector<int32_t> out(count);
    for (int32_t& v : out) v = next(kind);
    return out;
  }

 private:
  std::mt19937 random_{17};
};

TEST(FrontVariants, UpdateEqualsTheReference) {
  Values values;
  for (const Variant& variant : variants()) {
    for (int kind = 0; kind < 3; ++kind) {
      for (const uint32_t rows : {1u, 2u, 7u, 8u, 9u, 15u, 16u, 17u, 31u, 40u, 130u}) {
        for (const uint32_t pivots : {0u, 1u, 2u, 5u, 24u, 100u}) {
          for (uint32_t columns = 1; columns <= kFrontColumns; ++columns) {
            const size_t stride = rows + kFrontColumns + 3;
            const std::vector<int32_t> g = values.take(stride * (pivots + 1), kind);
            std::vector<int32_t> expected = values.take(stride * columns, kind), out = expected;
            front_update_ref(g.data(), stride, pivots, columns, rows, expected.data(), stride);
            variant.kernels.update(g.data(), stride, pivots, columns, rows, out.data(), stride);
            ASSERT_EQ(out, expected) << variant.name << " rows " << rows << " pivots " << pivots;
          }
        }
      }
    }
  }
}

TEST(FrontVariants, ProductsEqualTheReference) {
  Values values;
  for (const Variant& variant : variants()) {
    for (int kind = 0; kind < 3; ++kind) {
      for (const uint32_t terms : {0u, 1u, 3u, 8u, 61u, 300u}) {
        for (const bool along : {false, true}) {
          const size_t next = along ? terms + 5 : 1, step = along ? 1 : kFrontColumns + 2;
          const std::vector<int32_t> g = values.take(kFrontColumns * next + (terms + 1) * step, kind);
          const std::vector<int32_t> scaled = values.take((terms + 1) * size_t{kFrontBatch}, kind);
          std::vector<int64_t> expected(kFrontColumns * kFrontBatch, 1), out(expected.size(), 2);
          front_multiply_ref(g.data(), next, step, terms, scaled.data(), expected.data());
          variant.kernels.multiply(g.data(), next, step, terms, scaled.data(), out.data());
          ASSERT_EQ(out, expected) << variant.name << " terms " << terms;
        }
      }
    }
  }
}

// A front of some rows, their exponents, and what stands there.
struct SolveCase {
  static constexpr uint32_t kRows = 12;
  std::vector<int8_t> exponents;
  std::vector<int64_t> inverse;
  std::vector<int32_t> x;

  SolveCase(Values* values, int kind) : x(values->take(kRows * size_t{kFrontBatch}, kind)) {
    for (uint32_t i = 0; i < kRows; ++i) {
      exponents.push_back(static_cast<int8_t>(-5 + static_cast<int>((i * 7) % 25)));  // up to 24 below the front's 19
      inverse.push_back(static_cast<int64_t>(static_cast<uint32_t>(values->next(1))) << (kind == 0 ? 0 : 8));
    }
  }
  FrontRows rows() { return {19, exponents.data(), inverse.data(), x.data()}; }
};

TEST(FrontVariants, SolveEqualsTheReference) {
  Values values;
  for (const Variant& variant : variants()) {
    ASSERT_NE(variant.kernels.solve, front_solve_ref) << variant.name;
    for (int kind = 0; kind < 3; ++kind) {
      for (const bool forward : {true, false}) {
        for (uint32_t count = 1; count <= kFrontColumns; ++count) {
          for (uint32_t position = 0; position + count <= SolveCase::kRows; ++position) {
            SolveCase expected(&values, kind), out = expected;
            const size_t height = kFrontColumns + position;
            const std::vector<int32_t> g = values.take(kFrontColumns * height, kind);
            std::vector<int64_t> sums;
            for (uint32_t i = 0; i < count * kFrontBatch; ++i)
              sums.push_back(static_cast<int64_t>(values.next(kind)) * values.next(kind));
            std::vector<int64_t> sums_too = sums;
            std::vector<int32_t> expected_scaled(count * kFrontBatch, 1), scaled(expected_scaled.size(), 2);
            front_solve_ref(expected.rows(), g.data(), height, position, count, forward, sums.data(),
                            expected_scaled.data());
            variant.kernels.solve(out.rows(), g.data(), height, position, count, forward, sums_too.data(),
                                  scaled.data());
            ASSERT_EQ(out.x, expected.x) << variant.name << " place " << position << " count " << count;
            ASSERT_EQ(scaled, expected_scaled) << variant.name << " place " << position << " count " << count;
          }
        }
      }
    }
  }
}

TEST(FrontVariants, RowsEqualTheReference) {
  Values values;
  const std::vector<uint32_t> positions = {11, 0, 3, 4, 9, 1};
  for (const Variant& variant : variants()) {
    ASSERT_NE(variant.kernels.subtract, front_subtract_ref) << variant.name;
    ASSERT_NE(variant.kernels.load, front_load_ref) << variant.name;
    ASSERT_NE(variant.kernels.above, front_above_ref) << variant.name;
    for (int kind = 0; kind < 3; ++kind) {
      for (uint32_t count = 0; count <= positions.size(); ++count) {
        SolveCase expected(&values, kind), out = expected;
        std::vector<int64_t> sums;
        for (uint32_t i = 0; i < count * kFrontBatch; ++i)
          sums.push_back(static_cast<int64_t>(values.next(kind)) * values.next(kind));
        std::vector<int32_t> expected_scaled((count + 1) * kFrontBatch, 1), scaled = expected_scaled;
        front_load_ref(expected.rows(), positions.data(), count, expected_scaled.data());
        variant.kernels.load(out.rows(), positions.data(), count, scaled.data());
        ASSERT_EQ(scaled, expected_scaled) << variant.name << " count " << count;
        front_subtract_ref(expected.rows(), positions.data(), count, sums.data());
        variant.kernels.subtract(out.rows(), positions.data(), count, sums.data());
        ASSERT_EQ(out.x, expected.x) << variant.name << " count " << count;
      }
      for (int round = 0; round < 200; ++round) {
        std::vector<int32_t> x = values.take(kFrontBatch, kind == 2 ? 1 : kind);
        for (int32_t& value : x) value = std::min(std::max(value, -kFrontLargest), kFrontLargest);
        if (round % 2 == 0) x[static_cast<size_t>(round) % kFrontBatch] = kind == 0 ? kFrontOne : -kFrontOne - 1;
        const int32_t below = x[static_cast<size_t>(round / 2) % kFrontBatch];  // one of them is not above
        int64_t expected_sum = 5, sum = 5;
        int32_t expected_range = 0, range = 0;
        const uint32_t above = front_above_ref(x.data(), below, &expected_sum, &expected_range);
        ASSERT_EQ(variant.kernels.above(x.data(), below, &sum, &range), above) << variant.name;
        ASSERT_EQ(sum, expected_sum) << variant.name;
        ASSERT_EQ(range < 0, expected_range < 0) << variant.name;
      }
    }
  }
}

// By hand: two pivots of 1/2 whose off-diagonal entry is 1/4, both ways, on a row one power of two below its front.
TEST(FrontVariants, TheReferenceSolvesATriangle) {
  const int8_t exponents[2] = {0, -1};
  const int64_t inverse[2] = {int64_t{2} << kFrontBits, int64_t{2} << kFrontBits};
  const int32_t g[4] = {1 << 29, 1 << 28, 0, 1 << 29};  // columns
  std::vector<int32_t> x(2 * kFrontBatch, 100), scaled(2 * kFrontBatch);
  std::vector<int64_t> sums(2 * kFrontBatch, 0);
  const FrontRows rows = {0, exponents, inverse, x.data()};
  front_solve_ref(rows, g, 2, 0, 2, true, sums.data(), scaled.data());
  EXPECT_EQ(x[0], 200);          // 100 / 0.5
  EXPECT_EQ(x[kFrontBatch], 0);  // (100 - 2 * 200 / 4) / 0.5: the share counts twice at exponent -1
  EXPECT_EQ(scaled[0], 200);
  EXPECT_EQ(scaled[kFrontBatch], 0);
  x.assign(x.size(), 100);
  sums.assign(sums.size(), 0);
  front_solve_ref(rows, g, 2, 0, 2, false, sums.data(), scaled.data());
  EXPECT_EQ(x[kFrontBatch], 200);
  EXPECT_EQ(scaled[kFrontBatch], 100);  // 200 / 2
  EXPECT_EQ(x[0], 150);                 // (100 - 100 / 4) / 0.5
}

TEST(FrontVariants, TheReferenceSaysWhatIsAboveAndOutside) {
  std::vector<int32_t> x(kFrontBatch, 0);
  x[3] = 8;
  x[15] = 7;
  int64_t sum = 1;
  int32_t range = 0;
  EXPECT_EQ(front_above_ref(x.data(), 7, &sum, &range), 1u << 3);
  EXPECT_EQ(sum, 16);
  EXPECT_GE(range, 0);
  x[0] = -kFrontOne - 1;
  EXPECT_EQ(front_above_ref(x.data(), 7, &sum, &range), 1u << 3);
  EXPECT_LT(range, 0);
  x[0] = 2 * kFrontOne + 1;
  range = 0;
  EXPECT_EQ(front_above_ref(x.data(), 7, &sum, &range), 1u << 3 | 1u);
  EXPECT_LT(range, 0);
}

TEST(FrontVariants, TheReferenceRoundsTheSumHalfUp) {
  const int32_t g[6] = {1 << 15, 1 << 15, 1 << 15, 1 << 14, 1 << 15, -(1 << 15)};  // two pivots, three rows
  int32_t target[3] = {100, 100, 100};
  front_update_ref(g, 3, 2, 1, 3, target, 3);
  EXPECT_EQ(target[0], 99);  // 1.25
  EXPECT_EQ(target[1], 98);  // 1.5
  EXPECT_EQ(target[2], 99);  // 0.5
}

// Boxes about a segment: met and missed by a grid unit, flat, as points, absent, far away.
struct BoxCase {
  BoxGroup group;
  BoxSegment segment;

  BoxCase(std::mt19937* random, int32_t size) {
    const auto any = [&](int32_t reach) { return static_cast<int32_t>((*random)() % (2u * reach + 1)) - reach; };
    for (int axis = 0; axis < 3; ++axis) {
      const int32_t start = any(size), target = (*random)() % 4 == 0 ? start : any(size);
      segment.middle[axis] = start + target;
      segment.along[axis] = target - start;
      segment.half[axis] = target < start ? start - target : target - start;
      for (uint32_t i = 0; i < kBoxesInGroup; ++i) {
        const int32_t low = start + (target - start) / 4 * static_cast<int32_t>(i % 5) - any(size) / 2;
        const int32_t width = (*random)() % 3 == 0 ? 0 : any(size);
        group.low[axis][i] = low;
        group.high[axis][i] = low + (width < 0 ? -width : width);
      }
      group.low[axis][5] = 1 << 28;  // not there
      group.high[axis][5] = -(1 << 28);
    }
  }
};

TEST(BoxVariants, EqualTheReference) {
  std::mt19937 random(5);
  for (const Variant& variant : variants()) {
    ASSERT_NE(variant.boxes_met, boxes_met_ref) << variant.name;
    uint32_t met = 0;
    for (int round = 0; round < 20000; ++round) {
      const int32_t sizes[] = {2, 9, 300, 1 << 20, 1 << 23};
      const BoxCase c(&random, sizes[round % 5]);
      const uint32_t want = boxes_met_ref(c.group, c.segment);
      ASSERT_EQ(variant.boxes_met(c.group, c.segment), want) << variant.name << " round " << round;
      ASSERT_EQ(want & 1u << 5, 0u);
      for (uint32_t bits = want; bits != 0; bits &= bits - 1) ++met;
    }
    EXPECT_GT(met, 20000u);
  }
}

// Against the definition: some point of the segment lies in the box (slabs, in long double: grid units are exact).
TEST(BoxVariants, TheReferenceIsTheSegmentAndTheBox) {
  std::mt19937 random(6);
  uint32_t met = 0;
  for (int round = 0; round < 5000; ++round) {
    const BoxCase c(&random, round % 2 == 0 ? 9 : 300);
    const uint32_t bits = boxes_met_ref(c.group, c.segment);
    for (uint32_t i = 0; i < kBoxesInGroup; ++i) {
      if (i == 5) continue;
      long double from = 0, to = 1;
      for (int axis = 0; axis < 3; ++axis) {
        const long double start = (c.segment.middle[axis] - c.segment.along[axis]) / 2, along = c.segment.along[axis];
        const long double low = c.group.low[axis][i] - start, high = c.group.high[axis][i] - start;
        if (along == 0) {
          if (low > 0 || high < 0) to = -1;
          continue;
        }
        from = std::max(from, std::min(low / along, high / along));
        to = std::min(to, std::max(low / along, high / along));
      }
      if (std::abs(from - to) < 1e-9L) continue;  // touches: rounding of the slabs decides
      ASSERT_EQ(bits >> i & 1, from < to ? 1u : 0u) << "round " << round << " box " << i;
      met += bits >> i & 1;
    }
  }
  EXPECT_GT(met, 1000u);
}

}  // namespace
