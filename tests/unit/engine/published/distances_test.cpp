// SPDX-License-Identifier: MIT
// Weights by distance: the formula on a tube's chain of bones, and where they stop.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "heat/heat.hpp"
#include "heat_scene.hpp"
#include "sinew/published.h"
#include "sinew/sinew.hpp"

namespace {

using sinew_test::HeatScene;

constexpr uint32_t kJoints = 5, kInfluences = 12;

// A row as weights of all joints.
std::vector<double> weights_of(const HeatScene& scene, uint32_t vertex) {
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.method = SINEW_METHOD_DISTANCE;
  options.influence_count = kInfluences;
  const sinew_mesh mesh = scene.mesh_view();
  const sinew_skeleton skeleton = scene.skeleton_view();
  size_t bytes = 0;
  EXPECT_EQ(sinew_bind_workspace_size(nullptr, mesh.vertex_count, mesh.face_count, mesh.corner_count, kJoints, &options,
                                      &bytes),
            SINEW_OK);
  sinew::Workspace block(bytes);
  std::vector<uint16_t> joints(size_t{kInfluences} * mesh.vertex_count), weights(joints.size());
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = joints.data();
  outputs.weights = weights.data();
  EXPECT_EQ(sinew_bind(nullptr, &mesh, &skeleton, &options, block.data(), block.size(), &outputs), SINEW_OK);
  std::vector<double> row(kJoints, 0);
  for (uint32_t i = 0; i < kInfluences; ++i)
    row[joints[kInfluences * vertex + i]] += weights[kInfluences * vertex + i] / 65535.0;
  return row;
}

TEST(Distances, TheInverseSquareAmongABoneAndThoseBesideIt) {
  const HeatScene scene = sinew_test::capsule(40, 12, kJoints);
  for (const uint32_t vertex : {5u, 170u, 230u, 400u}) {
    const double y = double{scene.positions[3 * vertex + 1]},
                 side = std::hypot(double{scene.positions[3 * vertex]}, double{scene.positions[3 * vertex + 2]});
    // Bone j from joint j to the next one; the last one's goes on by half of that, at most a tenth of the skeleton's 3.4.
    std::vector<double> square(kJoints);
    for (uint32_t j = 0; j < kJoints; ++j) {
      const double head = 0.3 + 0.85 * j, tail = head + (j + 1 < kJoints ? 0.85 : 0.34);
      const double off = std::max({head - y, 0.0, y - tail});
      square[j] = side * side + off * off;
    }
    const uint32_t own = static_cast<uint32_t>(std::min_element(square.begin(), square.end()) - square.begin());
    double sum = 0;
    std::vector<double> expected(kJoints, 0);
    for (uint32_t j = own > 0 ? own - 1 : 0; j <= std::min(own + 1, kJoints - 1); ++j)
      sum += expected[j] = 1 / square[j];
    const std::vector<double> found = weights_of(scene, vertex);
    for (uint32_t j = 0; j < kJoints; ++j) {
      // Weights below 0.025 are cut and below 0.05 ramped, as those of heat are.
      if (expected[j] / sum < 0.05 && expected[j] > 0) continue;
      EXPECT_NEAR(found[j], expected[j] / sum, 0.06) << vertex << ' ' << j;
    }
    EXPECT_NEAR(found[own] / *std::max_element(found.begin(), found.end()), 1, 1e-6);
  }
}

}  // namespace
