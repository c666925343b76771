// SPDX-License-Identifier: MIT
// A hand's crop: the frame that all hands share, what is cut out, and that it has an inside.
#include "details/hand_crop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "core/vector_math.hpp"
#include "mesh_scene.hpp"
#include "votes/interior.hpp"

namespace {

using namespace sinew;
using namespace sinew::rigging;
using sinew_test::MeshScene;

struct HandMesh : sinew_test::MeshRun {
  GridQuantizer quantizer;
  explicit HandMesh(const MeshScene& scene) : sinew_test::MeshRun(scene) {
    EXPECT_EQ(make_grid_quantizer(scene.positions.data(), scene.vertex_count(), 0, &quantizer), SINEW_OK);
  }
};

// An open tube along +x from x0 to x1, `sides` around, a ring every `step`.
void add_tube(MeshScene* scene, double x0, double x1, double y, double z, double radius, double step = 0.02,
              int sides = 12) {
  const uint32_t first = scene->vertex_count();
  const int rings = static_cast<int>(std::lround((x1 - x0) / step));
  for (int r = 0; r <= rings; ++r) {
    for (int s = 0; s < sides; ++s) {
      const double a = 2 * M_PI * s / sides;
      scene->add_vertex(static_cast<float>(x0 + (x1 - x0) * r / rings), static_cast<float>(y + radius * std::cos(a)),
                        static_cast<float>(z + radius * std::sin(a)));
    }
  }
  const auto at = [&](int r, int s) { return first + static_cast<uint32_t>(r * sides + s % sides); };
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < sides; ++s) scene->add_face({at(r, s), at(r + 1, s), at(r + 1, s + 1), at(r, s + 1)});
}

// An arm to x = 1 that is open there, and a trunk.
MeshScene arm() {
  MeshScene scene;
  add_tube(&scene, 0, 1, 0.5, 0, 0.05);
  add_tube(&scene, -1, -0.1, 0.5, 0, 0.3);
  scene.add_joint(0, 0, 0, -1);
  return scene;
}

struct Cropped {
  HandCrop crop;
  Counts counts;
  Workspace block;

  Cropped(const HandMesh& run, const MeshScene& scene, const HandPosition& position) {
    const sinew_mesh view = scene.mesh_view();
    counts.vertices = view.vertex_count;
    counts.faces = view.face_count;
    counts.corners = view.corner_count;
    const auto stage = [&](Arena& arena) {
      (void)crop.allocate(arena, counts);
      (void)crop_hand(run.mesh, position, counts, arena, &crop);
    };
    Arena measuring;
    stage(measuring);
    block = Workspace(measuring.high_water());
    Arena arena(block.data(), measuring.high_water());
    stage(arena);
    EXPECT_TRUE(arena.ok());
    EXPECT_EQ(arena.high_water(), measuring.high_water());
  }
};

Vec3i grid(const HandMesh& run, float x, float y, float z) {
  const float p[3] = {x, y, z};
  return quantize_point(run.quantizer, p);
}

HandPosition position_at(const HandMesh& run, float wrist, float elbow, float length) {
  HandPosition position;
  position.wrist = grid(run, wrist, 0.5f, 0);
  position.elbow = grid(run, elbow, 0.5f, 0);
  position.length = grid(run, length, 0.5f, 0).x - grid(run, 0, 0.5f, 0).x;
  return position;
}

TEST(HandFrame, BringsTheForearmToXAndComesBack) {
  for (const Vec3i elbow : {Vec3i{-90000, 0, 0}, Vec3i{0, 90000, 10000}, Vec3i{30000, 40000, -50000},
                            Vec3i{90000, 0, 0}, Vec3i{90000, 9000, 5000}, Vec3i{0, 0, 0}}) {
    for (uint32_t quarters = 0; quarters < 4; ++quarters) {
      for (const bool right : {false, true}) {
        const MeshScene scene = arm();
        const HandMesh run(scene);
        HandPosition position = position_at(run, 0.8f, 0.4f, 0.2f);
        position.elbow = position.wrist + elbow;
        position.quarters = quarters;
        position.right = right;
        const Cropped cropped(run, scene, position);
        const HandFrame& frame = cropped.crop.frame;
        const Vec3l r = frame.rotated(position.elbow);
        const double size = std::sqrt(static_cast<double>(dot(elbow, elbow)));
        EXPECT_NEAR(static_cast<double>(r.x) / 256, -size, 2);
        EXPECT_NEAR(static_cast<double>(r.y) / 256, 0, 2);
        EXPECT_NEAR(static_cast<double>(r.z) / 256, 0, 2);
        for (const Vec3i p : {position.wrist, position.wrist + Vec3i{1000, -20000, 30000}}) {
          const Vec3i back = frame.from(frame.to(p));
          EXPECT_LE(extent(back - p), 2) << quarters << right;
        }
      }
    }
  }
}

TEST(HandFrame, TheRightHandIsTheLeftOnesMirrorImage) {
  HandFrame left, right;
  left.axes[0] = right.axes[0] = {1 << 28, 0, 0};
  left.axes[1] = right.axes[1] = {0, 1 << 28, 0};
  left.axes[2] = right.axes[2] = {0, 0, 1 << 28};
  right.right = true;
  EXPECT_EQ(left.to({1000, 200, 30}), right.to({-1000, 200, 30}));
}

TEST(HandCrop, HoldsTheHandAloneFromItsWristOn) {
  const MeshScene scene = arm();
  const HandMesh run(scene);
  const Cropped cropped(run, scene, position_at(run, 0.8f, 0.4f, 0.2f));
  const HandCrop& crop = cropped.crop;
  ASSERT_GT(crop.surface_triangles, 0u);
  for (uint32_t v = 0; v < crop.surface_vertices; ++v)
    EXPECT_GE(run.mesh.positions[crop.source[v]].x, grid(run, 0.75f, 0, 0).x);
  Vec3i low = crop.mesh.positions[0], high = low;
  for (uint32_t v = 0; v < crop.mesh.welded_count; ++v) grow(crop.mesh.positions[v], &low, &high);
  EXPECT_EQ(low.x, 0);
  EXPECT_NEAR(high.x, kSide, 2) << "the longest side";
  EXPECT_NEAR(low.y + high.y, 0, 4);
  EXPECT_NEAR(low.z + high.z, 0, 4);
}

TEST(HandCrop, IsClosedWhereItWasCutAndWhereTheMeshWasOpen) {
  const MeshScene scene = arm();
  const HandMesh run(scene);
  const Cropped cropped(run, scene, position_at(run, 0.8f, 0.4f, 0.2f));
  const Mesh& mesh = cropped.crop.mesh;
  EXPECT_EQ(mesh.welded_count, cropped.crop.surface_vertices + 2) << "one middle a loop";
  EXPECT_EQ(mesh.triangle_count, cropped.crop.surface_triangles + 24);
  std::multiset<std::pair<uint32_t, uint32_t>> edges;
  for (uint32_t t = 0; t < mesh.triangle_count; ++t)
    for (uint32_t c = 0; c < 3; ++c) edges.insert({mesh.triangles[3 * t + c], mesh.triangles[3 * t + (c + 1) % 3]});
  for (const auto& [a, b] : edges) EXPECT_EQ(edges.count({b, a}), 1u);
  Interior interior;
  Arena measuring;
  (void)interior.allocate(measuring);
  (void)build_interior(mesh, measuring, &interior);
  Workspace block(measuring.high_water());
  Arena arena(block.data(), measuring.high_water());
  (void)interior.allocate(arena);
  (void)build_interior(mesh, arena, &interior);
  EXPECT_GT(interior.depth[interior.grid.cell_of({kSide / 2, 0, 0})], 3 * kDepthUnits) << "the inside is solid";
}

TEST(HandCrop, PartsBesideTheHandStayOut) {
  MeshScene scene = arm();
  add_tube(&scene, 0.7, 1.1, 0.5, 0.15, 0.02);  // within the region, away from the axis
  const HandMesh run(scene);
  const Cropped cropped(run, scene, position_at(run, 0.8f, 0.4f, 0.2f));
  ASSERT_GT(cropped.crop.surface_vertices, 0u);
  for (uint32_t v = 0; v < cropped.crop.surface_vertices; ++v)
    EXPECT_LT(run.mesh.positions[cropped.crop.source[v]].z, grid(run, 0, 0, 0.1f).z);
}

TEST(HandCrop, IsEmptyWhereThereIsNoSurface) {
  const MeshScene scene = arm();
  const HandMesh run(scene);
  HandPosition position = position_at(run, 0.8f, 0.4f, 0.2f);
  position.wrist = grid(run, 3, 3, 3);
  EXPECT_EQ(Cropped(run, scene, position).crop.surface_triangles, 0u);
}

}  // namespace
