// SPDX-License-Identifier: MIT
// Things that are no body: closed surfaces, points with targets anywhere, the same for a seed.
#include "data/thing_sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace sinew {
namespace {

TEST(ThingSample, SurfacesAreClosedAndStandOnTheFloor) {
  std::set<size_t> sizes;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    const SourcedSurface thing = make_thing(seed);
    ASSERT_GE(thing.vertices.size(), 10u) << seed;
    ASSERT_EQ(thing.source.size(), thing.vertices.size());
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (const auto& t : thing.triangles) {
      for (size_t i = 0; i < 3; ++i) {
        const uint32_t a = t[i], b = t[(i + 1) % 3];
        edges[std::minmax(a, b)] += a < b ? 1 : -1;
      }
    }
    for (const auto& [edge, sum] : edges) ASSERT_EQ(sum, 0) << seed << ": walked both ways";
    double low = 1e9;
    for (const auto& p : thing.vertices) low = std::min(low, p[1]);
    EXPECT_NEAR(low, 0, 1e-12);
    sizes.insert(thing.vertices.size());
  }
  EXPECT_GT(sizes.size(), 20u) << "of many kinds";
}

TEST(ThingSample, TargetsAreAnywhereAndNoClassIsLearned) {
  for (const uint32_t cells : {0u, 64u}) {
    const RigSample one = make_thing_sample(4, cells), same = make_thing_sample(4, cells),
                    other = make_thing_sample(5, cells);
    EXPECT_EQ(one.start, same.start);
    EXPECT_EQ(one.inputs[0].rows, same.inputs[0].rows);
    EXPECT_NE(one.inputs[0].rows, other.inputs[0].rows);
    EXPECT_EQ(one.family, "thing");
    double mean[3] = {};
    for (size_t i = 0; i < one.start.size(); ++i)
      mean[i % 3] += static_cast<double>(one.start[i]) * 3 / static_cast<double>(one.start.size());
    EXPECT_NEAR(mean[0], 0, 0.06);
    EXPECT_NEAR(mean[1], 0.5, 0.06);
    EXPECT_NEAR(mean[2], 0, 0.06);
    EXPECT_TRUE(std::all_of(one.start_class.begin(), one.start_class.end(),
                            [](uint8_t c) { return c == rigging::kClassOther; }));
  }
}

}  // namespace
}  // namespace sinew
