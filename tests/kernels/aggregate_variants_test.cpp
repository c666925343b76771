// SPDX-License-Identifier: MIT
// Every vector variant of an aggregation equals the reference: random graphs and channel counts, absent rows, extremes,
// rings longer than the vector code takes.
#include <gtest/gtest.h>

#include <vector>

#include "kernels/select.hpp"
#include "random.hpp"

namespace sinew::test {
namespace {

constexpr int16_t kGuard = 0x7A7A;

class AggregateVariant : public testing::TestWithParam<uint32_t> {
 protected:
  void SetUp() override {
    ASSERT_TRUE(select_kernels(SINEW_KERNEL_REF, &reference_));
    if (!select_kernels(GetParam(), &variant_))
      GTEST_SKIP() << "NOT RUN: this processor has no " << kernel_name(GetParam());
    ASSERT_NE(variant_.ring_mean_pair, reference_.ring_mean_pair) << "the variant was not built";
    ASSERT_NE(variant_.part_mean_vertex, reference_.part_mean_vertex) << "the variant was not built";
    ASSERT_NE(variant_.global_max, reference_.global_max) << "the variant was not built";
    ASSERT_NE(variant_.candidate_max, reference_.candidate_max) << "the variant was not built";
  }
  Kernels reference_, variant_;
};

int16_t any_value(Random* random, bool extreme) {
  if (extreme) return random->below(2) != 0 ? int16_t{32767} : int16_t{-32767};
  return static_cast<int16_t>(random->between(-32767, 32767));
}

TEST_P(AggregateVariant, RingsEqualReference) {
  Random random(21);
  for (uint32_t round = 0; round < 400; ++round) {
    const uint32_t vertices = 1 + random.below(40), k = round % 2 == 0 ? 8 : 1 + random.below(16);
    const uint32_t channels = round % 3 == 0 ? 48 : 1 + random.below(150), stride = channels + random.below(3);
    const uint32_t joint_count = 1 + random.below(20);
    std::vector<uint16_t> joints(size_t{vertices} * k, kNoJoint);
    for (uint32_t v = 0; v < vertices; ++v) {  // different joints, absent slots anywhere
      uint16_t joint = static_cast<uint16_t>(random.below(3));
      for (uint32_t slot = 0; slot < k && joint < joint_count; ++slot) {
        if (random.below(5) == 0) continue;
        joints[size_t{v} * k + slot] = joint;
        joint = static_cast<uint16_t>(joint + 1 + random.below(3));
      }
    }
    std::vector<int16_t> values((size_t{vertices} * k - 1) * stride + channels);
    for (int16_t& value : values) value = any_value(&random, round % 5 == 0);
    const uint32_t count = round % 7 == 0 ? random.below(200) : random.below(12);
    std::vector<uint32_t> neighbors(count);
    for (uint32_t& u : neighbors) u = random.below(vertices);
    const RowsView rows = {values.data(), stride};
    const uint16_t joint = static_cast<uint16_t>(random.below(joint_count));
    const auto compare = [&](auto call, const char* what) {
      std::vector<int16_t> want(channels + 1, kGuard), got = want;
      call(reference_, want.data());
      call(variant_, got.data());
      ASSERT_EQ(got, want) << what << ": channels " << channels << " neighbors " << count << " k " << k << " round "
                           << round;
    };
    compare([&](const Kernels& x, int16_t* o) { x.ring_mean_vertex(rows, channels, neighbors.data(), count, o); },
            "mean, vertex");
    compare([&](const Kernels& x, int16_t* o) { x.ring_max_vertex(rows, channels, neighbors.data(), count, o); },
            "max, vertex");
    compare([&](const Kernels& x,
                int16_t* o) { x.ring_mean_pair(rows, channels, joints.data(), k, joint, neighbors.data(), count, o); },
            "mean, pair");
    compare([&](const Kernels& x,
                int16_t* o) { x.ring_max_pair(rows, channels, joints.data(), k, joint, neighbors.data(), count, o); },
            "max, pair");
    if (HasFatalFailure()) return;
  }
}

// Division is where a mean can go wrong: every count the vector code takes, sums around every quotient's edge.
TEST_P(AggregateVariant, MeansOfEveryCountAreExact) {
  Random random(22);
  for (uint32_t n = 1; n <= 64; ++n) {
    const std::vector<uint32_t> neighbors = [&] {
      std::vector<uint32_t> list(n);
      for (uint32_t i = 0; i < n; ++i) list[i] = i;
      return list;
    }();
    constexpr uint32_t kChannels = 4096;
    std::vector<int16_t> values(size_t{n} * kChannels);
    for (uint32_t c = 0; c < kChannels; ++c) {
      // Every channel's mean lies near a value, its sum a little beside the value's edges.
      const int32_t base = c < 8 ? (c % 2 != 0 ? 32767 : -32767) : random.between(-32766, 32766);
      int32_t rest = c < 8 ? 0 : random.between(-static_cast<int32_t>(n), static_cast<int32_t>(n));
      for (uint32_t r = 0; r < n; ++r) {
        const int32_t step = rest > 0 ? 1 : rest < 0 ? -1 : 0;
        rest -= step;
        values[size_t{r} * kChannels + c] = static_cast<int16_t>(base + step);
      }
    }
    std::vector<int16_t> want(kChannels), got(kChannels);
    reference_.ring_mean_vertex({values.data(), kChannels}, kChannels, neighbors.data(), n, want.data());
    variant_.ring_mean_vertex({values.data(), kChannels}, kChannels, neighbors.data(), n, got.data());
    ASSERT_EQ(got, want) << n << " rows";
  }
}

TEST_P(AggregateVariant, CandidateMaxEqualsReference) {
  Random random(23);
  for (uint32_t round = 0; round < 600; ++round) {
    const uint32_t k = 1 + random.below(16), channels = round % 3 == 0 ? 48 : 1 + random.below(100);
    const uint32_t stride = channels + random.below(3), out_stride = channels + random.below(3);
    std::vector<uint16_t> joints(k);
    const uint32_t absent = random.below(4);
    const bool by_joint = round % 4 == 1;
    const uint32_t rows = by_joint ? 20 : k, out_slots = round % 2 == 0 ? k : 1 + random.below(k);
    for (uint16_t& joint : joints) {
      joint =
          absent == 3 || (absent != 0 && random.below(3) < absent) ? kNoJoint : static_cast<uint16_t>(random.below(20));
    }
    std::vector<int16_t> values(size_t{rows - 1} * stride + channels),
        want(size_t{k - 1} * out_stride + channels, kGuard), got = want;
    for (int16_t& value : values) value = any_value(&random, round % 5 == 0);
    const RowsView view = {values.data(), stride};
    reference_.candidate_max(view, by_joint, channels, joints.data(), k, want.data(), out_stride, out_slots);
    variant_.candidate_max(view, by_joint, channels, joints.data(), k, got.data(), out_stride, out_slots);
    ASSERT_EQ(got, want) << "k " << k << " channels " << channels << " round " << round;
  }
}

TEST_P(AggregateVariant, PartAndGlobalMeansEqualReference) {
  Random random(24);
  for (uint32_t round = 0; round < 200; ++round) {
    // Some parts beyond what int32 sums hold, and beyond what the vector division takes.
    const bool huge = round % 50 == 0;
    const uint32_t vertices = huge ? 66000 : 1 + random.below(round % 4 == 0 ? 300 : 60);
    const uint32_t k = huge ? 1 : 1 + random.below(9), joint_count = k + random.below(20);
    const uint32_t channels = huge             ? 17
                              : round % 3 == 0 ? 48
                                               : 1 + random.below(140),
                   stride = channels + random.below(3);
    std::vector<uint16_t> joints(size_t{vertices} * k);
    for (size_t i = 0; i < joints.size(); ++i) {
      joints[i] = random.below(5) == 0
                      ? kNoJoint
                      : static_cast<uint16_t>((i % k + random.below(joint_count / k) * k) % joint_count);
    }
    std::vector<int16_t> values((size_t{vertices} * k - 1) * stride + channels);
    const bool extreme = round % 5 == 0;
    for (int16_t& value : values) value = extreme ? int16_t{-32767} : any_value(&random, false);
    std::vector<uint32_t> part;
    for (uint32_t v = 0; v < vertices; ++v) {
      if (huge || random.below(3) != 0 || v == 0) part.push_back(v);
    }
    const auto compare = [&](size_t outputs, auto call, const char* what) {
      std::vector<int64_t> sums(outputs);
      std::vector<int16_t> want(outputs, kGuard), got = want;
      call(reference_, sums.data(), want.data());
      call(variant_, sums.data(), got.data());
      ASSERT_EQ(got, want) << what << ": channels " << channels << " vertices " << vertices << " k " << k << " round "
                           << round;
    };
    const RowsView rows = {values.data(), stride};
    const uint32_t count = static_cast<uint32_t>(part.size());
    compare(
        size_t{joint_count} * channels,
        [&](const Kernels& x, int64_t* sums, int16_t* out) {
          x.part_mean_pair(rows, channels, joints.data(), k, part.data(), count, sums, out);
        },
        "part, pair");
    compare(
        channels,
        [&](const Kernels& x, int64_t* sums, int16_t* out) {
          x.part_mean_vertex(rows, channels, part.data(), count, sums, out);
        },
        "part, vertex");
    compare(
        channels,
        [&](const Kernels& x, int64_t*, int16_t* out) {
          x.global_max(rows, channels, round % 2 == 0 ? joints.data() : nullptr, joints.size(), out);
        },
        "global max");
    compare(
        channels,
        [&](const Kernels& x, int64_t* sums, int16_t* out) {
          x.global_mean(rows, channels, round % 2 == 0 ? joints.data() : nullptr, joints.size(), sums, out);
        },
        "global");
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(All, AggregateVariant,
                         testing::Values(SINEW_KERNEL_AVX2, SINEW_KERNEL_AVXVNNI, SINEW_KERNEL_VNNI,
                                         SINEW_KERNEL_SIMD128, SINEW_KERNEL_NEON),
                         [](const auto& tested) { return std::string(kernel_name(tested.param)); });

// A Cortex-M's DSP instructions are used for the linear layer alone. Whoever adds aggregations for them adds them
// above.
TEST(AggregateDsp, TakesTheReference) {
  Kernels reference, dsp;
  ASSERT_TRUE(select_kernels(SINEW_KERNEL_REF, &reference));
  if (!select_kernels(SINEW_KERNEL_DSP, &dsp)) GTEST_SKIP() << "NOT RUN: this processor has no dsp";
  EXPECT_NE(dsp.linear, reference.linear);
  EXPECT_EQ(dsp.ring_mean_vertex, reference.ring_mean_vertex);
  EXPECT_EQ(dsp.ring_max_pair, reference.ring_max_pair);
  EXPECT_EQ(dsp.candidate_max, reference.candidate_max);
  EXPECT_EQ(dsp.part_mean_pair, reference.part_mean_pair);
  EXPECT_EQ(dsp.global_max, reference.global_max);
}

}  // namespace
}  // namespace sinew::test
