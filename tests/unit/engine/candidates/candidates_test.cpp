// SPDX-License-Identifier: MIT
// Candidate joints: nearest through the body, distinct, usable ones only, for floating parts too.
#include "candidates/candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "mesh_scene.hpp"

namespace {

using sinew::kNoJoint;
using sinew_test::MeshRun;
using sinew_test::MeshScene;

// A closed box of n x n quads a side between two corners.
void add_box(MeshScene* scene, const float* low, const float* high, uint32_t n) {
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const uint32_t first = scene->vertex_count();
    for (uint32_t i = 0; i <= n; ++i) {
      for (uint32_t j = 0; j <= n; ++j) {
        float p[3];
        p[axis] = side % 2 ? high[axis] : low[axis];
        p[u] = low[u] + (high[u] - low[u]) * static_cast<float>(i) / static_cast<float>(n);
        p[v] = low[v] + (high[v] - low[v]) * static_cast<float>(j) / static_cast<float>(n);
        scene->add_vertex(p[0], p[1], p[2]);
      }
    }
    for (uint32_t i = 0; i < n; ++i) {
      for (uint32_t j = 0; j < n; ++j) {
        const uint32_t a = first + i * (n + 1) + j, b = a + n + 1;
        if (side % 2) {
          scene->add_face({a, b, b + 1, a + 1});
        } else {
          scene->add_face({a, a + 1, b + 1, b});
        }
      }
    }
  }
}
void add_box(MeshScene* scene, std::initializer_list<float> low, std::initializer_list<float> high, uint32_t n) {
  add_box(scene, low.begin(), high.begin(), n);
}

// A square column ten units tall with a chain of ten joints.
MeshScene column() {
  MeshScene scene;
  add_box(&scene, {-0.5f, 0, -0.5f}, {0.5f, 10, 0.5f}, 40);
  for (int j = 0; j < 10; ++j) scene.add_joint(0, static_cast<float>(j) + 0.05f, 0, j - 1);
  return scene;
}

MeshRun find(const MeshScene& scene, uint32_t k = 8, uint32_t grid = 64) { return MeshRun(scene, 0, k, grid, true); }

void expect_well_formed(const MeshRun& run) {
  ASSERT_EQ(run.status, SINEW_OK);
  const uint32_t k = run.counts.candidates;
  uint32_t usable = 0;
  for (uint32_t j = 0; j < run.counts.joints; ++j) usable += run.skeleton.usable[j];
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    const uint16_t* joints = run.candidates.joints + v * k;
    const uint32_t* distances = run.candidates.distances + v * k;
    std::set<uint16_t> seen;
    for (uint32_t i = 0; i < k; ++i) {
      if (i >= usable) {
        ASSERT_EQ(joints[i], kNoJoint);
        ASSERT_EQ(distances[i], 0u);
        continue;
      }
      ASSERT_LT(joints[i], run.counts.joints);
      ASSERT_TRUE(run.skeleton.usable[joints[i]]);
      ASSERT_TRUE(seen.insert(joints[i]).second);
      if (i > 0) {
        ASSERT_GE(distances[i], distances[i - 1]);
        if (distances[i] == distances[i - 1]) {
          ASSERT_GT(joints[i], joints[i - 1]);
        }
      }
    }
  }
}

TEST(Candidates, AChainIsNearestInOrder) {
  const MeshRun run = find(column());
  expect_well_formed(run);
  const double unit = sinew::kSide / 10.0;
  uint32_t right = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    const sinew::Vec3i p = run.mesh.positions[v];
    const int expected = std::clamp(static_cast<int>(std::floor(p.y / unit - 0.05)), 0, 9);
    right += run.candidates.joints[v * 8] == expected;
    // Eight of ten joints: no candidate is farther than six joints beyond the nearest end.
    for (uint32_t i = 0; i < 8; ++i) EXPECT_LE(std::abs(run.candidates.joints[v * 8 + i] - expected), 8);
    // The axis is 0.5 to 0.71 units away; chamfer lengths are off by a few percent and half a cell.
    const double across = std::hypot(p.x, p.z) / unit;
    if (p.y > unit && p.y < 9 * unit) {
      EXPECT_NEAR(run.candidates.distances[v * 8] / unit, across, 0.15);
    }
  }
  EXPECT_GT(right, run.mesh.welded_count * 9 / 10);
}

TEST(Candidates, DistancesGoThroughTheBodyNotAcrossTheGap) {
  MeshScene scene;  // two columns joined at the top: a wide gap between, a long way round
  add_box(&scene, {-2, 0, -0.4f}, {-1.6f, 10, 0.4f}, 30);
  add_box(&scene, {-1.2f, 0, -0.4f}, {-0.8f, 10, 0.4f}, 30);
  add_box(&scene, {-2, 9.6f, -0.4f}, {-0.8f, 10, 0.4f}, 10);
  scene.add_joint(-1.4f, 9.8f, 0, -1);
  scene.add_joint(-1.8f, 9.5f, 0, 0);  // 1: left column
  scene.add_joint(-1.8f, 0.2f, 0, 1);
  scene.add_joint(-1.0f, 9.5f, 0, 0);  // 3: right column
  scene.add_joint(-1.0f, 0.2f, 0, 3);
  const MeshRun run = find(scene);
  expect_well_formed(run);
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
    if (scene.positions[3 * v + 1] > 9) continue;
    const uint32_t nearest = run.candidates.joints[run.mesh.vertex_to_welded[v] * 8];
    if (scene.positions[3 * v] < -1.59f) {
      EXPECT_TRUE(nearest == 1 || nearest == 2);
    } else {
      // Across is legal but dear: the gap of 0.4 counts nearly four times, the left bone lies 0.2 inside.
      const uint16_t* row = run.candidates.joints + run.mesh.vertex_to_welded[v] * 8;
      for (uint32_t i = 0; i < 5; ++i) {
        if (row[i] == 1 || row[i] == 2) {
          EXPECT_GT(run.candidates.distances[run.mesh.vertex_to_welded[v] * 8 + i], sinew::kSide / 10.0 * 1.2);
        }
      }
      EXPECT_TRUE(nearest == 3 || nearest == 4);
    }
  }
}

TEST(Candidates, FloatingPartsAndLooseVerticesGetThemToo) {
  MeshScene scene = column();
  add_box(&scene, {3, 6, 3}, {3.4f, 6.4f, 3.4f}, 3);
  scene.add_vertex(-4, 2, 1);
  const MeshRun run = find(scene);
  expect_well_formed(run);
  const uint32_t loose = run.mesh.vertex_to_welded[scene.vertex_count() - 1];
  EXPECT_NEAR(run.candidates.joints[loose * 8], 1.5, 0.5);  // bones 1 and 2 meet at its height
  const uint32_t part = run.mesh.vertex_to_welded[scene.vertex_count() - 2];
  EXPECT_NEAR(run.candidates.joints[part * 8], 6, 1);
}

TEST(Candidates, OneJointTakesAll) {
  MeshScene scene;
  add_box(&scene, {-1, 0, -1}, {1, 2, 1}, 4);
  scene.add_joint(50, -70, 1e6f, -1);  // far outside
  const MeshRun run = find(scene);
  expect_well_formed(run);
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) EXPECT_EQ(run.candidates.joints[v * 8], 0);
  EXPECT_EQ(run.candidates.territory[0], 65536u);
}

TEST(Candidates, UnusableJointsNeverAppear) {
  MeshScene scene = column();
  scene.flags.assign(10, 0);
  for (const size_t j : {0u, 3u, 4u, 9u}) scene.flags[j] = SINEW_JOINT_NEVER;
  const MeshRun run = find(scene);
  expect_well_formed(run);  // and 6 usable joints fill 6 of the 8 slots
  for (const uint32_t j : {0u, 3u, 4u, 9u}) EXPECT_EQ(run.candidates.territory[j], 0u);
}

TEST(Candidates, WideRowsAndGridsOfAllSizes) {
  for (const uint32_t grid : {16u, 33u, 128u}) {
    for (const uint32_t k : {1u, 16u}) {
      const MeshRun run = find(column(), k, grid);
      ASSERT_NO_FATAL_FAILURE(expect_well_formed(run));
      EXPECT_EQ(run.used, run.measured);
    }
  }
}

TEST(Candidates, ALeafsTipPointsIntoItsTerritory) {
  MeshScene scene;  // a neck below a big head; the skeleton says nothing about how far the head reaches
  add_box(&scene, {-0.3f, 0, -0.3f}, {0.3f, 4, 0.3f}, 10);
  add_box(&scene, {-1.5f, 4, -1.5f}, {1.5f, 8, 1.5f}, 16);
  scene.add_joint(0, 0.5f, 0, -1);
  scene.add_joint(0, 3.5f, 0, 0);
  scene.add_joint(0, 4.2f, 0, 1);
  const MeshRun run = find(scene);
  expect_well_formed(run);
  const double unit = sinew::kSide / 8.0;
  const sinew::Vec3i tip = run.candidates.tips[2];
  EXPECT_NEAR(tip.x / unit, 0, 0.2);
  EXPECT_NEAR(tip.y / unit, 4.2 + 0.85 * 3.8, 0.2);
  EXPECT_NEAR(tip.z / unit, 0, 0.2);
  EXPECT_EQ(run.candidates.tips[0], run.skeleton.bone_tail[0]);
  uint32_t sum = 0;
  for (int j = 0; j < 3; ++j) sum += run.candidates.territory[j];
  EXPECT_NEAR(sum, 65536, 3);
  EXPECT_GT(run.candidates.territory[2], 32768u);
}

TEST(Candidates, ALeafWithoutTerritoryKeepsItsStub) {
  MeshScene scene = column();
  scene.add_joint(0, 5, 0, 4);   // inside the chain: its neighbors are nearer to everything
  scene.add_joint(0, 5, 0, 10);  // a leaf on top of it
  scene.flags.assign(12, 0);
  scene.flags[11] = SINEW_JOINT_NEVER;
  const MeshRun run = find(scene);
  expect_well_formed(run);
  EXPECT_EQ(run.candidates.tips[11], run.skeleton.bone_tail[11]);
}

TEST(Candidates, ALeafWithTwoVerticesKeepsItsStub) {
  MeshScene scene = column();
  scene.add_joint(4.5f, 5, 0, 4);
  scene.add_vertex(5, 5, 0);
  scene.add_vertex(5, 5, 1);
  const MeshRun run = find(scene);
  expect_well_formed(run);
  EXPECT_EQ(run.candidates.territory[10], 2 * 65536 / run.mesh.welded_count);
  EXPECT_EQ(run.candidates.tips[10], run.skeleton.bone_tail[10]);
}

TEST(Candidates, ACrowdOfSmallBonesDoesNotPushOutTheLargeOne) {
  MeshScene scene;
  add_box(&scene, {-1.5f, 0, -1.5f}, {1.5f, 8, 1.5f}, 24);
  scene.add_joint(0, 1, 0, -1);
  // A tiny chain at the front, like the muscles of a face. Beyond its end all ten of its bones are nearer than the
  // root's.
  for (int i = 0; i < 10; ++i) scene.add_joint(0.05f * static_cast<float>(i), 4, 1.45f, i);
  const MeshRun run = find(scene);
  expect_well_formed(run);
  const double unit = sinew::kSide / 8.0;
  uint32_t beyond = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    const sinew::Vec3i p = run.mesh.positions[v];
    if (std::abs(p.x / unit - 0.625) > 0.01 || std::abs(p.y / unit - 4) > 0.01 || p.z < unit) continue;
    ++beyond;
    const uint16_t* row = run.candidates.joints + v * 8;
    EXPECT_EQ(std::count(row, row + 8, 0), 1);
    const auto ninth = std::find(row, row + 8, 9);
    ASSERT_NE(ninth, row + 8);
    // The late start is taken off again: the bone ends 0.18 away, cells are 0.12 wide, the delay would be 0.22.
    EXPECT_LT(run.candidates.distances[v * 8 + static_cast<size_t>(ninth - row)] / unit, 0.36);
  }
  EXPECT_EQ(beyond, 1u);
}

TEST(Candidates, TakesExactlyWhatItMeasuredAndCanBeCancelled) {
  const MeshScene scene = column();
  const MeshRun run = find(scene);
  EXPECT_EQ(run.used, run.measured);
  EXPECT_EQ(MeshRun(scene, 0, 8, 64, true, 64).status, SINEW_ERROR_WORKSPACE);
  struct Caller {
    int calls = 0, stop_at = 0;
    uint32_t last = 0;
    static int report(void* user, uint32_t permille) {
      Caller* self = static_cast<Caller*>(user);
      EXPECT_GE(permille, self->last);
      self->last = permille;
      return ++self->calls == self->stop_at;
    }
  } all;
  sinew::Progress progress;
  progress.callback = &Caller::report;
  progress.user = &all;
  EXPECT_EQ(MeshRun(scene, 0, 8, 64, true, 0, progress).status, SINEW_OK);
  EXPECT_EQ(all.last, 1000u);
  for (int stop = 1; stop <= all.calls; ++stop) {
    Caller one;
    one.stop_at = stop;
    progress.user = &one;
    EXPECT_EQ(MeshRun(scene, 0, 8, 64, true, 0, progress).status, SINEW_ERROR_CANCELLED);
    EXPECT_EQ(one.calls, stop);
  }
}

}  // namespace
