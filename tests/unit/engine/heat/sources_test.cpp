// SPDX-License-Identifier: MIT
// Nearest bones with ties, what is visible of them, the visibility rule, and the strength of a source.
#include "heat/sources.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "heat_sources.hpp"

namespace {

using namespace sinew;
using sinew_test::HeatRun;
using sinew_test::HeatScene;
using sinew_test::Sources;

TEST(Sources, BonesThatShareTheNearestPointShareTheVertex) {
  // A chain of three joints: vertices level with the middle joint are nearest to the end of one bone and the start of
  // the next.
  HeatScene scene = sinew_test::capsule(31, 12, 0);
  scene.add_joint(0, 1, 0, -1);
  scene.add_joint(0, 2, 0, 0);
  scene.add_joint(0, 3, 0, 1);
  const HeatRun run(scene, false);
  ASSERT_EQ(run.status, SINEW_OK);
  const Sources sources(run);
  int shared = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    if (std::abs(run.mesh.positions[v].y - kSide / 2) > 2) continue;
    EXPECT_EQ(sources.of(kFieldRule, v), (std::set<uint32_t>{0, 1}));
    EXPECT_EQ(sources.of(kFieldSoft, v), (std::set<uint32_t>{0, 1}));
    EXPECT_EQ(sources.found.nearest[1][v], 0u);
    ++shared;
  }
  EXPECT_EQ(shared, 12);
}

TEST(Sources, NearestAndNearestVisibleOfManyBones) {
  const HeatRun run(sinew_test::tangle(400, 220, 60, 5), false);
  ASSERT_EQ(run.status, SINEW_OK);
  const Sources sources(run);
  size_t visible = 0, second = 0, seen_otherwise = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    const Vec3i at = run.mesh.positions[v], normal = run.mesh.normals[v];
    double smallest = 1e30, cosine = 1e30, seen = 1e30;
    for (uint32_t j = 0; j < run.counts.joints; ++j) {
      if (run.source_joints[j] == 0) continue;
      const Vec3i head = run.skeleton.positions[j], along = run.skeleton.bone_tail[j] - head, from = at - head;
      const double t = static_cast<double>(dot(from, along)) / std::max(1.0, static_cast<double>(dot(along, along)));
      const double share = std::min(1.0, std::max(0.0, t));
      const double x = from.x - share * along.x, y = from.y - share * along.y, z = from.z - share * along.z;
      const double euclid = std::sqrt(x * x + y * y + z * z);
      const double cos = (x * normal.x + y * normal.y + z * normal.z) / (16384 * std::max(euclid, 1e-3));
      smallest = std::min(smallest, euclid);
      cosine = std::min(cosine, euclid / (0.5 * (cos + 1.001)));
      if (euclid >= seen) continue;
      const Vec3i target = {at.x - static_cast<int32_t>(std::lround(x)), at.y - static_cast<int32_t>(std::lround(y)),
                            at.z - static_cast<int32_t>(std::lround(z))};
      bool hidden = false;
      for (uint32_t i = 0; i < run.mesh.triangle_count && !hidden; ++i) {
        const uint32_t* c = run.mesh.triangles + 3 * i;
        hidden =
            run.mesh.part[c[0]] == run.mesh.part[v] && c[0] != v && c[1] != v && c[2] != v &&
            crosses_front(at, target, run.mesh.positions[c[0]], run.mesh.positions[c[1]], run.mesh.positions[c[2]]);
      }
      if (!hidden) seen = euclid;
    }
    EXPECT_NEAR(static_cast<double>(sources.found.distance[0][v]) / 64, cosine, 2 + cosine / 1000) << v;
    const double soft = static_cast<double>(sources.found.distance[1][v]) / 64;
    EXPECT_GT(soft, smallest - 2) << v;
    if (seen == 1e30) continue;
    ++visible;
    second += seen > 1.1 * smallest;
    seen_otherwise += std::abs(soft - seen) > 2;  // rays along the edge of a triangle
  }
  EXPECT_GT(visible, 200u);
  EXPECT_GT(second, 50u);
  EXPECT_LT(seen_otherwise, 4u);
}

TEST(Sources, StrengthFallsWithTheSquareOfTheDistance) {
  const int64_t near = source_pull_q40(1000000, 100000 << kDistanceBits, kFieldRule);
  EXPECT_NEAR(static_cast<double>(near), 4 * 1e6 / 1e10 * std::pow(2.0, 40), 2);
  EXPECT_NEAR(static_cast<double>(source_pull_q40(1000000, 200000 << kDistanceBits, kFieldRule)),
              static_cast<double>(near) / 4, 2);
  EXPECT_NEAR(static_cast<double>(source_pull_q40(1000000, 100000 << kDistanceBits, kFieldSoft)),
              static_cast<double>(near) * 0.175, 2);
  EXPECT_EQ(source_pull_q40(1000000, 0, kFieldRule), source_pull_q40(1000000, kMinDistance, kFieldRule));
  EXPECT_GE(source_pull_q40(0, int64_t{1} << 41, kFieldSoft), 1);
  EXPECT_LE(source_pull_q40(~uint64_t{0}, 0, kFieldRule), int64_t{1} << 62);
}

// One closed shell far inside another: the inner one's faces look outwards, against anyone who comes from outside.
HeatScene nested_shells() {
  HeatScene scene = sinew_test::capsule(20, 16, 0);
  scene.add_joint(0, 0.6, 0, -1);
  scene.add_joint(0, 3.0, 0, 0);
  sinew_test::add_revolved(
      &scene, 8, 8, [](uint32_t i) { return 0.2 + 3.6 * i / 7; }, [](uint32_t, double) { return 0.15; }, 0.15, 3.85);
  return scene;
}

TEST(Sources, RuleFallsBackToPartsWhereAnotherPartHides) {
  const HeatRun run(nested_shells());
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_EQ(run.mesh.part_count, 2u);
  EXPECT_EQ(run.fields.part_rule[0], 1);  // the outer shell: the inner one hides the bones
  EXPECT_EQ(run.fields.part_rule[1], 0);  // the inner shell sees them
}

TEST(Sources, ALoneBoneOwnsEverything) {
  HeatScene scene;
  for (const double x : {0.0, 1.0}) {  // two parallel square plates with the bone between them
    const uint32_t first = scene.vertex_count();
    for (const double y : {0.0, 1.0}) {
      for (const double z : {0.0, 1.0}) scene.add_vertex(x, y, z);
    }
    scene.add_triangle(first, first + 1, first + 2);
    scene.add_triangle(first + 1, first + 3, first + 2);
  }
  scene.add_joint(0.5, 0.5, 0.5, -1);
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  for (uint32_t c = 0; c < run.mesh.part_count; ++c)
    EXPECT_EQ(run.fields.part_rule[c], 0);  // a flat plate hides nothing from its own corners
  for (uint32_t f = 0; f < kFieldCount; ++f) {
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) EXPECT_EQ(run.weight(f, v, 0), 1.0);
  }
}

TEST(Sources, InsideOutBodiesSeeWhatTheirTwinsSee) {
  HeatScene scene = sinew_test::capsule(12, 12, 0);
  scene.add_joint(6, 1, 0, -1);
  scene.add_joint(6, 3, 0, 0);
  HeatScene inside_out = scene;
  for (size_t i = 0; i < scene.triangles.size(); i += 3)
    std::swap(inside_out.triangles[i], inside_out.triangles[i + 1]);
  const HeatRun run(scene), twin(inside_out);
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_EQ(twin.status, SINEW_OK);
  for (uint32_t f = 0; f < kFieldCount; ++f) {
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
      ASSERT_EQ(run.fields.field[f].has_source[v], twin.fields.field[f].has_source[v]) << v;
      for (uint16_t j = 0; j < 2; ++j) ASSERT_EQ(run.weight(f, v, j), twin.weight(f, v, j)) << v;
    }
  }
}

TEST(Sources, BodiesThatHideTheirOwnBonesAreOpen) {
  // The inner shell hangs on the outer one by a triangle, so it is the same part; its own few vertices alone see the
  // bones.
  HeatScene scene = sinew_test::capsule(30, 30, 0);
  const uint32_t inner = scene.vertex_count();
  sinew_test::add_revolved(
      &scene, 4, 8, [](uint32_t i) { return 0.2 + 3.6 * i / 3; }, [](uint32_t, double) { return 0.25; }, 0.15, 3.85);
  scene.add_triangle(0, 1, inner);
  scene.add_joint(0, 0.6, 0, -1);
  scene.add_joint(0, 3.0, 0, 0);
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_EQ(run.mesh.part_count, 1u);
  EXPECT_EQ(run.fields.part_rule[0], 2);
  size_t seen = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    EXPECT_EQ(run.fields.field[kFieldRule].has_source[v], 1);
    seen += run.fields.field[kFieldParts].has_source[v];
  }
  EXPECT_GT(seen, 0u);
  EXPECT_LT(seen, run.mesh.welded_count / 10);
}

}  // namespace
