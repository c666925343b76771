// SPDX-License-Identifier: MIT
// The reduced surface of a fine mesh: how large it is, that it holds together, and where full vertices lie on it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "lent_threads.hpp"
#include "reduce/clusters.hpp"
#include "reduced_scene.hpp"
#include "weights/blend.hpp"

namespace {

using sinew::Mesh;
using sinew::Reduction;
using sinew_test::HeatScene;
using sinew_test::ReducedRun;

std::map<std::pair<uint32_t, uint32_t>, int> triangles_at_edges(const Mesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (uint32_t i = 0; i < mesh.triangle_count; ++i) {
    const uint32_t* t = mesh.triangles + 3 * size_t{i};
    for (int k = 0; k < 3; ++k) ++edges[std::minmax(t[k], t[(k + 1) % 3])];
  }
  return edges;
}

sinew::Vec3i point_of(const Mesh& mesh, const sinew::SurfacePosition& position) {
  double p[3] = {0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const sinew::Vec3i at = mesh.positions[position.vertices[i]];
    p[0] += at.x * (position.shares[i] / 32768.0);
    p[1] += at.y * (position.shares[i] / 32768.0);
    p[2] += at.z * (position.shares[i] / 32768.0);
  }
  return {static_cast<int32_t>(std::lround(p[0])), static_cast<int32_t>(std::lround(p[1])),
          static_cast<int32_t>(std::lround(p[2]))};
}

double distance(sinew::Vec3i a, sinew::Vec3i b) {
  const sinew::Vec3i way = a - b;
  return std::sqrt(static_cast<double>(sinew::dot(way, way)));
}

// n x n vertices in the plane z = 0, side 1.
HeatScene sheet(uint32_t n) {
  HeatScene scene;
  for (uint32_t y = 0; y < n; ++y) {
    for (uint32_t x = 0; x < n; ++x) scene.add_vertex(x / (n - 1.0), y / (n - 1.0), 0);
  }
  for (uint32_t y = 0; y + 1 < n; ++y) {
    for (uint32_t x = 0; x + 1 < n; ++x) {
      const uint32_t a = y * n + x;
      scene.add_triangle(a, a + 1, a + n + 1);
      scene.add_triangle(a, a + n + 1, a + n);
    }
  }
  scene.add_joint(0, 0, 0, -1);
  return scene;
}

TEST(Reduction, LeavesSmallMeshesAlone) {
  const HeatScene scene = sinew_test::capsule(20, 20, 3);
  const ReducedRun same(scene, scene.vertex_count());
  ASSERT_EQ(same.status, SINEW_OK);
  EXPECT_FALSE(same.counts.may_reduce());
  EXPECT_FALSE(same.reduction.active);
  const ReducedRun reduced(scene, scene.vertex_count() - 1);
  ASSERT_EQ(reduced.status, SINEW_OK);
  EXPECT_TRUE(reduced.reduction.active);
  EXPECT_LT(reduced.reduction.mesh.welded_count, scene.vertex_count());

  // As many vertices in the file, but only a few different ones.
  HeatScene seams = scene;
  for (uint32_t v = 0; v < scene.vertex_count(); ++v)
    seams.add_vertex(scene.positions[3 * v], scene.positions[3 * v + 1], scene.positions[3 * v + 2]);
  const ReducedRun welded(seams, scene.vertex_count());
  ASSERT_EQ(welded.status, SINEW_OK);
  EXPECT_TRUE(welded.counts.may_reduce());
  EXPECT_FALSE(welded.reduction.active);
}

TEST(Reduction, AClosedSurfaceStaysClosed) {
  const HeatScene scene = sinew_test::capsule(90, 80, 4);
  const ReducedRun run(scene, 600);
  ASSERT_EQ(run.status, SINEW_OK);
  const Mesh& mesh = run.reduction.mesh;
  ASSERT_TRUE(run.reduction.active);
  EXPECT_LE(mesh.welded_count, 600u);
  EXPECT_GT(mesh.welded_count, 450u) << "far fewer than were allowed";
  EXPECT_EQ(mesh.part_count, 1u);
  const auto edges = triangles_at_edges(mesh);
  for (const auto& edge : edges) EXPECT_EQ(edge.second, 2) << edge.first.first << " " << edge.first.second;
  EXPECT_EQ(
      static_cast<int>(mesh.welded_count) - static_cast<int>(edges.size()) + static_cast<int>(mesh.triangle_count), 2)
      << "Euler's formula of a sphere";
  for (uint32_t v = 1; v < mesh.welded_count; ++v) EXPECT_FALSE(mesh.positions[v] == mesh.positions[v - 1]);
}

TEST(Reduction, ClustersAreConnectedAndOfLikeSize) {
  const HeatScene scene = sinew_test::star(60, 70, 3);
  const ReducedRun run(scene, 400);
  ASSERT_EQ(run.status, SINEW_OK);
  std::vector<uint32_t> sizes(run.reduction.mesh.welded_count, 0);
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    ASSERT_LT(run.reduction.vertex[v], sizes.size());
    ++sizes[run.reduction.vertex[v]];
  }
  EXPECT_GT(*std::min_element(sizes.begin(), sizes.end()), 0u);
  const uint32_t mean = run.mesh.welded_count / static_cast<uint32_t>(sizes.size());
  EXPECT_LE(*std::max_element(sizes.begin(), sizes.end()), 6 * mean);
}

// Full vertices go back to where they were: on a plane exactly, on a body within its cluster.
TEST(Reduction, PlacesLieAtTheirVertices) {
  const ReducedRun flat(sheet(60), 200);
  ASSERT_EQ(flat.status, SINEW_OK);
  const sinew::Reduction& plane = flat.reduction;
  double farthest = 0;
  for (uint32_t v = 0; v < flat.mesh.welded_count; ++v) {
    const sinew::Vec3i at = flat.mesh.positions[v];
    const sinew::SurfacePosition position = plane.position(flat.mesh, v);
    ASSERT_EQ(position.shares[0] + position.shares[1] + position.shares[2], 32768u);
    const bool rim = std::abs(at.x) > sinew::kSide * 0.44 || std::abs(at.y - sinew::kSide / 2) > sinew::kSide * 0.44;
    if (!rim) farthest = std::max(farthest, distance(at, point_of(plane.mesh, position)));
  }
  EXPECT_LT(farthest, sinew::kSide / 2000.0);

  const ReducedRun body(sinew_test::star(60, 70, 3), 500);
  ASSERT_EQ(body.status, SINEW_OK);
  double nearer = 0, whole = 0;
  for (uint32_t v = 0; v < body.mesh.welded_count; ++v) {
    const sinew::Vec3i at = body.mesh.positions[v];
    const sinew::SurfacePosition position = body.reduction.position(body.mesh, v);
    const double own = distance(at, body.reduction.mesh.positions[body.reduction.vertex[v]]);
    const double found = distance(at, point_of(body.reduction.mesh, position));
    EXPECT_LE(found, own + 64);  // shares have 15 bits
    nearer += found;
    whole += own;
  }
  EXPECT_LT(nearer, whole / 3) << "triangles lie nearer to the surface than their corners";
}

// A tube of four vertices around is thinner than a cluster: no triangle is left, and still it is one piece.
TEST(Reduction, AThinTubeStaysOnePiece) {
  HeatScene scene;
  for (uint32_t ring = 0; ring < 600; ++ring) {
    for (uint32_t s = 0; s < 4; ++s) {
      scene.add_vertex(0.002 * std::cos(M_PI / 2 * s), ring / 100.0, 0.002 * std::sin(M_PI / 2 * s));
    }
    if (ring == 0) continue;
    for (uint32_t s = 0; s < 4; ++s) {
      const uint32_t a = 4 * ring - 4 + s, b = 4 * ring - 4 + (s + 1) % 4;
      scene.add_triangle(a, b, b + 4);
      scene.add_triangle(a, b + 4, a + 4);
    }
  }
  scene.add_joint(0, 1, 0, -1);
  const ReducedRun run(scene, 64);
  ASSERT_EQ(run.status, SINEW_OK);
  const Mesh& mesh = run.reduction.mesh;
  EXPECT_EQ(mesh.part_count, 1u);
  EXPECT_LT(mesh.triangle_count, mesh.welded_count) << "the case is gone: a chain was expected";
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    EXPECT_GT(mesh.row_offsets[v + 1], mesh.row_offsets[v]);
    EXPECT_GT(mesh.areas[v], 1u) << "a vertex without a triangle has its cluster's area";
  }
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    const sinew::Vec3i found = point_of(mesh, run.reduction.position(run.mesh, v));
    EXPECT_LT(distance(found, run.mesh.positions[v]), sinew::kSide / 64.0);
  }
}

TEST(Reduction, MorePartsThanVerticesAllowed) {
  HeatScene scene;
  for (uint32_t part = 0; part < 500; ++part) {
    const double x = part % 25, y = part / 25;
    const uint32_t a = scene.add_vertex(x, y, 0);
    scene.add_vertex(x + 0.3, y, 0.1);
    scene.add_vertex(x, y + 0.3, 0.2);
    scene.add_triangle(a, a + 1, a + 2);
  }
  scene.add_joint(0, 0, 0, -1);
  const ReducedRun run(scene, 100);
  ASSERT_EQ(run.status, SINEW_OK);
  EXPECT_LE(run.reduction.mesh.welded_count, 100u);
  EXPECT_GE(run.reduction.mesh.welded_count, 50u);
}

// A body among more hair cards than there may be vertices: the body stays a surface, cards stay whole and apart from
// it.
TEST(Reduction, ManySmallPartsLeaveRoomForTheLargeOne) {
  HeatScene scene = sinew_test::capsule(30, 30, 3);
  const uint32_t body = scene.vertex_count();
  for (uint32_t card = 0; card < 400; ++card) {
    const double x = 1 + card % 20, y = card / 20;
    const uint32_t a = scene.add_vertex(x, y, 0);
    scene.add_vertex(x + 0.1, y, 0);
    scene.add_vertex(x, y + 0.1, 0.05);
    scene.add_vertex(x + 0.1, y + 0.1, 0.05);
    scene.add_triangle(a, a + 1, a + 3);
    scene.add_triangle(a, a + 3, a + 2);
  }
  for (const uint32_t most : {1u, 2u, 3u, 16u, 240u, 500u, 540u}) {
    SCOPED_TRACE(most);
    const ReducedRun run(scene, most);
    ASSERT_EQ(run.status, SINEW_OK);
    EXPECT_LE(run.reduction.mesh.welded_count, most);
    if (most < 240) continue;
    std::set<uint32_t> of_body, of_cards;
    for (uint32_t v = 0; v < run.mesh.vertex_count; ++v) {
      const uint32_t reduced = run.reduction.vertex[run.mesh.vertex_to_welded[v]];
      (v < body ? of_body : of_cards).insert(reduced);
      if (v > body && (v - body) % 4 != 0) {
        EXPECT_EQ(reduced, run.reduction.vertex[run.mesh.vertex_to_welded[v - 1]]) << "a card was cut";
      }
    }
    EXPECT_GE(of_body.size(), most / 12);
    EXPECT_GE(of_cards.size(), most >= 540 ? 400u : most / 3);
    for (const uint32_t v : of_cards) EXPECT_EQ(of_body.count(v), 0u);
    EXPECT_GT(run.reduction.mesh.triangle_count, most / 12);
  }
}

// Every three of 40 vertices are a triangle: far more than the reduced mesh has room for.
TEST(Reduction, ASurfaceThatMeetsItselfEverywhere) {
  HeatScene scene;
  for (uint32_t v = 0; v < 40; ++v) scene.add_vertex(std::cos(v * 1.1), std::sin(v * 0.7), std::cos(v * 2.3));
  for (uint32_t a = 0; a < 40; ++a) {
    for (uint32_t b = a + 1; b < 40; ++b) {
      for (uint32_t c = b + 1; c < 40; ++c) scene.add_triangle(a, b, c);
    }
  }
  scene.add_joint(0, 0, 0, -1);
  const ReducedRun run(scene, 64);
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_TRUE(run.reduction.active) << "no more vertices than allowed, but 9,880 triangles";
  EXPECT_LE(run.reduction.mesh.triangle_count, 256u);
  EXPECT_GT(run.reduction.mesh.welded_count, 0u);
}

TEST(Reduction, TheSameForAnyNumberOfPieces) {
  const HeatScene scene = sinew_test::star(50, 60, 3);
  const ReducedRun alone(scene, 300);
  for (const uint32_t lanes : {2u, 7u}) {
    sinew_test::LoopLog log;
    const ReducedRun run(scene, 300, {lanes, sinew_test::run_backwards, &log});
    ASSERT_EQ(run.status, SINEW_OK);
    EXPECT_GT(log.loops, 0u);
    ASSERT_EQ(run.reduction.mesh.welded_count, alone.reduction.mesh.welded_count);
    EXPECT_TRUE(std::equal(run.reduction.vertex, run.reduction.vertex + run.mesh.welded_count, alone.reduction.vertex));
  }
}

TEST(RowBlend, AddsSharesAndKeepsTheLargest) {
  uint16_t joints[sinew::kRowSlots], out[sinew::kRowSlots];
  uint32_t weights[sinew::kRowSlots], sums[sinew::kRowSlots];
  sinew::RowBlend blend;
  const auto add = [&](uint16_t first, uint32_t count, uint32_t share) {
    for (uint32_t i = 0; i < sinew::kRowSlots; ++i) {
      joints[i] = i < count ? static_cast<uint16_t>(first + i) : sinew::kNoJoint;
      weights[i] = i < count ? 65536 / count : 0;
    }
    blend.add(joints, weights, share);
  };
  add(0, 16, 16384);  // 2048 each
  add(8, 16, 8192);   // 1024 each: joints 8..15 have 3072, 16..23 1024
  add(20, 1, 8192);   // joint 20: 1024 + 16384
  blend.take(out, sums);
  std::map<uint16_t, uint32_t> row;
  for (uint32_t i = 0; i < sinew::kRowSlots; ++i) row[out[i]] = sums[i];
  ASSERT_EQ(row.size(), sinew::kRowSlots);
  EXPECT_EQ(row.at(20), 17408u);
  EXPECT_EQ(row.at(8), 3072u);
  EXPECT_EQ(row.at(0), 2048u);
  EXPECT_EQ(row.at(6), 2048u);
  EXPECT_EQ(row.count(7), 0u) << "of equal ones the lower joints stay";
  EXPECT_EQ(row.count(16), 0u);
}

}  // namespace
