// SPDX-License-Identifier: MIT
// The variants of the factorisation's inner loops against their definition, bit for bit, over sizes with and without
// tails and values up to the extremes.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "kernels/cpu.hpp"
#include "kernels/front.hpp"
#include "sinew/sinew.h"

namespace {

using namespace sinew;

struct Variant {
  const char* name;
  FrontKernels kernels;
};

// Those that were built and run here; a processor that has the instructions must find them built.
std::vector<Variant> variants() {
  std::vector<Variant> out;
  const Cpu cpu = detect_cpu();
  FrontKernels kernels;
  if (add_front_s32_avx2(&kernels) && cpu.avx2) out.push_back({"avx2", kernels});
  if (add_front_s32_vnni(&kernels) && cpu.vnni) out.push_back({"vnni", kernels});
  if (add_front_s32_simd128(&kernels)) out.push_back({"simd128", kernels});
#if defined(__wasm_simd128__)
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

TEST(FrontVariants, LanesEqualTheReference) {
  Values values;
  for (const Variant& variant : variants()) {
    for (int kind = 0; kind < 3; ++kind) {
      for (const uint32_t terms : {0u, 1u, 3u, 8u, 61u, 300u}) {
        for (const bool along : {false, true}) {
          const size_t next = along ? terms + 5 : 1, step = along ? 1 : kFrontColumns + 2;
          const std::vector<int32_t> g = values.take(kFrontColumns * next + (terms + 1) * step, kind);
          const std::vector<int32_t> lanes = values.take((terms + 1) * size_t{kFrontLanes}, kind);
          std::vector<int64_t> expected(kFrontColumns * kFrontLanes, 1), out(expected.size(), 2);
          front_lanes_ref(g.data(), next, step, terms, lanes.data(), expected.data());
          variant.kernels.lanes(g.data(), next, step, terms, lanes.data(), out.data());
          ASSERT_EQ(out, expected) << variant.name << " terms " << terms;
        }
      }
    }
  }
}

TEST(FrontVariants, TheReferenceRoundsTheSumHalfUp) {
  const int32_t g[6] = {1 << 15, 1 << 15, 1 << 15, 1 << 14, 1 << 15, -(1 << 15)};  // two pivots, three rows
  int32_t target[3] = {100, 100, 100};
  front_update_ref(g, 3, 2, 1, 3, target, 3);
  EXPECT_EQ(target[0], 99);  // 1.25
  EXPECT_EQ(target[1], 98);  // 1.5
  EXPECT_EQ(target[2], 99);  // 0.5
}

}  // namespace
