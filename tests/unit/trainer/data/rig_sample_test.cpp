// SPDX-License-Identifier: MIT
// Samples of changed characters: labels follow the joints, whatever became of the surface.
#include "data/rig_sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sinew_data_sets/synthesize.hpp"
#include "votes/joint_class.hpp"

namespace sinew {
namespace {

using namespace rigging;

const RigSource& biped() {
  static const RigSource source = [] {
    SynthesizeOptions options;
    options.resolution = 32;
    options.clothing = false;
    return RigSource(synthesize(options));
  }();
  return source;
}

double mean_distance(const RigSample& s) {
  double sum = 0;
  for (size_t i = 0; i < s.vertices; ++i)
    sum += std::hypot(s.start[3 * i] - s.medial[3 * i], s.start[3 * i + 1] - s.medial[3 * i + 1],
                      s.start[3 * i + 2] - s.medial[3 * i + 2]);
  return sum / s.vertices;
}

std::array<size_t, kEndClasses> points_of_classes(const RigSample& s) {
  std::array<size_t, kEndClasses> counts = {};
  for (const uint8_t c : s.start_class) ++counts[c];
  return counts;
}

TEST(RigSample, OneSeedOneSample) {
  const RigVariant variant = {.strength = 1, .wide = true, .cells = 72, .wall = true, .specks = true};
  const RigSample one = biped().make(5, variant), same = biped().make(5, variant), other = biped().make(6, variant);
  EXPECT_EQ(one.inputs[0].rows, same.inputs[0].rows);
  EXPECT_EQ(one.start, same.start);
  EXPECT_NE(one.inputs[0].rows, other.inputs[0].rows);
}

TEST(RigSample, AShellHasTheLabelsOfItsSurface) {
  const RigSample plain = biped().make(1, {}), grown = biped().make(1, {.cells = 96});
  EXPECT_NEAR(mean_distance(grown), mean_distance(plain), 0.15 * mean_distance(plain));
  const auto before = points_of_classes(plain), after = points_of_classes(grown);
  size_t moved = 0;
  for (size_t c = 0; c < kEndClasses; ++c) moved += before[c] > after[c] ? before[c] - after[c] : after[c] - before[c];
  EXPECT_LT(moved / 2, kSetPoints * 15 / 100);
  for (const float w : grown.weight) EXPECT_GT(w, 0) << "every point has an owner";
}

TEST(RigSample, JointsOfAWidePoseStayInsideTheMesh) {
  for (uint64_t seed = 1; seed < 6; ++seed) {
    const RigSource::PosedMesh posed_mesh = biped().make_mesh(seed, {.strength = 1, .wide = true, .cells = 72});
    double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9};
    for (uint32_t v = 0; v < posed_mesh.engine.mesh.welded_count; ++v) {
      const Vec3i p = posed_mesh.engine.mesh.positions[v];
      const double at[3] = {p.x / double{kSide}, p.y / double{kSide}, p.z / double{kSide}};
      for (size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], at[i]);
        high[i] = std::max(high[i], at[i]);
      }
    }
    for (const auto& joint : posed_mesh.joints)
      for (size_t i = 0; i < 3; ++i) {
        EXPECT_GT(joint[i], low[i] - 0.02) << seed;
        EXPECT_LT(joint[i], high[i] + 0.02) << seed;
      }
  }
}

TEST(RigSample, WallsAndSpecksAddSurface) {
  const auto triangles = [](const RigVariant& variant) {
    return biped().make_mesh(3, variant).engine.corners.size() / 3;
  };
  const size_t plain = triangles({});
  EXPECT_EQ(triangles({.wall = true}), 2 * plain);
  EXPECT_GE(triangles({.specks = true}), plain + 40);
}

}  // namespace
}  // namespace sinew
