// SPDX-License-Identifier: MIT
// numpy's draws, written down from numpy 1.24.2: any slip in seeding, PCG64 or the ziggurat changes every pose.
#include "score/numpy_random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sinew {
namespace {

TEST(NumpyRandom, FirstWordsOfThreeSeeds) {
  EXPECT_EQ(NumpyRandom(0).next_uint64(), 0xa30febcfd9c2825fu);
  EXPECT_EQ(NumpyRandom(1).next_uint64(), 0x8306bdf37922e4ffu);
  EXPECT_EQ(NumpyRandom(12345).next_uint64(), 0x3a32b18db2ffc19du);
}

TEST(NumpyRandom, UniformsAreTheSameBits) {
  NumpyRandom zero(0), one(1), many(12345);
  for (double expected : {0x1.187f5e7ece140p-2, -0x1.d77a103be9318p-2, -0x1.d60b095ac4c86p-1})
    EXPECT_EQ(zero.uniform(-1, 1), expected);
  for (double expected : {0x1.835ef9bc91700p-6, 0x1.cd465aef054aap-1, -0x1.6c616c27dc4fap-1})
    EXPECT_EQ(one.uniform(-1, 1), expected);
  for (double expected : {-0x1.173539c934010p-1, -0x1.77476751b0da0p-2, 0x1.30809208d113ap-1})
    EXPECT_EQ(many.uniform(-1, 1), expected);
}

// Draws before an index, then the value there: |x| > 3.654 comes from the tail, where numpy takes the sign from another
// bit.
struct Draw {
  uint64_t seed;
  int index;
  double value;
};

TEST(NumpyRandom, NormalsOfLayersAndOfTheTail) {
  for (const Draw& draw :
       {Draw{0, 0, 0x1.017ed89db8441p-3}, Draw{0, 1, -0x1.0e8cfe9bd45ccp-3}, Draw{0, 2, 0x1.47e57a468b06dp-1},
        Draw{0, 303, -0x1.e2d9e98d87bc6p+1}, Draw{0, 478, -0x1.f3204051f2938p+1}, Draw{1, 0, 0x1.61e0d28bbb3a1p-2},
        Draw{1, 3, -0x1.4d9bb65b49607p+0}, Draw{1, 860, 0x1.e035931978327p+1}, Draw{1, 3284, 0x1.dbdba47b03290p+1},
        Draw{12345, 0, -0x1.6c7fcc2ecc744p+0}, Draw{12345, 3, -0x1.0964b5602ac3cp-2},
        Draw{12345, 1846, 0x1.dc4ceede8c71ap+1}, Draw{12345, 4644, 0x1.f3753b3a118a6p+1}}) {
    NumpyRandom random(draw.seed);
    for (int i = 0; i < draw.index; ++i) random.normal();
    EXPECT_NEAR(random.normal(), draw.value, 1e-14) << "seed " << draw.seed << " draw " << draw.index;
  }
}

TEST(NumpyRandom, AMillionNormalsHaveTheRightMoments) {
  NumpyRandom random(7);
  double sum = 0, squares = 0, fourths = 0;
  constexpr int count = 1000000;
  for (int i = 0; i < count; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    fourths += x * x * x * x;
  }
  EXPECT_NEAR(sum / count, 0, 0.005);
  EXPECT_NEAR(squares / count, 1, 0.01);
  EXPECT_NEAR(fourths / count, 3, 0.06);
}

}  // namespace
}  // namespace sinew
