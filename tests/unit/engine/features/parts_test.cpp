// SPDX-License-Identifier: MIT
// Parts: what each one hangs on, against a search over all vertices.
#include "features/parts.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "mesh_scene.hpp"
#include "with_asan.hpp"

namespace {

using sinew::kNoVertex;
using sinew_test::MeshRun;
using sinew_test::MeshScene;

// A sheet of `columns` x `rows` quads on a lattice, so that equal distances are common.
void add_sheet(MeshScene* scene, const int* at, int columns, int rows, int across, int along) {
  const uint32_t first = scene->vertex_count();
  for (int i = 0; i <= columns; ++i) {
    for (int j = 0; j <= rows; ++j) {
      int p[3] = {at[0], at[1], at[2]};
      p[across] += i;
      p[along] += j;
      scene->add_vertex(static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]));
    }
  }
  const auto corner = [&](int i, int j) { return first + static_cast<uint32_t>(i * (rows + 1) + j); };
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j)
      scene->add_face({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
  }
}

// Sheets of any size, crossing, touching and far from each other; sheets with a common vertex are one part.
MeshScene sheets(uint32_t seed, int count, int most, int room) {
  std::mt19937 random(seed);
  const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<uint32_t>(limit)); };
  MeshScene scene;
  for (int i = 0; i < count; ++i) {
    const int at[3] = {below(room), below(room), below(room)}, axis = below(3);
    add_sheet(&scene, at, 1 + below(most), 1 + below(most), axis, (axis + 1 + below(2)) % 3);
  }
  scene.add_joint(0, 0, 0, -1);
  return scene;
}

struct PartsRun {
  explicit PartsRun(const MeshScene& scene) : run(scene), has_source(run.mesh.welded_count) {
    for (size_t v = 0; v < has_source.size(); ++v) has_source[v] = v % 3 == 0;
    heat.field[sinew::kFieldRule].has_source = has_source.data();
    const auto find = [&](sinew::Arena& arena) {
      parts.allocate(arena, run.counts);
      return sinew::find_parts(run.mesh, heat, run.counts, arena, &parts);
    };
    sinew::Arena measure;
    (void)find(measure);
    block.assign(measure.high_water() / 64 + 2, Line());
    sinew::Arena arena(block.data(), measure.high_water());
    status = find(arena);
  }

  struct alignas(64) Line {
    Line() { std::memset(bytes, 0xA5, sizeof bytes); }
    uint8_t bytes[64];
  };
  MeshRun run;
  std::vector<uint8_t> has_source;
  sinew::HeatFields heat;
  sinew::Parts parts;
  std::vector<Line> block;
  sinew_status status;
};

void expect_nearest_hosts(const PartsRun& r) {
  ASSERT_EQ(r.run.status, SINEW_OK);
  ASSERT_EQ(r.status, SINEW_OK);
  const sinew::Mesh& mesh = r.run.mesh;
  for (uint32_t v = 0; v < mesh.welded_count; ++v) {
    uint32_t host = kNoVertex;
    int64_t best = 0;
    for (uint32_t other = 0; other < mesh.welded_count; ++other) {
      if (mesh.part[other] >= mesh.part[v]) continue;
      const sinew::Vec3i d = mesh.positions[other] - mesh.positions[v];
      if (host != kNoVertex && sinew::dot(d, d) >= best) continue;
      host = other;
      best = sinew::dot(d, d);
    }
    ASSERT_EQ(r.parts.host_vertex[v], host) << v;
    ASSERT_EQ(r.parts.host_distance[v], sinew::isqrt64(static_cast<uint64_t>(best))) << v;
  }
}

TEST(Parts, HostIsTheNearestVertexOfALargerPart) {
  for (uint32_t seed = 0; seed < 40; seed += sinew_test::kEveryWithAsan) {
    SCOPED_TRACE(seed);
    const int count = 1 + static_cast<int>(seed) * 2;
    const PartsRun r(sheets(seed, count, 1 + static_cast<int>(seed * 7 % 13), 12 + static_cast<int>(seed)));
    expect_nearest_hosts(r);
  }
}

TEST(Parts, ManySmallOnesOnALargeOne) {
  std::mt19937 random(7);
  MeshScene scene;
  const int corner[3] = {0, 0, 0};
  add_sheet(&scene, corner, 30, 40, 0, 1);
  for (int i = 0; i < 300; ++i) {
    const auto real = [&] { return static_cast<float>(random() % 4096) / 100; };
    const float x = real(), y = real(), z = real() / 8 + 0.1f;
    const uint32_t a = scene.add_vertex(x, y, z), b = scene.add_vertex(x + 0.3f, y, z),
                   c = scene.add_vertex(x, y, z + 1);
    scene.add_face({a, b, c});
  }
  scene.add_joint(0, 0, 0, -1);
  const PartsRun r(scene);
  EXPECT_GT(r.run.mesh.part_count, 200u);
  expect_nearest_hosts(r);
}

TEST(Parts, OneHasNoHost) {
  MeshScene scene;
  sinew_test::add_cube(&scene, 0, 0, 0);
  scene.add_joint(0, 0, 0, -1);
  const PartsRun r(scene);
  expect_nearest_hosts(r);
  EXPECT_EQ(r.parts.host_vertex[0], kNoVertex);
  EXPECT_EQ(r.parts.source_count[0], 3u);
  EXPECT_EQ(r.parts.boundary_count[0], 0u);
}

}  // namespace
