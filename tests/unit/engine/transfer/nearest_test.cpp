// SPDX-License-Identifier: MIT
// The tree of triangles: it finds what a search of all of them finds, weighs how faces look, and takes points where no triangle is
// of use.
#include "transfer/nearest.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "arena_block.hpp"
#include "core/triangle.hpp"
#include "mesh_scene.hpp"

namespace sinew::transferring {
namespace {

using sinew_test::Block;
using sinew_test::MeshRun;
using sinew_test::MeshScene;

struct Searched {
  MeshRun run;
  std::vector<Vec3d> positions;
  std::vector<uint8_t> of_use;
  Block block = Block(size_t{1} << 22);
  SurfaceTree tree;

  explicit Searched(const MeshScene& scene) : run(scene), of_use(run.mesh.welded_count, 1) {
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) positions.push_back(1e-6 * to_double(run.mesh.positions[v]));
  }
  void build() {
    ASSERT_TRUE(tree.allocate(block.arena, run.counts));
    tree.build(run.mesh, positions.data(), of_use.data(), block.arena);
  }
  Vec3d point(const MatchedPoint& p) const {
    return p.shares[0] * positions[p.corners[0]] + p.shares[1] * positions[p.corners[1]] +
           p.shares[2] * positions[p.corners[2]];
  }
};

TEST(SurfaceTree, FindsWhatASearchOfAllFinds) {
  Searched s(sinew_test::cube_sphere(8));
  s.build();
  EXPECT_EQ(s.tree.item_count(), s.run.mesh.triangle_count);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> draw(-1.3, 1.3);
  for (int i = 0; i < 300; ++i) {
    const Vec3d p = {draw(random), draw(random) + 0.5, draw(random)};
    const MatchedPoint found = s.tree.nearest(p, {0, 0, 0}, Facing::kSame);
    double least = 1e300;
    for (uint32_t t = 0; t < s.run.mesh.triangle_count; ++t) {
      const uint32_t* const c = s.run.mesh.triangles + 3 * size_t{t};
      double shares[3];
      nearest_on_triangle(p, s.positions[c[0]], s.positions[c[1]], s.positions[c[2]], shares);
      least = lesser(least, length(p - (shares[0] * s.positions[c[0]] + shares[1] * s.positions[c[1]] +
                                        shares[2] * s.positions[c[2]])));
    }
    EXPECT_NEAR(found.distance, least, 1e-12);
    EXPECT_NEAR(length(p - s.point(found)), found.distance, 1e-12);
    EXPECT_NEAR(found.shares[0] + found.shares[1] + found.shares[2], 1, 1e-12);
  }
}

// Two sides of a thin plate: a normal asks for one of them, though the other is nearer.
TEST(SurfaceTree, FacesThatLookTheOtherWayCostMore) {
  MeshScene scene;
  for (const float z : {0.0f, 0.02f})
    for (const float y : {0.0f, 1.0f})
      for (const float x : {0.0f, 1.0f}) scene.add_vertex(x, y, z);
  scene.add_face({0, 2, 3, 1});  // looks to -z
  scene.add_face({4, 5, 7, 6});  // to +z
  scene.add_joint(0.5, 0.5, 0.01, -1);
  Searched s(scene);
  s.build();
  double front = s.positions[0].z, back = front;  // vertices have an order of their own
  for (const Vec3d& position : s.positions) {
    front = greater(front, position.z);
    back = lesser(back, position.z);
  }
  ASSERT_LT(back, front);
  const double between = 0.4 * front + 0.6 * back;
  const Vec3d p = {0, 0.5, between};
  EXPECT_NEAR(s.point(s.tree.nearest(p, {0, 0, 1}, Facing::kSame)).z, front, 1e-9);
  EXPECT_NEAR(s.point(s.tree.nearest(p, {0, 0, -1}, Facing::kSame)).z, back, 1e-9);
  EXPECT_NEAR(s.point(s.tree.nearest(p, {0, 0, 0}, Facing::kSame)).z, back, 1e-9);
  EXPECT_NEAR(s.tree.nearest(p, {0, 0, 1}, Facing::kSame).cosine, 1, 1e-6);
  EXPECT_GE(s.tree.nearest({0, 0.5, 2}, {0, 0, -1}, Facing::kEither).cosine, 0) << "has no sign";
}

TEST(SurfaceTree, VerticesOfNoUseAreLeftOut) {
  Searched s(sinew_test::cube_sphere(4));
  for (uint32_t v = 0; v < s.run.mesh.welded_count; ++v) s.of_use[v] = s.positions[v].x < 0.2 ? 1 : 0;
  s.build();
  const MatchedPoint found = s.tree.nearest({5, 0.5, 0}, {0, 0, 0}, Facing::kSame);
  bool any = false;
  for (const uint32_t c : found.corners) any = any || s.of_use[c] != 0;
  EXPECT_TRUE(any);

  Searched one(sinew_test::cube_sphere(4));
  for (uint8_t& use : one.of_use) use = 0;
  one.build();
  EXPECT_EQ(one.tree.item_count(), 0u);
}

TEST(SurfaceTree, AMeshWithoutTrianglesOffersItsPoints) {
  MeshScene scene;
  for (int i = 0; i < 9; ++i) scene.add_vertex(i, 0.1 * i * i, 0);
  scene.add_joint(4, 0, 0, -1);
  Searched s(scene);
  s.build();
  EXPECT_EQ(s.tree.item_count(), 9u);
  for (uint32_t v = 0; v < 9; ++v) {
    const MatchedPoint found = s.tree.nearest(s.positions[v], {0, 0, 0}, Facing::kSame);
    EXPECT_NEAR(found.distance, 0, 1e-12);
    EXPECT_NEAR(length(s.point(found) - s.positions[v]), 0, 1e-12);
  }
}

}  // namespace
}  // namespace sinew::transferring
