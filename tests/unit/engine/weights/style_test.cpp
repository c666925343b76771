// SPDX-License-Identifier: MIT
// Rigid and soft parts and softened logits on rows made by hand.
#include <gtest/gtest.h>

#include <vector>

#include "kernels/softmax.hpp"
#include "weights/users_say.hpp"

namespace sinew {
namespace {

// Two parts: vertices 0, 1, 2 and vertices 3, 4; four joints.
struct TwoParts {
  Mesh mesh{};
  Counts counts{};
  std::vector<uint32_t> offsets{0, 3, 5}, vertices{0, 1, 2, 3, 4};
  std::vector<uint16_t> joints = std::vector<uint16_t>(5 * kRowSlots, kNoJoint);
  std::vector<uint32_t> weights = std::vector<uint32_t>(5 * kRowSlots, 0);
  std::vector<uint64_t> block = std::vector<uint64_t>(64);
  Arena arena{block.data(), block.size() * 8};
  Rows rows;

  TwoParts() {
    mesh.welded_count = 5;
    mesh.part_count = 2;
    mesh.part_offsets = offsets.data();
    mesh.part_vertices = vertices.data();
    counts.vertices = 5;
    counts.joints = 4;
    rows.joints = joints.data();
    rows.weights = weights.data();
  }
  void set(uint32_t vertex, uint16_t a, uint32_t share, uint16_t b) {
    rows.add(vertex, a, share);
    if (share < kWholeRow) rows.add(vertex, b, kWholeRow - share);
  }
};

TEST(PartStyle, AlwaysGivesEveryPartItsHeaviestJoint) {
  TwoParts p;
  p.set(0, 1, 40000, 2);
  p.set(1, 2, 30000, 1);
  p.set(2, 2, 50000, 3);  // the part's sums: joint 1: 75536, joint 2: 105536
  p.set(3, 3, kWholeRow / 2, 0);
  p.set(4, 3, kWholeRow / 2, 0);  // a tie: the lower joint
  ASSERT_EQ(make_parts_rigid(p.mesh, p.counts, p.arena, &p.rows), SINEW_OK);
  for (uint32_t v = 0; v < 5; ++v) {
    const uint16_t expected = v < 3 ? 2 : 0;
    EXPECT_EQ(p.rows.weight(v, expected), kWholeRow) << v;
    EXPECT_EQ(p.rows.joints_of(v)[1], kNoJoint) << v;
  }
}

TEST(PartStyle, NeverTakesHeatWhereOnlyTheModelIsRigid) {
  TwoParts p;
  for (uint32_t v = 0; v < 3; ++v) p.set(v, 1, kWholeRow, 0);  // rigid for the model, not for heat
  for (uint32_t v = 3; v < 5; ++v) p.set(v, 3, kWholeRow, 0);  // rigid for both
  std::vector<uint16_t> heat_joints(5 * kHeatSlots, kNoJoint), heat_weights(5 * kHeatSlots, 0), nearest(5, 0);
  const auto heat_row = [&](uint32_t v, uint16_t a, uint16_t wa, uint16_t b, uint16_t wb) {
    heat_joints[v * kHeatSlots] = a;
    heat_weights[v * kHeatSlots] = wa;
    heat_joints[v * kHeatSlots + 1] = wb > 0 ? b : kNoJoint;
    heat_weights[v * kHeatSlots + 1] = wb;
  };
  for (uint32_t v = 0; v < 3; ++v) heat_row(v, 1, 24576, 2, 8192);
  for (uint32_t v = 3; v < 5; ++v) heat_row(v, 0, 32768, 0, 0);
  HeatField heat;
  heat.joints = heat_joints.data();
  heat.weights = heat_weights.data();
  heat.nearest = nearest.data();
  ASSERT_EQ(make_parts_soft(p.mesh, heat, p.counts, p.arena, &p.rows), SINEW_OK);
  for (uint32_t v = 0; v < 3; ++v) {
    EXPECT_EQ(p.rows.weight(v, 1), 49152u) << v;
    EXPECT_EQ(p.rows.weight(v, 2), 16384u) << v;
  }
  for (uint32_t v = 3; v < 5; ++v) EXPECT_EQ(p.rows.weight(v, 3), kWholeRow) << v;
}

TEST(PartStyle, TooSmallABlockIsAStatus) {
  TwoParts p;
  Arena small(p.block.data(), 8);
  EXPECT_EQ(make_parts_rigid(p.mesh, p.counts, small, &p.rows), SINEW_ERROR_WORKSPACE);
}

TEST(Softness, DividesDifferencesAndKeepsTheOrder) {
  const int16_t logits[4] = {1000, 3000, -500, 32000};
  const uint16_t joints[4] = {4, 7, 9, kNoJoint};  // the last slot is absent: its logit counts for nothing
  int16_t out[4];
  soften_logits(logits, joints, 4, 200, out);
  EXPECT_EQ(out[0], -1000);
  EXPECT_EQ(out[1], 0);
  EXPECT_EQ(out[2], -1750);
  soften_logits(logits, joints, 4, 25, out);
  EXPECT_EQ(out[0], -8000);
  EXPECT_EQ(out[2], -14000);
  const int16_t far[2] = {32767, -32768};
  soften_logits(far, joints, 2, 25, out);
  EXPECT_EQ(out[1], INT16_MIN);  // clamped
  uint32_t soft[4], plain[4];
  soften_logits(logits, joints, 4, 400, out);
  softmax_s16_ref(out, joints, 4, 0, soft);
  softmax_s16_ref(logits, joints, 4, 0, plain);
  EXPECT_LT(soft[1], plain[1]);
  EXPECT_GT(soft[1], soft[0]);
  EXPECT_EQ(soft[3], 0u);
}

}  // namespace
}  // namespace sinew
