// SPDX-License-Identifier: MIT
// Modes of clouds against the same climb in doubles, and of clouds whose modes are known.
#include "votes/mean_shift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "arena_block.hpp"
#include "random.hpp"

namespace sinew::rigging {
namespace {

using sinew_test::Block;
using test::Random;

constexpr int32_t kWidth = side_share(280);

struct Point {
  Vec3i at;
  uint32_t weight;
};

std::vector<Mode> modes_of(std::vector<Point> points, bool mirrored = false, uint32_t most = kMaxModes) {
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return comes_before(a.at, b.at); });
  Arena measuring;
  Cloud cloud;
  EXPECT_TRUE(cloud.allocate(measuring, static_cast<uint32_t>(points.size())));
  Block block(measuring.high_water() + 64);
  EXPECT_TRUE(cloud.allocate(block.arena, static_cast<uint32_t>(points.size())));
  for (const Point& p : points) cloud.add(p.at, p.weight);
  std::array<Mode, kMaxModes> modes;
  const uint32_t count = find_modes(cloud, kWidth, mirrored, most, modes.data());
  return {modes.begin(), modes.begin() + count};
}

std::vector<Point> blob(Random* random, Vec3i center, uint32_t count, double sigma) {
  std::vector<Point> points;
  const auto off = [&] { return static_cast<int32_t>(sigma * kSide * random->normal()); };
  for (uint32_t i = 0; i < count; ++i) {
    points.push_back({center + Vec3i{off(), off(), off()}, 1 + random->below(32768)});
  }
  return points;
}

// The density's slope in doubles: how far a mean-shift step goes from here.
double step_from(const std::vector<Point>& points, Vec3i at, bool mirrored) {
  double sum[4] = {};
  for (const Point& p : points) {
    for (int side = 0; side < (mirrored ? 2 : 1); ++side) {
      const double d[3] = {static_cast<double>((side == 0 ? p.at.x : -p.at.x) - at.x),
                           static_cast<double>(p.at.y - at.y), static_cast<double>(p.at.z - at.z)};
      const double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      if (square >= 9.0 * kWidth * kWidth) continue;
      const double share = p.weight * std::exp(-square / (2.0 * kWidth * kWidth));
      for (int k = 0; k < 3; ++k) sum[k] += share * d[k];
      sum[3] += share;
    }
  }
  return std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) / sum[3];
}

TEST(MeanShift, NothingHasNoModeAndOnePointIsIts) {
  EXPECT_TRUE(modes_of({}).empty());
  const std::vector<Mode> modes = modes_of({{{5, 6, 7}, 1}});
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_TRUE((modes[0].at == Vec3i{5, 6, 7}));
  EXPECT_GT(modes[0].density, 32000);  // nearly 1 in Q15 times the weight
}

TEST(MeanShift, FindsBlobsByFallingDensityWhereTheDensityIsFlat) {
  for (uint32_t seed = 0; seed < 30; ++seed) {
    Random random(seed);
    const bool mirrored = seed % 2 == 1;
    std::vector<Point> points;
    const uint32_t blobs = 1 + random.below(5);
    for (uint32_t b = 0; b < blobs; ++b) {
      const Vec3i center = {static_cast<int32_t>(b) * (kSide / 5) + kSide / 32, random.between(0, kSide), 0};
      for (const Point& p : blob(&random, center, 40 + random.below(200), 0.01)) points.push_back(p);
    }
    for (Point& p : points) p.at.x = mirrored ? std::abs(p.at.x) : p.at.x;
    const std::vector<Mode> modes = modes_of(points, mirrored);
    EXPECT_GE(modes.size(), blobs) << seed;
    for (size_t m = 0; m < modes.size(); ++m) {
      if (m > 0) {
        EXPECT_GE(modes[m - 1].density, modes[m].density) << seed;
      }
      // A step is less than what ends the climb, and what the kernel's table rounds away.
      EXPECT_LT(step_from(points, modes[m].at, mirrored), 3e-4 * kSide) << seed << " " << m;
      EXPECT_TRUE(!mirrored || modes[m].at.x >= 0);
      for (size_t other = 0; other < m; ++other) {
        EXPECT_GT(square_distance(modes[m].at, modes[other].at), square(kWidth * 3 / 5)) << seed;
      }
    }
  }
}

// Along a ridge a climb is slow, and where it ends must not be where it tires.
TEST(MeanShift, ARidgeHasOneModeWhereverAClimbBegins) {
  std::vector<Point> points;
  for (int32_t i = 0; i < 400; ++i)
    points.push_back({{0, i * (kSide / 4) / 400, 0}, static_cast<uint32_t>(8000 - 20 * std::abs(i - 210))});
  const Vec3i at = modes_of(points)[0].at;
  for (const int32_t first : {20, 390}) {
    points[static_cast<size_t>(first)].weight = 9000;
    const Mode mode = modes_of(points, false, 1)[0];
    points[static_cast<size_t>(first)].weight = 8000;
    EXPECT_LT(std::abs(mode.at.y - at.y), kSide / 300) << first;
  }
}

TEST(MeanShift, TheHeaviestPointIsTheFirstSeed) {
  const std::vector<Point> points = {{{0, 0, 0}, 400}, {{0, kSide / 2, 0}, 500}, {{0, kSide, 0}, 450}};
  const std::vector<Mode> modes = modes_of(points, false, 1);
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_EQ(modes[0].at.y, kSide / 2);
}

TEST(MeanShift, ImagesDrawAModeToThePlane) {
  Random random(3);
  std::vector<Point> points = blob(&random, {kSide / 100, 0, 0}, 300, 0.01);
  for (Point& p : points) p.at.x = std::abs(p.at.x);
  EXPECT_LT(modes_of(points, true)[0].at.x, kSide / 500);
  EXPECT_GT(modes_of(points, false)[0].at.x, kSide / 150);
}

TEST(MeanShift, OrderOfEqualPlacesDoesNotMatter) {
  Random random(9);
  std::vector<Point> points;
  for (int i = 0; i < 3000; ++i) {
    points.push_back({{random.between(0, 20) << 14, random.between(0, 20) << 14, 0}, 1 + random.below(3) * 1000});
  }
  const std::vector<Mode> modes = modes_of(points);
  std::shuffle(points.begin(), points.end(), random.engine());
  const std::vector<Mode> again = modes_of(points);
  ASSERT_EQ(modes.size(), again.size());
  for (size_t m = 0; m < modes.size(); ++m) {
    EXPECT_TRUE(modes[m].at == again[m].at);
    EXPECT_EQ(modes[m].density, again[m].density);
  }
}

TEST(MeanShift, KeepsWithinItsSeedsAndSums) {
  Random random(4);
  std::vector<Point> points;
  for (uint32_t i = 0; i < kMaxVotes; ++i) {  // all weight in reach of all
    points.push_back({{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)}, 32768});
  }
  const std::vector<Mode> heavy = modes_of(points, true);
  ASSERT_EQ(heavy.size(), 1u);
  EXPECT_LE(heavy[0].at.x, 9);
  EXPECT_NEAR(static_cast<double>(heavy[0].density), 2.0 * kMaxVotes * 32768 * 32768, 4e11);
  for (Point& p : points)
    p.at = {random.between(-kSide, kSide), random.between(-kSide, kSide), random.between(0, kSide)};
  EXPECT_LE(modes_of(points, false, 7).size(), 7u);
  EXPECT_LE(modes_of(points).size(), kMaxModes);
}

}  // namespace
}  // namespace sinew::rigging
