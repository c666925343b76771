// SPDX-License-Identifier: MIT
// Reference kernels against their definitions in int64 and exact division: odd sizes, strides, extremes, absent rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kernels/kernels.hpp"
#include "linear_layer.hpp"
#include "random.hpp"

namespace sinew::test {
namespace {

constexpr int16_t kGuard = 0x7A7A;

TEST(LinearKernel, EqualsInt64OnOddSizesAndExtremes) {
  Random random(1);
  size_t clamped_low = 0, clamped_high = 0, inside = 0;
  for (int i = 0; i < 400; ++i) {
    const bool wide = i % 3 == 0, residual = i % 2 == 0, extreme = i % 5 == 0;
    LinearLayer c(1 + random.below(i % 7 == 0 ? 300 : 40), 1 + random.below(35));
    c.wide = wide;
    c.has_residual = residual;
    if (wide) c.block = 1 + random.below(2);
    c.set_range(static_cast<ValueRange>(random.below(3)));
    const bool long_blocks = i % 6 == 0;  // small weights may sum in blocks of any length
    if (wide && long_blocks) c.block = 1 + random.below(c.in);
    const int32_t largest = wide && !long_blocks ? 32767 : std::min(32767, 60000 / (static_cast<int32_t>(c.in) + 2));
    const auto weight = [&] {
      return static_cast<int16_t>(extreme ? (random.below(2) ? largest : -largest) : random.between(-largest, largest));
    };
    for (uint32_t n = 0; n < c.out; ++n) {
      const int shift = random.between(1, wide ? 47 : 31);
      c.shifts[n] = static_cast<uint8_t>(i % 4 == 0 ? shift : random.between(8, 16));
      const int64_t bias = random.between(-1000000, 1000000);
      c.set_bias(n, wide ? bias * (int64_t{1} << random.below(30)) : bias);
      for (uint32_t k = 0; k < c.in; ++k) c.weights[size_t{n} * c.in + k] = weight();
      c.residual[n] = weight();
    }
    const uint32_t rows = 1 + random.below(9), in_stride = c.in + random.below(5), res_stride = c.out + random.below(5),
                   out_stride = c.out + random.below(5);
    std::vector<int16_t> in, res, out(rows * out_stride, kGuard);
    const auto value = [&] {
      return static_cast<int16_t>(extreme ? (random.below(2) ? 16383 : -16384) : random.between(-16384, 16383));
    };
    for (uint32_t k = 0; k < rows * in_stride; ++k) in.push_back(value());
    for (uint32_t k = 0; k < rows * res_stride; ++k) res.push_back(value());
    std::vector<uint16_t> present(rows);
    for (uint16_t& joint : present) joint = random.below(4) == 0 ? kNoJoint : 3;
    const bool masked = i % 2 == 1;
    linear_s16_ref(c.view(), {in.data(), in_stride}, {res.data(), res_stride}, masked ? present.data() : nullptr, rows,
                   out.data(), out_stride);
    for (uint32_t r = 0; r < rows; ++r) {
      for (uint32_t n = 0; n < out_stride; ++n) {
        int64_t want = kGuard;
        if (n < c.out) {
          int64_t sum = c.bias(n) + (residual ? int64_t{res[r * res_stride + n]} * c.residual[n] : 0);
          for (uint32_t k = 0; k < c.in; ++k) sum += int64_t{in[r * in_stride + k]} * c.weights[size_t{n} * c.in + k];
          const int64_t value_out = floor_divide(sum, int64_t{1} << c.shifts[n]);
          want = std::clamp<int64_t>(value_out, c.low, c.high);
          clamped_low += value_out < want;
          clamped_high += value_out > want;
          inside += value_out == want;
          if (masked && present[r] == kNoJoint) want = 0;
        }
        ASSERT_EQ(out[r * out_stride + n], want) << "case " << i << " row " << r << " channel " << n;
      }
    }
  }
  EXPECT_GT(clamped_low, 100u);
  EXPECT_GT(clamped_high, 100u);
  EXPECT_GT(inside, 1000u);
}

TEST(RoundMean, IsHalfUpEverywhere) {
  Random random(2);
  for (const uint32_t n : {1u, 2u, 3u, 7u, 255u, 32767u, 32768u, 32769u, 65535u, 65536u, 4000000u, 2147483647u}) {
    const int64_t lowest = -32768 * int64_t{n}, highest = 32767 * int64_t{n};
    std::vector<int64_t> sums = {lowest, lowest + 1,      highest,     highest - 1,          0,
                                 n / 2,  -int64_t{n / 2}, (n + 1) / 2, -int64_t{(n + 1) / 2}};
    for (int i = 0; i < 2000; ++i)
      sums.push_back(lowest + static_cast<int64_t>(random.uniform() * static_cast<double>(highest - lowest)));
    for (const int64_t sum : sums) {
      ASSERT_EQ(round_mean(sum, n), floor_divide(2 * sum + n, 2 * int64_t{n})) << sum << " / " << n;
    }
  }
  EXPECT_EQ(round_mean(1, 2), 1);
  EXPECT_EQ(round_mean(-1, 2), 0);
  EXPECT_EQ(round_mean(-3, 2), -1);
}

TEST(RingKernels, ManyNeighborsDoNotOverflow) {
  const uint32_t count = 70000, channels = 67;  // beyond what int32 sums hold, and more than one chunk of channels
  std::vector<int16_t> values(channels, -32767);
  const std::vector<uint32_t> neighbors(count, 0);
  std::vector<int16_t> out(channels + 1, kGuard);
  ring_mean_vertex_s16_ref({values.data(), channels}, channels, neighbors.data(), count, out.data());
  EXPECT_EQ(out, [&] {
    auto want = values;
    want.push_back(kGuard);
    return want;
  }());
  const uint16_t joints[1] = {5};
  ring_mean_pair_s16_ref({values.data(), channels}, channels, joints, 1, 5, neighbors.data(), count, out.data());
  EXPECT_EQ(out[66], -32767);
  ring_mean_pair_s16_ref({values.data(), channels}, channels, joints, 1, 6, neighbors.data(), count, out.data());
  EXPECT_EQ(out[66], 0);
}

TEST(RingKernels, MaximumOfNegativesIsNotZero) {
  const std::vector<int16_t> values = {-5, -9, -3, -20};
  const uint32_t neighbors[2] = {0, 1};
  int16_t out[2];
  ring_max_vertex_s16_ref({values.data(), 2}, 2, neighbors, 2, out);
  EXPECT_EQ(out[0], -3);
  EXPECT_EQ(out[1], -9);
  ring_max_vertex_s16_ref({values.data(), 2}, 2, neighbors, 0, out);
  EXPECT_EQ(out[0], 0);
}

TEST(CandidateMax, SkipsAbsentSlotsWhereverTheyAre) {
  const std::vector<int16_t> values = {0, -7, -4, 0};
  const uint16_t joints[4] = {kNoJoint, 3, 1, kNoJoint};
  std::vector<int16_t> out(8, kGuard);
  candidate_max_s16_ref({values.data(), 1}, false, 1, joints, 4, out.data(), 2, 4);
  EXPECT_EQ(out, (std::vector<int16_t>{0, kGuard, -4, kGuard, -4, kGuard, 0, kGuard}));
}

TEST(CandidateMax, ReadsRowsByJointAndWritesTheSlotsAskedFor) {
  const std::vector<int16_t> by_joint = {9, -4, 9, -7};
  const uint16_t joints[4] = {kNoJoint, 3, 1, kNoJoint};
  std::vector<int16_t> out(4, kGuard);
  candidate_max_s16_ref({by_joint.data(), 1}, true, 1, joints, 4, out.data(), 1, 2);
  EXPECT_EQ(out, (std::vector<int16_t>{0, -4, kGuard, kGuard}));
}

TEST(PartMean, DividesByThePartsVerticesAndTouchesItsJointsOnly) {
  // Three vertices of two slots; the part is {0, 2}. Joint 1 at both, joint 4 at one of them, joint 2 elsewhere.
  const std::vector<uint16_t> joints = {1, 4, 2, kNoJoint, 1, kNoJoint};
  const std::vector<int16_t> values = {10, 5, 1000, 0, 21, 0};
  const uint32_t part[2] = {0, 2};
  std::vector<int64_t> sums(5, 99);
  std::vector<int16_t> out(5, kGuard);
  part_mean_pair_s16_ref({values.data(), 1}, 1, joints.data(), 2, part, 2, sums.data(), out.data());
  EXPECT_EQ(out, (std::vector<int16_t>{kGuard, 16, kGuard, kGuard, 3}));  // 31 / 2 and 5 / 2, half up
}

TEST(Global, NothingPresentIsZero) {
  const std::vector<int16_t> values = {-5, 6};
  const uint16_t none[2] = {kNoJoint, kNoJoint}, first[2] = {0, kNoJoint};
  int64_t sum;
  int16_t out;
  global_mean_s16_ref({values.data(), 1}, 1, none, 2, &sum, &out);
  EXPECT_EQ(out, 0);
  global_max_s16_ref({values.data(), 1}, 1, none, 2, &out);
  EXPECT_EQ(out, 0);
  global_max_s16_ref({values.data(), 1}, 1, first, 2, &out);
  EXPECT_EQ(out, -5);
  global_mean_s16_ref({values.data(), 1}, 1, nullptr, 2, &sum, &out);
  EXPECT_EQ(out, 1);
}

}  // namespace
}  // namespace sinew::test
