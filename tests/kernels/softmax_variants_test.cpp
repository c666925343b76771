// SPDX-License-Identifier: MIT
// Softmax: its definition against double, and every variant against the definition, bit for bit, over all counts,
// absent slots, ties, extremes, and divisions that fall on a half.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "kernels/select.hpp"
#include "kernels/softmax_s16_powers.hpp"
#include "random.hpp"

namespace sinew::test {
namespace {

constexpr uint32_t kGuard = 0x7A7A7A7A;
constexpr uint32_t kOnePercent = 655;

// Vectors of the row's own size: what a kernel reads behind them a sanitizer sees.
struct SoftmaxRow {
  std::vector<int16_t> logits;
  std::vector<uint16_t> joints;

  void add(int16_t logit, bool present) {
    logits.push_back(logit);
    joints.push_back(present ? static_cast<uint16_t>(kNoJoint - 16 + joints.size()) : kNoJoint);  // negative as int16
  }
  std::vector<uint32_t> run(SoftmaxKernel kernel, uint32_t smallest) const {
    std::vector<uint32_t> out(logits.size() + 1, kGuard);
    kernel(logits.data(), joints.data(), static_cast<uint32_t>(logits.size()), smallest, out.data());
    return out;
  }
};

class SoftmaxVariant : public testing::TestWithParam<uint32_t> {
 protected:
  void SetUp() override {
    Kernels kernels;
    if (!select_kernels(GetParam(), &kernels))
      GTEST_SKIP() << "NOT RUN: this processor has no " << kernel_name(GetParam());
    variant_ = kernels.softmax;
    ASSERT_NE(variant_, softmax_s16_ref) << "the variant was not built";
  }
  void compare(const SoftmaxRow& row) {
    for (const uint32_t smallest : {uint32_t{0}, kOnePercent, uint32_t{65536}}) {
      ASSERT_EQ(row.run(variant_, smallest), row.run(softmax_s16_ref, smallest))
          << "smallest " << smallest << " logits " << testing::PrintToString(row.logits) << " joints "
          << testing::PrintToString(row.joints);
    }
  }
  SoftmaxKernel variant_ = nullptr;
};

TEST_P(SoftmaxVariant, RandomRowsEqualTheReference) {
  Random random(31);
  for (uint32_t round = 0; round < 40000; ++round) {
    const int32_t range[] = {3, 500, 8000, 32767};  // ties, usual ones, some that vanish, most that vanish
    const int32_t reach = range[round / 16 % 4];
    const uint32_t absent = round / 64 % 4;  // quarters of the slots
    SoftmaxRow row;
    for (uint32_t i = 0; i <= round % 16; ++i)
      row.add(static_cast<int16_t>(random.between(-reach, reach)), random.below(4) >= absent);
    compare(row);
    if (HasFatalFailure()) return;
  }
}

TEST_P(SoftmaxVariant, ExtremesEqualTheReference) {
  Random random(32);
  const int16_t values[] = {-32768, -32767, -1, 0, 1, 32766, 32767};
  for (uint32_t round = 0; round < 20000; ++round) {
    SoftmaxRow row;
    for (uint32_t i = 0; i <= round % 16; ++i) row.add(values[random.below(7)], random.below(4) != 0);
    compare(row);
    if (HasFatalFailure()) return;
  }
}

// Every entry of the table and every step between, halved up to 63 times.
TEST_P(SoftmaxVariant, EveryDifferenceEqualsTheReference) {
  for (int32_t difference = 0; difference <= 65535; ++difference) {
    SoftmaxRow row;
    row.add(static_cast<int16_t>(32767 - difference), true);
    row.add(32767, true);
    if (difference % 3 == 0) row.add(32767, false);
    compare(row);
    if (HasFatalFailure()) return;
  }
}

// Powers of two, up to sixteen equal ones: sums that divide without a remainder.
TEST_P(SoftmaxVariant, PowersOfTwoEqualTheReference) {
  Random random(33);
  for (uint32_t count = 1; count <= 16; ++count) {
    for (uint32_t round = 0; round < 3000; ++round) {
      const uint32_t spread = 1 + round % 33;  // 1: all are equal
      SoftmaxRow row;
      for (uint32_t i = 0; i < count; ++i)
        row.add(static_cast<int16_t>(32767 - 1024 * static_cast<int32_t>(random.below(spread))), true);
      compare(row);
      if (HasFatalFailure()) return;
    }
  }
}

// Division is where a variant can go wrong: rows with a probability of just a half above a whole number. The sum is
// 2^17 p / m for a power p and an odd m; powers that bring it there are found from the largest down.
TEST_P(SoftmaxVariant, HalvesEqualTheReference) {
  Random random(34);
  std::vector<uint32_t> powers;  // of every difference, falling
  for (uint32_t d = 0; d < 31 * 1024; ++d) {
    const uint32_t step = d % 1024 >> kFineBits, drop = kPowers.q30[step] - kPowers.q30[step + 1];
    powers.push_back((kPowers.q30[step] - (drop * (d % (1u << kFineBits)) >> kFineBits)) >> d / 1024);
  }
  uint32_t rows = 0;
  for (uint32_t round = 0; round < 100000; ++round) {
    const uint32_t d = random.below(18 * 1024), odd = 1 + 2 * random.below(60);
    const uint64_t p = powers[d], sum = (p << 17) / odd;
    if (p % odd != 0 || sum < p + powers[0]) continue;
    SoftmaxRow row;
    row.add(32767, true);
    row.add(static_cast<int16_t>(32767 - static_cast<int32_t>(d)), true);
    uint64_t rest = sum - p - powers[0];
    while (rest != 0 && row.logits.size() < 16) {
      const auto next = std::find_if(powers.begin(), powers.end(), [&](uint32_t power) { return power <= rest; });
      row.add(static_cast<int16_t>(32767 - (next - powers.begin())), true);
      rest -= *next;
    }
    if (rest != 0) continue;
    ++rows;
    compare(row);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(rows, 1000u);
}

TEST_P(SoftmaxVariant, NothingPresentIsAllZero) {
  for (uint32_t count = 1; count <= 16; ++count) {
    SoftmaxRow row;
    for (uint32_t i = 0; i < count; ++i) row.add(i % 2 == 0 ? INT16_MAX : INT16_MIN, false);
    std::vector<uint32_t> want(count + 1, 0);
    want.back() = kGuard;
    EXPECT_EQ(row.run(variant_, 0), want);
    EXPECT_EQ(row.run(softmax_s16_ref, 0), want);
  }
}

INSTANTIATE_TEST_SUITE_P(All, SoftmaxVariant,
                         testing::Values(SINEW_KERNEL_AVX2, SINEW_KERNEL_AVXVNNI, SINEW_KERNEL_VNNI,
                                         SINEW_KERNEL_SIMD128, SINEW_KERNEL_NEON),
                         [](const auto& tested) { return std::string(kernel_name(tested.param)); });

TEST(SoftmaxDsp, TakesTheReference) {
  Kernels dsp;
  if (!select_kernels(SINEW_KERNEL_DSP, &dsp)) GTEST_SKIP() << "NOT RUN: this processor has no dsp";
  EXPECT_EQ(dsp.softmax, softmax_s16_ref);
}

std::vector<double> exact_softmax(const std::vector<int16_t>& logits, const std::vector<uint16_t>& joints) {
  std::vector<double> p(logits.size());
  double sum = 0;
  for (size_t i = 0; i < p.size(); ++i) sum += p[i] = joints[i] == kNoJoint ? 0 : std::exp2(logits[i] / 1024.0);
  for (double& value : p) value /= sum;
  return p;
}

TEST(SoftmaxReference, IsCloseToDouble) {
  Random random(1);
  double worst = 0;
  for (int row = 0; row < 20000; ++row) {
    const uint32_t count = 1 + random.below(16);
    const int range = row % 3 == 0 ? 500 : row % 3 == 1 ? 8000 : 32767;
    std::vector<int16_t> logits;
    std::vector<uint16_t> joints;
    for (uint32_t i = 0; i < count; ++i) {
      logits.push_back(
          static_cast<int16_t>(static_cast<int>(random.below(static_cast<uint32_t>(2 * range + 1))) - range));
      joints.push_back(i > 0 && random.below(4) == 0 ? kNoJoint : static_cast<uint16_t>(i));
    }
    std::vector<uint32_t> q16(count);
    softmax_s16_ref(logits.data(), joints.data(), count, 0, q16.data());
    const std::vector<double> exact = exact_softmax(logits, joints);
    for (uint32_t i = 0; i < count; ++i) {
      worst = std::max(worst, std::abs(q16[i] / 65536.0 - exact[i]));
      if (joints[i] == kNoJoint) {
        ASSERT_EQ(q16[i], 0u);
      }
    }
  }
  EXPECT_LE(worst, 3e-5);  // the promise to the network is 2e-4
}

TEST(SoftmaxReference, ExtremesStayInRange) {
  const uint16_t joints[3] = {4, 5, 6};
  uint32_t p[3];
  const int16_t far[3] = {32767, -32767, 32766};
  softmax_s16_ref(far, joints, 3, 0, p);
  EXPECT_EQ(p[1], 0u);
  EXPECT_GT(p[0], p[2]);
  const int16_t lowest[1] = {INT16_MIN};
  softmax_s16_ref(lowest, joints, 1, 0, p);
  EXPECT_EQ(p[0], 65536u);
  const uint16_t none[2] = {kNoJoint, kNoJoint};
  softmax_s16_ref(far, none, 2, 0, p);
  EXPECT_EQ(p[0] + p[1], 0u);
}

TEST(SoftmaxReference, HigherLogitNeverGetsLess) {
  const uint16_t joints[2] = {0, 1};
  uint32_t before = 0;
  for (int logit = -20000; logit <= 20000; ++logit) {
    const int16_t logits[2] = {static_cast<int16_t>(logit), 0};
    uint32_t p[2];
    softmax_s16_ref(logits, joints, 2, 0, p);
    ASSERT_GE(p[0], before) << logit;
    before = p[0];
  }
}

TEST(SoftmaxReference, DropsWhatIsBelowTheSmallest) {
  const uint16_t joints[3] = {0, 1, 2};
  const int16_t logits[3] = {0, -6785, -6790};  // about 1 % and a little less
  uint32_t all[3], kept[3];
  softmax_s16_ref(logits, joints, 3, 0, all);
  ASSERT_GT(all[1], all[2]);
  softmax_s16_ref(logits, joints, 3, all[1], kept);
  EXPECT_EQ(kept[0], all[0]);
  EXPECT_EQ(kept[1], all[1]);
  EXPECT_EQ(kept[2], 0u);
}

}  // namespace
}  // namespace sinew::test
