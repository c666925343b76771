// SPDX-License-Identifier: MIT
// How likely a front is by how far its answer reaches: rising, even odds at nothing, less where no mirror plane holds it.
#include "front/front.hpp"

#include <gtest/gtest.h>

namespace sinew::rigging {
namespace {

TEST(Front, ALikelihoodRisesWithTheReach) {
  for (const bool mirrored : {false, true}) {
    EXPECT_EQ(front_likelihood(0, mirrored), 0.5f);
    float before = 0;
    for (int64_t reach = -1 << 16; reach <= 1 << 16; reach += 1 << 12) {
      const float now = front_likelihood(reach, mirrored);
      EXPECT_GT(now, before) << reach;
      EXPECT_NEAR(now + front_likelihood(-reach, mirrored), 1, 2.5e-4) << reach;  // the logit is Q10
      before = now;
    }
  }
}

TEST(Front, WithoutAMirrorPlaneTheSameReachPromisesLess) {
  constexpr int64_t kOne = 1 << 15;
  EXPECT_NEAR(front_likelihood(kOne, true), 0.94, 0.005);   // 1 / (1 + exp(-2.75))
  EXPECT_NEAR(front_likelihood(kOne, false), 0.82, 0.005);  // 1 / (1 + exp(-1.51))
}

}  // namespace
}  // namespace sinew::rigging
