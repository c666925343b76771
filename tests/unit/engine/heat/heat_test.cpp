// SPDX-License-Identifier: MIT
// The heat stage as a whole: weights that a body must get, finished rows, memory, progress.
#include "heat/heat.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <numeric>
#include <set>

#include "arena_block.hpp"
#include "heat_scene.hpp"
#include "kernels/select.hpp"

namespace {

using namespace sinew;
using sinew_test::Block;
using sinew_test::HeatRun;
using sinew_test::HeatScene;

TEST(Heat, TwoBonesGiveASmoothMonotoneBlend) {
  const HeatScene scene = sinew_test::capsule(60, 16, 0);
  HeatScene rigged = scene;
  rigged.add_joint(0, 0.4, 0, -1);
  rigged.add_joint(0, 2.0, 0, 0);
  const HeatRun run(rigged);
  ASSERT_EQ(run.status, SINEW_OK);
  std::vector<std::pair<int32_t, double>> profile;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    profile.push_back({run.mesh.positions[v].y, run.weight(kFieldRule, v, 1)});
    EXPECT_NEAR(run.weight(kFieldRule, v, 0) + run.weight(kFieldRule, v, 1), 1.0, 5e-4);
  }
  std::sort(profile.begin(), profile.end());
  for (size_t i = 1; i < profile.size(); ++i) {
    EXPECT_GE(profile[i].second, profile[i - 1].second - 2e-3);
    EXPECT_LE(profile[i].second - profile[i - 1].second, 0.3);
  }
  EXPECT_LT(profile.front().second, 0.01);
  EXPECT_GT(profile.back().second, 0.97);
}

TEST(Heat, MirroredBodiesGetMirroredWeights) {
  // Half of the triangles, and their mirror images: the diagonals of the quads must be mirrored, too.
  HeatScene scene = sinew_test::capsule(40, 24, 0);
  const std::vector<uint32_t> all = scene.triangles;
  scene.triangles.clear();
  const auto image = [](uint32_t v) { return v < 40 * 24 ? v / 24 * 24 + (36 - v % 24) % 24 : v; };
  for (size_t i = 0; i < all.size(); i += 3) {
    const double x = scene.positions[3 * all[i]] + scene.positions[3 * all[i + 1]] + scene.positions[3 * all[i + 2]];
    if (x < 0) continue;
    scene.add_triangle(all[i], all[i + 1], all[i + 2]);
    scene.add_triangle(image(all[i]), image(all[i + 2]), image(all[i + 1]));
  }
  ASSERT_EQ(scene.triangles.size(), all.size());
  scene.add_joint(0, 0.6, 0, -1);
  scene.add_joint(0.15, 1.5, 0, 0);
  scene.add_joint(0.2, 3.2, 0, 1);
  scene.add_joint(-0.15, 1.5, 0, 0);
  scene.add_joint(-0.2, 3.2, 0, 3);
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  const uint32_t mirror[5] = {0, 3, 4, 1, 2};
  std::map<std::array<int32_t, 3>, uint32_t> at;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v)
    at[{run.mesh.positions[v].x, run.mesh.positions[v].y, run.mesh.positions[v].z}] = v;
  size_t pairs = 0;
  double worst = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    const Vec3i p = run.mesh.positions[v];
    // The float input is symmetric up to a grid unit.
    for (int32_t step = 0; step < 9; ++step) {
      const auto other = at.find({-p.x + step % 3 - 1, p.y, p.z + step / 3 - 1});
      if (other == at.end()) continue;
      ++pairs;
      for (uint32_t j = 0; j < 5; ++j) {
        worst =
            std::max(worst, std::abs(run.weight(kFieldRule, v, j) - run.weight(kFieldRule, other->second, mirror[j])));
      }
    }
  }
  EXPECT_GT(pairs, run.mesh.welded_count * 9 / 10);
  EXPECT_LT(worst, 2e-3);
}

TEST(Heat, NumberingOfVerticesFacesAndJointsDoesNotMatter) {
  HeatScene scene = sinew_test::capsule(20, 15, 4);
  sinew_test::add_sleeve(&scene, 0.6, 1.0, 3.0, 7, 13);
  const HeatRun plain(scene);
  ASSERT_EQ(plain.status, SINEW_OK);
  std::mt19937 random(19);
  const auto shuffled = [&](uint32_t n) {
    std::vector<uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    for (uint32_t i = n; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    return order;
  };
  const std::vector<uint32_t> vertex = shuffled(scene.vertex_count()),
                              face = shuffled(static_cast<uint32_t>(scene.triangles.size() / 3));
  const std::vector<uint32_t> joint = shuffled(scene.joint_count());
  HeatScene renamed = scene;
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
    std::copy_n(&scene.positions[3 * v], 3, &renamed.positions[3 * vertex[v]]);
  }
  for (uint32_t f = 0; f < face.size(); ++f) {
    for (uint32_t k = 0; k < 3; ++k) renamed.triangles[3 * face[f] + k] = vertex[scene.triangles[3 * f + (k + f) % 3]];
  }
  for (uint32_t j = 0; j < scene.joint_count(); ++j) {
    std::copy_n(&scene.joints[3 * j], 3, &renamed.joints[3 * joint[j]]);
    renamed.parents[joint[j]] = scene.parents[j] < 0 ? -1 : static_cast<int32_t>(joint[scene.parents[j]]);
  }
  const HeatRun other(renamed);
  ASSERT_EQ(other.status, SINEW_OK);
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
    for (uint32_t f = 0; f < kFieldCount; ++f) {
      for (uint32_t j = 0; j < scene.joint_count(); ++j) {
        ASSERT_EQ(plain.weight(f, plain.mesh.vertex_to_welded[v], j),
                  other.weight(f, other.mesh.vertex_to_welded[vertex[v]], joint[j]));
      }
    }
  }
}

TEST(Heat, EveryVertexEndsWithARowThatSumsToOne) {
  HeatScene scene = sinew_test::tangle(60, 40, 5, 2);  // with isolated vertices
  scene.add_vertex(3, 3, 3);
  sinew_test::add_sleeve(&scene, 0.6, 1.0, 3.0, 4, 9);
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  for (const HeatField& field : run.fields.field) {
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
      uint16_t joints[kHeatSlots], weights[kHeatSlots];
      const uint32_t used = finish_heat_row(field, v, joints, weights);
      ASSERT_GE(used, 1u);
      uint32_t sum = 0;
      for (uint32_t s = 0; s < kHeatSlots; ++s) {
        sum += weights[s];
        EXPECT_EQ(joints[s] == kNoJoint, s >= used);
      }
      EXPECT_NEAR(sum, 32768, used);
    }
  }
}

TEST(Heat, RowsFallAndNameNoJointTwice) {
  const HeatRun run(sinew_test::star(28, 37, 5));
  ASSERT_EQ(run.status, SINEW_OK);
  for (const HeatField& field : run.fields.field) {
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
      const uint16_t* joints = field.joints + v * kHeatSlots;
      const uint16_t* weights = field.weights + v * kHeatSlots;
      std::set<uint16_t> seen;
      for (uint32_t s = 0; s < kHeatSlots && joints[s] != kNoJoint; ++s) {
        EXPECT_TRUE(seen.insert(joints[s]).second);
        EXPECT_GE(weights[s], 8u);
        if (s == 0) continue;
        EXPECT_TRUE(weights[s] < weights[s - 1] || (weights[s] == weights[s - 1] && joints[s] > joints[s - 1]));
      }
      EXPECT_FALSE(seen.empty());
    }
  }
}

TEST(Heat, EqualWeightsComeInOrderOfJoints) {
  HeatScene scene = sinew_test::capsule(20, 12, 0);
  scene.add_joint(0, 1, 0, -1);
  for (int i = 0; i < 3; ++i) scene.add_joint(0, 3, 0, 0);  // three bones at one position
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    if (run.weight(kFieldRule, v, 1) < 0.3) continue;
    EXPECT_EQ(run.fields.field[kFieldRule].joints[v * kHeatSlots], 1);
    EXPECT_EQ(run.fields.field[kFieldRule].joints[v * kHeatSlots + 1], 2);
    EXPECT_EQ(run.fields.field[kFieldRule].joints[v * kHeatSlots + 2], 3);
    EXPECT_EQ(run.weight(kFieldRule, v, 1), run.weight(kFieldRule, v, 3));
  }
}

TEST(Heat, SpecksFarFromTheBonesStillSumToOne) {
  // A few grid units wide and a thousandfold their size away: their sources pull by less than rounding can hold.
  HeatScene scene = sinew_test::capsule(12, 12, 3);
  const double unit = 1.0 / 200000, far = 2;
  const uint32_t first = scene.vertex_count();
  for (int i = 0; i < 5; ++i) {
    for (int k = 0; k < 5; ++k) scene.add_vertex(far + 3 * unit * i, 1 + 2 * unit * k, unit * (i * k % 3));
  }
  for (uint32_t i = 0; i < 4; ++i) {
    for (uint32_t k = 0; k < 4; ++k) {
      const uint32_t a = first + 5 * i + k;
      scene.add_triangle(a, a + 5, a + 1);
      scene.add_triangle(a + 1, a + 5, a + 6);
    }
  }
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_EQ(run.mesh.part_count, 2u);
  for (uint32_t f = 0; f < kFieldCount; ++f) {
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
      EXPECT_NEAR(run.weight(f, v, 0) + run.weight(f, v, 1) + run.weight(f, v, 2), 1.0, 6e-4) << v;
    }
  }
}

TEST(Heat, FinishedRowsAreCutAndRamped) {
  uint16_t joints[kHeatSlots], weights[kHeatSlots], nearest[1] = {9};
  std::fill_n(joints, kHeatSlots, kNoJoint);
  std::fill_n(weights, kHeatSlots, uint16_t{0});
  HeatField field;
  field.joints = joints;
  field.weights = weights;
  field.nearest = nearest;
  uint16_t out_joints[kHeatSlots], out_weights[kHeatSlots];
  EXPECT_EQ(finish_heat_row(field, 0, out_joints, out_weights), 1u);
  EXPECT_EQ(out_joints[0], 9);
  EXPECT_EQ(out_weights[0], 32768);
  // 0.9, 0.05, 0.0375 (half way up the ramp: 0.025), 0.0249 (cut).
  const double raw[4] = {0.9, 0.05, 0.0375, 0.0249};
  for (uint32_t s = 0; s < 4; ++s) {
    joints[s] = static_cast<uint16_t>(s);
    weights[s] = static_cast<uint16_t>(raw[s] * 32768 + 0.5);
  }
  EXPECT_EQ(finish_heat_row(field, 0, out_joints, out_weights), 3u);
  EXPECT_NEAR(out_weights[0], 32768 * 0.9 / 0.975, 2);
  EXPECT_NEAR(out_weights[1], 32768 * 0.05 / 0.975, 2);
  EXPECT_NEAR(out_weights[2], 32768 * 0.025 / 0.975, 2);
}

TEST(Heat, MeasureEqualsTheRun) {
  for (const HeatScene& scene :
       {sinew_test::star(20, 21, 3), sinew_test::tangle(50, 30, 3, 1), sinew_test::capsule(3, 3, 1)}) {
    HeatRun run(scene, false);
    ASSERT_EQ(run.status, SINEW_OK);
    const size_t held = run.arena.used();
    Block exact(run.heat_scratch_bytes);
    EXPECT_EQ(solve_heat(run.mesh, run.skeleton, run.source_joints.data(), run.counts, fastest_kernels(), {},
                         exact.arena, &run.fields),
              SINEW_OK);
    EXPECT_EQ(exact.arena.high_water(), run.heat_scratch_bytes);
    EXPECT_EQ(exact.arena.used(), 0u);
    EXPECT_EQ(run.arena.used(), held);
    Block small(run.heat_scratch_bytes - 64);
    EXPECT_EQ(solve_heat(run.mesh, run.skeleton, run.source_joints.data(), run.counts, fastest_kernels(), {},
                         small.arena, &run.fields),
              SINEW_ERROR_WORKSPACE);
  }
}

TEST(Heat, FiveThousandVerticesFitTwentyFiveMegabytes) {
  Counts counts;
  counts.vertices = 5000;
  counts.faces = 10000;
  counts.corners = 30000;
  counts.joints = 60;
  Arena measure;
  HeatFields fields;
  (void)solve_heat({}, {}, nullptr, counts, fastest_kernels(), {}, measure, &fields);
  EXPECT_LT(measure.high_water(), 25u << 20);
}

TEST(Heat, ReportsProgressInOrderAndStopsWhenAsked) {
  const HeatScene scene = sinew_test::star(40, 50, 2);
  HeatRun run(scene, false);
  ASSERT_EQ(run.status, SINEW_OK);
  struct State {
    uint32_t last = 0, calls = 0, stop_at = 2000;
    bool falls = false;
  } state;
  Progress progress;
  progress.user = &state;
  progress.callback = [](void* user, uint32_t permille) {
    State* s = static_cast<State*>(user);
    s->falls = s->falls || permille < s->last;
    s->last = permille;
    ++s->calls;
    return permille >= s->stop_at ? 1 : 0;
  };
  EXPECT_EQ(solve_heat(run.mesh, run.skeleton, run.source_joints.data(), run.counts, fastest_kernels(), progress,
                       run.arena, &run.fields),
            SINEW_OK);
  EXPECT_FALSE(state.falls);
  EXPECT_EQ(state.last, 1000u);
  EXPECT_GT(state.calls, 4u);
  for (const uint32_t stop : {0u, 100u, 400u}) {
    state = State();
    state.stop_at = stop;
    const size_t used = run.arena.used();
    EXPECT_EQ(solve_heat(run.mesh, run.skeleton, run.source_joints.data(), run.counts, fastest_kernels(), progress,
                         run.arena, &run.fields),
              SINEW_ERROR_CANCELLED);
    EXPECT_EQ(run.arena.used(), used);
  }
}

}  // namespace
