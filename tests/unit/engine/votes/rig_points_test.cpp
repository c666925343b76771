// SPDX-License-Identifier: MIT
// Points of the surface, the mirror plane, the body in voxels and what a network sees of a point.
#include "votes/rig_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "mesh_scene.hpp"

namespace {

using namespace sinew;
using namespace sinew::rigging;
using sinew_test::add_cube;
using sinew_test::cube_sphere;
using sinew_test::MeshRun;
using sinew_test::MeshScene;

// Runs a stage in a block of exactly the measured size.
template <class Stage>
struct InBlock {
  Workspace block;
  explicit InBlock(const Stage& stage) {
    Arena measuring;
    stage(measuring);
    block = Workspace(measuring.high_water());
    Arena arena(block.data(), measuring.high_water());
    stage(arena);
    EXPECT_TRUE(arena.ok());
    EXPECT_EQ(arena.high_water(), measuring.high_water());
  }
};

MeshScene with_joint(MeshScene scene) {
  if (scene.parents.empty()) scene.add_joint(0, 0, 0, -1);
  return scene;
}

TEST(SurfacePoints, LieOnTheirTrianglesEvenlyByArea) {
  MeshScene scene;  // two squares, one nine times as large
  for (const auto& [x, side] : {std::pair{0.0f, 1.0f}, {5.0f, 3.0f}}) {
    const uint32_t first = scene.vertex_count();
    scene.add_vertex(x, 0, 0);
    scene.add_vertex(x + side, 0, 0);
    scene.add_vertex(x + side, side, 0);
    scene.add_vertex(x, side, 0);
    scene.add_face({first, first + 1, first + 2, first + 3});
  }
  const MeshRun run(with_joint(scene));
  constexpr uint32_t kCount = 2000;
  std::vector<SurfacePoint> points(kCount), again(kCount), others(kCount);
  spread_points(run.mesh, kCount, 5, points.data());
  spread_points(run.mesh, kCount, 5, again.data());
  spread_points(run.mesh, kCount, 6, others.data());
  uint32_t small = 0, moved = 0;
  for (uint32_t i = 0; i < kCount; ++i) {
    const SurfacePoint& p = points[i];
    EXPECT_EQ(p.position, again[i].position);
    moved += p.position == others[i].position ? 0 : 1;
    ASSERT_LT(p.triangle, run.mesh.triangle_count);
    EXPECT_EQ(p.share[0] + p.share[1] + p.share[2], 32768);
    for (int axis = 0; axis < 3; ++axis) {
      double sum = 0;
      for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(p.corner[c], run.mesh.triangles[3 * p.triangle + static_cast<uint32_t>(c)]);
        const Vec3i v = run.mesh.positions[p.corner[c]];
        sum += (axis == 0 ? v.x : axis == 1 ? v.y : v.z) * (p.share[c] / 32768.0);
      }
      EXPECT_NEAR(axis == 0 ? p.position.x : axis == 1 ? p.position.y : p.position.z, sum, 0.51);
    }
    EXPECT_EQ(std::abs(p.normal.z), 1 << kNormalBits);
    small += run.mesh.part[p.corner[0]] == run.mesh.part[run.mesh.vertex_to_welded[0]] ? 1 : 0;
  }
  EXPECT_NEAR(small, kCount / 10, 2) << "strata hold a tenth to within a point on either side";
  EXPECT_GT(moved, kCount * 9 / 10);
}

TEST(SurfacePoints, WithoutAreaTheyAreVertices) {
  MeshScene scene;
  for (int v = 0; v < 10; ++v) scene.add_vertex(static_cast<float>(v), 0, 0);
  const MeshRun run(with_joint(scene));
  std::vector<SurfacePoint> points(30);
  spread_points(run.mesh, 30, 1, points.data());
  for (const SurfacePoint& p : points) {
    EXPECT_EQ(p.triangle, kNoTriangle);
    EXPECT_EQ(p.position, run.mesh.positions[p.corner[0]]);
    EXPECT_EQ(p.share[0], 32768);
  }
  EXPECT_EQ(points[0].corner[0], 0u);
  EXPECT_EQ(points[29].corner[0], 9u);
}

bool looks_like_a_sheet(const MeshScene& scene) {
  const MeshRun run(with_joint(scene));
  std::vector<SurfacePoint> points(kSetPoints);
  spread_points(run.mesh, kSetPoints, 1, points.data());
  return is_sheet(points.data(), kSetPoints);
}

// Two squares of side 1, `apart` from each other, with or without the rim between them, turned out of every axis' way.
MeshScene card(float apart, bool rim) {
  MeshScene scene;
  add_cube(&scene, 0, 0, 0);
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
    float* const p = scene.positions.data() + size_t{3} * v;
    const float x = p[0], y = p[1], z = p[2] * apart;
    p[0] = 0.48f * x + 0.6f * y + 0.64f * z;
    p[1] = 0.6f * x - 0.75f * y + 0.28f * z;
    p[2] = -0.64f * x - 0.28f * y + 0.715f * z;
  }
  if (!rim) {
    scene = MeshScene();
    scene.add_vertex(0, 0, 0);
    scene.add_vertex(0.6f, 0, 0.8f);
    scene.add_vertex(0, 1, 0);
    scene.add_face({0, 1, 2});
  }
  return scene;
}

TEST(SurfacePoints, CardsAndTrianglesAreSheetsAndBodiesAreNot) {
  EXPECT_TRUE(looks_like_a_sheet(card(0, false)));
  EXPECT_TRUE(looks_like_a_sheet(card(0.02f, true)));
  EXPECT_FALSE(looks_like_a_sheet(card(0.25f, true)));
  EXPECT_FALSE(looks_like_a_sheet(cube_sphere(4)));
  MeshScene line;  // no area, no normals
  line.add_vertex(0, 0, 0);
  line.add_vertex(1, 0, 0);
  EXPECT_FALSE(looks_like_a_sheet(line));
}

MirrorFrame frame_of(const MeshScene& scene, Mirroring mirroring = Mirroring::kAuto) {
  const MeshRun run(with_joint(scene));
  GridQuantizer quantizer;
  EXPECT_EQ(make_grid_quantizer(scene.positions.data(), scene.vertex_count(), 0, &quantizer), SINEW_OK);
  const float zero[3] = {0, 0, 0};
  const Vec3i middle = quantize_point(quantizer, zero);
  const int32_t middles[2] = {middle.x, middle.z};
  MirrorFrame frame;
  const auto stage = [&](Arena& arena) { (void)find_mirror_frame(run.mesh, mirroring, middles, false, arena, &frame); };
  const InBlock<decltype(stage)> done(stage);
  return frame;
}

// A body along z with legs, alike on both sides of x = 0 unless `lean` moves one.
MeshScene animal(float lean, bool turned) {
  MeshScene boxes;
  add_cube(&boxes, -0.5f, 1, -1);
  add_cube(&boxes, -0.5f, 1, 0);
  add_cube(&boxes, -0.4f, 1.6f, 1, 0.8f);
  for (const float z : {-1.0f, 0.6f}) {
    add_cube(&boxes, -0.5f, 0, z, 0.3f);
    add_cube(&boxes, 0.2f + lean, 0, z, 0.3f);
  }
  if (!turned) return boxes;
  MeshScene scene = boxes;
  for (uint32_t v = 0; v < boxes.vertex_count(); ++v) {
    scene.positions[3 * v] = boxes.positions[3 * v + 2];
    scene.positions[3 * v + 2] = -boxes.positions[3 * v];
  }
  return scene;
}

TEST(MirrorFrame, FindsThePlaneAndItsDirection) {
  MirrorFrame frame = frame_of(animal(0, false));
  EXPECT_TRUE(frame.folded);
  EXPECT_EQ(frame.quarters, 0u);
  EXPECT_EQ(frame.plane, 0);
  frame = frame_of(animal(0, true));
  EXPECT_TRUE(frame.folded);
  EXPECT_EQ(frame.quarters, 1u);
  frame = frame_of(animal(1.5f, false));
  EXPECT_FALSE(frame.folded) << frame.error;
  EXPECT_FALSE(frame_of(animal(0, false), Mirroring::kNever).folded);
  EXPECT_TRUE(frame_of(animal(1.5f, false), Mirroring::kAlways).folded);
}

TEST(MirrorFrame, ToAndFromAreInverse) {
  std::mt19937 random(2);
  for (uint32_t quarters = 0; quarters < 4; ++quarters) {
    MirrorFrame frame;
    frame.quarters = quarters;
    frame.plane = 12345;
    for (int i = 0; i < 100; ++i) {
      const auto draw = [&] { return static_cast<int32_t>(random() % 2000001) - 1000000; };
      const Vec3i p = {draw(), draw(), draw()};
      EXPECT_EQ(frame.from(frame.to(p)), p);
    }
    const Vec3i on_plane = frame.turned() ? Vec3i{5, 6, 12345} : Vec3i{12345, 6, 7};
    EXPECT_EQ(frame.to(on_plane).x, 0);
  }
}

struct Body {
  MeshRun run;
  Interior interior;
  PointSet set;
  Workspace block;
  explicit Body(const MeshScene& scene, uint64_t seed = 7) : run(with_joint(scene)) {
    const auto stage = [&](Arena& arena) {
      (void)interior.allocate(arena);
      (void)set.allocate(arena);
      (void)build_interior(run.mesh, arena, &interior);
      (void)make_point_set(run.mesh, interior, seed, arena, &set);
    };
    InBlock<decltype(stage)> done(stage);
    block = std::move(done.block);
  }
};

TEST(Interior, ASphereIsDeepInItsMiddleAndWaysGrowFromThere) {
  const Body body(cube_sphere(16));
  const Interior& in = body.interior;
  const Vec3i middle = {0, kSide / 2, 0};
  const uint32_t cell = in.grid.cell_of(middle);
  EXPECT_TRUE(in.solid_at(middle));
  // 32 cells to the outside, three units each, as far as chamfer steps are right.
  EXPECT_NEAR(in.depth[cell], 3 * 32, 6);
  EXPECT_LE(in.distance[cell], 10);
  uint16_t farthest = 0;
  for (uint32_t c = 0; c < in.grid.cell_count; ++c) {
    if (in.depth[c] == 0) continue;
    ASSERT_NE(in.distance[c], kNoDistance);
    farthest = std::max(farthest, in.distance[c]);
    const Vec3i d = in.grid.center(c) - middle;
    const double straight = std::sqrt(static_cast<double>(dot(d, d))) / in.grid.cell_size;
    EXPECT_GE(in.distance[c], kDistanceUnits * (straight - 2) * 0.9);
    EXPECT_LE(in.distance[c], kDistanceUnits * (straight + 2) * 1.1 + 5);
  }
  EXPECT_GT(farthest, 5 * 28);
  EXPECT_FALSE(in.solid_at({kSide, kSide / 2, 0}));
  EXPECT_FALSE(in.solid_at({0, -kSide / 4, 0}));
  // From the middle the surface is 64 half cells away, whatever the direction.
  for (const Vec3i d : {Vec3i{1 << 14, 0, 0}, Vec3i{0, -(1 << 14), 0}, Vec3i{9459, 9459, 9459}})
    EXPECT_NEAR(in.march(middle, d, 1000), 64, 3);
  EXPECT_EQ(in.march(middle, {1 << 14, 0, 0}, 10), 10u);
}

TEST(RigPoints, OnASphereTheyLookInwardAndKnowTheirMiddle) {
  const Body body(cube_sphere(16));
  const PointSet& set = body.set;
  for (uint32_t i = 0; i < kSetPoints; ++i) {
    const int16_t* const row = set.features + size_t{i} * kRigChannels;
    const Vec3i p = set.points[i].position, m = set.medial[i];
    const Vec3i out = p - Vec3i{0, kSide / 2, 0};
    EXPECT_GT(dot(set.points[i].normal, out), 0);
    EXPECT_LT(std::sqrt(static_cast<double>(dot(m - Vec3i{0, kSide / 2, 0}, m - Vec3i{0, kSide / 2, 0}))),
              0.14 * kSide);
    EXPECT_NEAR(row[kRigPosition], std::abs(p.x) * 2.0 / kSide * 8192, 1);
    EXPECT_NEAR(row[kRigPosition + 1], std::min(16383.0, p.y * 2.0 / kSide * 8192), 1);
    EXPECT_NEAR(row[kRigThickness], 16383, 4000) << "4 t, cut at 2";
    EXPECT_GT(row[kRigDepth], 8192);
    EXPECT_EQ(row[kRigBody], set.features[kRigBody]);
    EXPECT_NEAR(row[kRigBody], 1.5 * 8192, 300);
  }
}

TEST(RigPoints, BothSidesOfASymmetricBodyLookTheSame) {
  // Each point's image, made by hand, has the same features but for the sign of x, which is folded away.
  MeshScene scene = animal(0, false), image = scene;
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) image.positions[3 * v] = -scene.positions[3 * v];
  for (size_t f = 0; f + 1 < image.offsets.size(); ++f)
    std::reverse(image.corners.begin() + image.offsets[f], image.corners.begin() + image.offsets[f + 1]);
  const Body a(scene), b(image);
  ASSERT_EQ(a.run.mesh.triangle_count, b.run.mesh.triangle_count);
  // The triangles are other ones in another order, so points differ: compare what holds for all of a set.
  for (uint32_t c = kRigBody; c < kRigBody + 6; ++c) EXPECT_NEAR(a.set.features[c], b.set.features[c], 250) << c;
}

TEST(RigPoints, NeighborsAreTheNearestByPlaceAndMedialPoint) {
  const Body body(animal(0.4f, false), 3);
  const PointSet& set = body.set;
  for (uint32_t i = 0; i < kSetPoints; i += 7) {
    std::vector<std::pair<int64_t, uint32_t>> order;
    for (uint32_t j = 0; j < kSetPoints; ++j) {
      const Vec3i a = set.points[i].position - set.points[j].position, b = set.medial[i] - set.medial[j];
      order.emplace_back(dot(a, a) + dot(b, b), j);
    }
    std::sort(order.begin(), order.end());
    if (order[0].second != i || order[1].first == 0) continue;  // two points at one position
    for (uint32_t k = 0; k < kNeighbors; ++k) {
      EXPECT_EQ(set.near_neighbors[i * kNeighbors + k], order[k + 1].second);
      EXPECT_EQ(set.far_neighbors[i * kNeighbors + k], order[(k + 1) * kFarStep].second);
    }
  }
}

}  // namespace
