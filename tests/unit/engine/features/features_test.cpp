// SPDX-License-Identifier: MIT
// Channels of pairs and vertices against what they are said to hold, worked out in double from the stages before them.
#include "features/features.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bind/pipeline.hpp"
#include "features/channels.hpp"
#include "heat_scene.hpp"
#include "kernels/select.hpp"
#include "sinew/sinew.hpp"

namespace sinew {
namespace {

enum Pair : uint32_t {
#define SINEW_CHANNEL(name) kPair_##name,
  SINEW_PAIR_CHANNELS(SINEW_CHANNEL)
#undef SINEW_CHANNEL
};
enum Vertex : uint32_t {
#define SINEW_CHANNEL(name) kVertex_##name,
  SINEW_VERTEX_CHANNELS(SINEW_CHANNEL)
#undef SINEW_CHANNEL
};

constexpr double kStep = 1.0 / (1 << kFeatureBits);
constexpr double kSofter = kSide / 256;  // added to lengths before their logarithm

// A body with arms in two sleeves, from the mesh to the features.
struct Featured {
  explicit Featured(uint32_t candidates) : scene(sinew_test::star(24, 32, 4)) {
    sinew_test::add_sleeve(&scene, 0.5, 0.9, 1.5, 12, 16);
    sinew_test::add_sleeve(&scene, 0.5, -1.5, -0.9, 12, 16);
    EXPECT_EQ(make_counts(scene.vertex_count(), scene.counts().faces, scene.counts().corners, scene.joint_count(),
                          candidates, 32, &counts),
              SINEW_OK);
    const auto run = [&](Arena& arena) {
      return prepare(scene.mesh_view(), scene.skeleton_view(), 0, counts, PreparePurpose::kNetwork, fastest_kernels(),
                     {}, arena, &p);
    };
    Arena measuring;
    (void)run(measuring);
    block = Workspace(measuring.high_water());
    Arena arena(block.data(), measuring.high_water());
    EXPECT_EQ(run(arena), SINEW_OK);
  }
  const int16_t* pair(uint32_t v, uint32_t slot) const {
    return p.features.pair + (size_t{v} * counts.candidates + slot) * kPairFeatures;
  }
  uint32_t joint(uint32_t v, uint32_t slot) const { return p.features.joints[size_t{v} * counts.candidates + slot]; }

  sinew_test::HeatScene scene;
  Counts counts;
  Workspace block;
  PreparedBind p;
};

// Calls check(run, vertex, slot, joint, channels) for every pair.
template <class Check>
void for_each_pair(Check check) {
  for (const uint32_t candidates : {1u, 3u, 8u, 16u}) {
    const Featured run(candidates);
    ASSERT_GE(run.p.mesh.part_count, 3u);
    for (uint32_t v = 0; v < run.p.mesh.welded_count; ++v) {
      for (uint32_t slot = 0; slot < candidates; ++slot) {
        const uint32_t joint = run.joint(v, slot);
        if (joint != kNoJoint) check(run, v, slot, joint, run.pair(v, slot));
      }
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

struct Fit {
  double distance = HUGE_VAL, along = 0, cosine = 0, length = 0, up = 0;
};

// The nearest of a joint's bones.
Fit fit(const PreparedBind& p, Vec3i at, uint32_t joint) {
  std::vector<Vec3i> ends;
  for (uint32_t j = 0; j < p.skeleton.joint_count; ++j) {
    if (p.skeleton.parents[j] == static_cast<int32_t>(joint)) ends.push_back(p.skeleton.positions[j]);
  }
  if (ends.empty()) ends.push_back(p.candidates.tips[joint]);
  Fit best;
  const Vec3i head = p.skeleton.positions[joint];
  for (const Vec3i end : ends) {
    const Vec3i d = end - head, to = at - head;
    const double length2 = static_cast<double>(dot(d, d));
    const double t = length2 == 0 ? 0 : std::fmin(1, std::fmax(0, static_cast<double>(dot(to, d)) / length2));
    const double distance = std::hypot(to.x - t * d.x, to.y - t * d.y, to.z - t * d.z);
    if (distance < best.distance)
      best = {distance, t, 0, std::sqrt(length2), length2 == 0 ? 0 : d.y / std::sqrt(length2)};
  }
  return best;
}

double q13(double value) { return std::fmin(2 - kStep, std::fmax(-2, value)); }

TEST(Features, PairsKnowTheirBones) {
  for_each_pair([](const Featured& run, uint32_t v, uint32_t, uint32_t joint, const int16_t* f) {
    const PreparedBind& p = run.p;
    const Fit own = fit(p, p.mesh.positions[v], joint);
    double nearest = HUGE_VAL;
    for (uint32_t i = 0; i < run.counts.candidates; ++i) {
      if (run.joint(v, i) != kNoJoint) {
        nearest = std::fmin(nearest, fit(p, p.mesh.positions[v], run.joint(v, i)).distance);
      }
    }
    ASSERT_NEAR(f[kPair_bone_distance] * kStep, q13(2 * own.distance / kSide), 2 * kStep);
    ASSERT_NEAR(f[kPair_bone_ratio] * kStep, q13(std::log2((own.distance + kSofter) / (nearest + kSofter)) / 4),
                2 * kStep);
    ASSERT_NEAR(f[kPair_bone_length] * kStep, q13(4 * own.length / kSide), kStep);
    ASSERT_NEAR(f[kPair_bone_position] * kStep, own.along, 2 * kStep);
    ASSERT_NEAR(f[kPair_bone_up] * kStep, own.up, kStep);
    ASSERT_EQ(f[kPair_is_leaf] != 0, p.skeleton.child_count[joint] == 0);
  });
}

TEST(Features, PairsKnowTheirHeat) {
  for_each_pair([](const Featured& run, uint32_t v, uint32_t, uint32_t joint, const int16_t* f) {
    const PreparedBind& p = run.p;
    const uint32_t channels[kFieldCount][3] = {{kPair_rule, kPair_rule_root, kPair_rule_log},
                                               {kPair_parts, kPair_parts_root, kPair_parts_log},
                                               {kPair_soft, kPair_soft_root, kPair_soft_log}};
    for (uint32_t field = 0; field < kFieldCount; ++field) {
      uint16_t joints[kHeatSlots], weights[kHeatSlots];
      const uint32_t count = finish_heat_row(p.heat.field[field], v, joints, weights);
      double weight = 0, children = 0, parent = 0;
      for (uint32_t i = 0; i < count; ++i) {
        const double share = weights[i] / 32768.0;
        if (joints[i] == joint) weight = share;
        if (p.skeleton.parents[joints[i]] == static_cast<int32_t>(joint)) children += share;
        if (p.skeleton.parents[joint] == static_cast<int32_t>(joints[i])) parent = share;
      }
      ASSERT_NEAR(f[channels[field][0]] * kStep, weight, kStep);
      ASSERT_NEAR(f[channels[field][1]] * kStep, std::sqrt(weight), kStep);
      ASSERT_NEAR(f[channels[field][2]] * kStep, std::log(std::fmax(weight, 1.0 / 8192)) / 8, kStep);
      if (field != kFieldRule) continue;
      ASSERT_NEAR(f[kPair_children_rule] * kStep, children, kStep);
      ASSERT_NEAR(f[kPair_parent_rule] * kStep, parent, kStep);
    }
    double raw = 0;
    for (uint32_t i = 0; i < kHeatSlots; ++i) {
      const size_t slot = size_t{v} * kHeatSlots + i;
      if (p.heat.field[kFieldRule].joints[slot] == joint) raw = p.heat.field[kFieldRule].weights[slot] / 32768.0;
    }
    ASSERT_NEAR(f[kPair_rule_raw_root] * kStep, std::sqrt(raw), kStep);
  });
}

TEST(Features, PairsKnowTheirWayThroughTheBody) {
  for_each_pair([](const Featured& run, uint32_t v, uint32_t slot, uint32_t joint, const int16_t* f) {
    const Candidates& found = run.p.candidates;
    const uint32_t k = run.counts.candidates;
    double distance = -1, farthest = 0, before = -1;
    for (uint32_t i = 0; i < k && found.joints[size_t{v} * k + i] != kNoJoint; ++i) {
      farthest = found.distances[size_t{v} * k + i];
      if (found.joints[size_t{v} * k + i] == joint) distance = farthest;
    }
    if (distance < 0) distance = farthest + 1;
    ASSERT_NEAR(f[kPair_voxel_distance] * kStep, q13(2 * distance / kSide), kStep);
    if (slot > 0) before = run.pair(v, slot - 1)[kPair_voxel_distance];
    ASSERT_GE(f[kPair_voxel_distance], before);
    for (uint32_t i = 0; i < slot; ++i) ASSERT_NE(run.joint(v, i), joint);
  });
}

}  // namespace
}  // namespace sinew
