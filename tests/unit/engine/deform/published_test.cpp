// SPDX-License-Identifier: MIT
// The published correction as it is shipped: volumes, its springs, its rounds, its smoothing, contact, weights of tetrahedra.
#include "sinew/published.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "posed_tube.hpp"

namespace {

using sinew_test::BentTube, sinew_test::Posed, sinew_test::farthest, sinew_test::pose, sinew_test::skinned,
    sinew_test::stretch;

sinew_deform_options shipped() {
  sinew_deform_options options = SINEW_INIT(sinew_deform_options);
  options.method = SINEW_DEFORM_XPBD;
  return options;
}

double volume_error(const BentTube& tube, const std::vector<float>& at) {
  return std::abs(tube.volume(at) / tube.volume(tube.positions) - 1);
}

TEST(Published, ABendKeepsMoreVolumeThanSkinning) {
  const BentTube tube(2, 0.5);
  for (const double degrees : {60.0, 90.0, 150.0}) {
    const std::vector<float> palette = tube.turned({0, 0, 1}, degrees);
    const Posed posed = pose(tube, shipped(), palette);
    EXPECT_LT(volume_error(tube, posed.positions), 0.5 * volume_error(tube, skinned(tube, palette, false))) << degrees;
    EXPECT_LT(volume_error(tube, posed.positions), volume_error(tube, skinned(tube, palette, true))) << degrees;
    EXPECT_GT(posed.outputs.active_tetrahedra, 0u) << degrees;
  }
}

TEST(Published, ASmallBendIsASmallCorrection) {
  const BentTube tube(2, 0.3);
  float last = 1;
  for (const double degrees : {10.0, 1.0, 0.1}) {
    const std::vector<float> palette = tube.turned({0, 0, 1}, degrees);
    const std::vector<float> posed = pose(tube, shipped(), palette).positions;
    const float moved = farthest(posed, skinned(tube, palette, false));
    EXPECT_LT(moved, 0.25f * last) << degrees;
    EXPECT_LT(volume_error(tube, posed), 1e-4 * degrees) << degrees;
    last = moved;
  }
  EXPECT_LT(last, 1e-4f);
}

TEST(Published, SmoothingIsOfBendsAndGrowsWithThem) {
  const BentTube tube(2, 0.3);
  sinew_deform_options plain = shipped();
  plain.without = SINEW_WITHOUT_SMOOTHING;
  float last = 0;
  for (const double degrees : {0.0, 20.0, 60.0, 120.0}) {
    const std::vector<float> palette = tube.turned({0, 0, 1}, degrees);
    const std::vector<float> with = pose(tube, shipped(), palette).positions;
    const std::vector<float> without = pose(tube, plain, palette).positions;
    const float moved = farthest(with, without);
    if (degrees == 0) {
      EXPECT_EQ(moved, 0.0f);
    } else {
      EXPECT_GT(moved, last) << degrees;
    }
    last = moved;
    for (size_t i = 0; i < 15 * BentTube::kAround; ++i) ASSERT_EQ(with[i], without[i]) << i;
    EXPECT_LT(volume_error(tube, with), volume_error(tube, without) + 0.01) << degrees;
  }
}

// As published: a vertex of the bend goes towards the mean of its neighbors, by half of the way at most.
TEST(Published, AsDrawnALaplacianSmoothsTheBend) {
  const BentTube tube(2, 0.3);
  const std::vector<float> palette = tube.turned({0, 0, 1}, 60);
  sinew_deform_options options = shipped();
  options.as_drawn = 1;
  const std::vector<float> with = pose(tube, options, palette).positions;
  options.without = SINEW_WITHOUT_SMOOTHING;
  const std::vector<float> without = pose(tube, options, palette).positions;
  const sinew_mesh mesh = tube.mesh();
  size_t moved = 0;
  for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
    if (std::equal(&with[3 * v], &with[3 * v] + 3, &without[3 * v])) continue;
    ++moved;
    std::set<uint32_t> neighbors;
    for (uint32_t f = 0; f < mesh.face_count; ++f) {
      const std::set<uint32_t> corners = {tube.corners[3 * f], tube.corners[3 * f + 1], tube.corners[3 * f + 2]};
      if (corners.count(v) > 0) neighbors.insert(corners.begin(), corners.end());
    }
    neighbors.erase(v);
    double way[3], made[3], along = 0, whole = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
      double mean = 0;
      for (const uint32_t n : neighbors) mean += double{without[3 * n + axis]} / static_cast<double>(neighbors.size());
      way[axis] = mean - double{without[3 * v + axis]};
      made[axis] = double{with[3 * v + axis]} - double{without[3 * v + axis]};
      along += way[axis] * made[axis];
      whole += way[axis] * way[axis];
    }
    const double share = along / whole;
    EXPECT_GT(share, 0) << v;
    EXPECT_LT(share, 0.501) << v;
    for (size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(made[axis], share * way[axis], 1e-5) << v;
  }
  EXPECT_GT(moved, 10u);
  EXPECT_EQ(pose(tube, options, tube.turned({0, 0, 1}, 0)).positions, tube.positions);
  sinew::Deformer deformer;
  options.method = SINEW_DEFORM_VOLUME;
  EXPECT_EQ(deformer.create(tube.mesh(), tube.skeleton(), tube.skin(), options), SINEW_ERROR_ARGUMENT);
}

TEST(Published, StifferSpringsStretchLess) {
  const BentTube tube(2, 0.3);
  const std::vector<float> palette = tube.turned({0, 0, 1}, 90);
  sinew_deform_options options = shipped();
  std::vector<float> last;
  double least = 1e9;
  for (const uint32_t energy : {1u, 200u, 900u}) {
    options.energy = energy;
    const std::vector<float> posed = pose(tube, options, palette).positions;
    EXPECT_NE(posed, last) << energy;
    EXPECT_LT(stretch(tube, posed), least) << energy;
    least = stretch(tube, posed);
    last = posed;
  }
  options.energy = 200;
  const std::vector<float> given = pose(tube, options, palette).positions;
  EXPECT_EQ(pose(tube, shipped(), palette).positions, given);  // the default is 0.2
}

TEST(Published, RoundsComeNearerToOneSolution) {
  const BentTube tube(2, 0.3);
  const std::vector<float> palette = tube.turned({0, 0, 1}, 120);
  sinew_deform_options options = shipped();
  const auto posed = [&](uint32_t rounds) {
    options.round_count = rounds;
    return pose(tube, options, palette).positions;
  };
  const std::vector<float> end = posed(200);
  const float one = farthest(posed(1), end), ten = farthest(posed(10), end), sixty = farthest(posed(60), end);
  EXPECT_LT(ten, 0.8f * one);
  EXPECT_LT(sixty, 0.6f * ten);
  EXPECT_LT(volume_error(tube, end), volume_error(tube, posed(1)));
}

TEST(Published, TetrahedraTakeWeightsFromTheSkinOrFromDistances) {
  const BentTube tube(3, 0.1);
  const std::vector<float> palette = tube.turned({0, 0, 1}, 45);
  sinew_deform_options options = shipped();
  const std::vector<float> skin = pose(tube, options, palette).positions;
  options.tet_weights = SINEW_TET_WEIGHTS_DISTANCE;
  const std::vector<float> distance = pose(tube, options, palette).positions;
  EXPECT_NE(skin, distance);
  EXPECT_LT(farthest(skin, distance), 0.15f);
  EXPECT_EQ(pose(tube, options, tube.turned({0, 0, 1}, 0)).positions, tube.positions);
}

TEST(Published, RefusesOptionsOutOfTheirRange) {
  const BentTube tube(2);
  sinew::Deformer deformer;
  sinew_deform_options options = shipped();
  options.tet_weights = 2;
  EXPECT_EQ(deformer.create(tube.mesh(), tube.skeleton(), tube.skin(), options), SINEW_ERROR_ARGUMENT);
  options = shipped();
  options.energy = SINEW_MAX_DEFORM_ENERGY + 1;
  EXPECT_EQ(deformer.create(tube.mesh(), tube.skeleton(), tube.skin(), options), SINEW_ERROR_ARGUMENT);
}

}  // namespace
