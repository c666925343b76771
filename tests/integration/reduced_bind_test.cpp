// SPDX-License-Identifier: MIT
// sinew_bind() on a reduced surface: close to the bind without it, in bounded memory, with every option.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bound_scene.hpp"
#include "lent_threads.hpp"

namespace {

using sinew_test::HeatScene;

using Bound = sinew_test::BoundScene;
using sinew_test::bind_scene;

sinew_bind_options with_surface(uint32_t vertices, uint32_t method = SINEW_METHOD_MODEL) {
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.grid_size = 32;
  options.method = method;
  options.surface_vertices = vertices;
  return options;
}

// Mean over vertices of the sum of absolute differences, weights from 0 to 1.
double mean_l1(const Bound& a, const Bound& b) {
  double sum = 0;
  for (size_t first = 0; first < a.joints.size(); first += 4) {
    int64_t row[64] = {};
    for (size_t i = first; i < first + 4; ++i) {
      row[a.joints[i]] += a.weights[i];
      row[b.joints[i]] -= b.weights[i];
    }
    for (const int64_t difference : row) sum += static_cast<double>(std::abs(difference)) / 65535;
  }
  return sum / (static_cast<double>(a.joints.size()) / 4);
}

class ReducedBind : public ::testing::TestWithParam<uint32_t> {};

TEST_P(ReducedBind, IsCloseToTheWholeMesh) {
  const HeatScene scene = sinew_test::star(90, 100, 4);
  const Bound whole = bind_scene(scene, with_surface(SINEW_MAX_VERTICES, GetParam()));
  const Bound reduced = bind_scene(scene, with_surface(3000, GetParam()));
  ASSERT_EQ(whole.status, SINEW_OK);
  ASSERT_EQ(reduced.status, SINEW_OK);
  const double moved = mean_l1(whole, reduced);
  RecordProperty("mean_l1", std::to_string(moved));
  EXPECT_GT(moved, 0) << "nothing was reduced";
  // What decimation moves: the network sees another resolution, heat hardly minds (trainer/configs/RESULTS.md, robustness).
  EXPECT_LT(moved, GetParam() == SINEW_METHOD_HEAT ? 0.04 : 0.16);
  EXPECT_LT(reduced.bytes, whole.bytes / 2);
  EXPECT_LE(reduced.used, reduced.bytes);
  double certainty[2] = {0, 0};
  for (size_t v = 0; v < whole.confidence.size(); ++v) {
    certainty[0] += whole.confidence[v];
    certainty[1] += reduced.confidence[v];
  }
  EXPECT_NEAR(certainty[1] / certainty[0], 1, 0.05);
}
INSTANTIATE_TEST_SUITE_P(Methods, ReducedBind, ::testing::Values(SINEW_METHOD_MODEL, SINEW_METHOD_HEAT));

TEST(ReducedBindOptions, HintsPartsAndSymmetryActOnTheWholeMesh) {
  const HeatScene scene = sinew_test::capsule(60, 60, 4);
  std::vector<uint8_t> hints(scene.vertex_count(), 0);
  for (size_t v = 0; v < hints.size(); v += 50) hints[v] = 1;
  sinew_bind_options options = with_surface(500);
  options.hints = hints.data();
  const Bound hinted = bind_scene(scene, options);
  ASSERT_EQ(hinted.status, SINEW_OK);
  for (size_t v = 0; v < hints.size(); v += 50) {
    EXPECT_EQ(hinted.joints[4 * v], sinew_test::hinted_joint(scene, static_cast<uint32_t>(v)));
    EXPECT_EQ(hinted.weights[4 * v], 65535);
    EXPECT_EQ(hinted.confidence[v], 255);
  }
  EXPECT_GT(mean_l1(hinted, bind_scene(scene, with_surface(500))), 0.1) << "hints steer";

  options = with_surface(500);
  options.rigid_parts = SINEW_RIGID_PARTS_ALWAYS;
  const Bound rigid = bind_scene(scene, options);
  ASSERT_EQ(rigid.status, SINEW_OK);
  for (size_t row = 4; row < rigid.joints.size(); row += 4) {
    EXPECT_EQ(rigid.joints[row], rigid.joints[0]);
    EXPECT_EQ(rigid.weights[row], 65535);
  }

  options = with_surface(500);
  options.symmetric = 1;
  const Bound symmetric = bind_scene(scene, options);
  ASSERT_EQ(symmetric.status, SINEW_OK);
  EXPECT_EQ(symmetric.symmetric_vertices, scene.vertex_count());
  for (uint32_t ring = 0; ring < 60; ++ring) {  // segment s at angle 2 pi s / 60: its mirror image in x is 30 - s
    for (uint32_t s = 0; s < 60; ++s) {
      const size_t a = 4 * size_t{ring * 60 + s}, b = 4 * size_t{ring * 60 + (90 - s) % 60};
      for (size_t i = 0; i < 4 && s != (90 - s) % 60; ++i) {
        EXPECT_EQ(symmetric.joints[a + i], symmetric.joints[b + i]);
        EXPECT_EQ(symmetric.weights[a + i], symmetric.weights[b + i]);
      }
    }
  }
}

TEST(ReducedBindOptions, TheSameBytesForAllKernelsAndThreads) {
  const HeatScene scene = sinew_test::star(40, 50, 4);
  sinew_bind_options options = with_surface(600);
  options.kernel = SINEW_KERNEL_REF;
  const Bound reference = bind_scene(scene, options);
  ASSERT_EQ(reference.status, SINEW_OK);
  options.kernel = SINEW_KERNEL_AUTO;
  sinew_test::LoopLog log;
  options.parallel_for = sinew_test::run_on_threads;
  options.parallel_user = &log;
  for (const uint32_t threads : {1u, 2u, 7u}) {
    options.thread_count = threads;
    const Bound bound = bind_scene(scene, options);
    ASSERT_EQ(bound.status, SINEW_OK);
    EXPECT_EQ(bound.joints, reference.joints);
    EXPECT_EQ(bound.weights, reference.weights);
    EXPECT_EQ(bound.confidence, reference.confidence);
  }
}

// What a mesh of some size asks for is enough for every smaller one, also across the limit.
TEST(ReducedBindOptions, WorkspaceNeverFalls) {
  size_t before = 0;
  for (uint32_t vertices = 900; vertices < 1100; vertices += 7) {
    size_t bytes = 0;
    const sinew_bind_options options = with_surface(1000);
    ASSERT_EQ(sinew_bind_workspace_size(bundled_model(), vertices, 2 * vertices, 6 * vertices, 20, &options, &bytes),
              SINEW_OK);
    EXPECT_GE(bytes, before) << vertices;
    before = bytes;
  }
  for (uint32_t faces = 1000; faces < 9000; faces += 500) {
    size_t bytes = 0;
    const sinew_bind_options options = with_surface(1000);
    ASSERT_EQ(sinew_bind_workspace_size(bundled_model(), 1100, faces, 3 * faces, 20, &options, &bytes), SINEW_OK);
    if (faces > 1000) {
      EXPECT_GE(bytes, before) << faces;
    }
    before = bytes;
  }
}

TEST(ReducedBindOptions, RefusesLimitsThatMakeNoSense) {
  const HeatScene scene = sinew_test::capsule(6, 6, 2);
  for (const uint32_t vertices : {1u, 15u, SINEW_MAX_VERTICES + 1}) {
    EXPECT_EQ(bind_scene(scene, with_surface(vertices)).status, SINEW_ERROR_ARGUMENT) << vertices;
  }
  EXPECT_EQ(bind_scene(scene, with_surface(16)).status, SINEW_OK);
}

}  // namespace
