// SPDX-License-Identifier: MIT
// The spectral stage: what it is invariant to, meshes at the edge of what is legal, and its small dense problems.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "spectral/eigenpairs.hpp"
#include "spectral/signatures.hpp"
#include "spectral_scene.hpp"

namespace {

using namespace sinew;
using sinew_test::MeshScene;
using sinew_test::SpectralRun;

// A lumpy closed body with an open cloth sheet beside it: two parts, one with a boundary.
MeshScene body() {
  MeshScene scene = sinew_test::cube_sphere(12);
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
    float* p = &scene.positions[3 * v];
    const float stretch = 1.0f + 0.6f * p[1] + 0.35f * p[0] * p[2];
    p[0] *= stretch;
    p[1] *= 2.5f;
    p[2] *= 0.7f * stretch;
  }
  const uint32_t first = scene.vertex_count();
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 7; ++j)
      scene.add_vertex(3 + 0.3f * static_cast<float>(i), 0.25f * static_cast<float>(j),
                       0.02f * static_cast<float>(i * j));
  }
  const auto at = [&](int i, int j) { return first + static_cast<uint32_t>(i * 7 + j); };
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 6; ++j) scene.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  return scene;
}

double largest_difference(const SpectralRun& a, const SpectralRun& b, uint32_t vertices) {
  double worst = 0;
  for (uint32_t v = 0; v < vertices; ++v) {
    for (uint32_t i = 0; i < kSpectralChannels; ++i) worst = std::max(worst, std::fabs(a.at(v, i) - b.at(v, i)));
  }
  return worst;
}

TEST(Spectral, NumberingOfVerticesAndFacesDoesNotMatter) {
  const MeshScene scene = body();
  std::vector<uint32_t> order(scene.vertex_count()), new_index(scene.vertex_count());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  for (uint32_t i = 0; i < order.size(); ++i) new_index[order[i]] = i;
  MeshScene other;
  for (uint32_t v : order)
    other.add_vertex(scene.positions[3 * v], scene.positions[3 * v + 1], scene.positions[3 * v + 2]);
  for (size_t f = scene.offsets.size() - 1; f-- > 0;) {
    std::vector<uint32_t> face;
    for (uint32_t c = scene.offsets[f]; c < scene.offsets[f + 1]; ++c) face.push_back(new_index[scene.corners[c]]);
    other.add_face(face);
  }
  other.add_joint(0, 0, 0, -1);
  const SpectralRun a(scene), b(other);
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
    for (uint32_t i = 0; i < kSpectralChannels; ++i) ASSERT_EQ(a.at(v, i), b.at(new_index[v], i)) << v << " " << i;
  }
}

TEST(Spectral, SeamsDoNotMatter) {
  const MeshScene scene = body();
  MeshScene split = scene;
  split.positions.clear();
  split.corners.clear();
  std::vector<uint32_t> origin;
  for (uint32_t v : scene.corners) {  // every corner its own vertex
    split.corners.push_back(
        split.add_vertex(scene.positions[3 * v], scene.positions[3 * v + 1], scene.positions[3 * v + 2]));
    origin.push_back(v);
  }
  const SpectralRun a(scene), b(split);
  for (uint32_t c = 0; c < origin.size(); ++c) {
    for (uint32_t i = 0; i < kSpectralChannels; ++i) ASSERT_EQ(a.at(origin[c], i), b.at(c, i));
  }
}

TEST(Spectral, PlaceAndSizeDoNotMatterAndTurningHardly) {
  const MeshScene scene = body();
  const SpectralRun original(scene);
  const auto changed = [&](auto&& change) {
    MeshScene other = scene;
    for (uint32_t v = 0; v < other.vertex_count(); ++v) change(&other.positions[3 * v]);
    return largest_difference(original, SpectralRun(other), other.vertex_count());
  };
  const auto scaled = [&](float s) {
    return changed([s](float* p) {
      for (int i = 0; i < 3; ++i) p[i] *= s;
    });
  };
  EXPECT_EQ(scaled(64.0f), 0);
  // What is left is a last digit of the grid here and there.
  EXPECT_LE(scaled(0.37f), 0.01);
  EXPECT_LE(changed([](float* p) {
              p[0] += 17.0f;
              p[1] -= 3.0f;
            }),
            0.01);
  EXPECT_LE(changed([](float* p) {
              const float x = p[0], z = p[2];
              p[0] = 0.8f * x + 0.6f * z;
              p[2] = -0.6f * x + 0.8f * z;
            }),
            0.3);
}

TEST(Spectral, PartsDoNotSeeEachOther) {
  const MeshScene scene = body();
  MeshScene twice = scene;
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
    twice.add_vertex(scene.positions[3 * v], scene.positions[3 * v + 1] + 8.0f, scene.positions[3 * v + 2]);
  }
  for (size_t f = 0; f + 1 < scene.offsets.size(); ++f) {
    std::vector<uint32_t> face;
    for (uint32_t c = scene.offsets[f]; c < scene.offsets[f + 1]; ++c)
      face.push_back(scene.corners[c] + scene.vertex_count());
    twice.add_face(face);
  }
  // On a coarser grid and cut differently into runs and separators: a small difference is left.
  EXPECT_LE(largest_difference(SpectralRun(scene), SpectralRun(twice), scene.vertex_count()), 0.25);
}

TEST(Spectral, ASphereIsTheSameEverywhere) {
  const MeshScene scene = sinew_test::cube_sphere(16);
  const SpectralRun run(scene);
  for (uint32_t i = 0; i < kHeatKernelTimes; ++i) {
    double low = 100, high = -100;
    for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
      low = std::min(low, run.at(v, i));
      high = std::max(high, run.at(v, i));
    }
    EXPECT_LE(high - low, 0.2) << i;
    // l (l + 1) / 1 on the unit sphere, area 4 pi: lambda = l (l + 1), each 2 l + 1 times.
    double expected = 0;
    for (int l = 0; l < 40; ++l) expected += (2 * l + 1) * std::exp(-l * (l + 1) * std::exp2(-3 + 1.5 * i));
    EXPECT_NEAR((low + high) / 2, std::log2(expected), 0.1) << i;
  }
}

TEST(Spectral, LegalButOdd) {
  const auto values = [](const MeshScene& scene, uint32_t vertex) {
    const SpectralRun run(scene);
    EXPECT_EQ(run.status, SINEW_OK);
    std::vector<double> row;
    for (uint32_t i = 0; i < kSpectralChannels; ++i) row.push_back(run.at(vertex, i));
    return row;
  };
  std::vector<double> alone(kSpectralChannels, 0.0);
  std::fill(alone.begin() + 12, alone.end(), -8.0);

  MeshScene one;
  one.add_vertex(1, 2, 3);
  one.add_joint(0, 0, 0, -1);
  EXPECT_EQ(values(one, 0), alone);
  for (int i = 0; i < 5; ++i) one.add_vertex(static_cast<float>(i), 0, 0);
  EXPECT_EQ(values(one, 3), alone) << "no faces";

  MeshScene isolated = body();
  const uint32_t extra = isolated.add_vertex(0, 9, 0);
  EXPECT_EQ(values(isolated, extra), alone);

  MeshScene triangle;
  triangle.add_vertex(0, 0, 0);
  triangle.add_vertex(1, 0, 0);
  triangle.add_vertex(0, 1, 0);
  triangle.add_face({0, 1, 2});
  triangle.add_joint(0, 0, 0, -1);
  EXPECT_GT(values(triangle, 0)[0], 0.0);

  MeshScene fan;  // eleven faces at one edge, and one that is folded back on it
  fan.add_vertex(0, 0, 0);
  fan.add_vertex(0, 1, 0);
  for (int i = 0; i < 11; ++i) {
    const float angle = 0.57f * static_cast<float>(i);
    const uint32_t v = fan.add_vertex(std::cos(angle), 0.3f, std::sin(angle));
    fan.add_face({0, 1, v});
  }
  fan.add_joint(0, 0, 0, -1);
  EXPECT_GT(values(fan, 5)[0], 0.0);

  MeshScene needles = body();  // triangles of no width to speak of
  for (uint32_t i = 0; i < 60; ++i) {
    const uint32_t v = needles.add_vertex(needles.positions[3 * i] + 1e-5f, needles.positions[3 * i + 1], 30.0f);
    needles.add_face({i, i + 1, v});
  }
  EXPECT_EQ(SpectralRun(needles).status, SINEW_OK);
}

// Faces between random vertices, no surface: the factor does not fit.
TEST(Spectral, Tangle) {
  MeshScene scene;
  std::mt19937 random(3);
  const auto unit = [&] { return static_cast<float>(random() >> 8) / 16777216.0f; };
  for (int v = 0; v < 1500; ++v) {
    const float x = unit(), y = unit(), z = unit();
    scene.add_vertex(x, y, z);
  }
  for (int t = 0; t < 6000; ++t) {
    std::vector<uint32_t> face;
    for (int k = 0; k < 3; ++k) face.push_back(static_cast<uint32_t>(random() % 1500));
    scene.add_face(face);
  }
  scene.add_joint(0, 0, 0, -1);
  const SpectralRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  for (uint32_t i = 0; i < kSpectralChannels; ++i) EXPECT_EQ(run.at(7, i), i < 12 ? 0.0 : -8.0);
}

TEST(Spectral, WorkspaceAndCanceling) {
  const MeshScene scene = body();
  EXPECT_EQ(SpectralRun(scene, 64).status, SINEW_ERROR_WORKSPACE);
  const SpectralRun a(scene), b(scene, 0, {}, 0x5A);
  EXPECT_EQ(a.rows, b.rows) << "what lies in the workspace beforehand must not matter";
  Progress stop;
  stop.callback = [](void*, uint32_t) { return 1; };
  EXPECT_EQ(SpectralRun(scene, 0, stop).status, SINEW_ERROR_CANCELLED);
}

TEST(SymmetricEigenpairs, RebuildTheMatrix) {
  std::mt19937 random(9);
  const uint32_t n = 40;
  static int64_t matrix[kSpectralModes][kSpectralModes], original[kSpectralModes][kSpectralModes],
      vectors[kSpectralModes][kSpectralModes];
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = 0; j <= i; ++j) {
      const int64_t value = static_cast<int64_t>(random() % (1u << 26)) - (1 << 25);
      original[i][j] = original[j][i] = matrix[i][j] = matrix[j][i] = i == j ? 8 * value : value;
    }
  }
  symmetric_eigenpairs(matrix, vectors, n);
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = 0; j < n; ++j) {
      double sum = 0, dot = 0;
      for (uint32_t k = 0; k < n; ++k) {
        sum += static_cast<double>(vectors[k][i]) * static_cast<double>(vectors[k][j]) * std::exp2(-60) *
               static_cast<double>(matrix[k][k]);
        dot += static_cast<double>(vectors[i][k]) * static_cast<double>(vectors[j][k]) * std::exp2(-60);
      }
      EXPECT_NEAR(sum, static_cast<double>(original[i][j]), 2000) << i << " " << j;  // of 2^31
      EXPECT_NEAR(dot, i == j ? 1 : 0, 1e-6);
    }
  }
}

}  // namespace
