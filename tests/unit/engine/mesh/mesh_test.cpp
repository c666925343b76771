// SPDX-License-Identifier: MIT
// Weld, triangles, one-ring, parts, normals, areas and curvatures of the integer mesh.
#include "mesh/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/vector_math.hpp"
#include "mesh_scene.hpp"

namespace {

using sinew_test::add_cube;
using sinew_test::cube_sphere;
using sinew_test::MeshRun;
using sinew_test::MeshScene;

constexpr double kSide = sinew::kSide;

MeshScene with_joint(MeshScene scene) {
  scene.add_joint(0, 0, 0, -1);
  return scene;
}

std::vector<uint32_t> ring(const sinew::Mesh& mesh, uint32_t v) {
  return {mesh.col_indices + mesh.row_offsets[v], mesh.col_indices + mesh.row_offsets[v + 1]};
}

TEST(Mesh, WeldsEqualPositionsOnly) {
  MeshScene scene;
  add_cube(&scene, 0, 0, 0);
  add_cube(&scene, 0, 0, 0);      // all eight again
  scene.add_vertex(0, 0, 1e-7f);  // a tenth of a grid unit away
  scene.add_vertex(0, 0, 3e-6f);  // three units away, in no face
  const MeshRun run(with_joint(scene));
  ASSERT_EQ(run.status, SINEW_OK);
  EXPECT_EQ(run.mesh.vertex_count, 18u);
  EXPECT_EQ(run.mesh.welded_count, 9u);
  EXPECT_EQ(run.mesh.triangle_count, 12u);  // the second cube's faces are duplicates
  for (uint32_t v = 0; v < 8; ++v) EXPECT_EQ(run.mesh.vertex_to_welded[v], run.mesh.vertex_to_welded[v + 8]);
  EXPECT_EQ(run.mesh.vertex_to_welded[16], run.mesh.vertex_to_welded[0]);
  const uint32_t lone = run.mesh.vertex_to_welded[17];
  EXPECT_EQ(run.mesh.row_offsets[lone], run.mesh.row_offsets[lone + 1]);
  EXPECT_EQ(run.mesh.areas[lone], 0u);
  EXPECT_EQ(run.mesh.normals[lone], (sinew::Vec3i{0, 0, 0}));
  EXPECT_EQ(run.mesh.part_count, 2u);
  for (uint32_t v = 1; v < 9; ++v) EXPECT_FALSE(run.mesh.positions[v] == run.mesh.positions[v - 1]);
}

TEST(Mesh, DropsDegenerateAndDuplicateTriangles) {
  MeshScene scene;
  for (int i = 0; i < 5; ++i) scene.add_vertex(static_cast<float>(i), 0, 0);  // 0..4 on a line
  scene.add_vertex(0, 3, 0);                                                  // 5
  scene.add_vertex(2, 3, 1);                                                  // 6
  scene.add_face({0, 1, 5});
  scene.add_face({1, 5, 0});     // the same, turned
  scene.add_face({5, 1, 0});     // the same, flipped
  scene.add_face({0, 1, 2});     // zero area
  scene.add_face({0, 0, 5});     // repeated vertex
  scene.add_face({3, 6});        // an edge
  scene.add_face({1, 5, 6, 3});  // a fan of two
  const MeshRun run(with_joint(scene));
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_EQ(run.mesh.triangle_count, 3u);
  std::set<std::set<uint32_t>> sets;
  for (uint32_t t = 0; t < 3; ++t) {
    const uint32_t* c = run.mesh.triangles + 3 * t;
    EXPECT_LT(c[0], c[1]);
    EXPECT_LT(c[0], c[2]);
    if (t > 0) {
      EXPECT_TRUE(std::lexicographical_compare(c - 3, c, c, c + 3));
    }
    sets.insert({c[0], c[1], c[2]});
  }
  const auto w = [&](uint32_t v) { return run.mesh.vertex_to_welded[v]; };
  EXPECT_EQ(sets, (std::set<std::set<uint32_t>>{{w(0), w(1), w(5)}, {w(1), w(3), w(6)}, {w(1), w(6), w(5)}}));
}

TEST(Mesh, OneRingIsSymmetricSortedAndComplete) {
  MeshScene scene = cube_sphere(5);
  scene.add_face({0, 20, 40});  // and a few wild faces: edges with more than two triangles
  scene.add_face({0, 20, 41});
  const MeshRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  const sinew::Mesh& mesh = run.mesh;
  std::set<std::pair<uint32_t, uint32_t>> edges;
  for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t a = mesh.triangles[3 * t + c], b = mesh.triangles[3 * t + (c + 1) % 3];
      edges.insert({a, b});
      edges.insert({b, a});
    }
  }
  EXPECT_EQ(mesh.row_offsets[0], 0u);
  EXPECT_EQ(mesh.row_offsets[mesh.welded_count], edges.size());
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    const std::vector<uint32_t> row = ring(mesh, v);
    EXPECT_TRUE(std::is_sorted(row.begin(), row.end()));
    EXPECT_TRUE(std::adjacent_find(row.begin(), row.end()) == row.end());
    for (const uint32_t n : row) EXPECT_TRUE(edges.count({v, n})) << v << " " << n;
  }
}

TEST(Mesh, PartsFallInSizeAndTiesGoByFirstVertex) {
  MeshScene scene;
  scene.add_vertex(-5, 0, 0);  // a lone vertex
  add_cube(&scene, 0, 0, 0);
  add_cube(&scene, 3, 0, 0);
  scene.add_face({1, scene.add_vertex(0.5f, 5, 0), 2});  // makes the first cube the largest
  add_cube(&scene, 6, 0, 0);
  const MeshRun run(with_joint(scene));
  ASSERT_EQ(run.status, SINEW_OK);
  const sinew::Mesh& mesh = run.mesh;
  ASSERT_EQ(mesh.part_count, 4u);
  EXPECT_EQ(std::vector<uint32_t>(mesh.part_sizes, mesh.part_sizes + 4), (std::vector<uint32_t>{9, 8, 8, 1}));
  EXPECT_EQ(mesh.part[mesh.vertex_to_welded[0]], 3u);
  EXPECT_EQ(mesh.part[mesh.vertex_to_welded[1]], 0u);
  uint32_t at = 0;
  for (uint32_t id = 0; id < 4; ++id) {
    EXPECT_EQ(mesh.part_offsets[id], at);
    for (; at < mesh.part_offsets[id + 1]; ++at) {
      EXPECT_EQ(mesh.part[mesh.part_vertices[at]], id);
      if (at > mesh.part_offsets[id]) {
        EXPECT_GT(mesh.part_vertices[at], mesh.part_vertices[at - 1]);
      }
    }
  }
  EXPECT_EQ(at, mesh.welded_count);
  EXPECT_LT(mesh.part_vertices[mesh.part_offsets[1]], mesh.part_vertices[mesh.part_offsets[2]]);
}

TEST(Mesh, SphereHasItsNormalsAreaAndCurvature) {
  const MeshRun run(cube_sphere(24));
  ASSERT_EQ(run.status, SINEW_OK);
  const sinew::Mesh& mesh = run.mesh;
  EXPECT_EQ(mesh.part_count, 1u);
  const double radius = kSide / 2;
  double area = 0, defect = 0, mean = 0, expected_mean = 0;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    area += static_cast<double>(mesh.areas[v]);
    defect += mesh.gauss_curvature[v] / 8192.0 * M_PI;
    const sinew::Vec3i p = mesh.positions[v], n = mesh.normals[v];
    const double along = (p.x * double(n.x) + (p.y - radius) * double(n.y) + p.z * double(n.z)) / radius / 16384;
    EXPECT_GT(along, 0.998);
    // An edge of length e on a sphere drops by e^2 / 2R, so the mean drop over the mean length is about e / 2R.
    mean += mesh.mean_curvature[v] / 8192.0;
    expected_mean -= mesh.edge_length[v] / (2 * radius);
  }
  EXPECT_NEAR(area / (4 * M_PI * radius * radius), 1, 0.005);
  EXPECT_NEAR(defect, 4 * M_PI, 0.25);  // Gauss and Bonnet; the rounding of 3458 defects to 1/8192 pi allows 0.2
  EXPECT_NEAR(mean / expected_mean, 1, 0.1);
}

TEST(Mesh, CubeCornersHoldAllTheCurvature) {
  MeshScene scene;
  add_cube(&scene, 2, 3, 4);
  const MeshRun run(with_joint(scene));
  ASSERT_EQ(run.status, SINEW_OK);
  uint64_t area = 0;
  for (uint32_t v = 0; v < 8; ++v) {
    EXPECT_EQ(run.mesh.gauss_curvature[v], 4096);  // 2 pi - 3 pi / 2 = pi / 2
    EXPECT_LT(run.mesh.mean_curvature[v], -4000);
    area += run.mesh.areas[v];
  }
  EXPECT_NEAR(static_cast<double>(area) / (kSide * kSide), 6, 1e-6);
}

TEST(Mesh, PlaneIsFlatAndItsRimIsBoundary) {
  MeshScene scene;
  for (int i = 0; i < 25; ++i) scene.add_vertex(static_cast<float>(i % 5), 0, static_cast<float>(i / 5));
  for (uint32_t i = 0; i < 4; ++i) {
    for (uint32_t j = 0; j < 4; ++j) scene.add_face({5 * i + j, 5 * i + j + 5, 5 * i + j + 6, 5 * i + j + 1});
  }
  const MeshRun run(with_joint(scene));
  ASSERT_EQ(run.status, SINEW_OK);
  for (uint32_t v = 0; v < 25; ++v) {
    const uint32_t w = run.mesh.vertex_to_welded[v];
    EXPECT_EQ(run.mesh.normals[w], (sinew::Vec3i{0, 16384, 0}));
    EXPECT_EQ(run.mesh.mean_curvature[w], 0);
    EXPECT_EQ(run.mesh.gauss_curvature[w], 0);  // a corner of the rim would have a defect of 3 pi / 2
  }
}

TEST(Mesh, AFoldedCornerIsClampedAndNeverDividesByZero) {
  MeshScene scene;  // a needle: the tip's neighbors all lie one way
  scene.add_vertex(0, 100, 0);
  for (int i = 0; i < 3; ++i) scene.add_vertex(i == 1 ? 1e-4f : 0, 0, i == 2 ? 1e-4f : 0);
  scene.add_face({0, 1, 2});
  scene.add_face({0, 2, 3});
  scene.add_face({0, 3, 1});
  scene.add_face({1, 3, 2});
  for (int i = 0; i < 3; ++i) scene.add_vertex(i == 1 ? 10.0001f : 10, 0, i == 2 ? 1e-4f : 0);
  scene.add_face({4, 5, 6});  // one grid unit wide: a sixth of its cross product rounds to 0
  const MeshRun run(with_joint(scene));
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_EQ(run.mesh.triangle_count, 5u);
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    EXPECT_LE(std::abs(run.mesh.gauss_curvature[v]), 16384);
    EXPECT_LE(std::abs(run.mesh.mean_curvature[v]), 16384);
    EXPECT_GT(run.mesh.areas[v], 0u);
    EXPECT_GT(run.mesh.edge_length[v], 0u);
  }
}

TEST(Mesh, AnglesAgreeWithAtan2) {
  for (int i = 0; i <= 720; ++i) {
    const double angle = M_PI * i / 720;
    for (const double size : {1e3, 1e9, 1e17}) {
      const int64_t y = std::llround(size * std::sin(angle)), x = std::llround(size * std::cos(angle));
      const int64_t xs[3] = {x, -x, x / 7};
      int32_t angles[3];
      sinew::angles_q30(y, xs, angles);
      for (int k = 0; k < 3; ++k) {
        const double expected = std::atan2(static_cast<double>(y), static_cast<double>(xs[k])) / M_PI;
        EXPECT_NEAR(angles[k] / 1073741824.0, expected, 6e-8);
      }
    }
  }
  int32_t angles[3];
  sinew::angles_q30(0, {0, 1, -1}, angles);
  EXPECT_EQ(angles[0], 0);
  EXPECT_NEAR(angles[1], 0, 64);
  EXPECT_NEAR(angles[2], 1 << 30, 64);
}

TEST(Mesh, UnitVectorsAreUnitAtEverySize) {
  for (const int64_t size : {int64_t{1}, int64_t{7}, int64_t{1} << 20, int64_t{1} << 40, int64_t{1} << 60}) {
    const sinew::Vec3i n = sinew::unit_vector({size, -size, size}, 14);
    EXPECT_NEAR(n.x, 16384 / std::sqrt(3), 1);
    EXPECT_EQ(n.y, -n.x);
    EXPECT_NEAR(static_cast<double>(sinew::length(sinew::Vec3l{size, -size, size})) /
                    (std::sqrt(3) * static_cast<double>(size)),
                1, size == 1 ? 0.5 : 0.06);
  }
  EXPECT_EQ(sinew::unit_vector({0, 0, 0}, 14), (sinew::Vec3i{0, 0, 0}));
}

TEST(Mesh, RefusesFacesThatDoNotFit) {
  MeshScene scene;
  add_cube(&scene, 0, 0, 0);
  scene = with_joint(scene);
  const auto status = [](const MeshScene& s) { return MeshRun(s).status; };
  EXPECT_EQ(status(scene), SINEW_OK);
  MeshScene bad = scene;
  bad.corners[23] = 8;
  EXPECT_EQ(status(bad), SINEW_ERROR_INDEX);
  bad = scene;
  std::swap(bad.offsets[2], bad.offsets[3]);
  EXPECT_EQ(status(bad), SINEW_ERROR_INDEX);
  bad = scene;
  bad.offsets[0] = 1;
  EXPECT_EQ(status(bad), SINEW_ERROR_INDEX);
  bad = scene;
  bad.corners.push_back(0);
  EXPECT_EQ(status(bad), SINEW_ERROR_INDEX);
  bad = scene;
  bad.positions[5] = NAN;
  EXPECT_EQ(status(bad), SINEW_ERROR_NOT_FINITE);
  MeshScene line = scene;  // two corners more are a face to ignore; one is none
  line.corners.insert(line.corners.end(), {0, 1});
  line.offsets.push_back(line.offsets.back() + 2);
  EXPECT_EQ(status(line), SINEW_OK);
  EXPECT_EQ(MeshRun(line).mesh.triangle_count, MeshRun(scene).mesh.triangle_count);
  bad = scene;
  bad.corners.push_back(0);
  bad.offsets.push_back(bad.offsets.back() + 1);
  EXPECT_EQ(status(bad), SINEW_ERROR_INDEX);
}

TEST(Mesh, WithoutOffsetsFacesAreTriangles) {
  MeshScene scene;
  for (int i = 0; i < 4; ++i) scene.add_vertex(static_cast<float>(i % 2), static_cast<float>(i / 2), 0);
  scene.add_joint(0, 0, 0, -1);
  const uint32_t corners[6] = {0, 1, 2, 1, 3, 2};
  sinew_mesh view = scene.mesh_view();
  view.face_offsets = nullptr;
  view.face_vertices = corners;
  view.face_count = 2;
  view.corner_count = 6;
  const sinew::Counts counts{4, 2, 6, 1, 8, 64};
  alignas(64) static uint8_t block[8192];
  for (const bool whole : {true, false}) {
    if (!whole) view.corner_count = 5;
    sinew::Arena arena(block, sizeof(block));
    sinew::Mesh mesh;
    sinew::Skeleton skeleton;
    ASSERT_TRUE(mesh.allocate(arena, counts) && skeleton.allocate(arena, counts));
    EXPECT_EQ(sinew::build_mesh_and_skeleton(view, scene.skeleton_view(), 0, counts, arena, &mesh, &skeleton),
              whole ? SINEW_OK : SINEW_ERROR_INDEX);
    if (whole) {
      EXPECT_EQ(mesh.triangle_count, 2u);
    }
  }
}

TEST(Mesh, TakesExactlyWhatItMeasured) {
  const MeshScene scene = cube_sphere(6);
  const MeshRun run(scene);
  EXPECT_EQ(run.status, SINEW_OK);
  EXPECT_EQ(run.used, run.measured);
  EXPECT_EQ(MeshRun(scene, 0, 8, 64, false, 64).status, SINEW_ERROR_WORKSPACE);
}

// A sphere that holds a cube and stands on the floor, a cube beside it and a plate before both.
MeshScene objects(bool first_inward, bool second_inward, bool plate_inward) {
  const auto scene_of = [](bool inward, const auto& add) {
    MeshScene scene;
    add(&scene);
    for (size_t f = 0; inward && f + 1 < scene.offsets.size(); ++f)
      std::reverse(scene.corners.begin() + scene.offsets[f], scene.corners.begin() + scene.offsets[f + 1]);
    return scene;
  };
  MeshScene all = cube_sphere(6);
  const auto append = [&](const MeshScene& scene) {
    const uint32_t first = all.vertex_count();
    all.positions.insert(all.positions.end(), scene.positions.begin(), scene.positions.end());
    for (size_t f = 0; f + 1 < scene.offsets.size(); ++f) {
      std::vector<uint32_t> face(scene.corners.begin() + scene.offsets[f],
                                 scene.corners.begin() + scene.offsets[f + 1]);
      for (uint32_t& corner : face) corner += first;
      all.add_face(face);
    }
  };
  append(scene_of(first_inward, [](MeshScene* s) { add_cube(s, 2, 0, 0); }));
  append(scene_of(second_inward, [](MeshScene* s) { add_cube(s, -0.01f, 0, 0, 0.02f); }));
  append(scene_of(plate_inward, [](MeshScene* s) {
    for (int i = 0; i < 4; ++i) s->add_vertex(static_cast<float>(i & 1), static_cast<float>(i >> 1), 3);
    s->add_face({0, 1, 3, 2});
  }));
  return all;
}

MeshScene inside_out(MeshScene scene) {
  for (size_t f = 0; f + 1 < scene.offsets.size(); ++f)
    std::reverse(scene.corners.begin() + scene.offsets[f], scene.corners.begin() + scene.offsets[f + 1]);
  return scene;
}

std::vector<uint32_t> triangles_of(const MeshRun& run) {
  EXPECT_EQ(run.status, SINEW_OK);
  return {run.mesh.triangles, run.mesh.triangles + 3 * static_cast<size_t>(run.mesh.triangle_count)};
}

TEST(Mesh, InsideOutIsTheSame) {
  // The middle quad of each is not flat: a fan around another corner would be another surface.
  MeshScene bent = objects(false, false, false);
  for (size_t i = 0; i < bent.positions.size(); i += 7) bent.positions[i] *= 1.03f;
  const MeshRun a(bent), b(inside_out(bent));
  EXPECT_EQ(triangles_of(a), triangles_of(b));
  for (uint32_t v = 0; v < a.mesh.welded_count; ++v) {
    ASSERT_EQ(a.mesh.normals[v], b.mesh.normals[v]);
    ASSERT_EQ(a.mesh.mean_curvature[v], b.mesh.mean_curvature[v]);
    ASSERT_EQ(ring(a.mesh, v), ring(b.mesh, v));
  }
  const sinew::Vec3i top = a.mesh.normals[a.mesh.welded_count - 1];
  EXPECT_GT(top.x + top.y + top.z, 0);  // the last in Morton order lies at the far corner
}

TEST(Mesh, AClosedPartThatIsTurnedInwardsIsTurned) {
  EXPECT_EQ(triangles_of(MeshRun(objects(true, false, false))), triangles_of(MeshRun(objects(false, false, false))));
}

TEST(Mesh, ACavityStaysTurnedInwards) {
  EXPECT_NE(triangles_of(MeshRun(objects(false, true, false))), triangles_of(MeshRun(objects(false, false, false))));
  EXPECT_EQ(triangles_of(MeshRun(inside_out(objects(false, true, false)))),
            triangles_of(MeshRun(objects(false, true, false))));
}

TEST(Mesh, AnOpenPartGoesWithTheWhole) {
  EXPECT_NE(triangles_of(MeshRun(objects(false, false, true))), triangles_of(MeshRun(objects(false, false, false))));
  EXPECT_EQ(triangles_of(MeshRun(inside_out(objects(true, false, true)))),
            triangles_of(MeshRun(objects(false, false, true))));
}

}  // namespace
