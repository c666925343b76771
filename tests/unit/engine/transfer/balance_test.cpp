// SPDX-License-Identifier: MIT
// How much is carried over, and rows that are divided, folded and mixed: nothing of a row is lost.
#include "transfer/balance.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "arena_block.hpp"
#include "mesh_scene.hpp"

namespace sinew::transferring {
namespace {

using sinew_test::Block;
using sinew_test::MeshRun;
using sinew_test::MeshScene;

struct Weighed {
  MeshRun run = MeshRun(sinew_test::cube_sphere(4));
  Block block = Block(size_t{1} << 20);
  Balance balance;

  Weighed() { EXPECT_TRUE(balance.allocate(block.arena, run.counts)); }
  uint32_t count() const { return run.mesh.welded_count; }
  double mean(double style, double mismatch) {
    for (uint32_t v = 0; v < count(); ++v) {
      balance.style[v] = style;
      balance.mismatch[v] = mismatch;
    }
    balance.weigh(run.mesh);
    double sum = 0;
    for (uint32_t v = 0; v < count(); ++v) {
      EXPECT_GE(balance.carried[v], 0);
      EXPECT_LE(balance.carried[v], 1);
      sum += balance.carried[v];
    }
    return sum / count();
  }
};

TEST(Balance, StyleCarriesOverAndMismatchDoesNot) {
  Weighed w;
  EXPECT_GT(w.mean(1, 0), 0.99);
  EXPECT_LT(w.mean(0, 1), 0.01);
  EXPECT_LT(w.mean(0, 0), 0.01) << "what a bind gives is bound";
  EXPECT_GT(w.mean(0.4, 0.2), w.mean(0.4, 0.4));
}

TEST(Balance, AGarmentIsCarriedOverWhereItIsNear) {
  Weighed w;
  std::vector<MatchedPoint> points(w.count());
  Match match;
  match.points = points.data();
  w.balance.weigh_by_distance(w.run.mesh, match);
  for (uint32_t v = 0; v < w.count(); ++v) EXPECT_EQ(w.balance.carried[v], 1);
  for (MatchedPoint& p : points) p.distance = 0.2;
  w.balance.weigh_by_distance(w.run.mesh, match);
  for (uint32_t v = 0; v < w.count(); ++v) EXPECT_EQ(w.balance.carried[v], 0);
}

// One vertex' rows.
struct OneRow {
  uint16_t joints[kRowSlots];
  uint32_t weights[kRowSlots];
  Rows rows;

  explicit OneRow(const std::vector<std::pair<uint16_t, uint32_t>>& row = {}) {
    rows.joints = joints;
    rows.weights = weights;
    rows.clear(0);
    for (const auto& [joint, weight] : row) rows.add(0, joint, weight);
  }
  uint32_t sum() const {
    uint32_t sum = 0;
    for (const uint32_t w : weights) sum += w;
    return sum;
  }
};

// Joints 0 and 2 have a counterpart; 1 is below 0, and 3 below 2.
struct Heads {
  int32_t head[4] = {0, 0, 2, 2};
  JointCounterparts map;
  Heads() { map.head = head; }
};

TEST(Rows, NewJointsGetWhatABindGivesThem) {
  const Heads heads;
  const OneRow bound({{0, 10000}, {1, 30000}, {2, 25535}});
  const OneRow carried({{0, 40000}, {2, 25535}});
  share_with_new_joints(heads.map, bound.rows, 0, carried.rows);
  EXPECT_EQ(carried.rows.weight(0, 0), 10000u);
  EXPECT_EQ(carried.rows.weight(0, 1), 30000u);
  EXPECT_EQ(carried.rows.weight(0, 2), 25535u);
  EXPECT_EQ(carried.rows.weight(0, 3), 0u);
  // Where a bind gives the head and what is below it nothing, the head keeps its weight.
  const OneRow other({{3, 65535}}), own({{0, 65535}});
  share_with_new_joints(heads.map, other.rows, 0, own.rows);
  EXPECT_EQ(own.rows.weight(0, 0), 65535u);
}

TEST(Rows, FoldingGivesNewJointsToTheirHeads) {
  const Heads heads;
  const OneRow bound({{0, 10000}, {1, 30000}, {3, 25535}}), out;
  fold_new_joints(heads.map, bound.rows, 0, out.rows, 0);
  EXPECT_EQ(out.rows.weight(0, 0), 40000u);
  EXPECT_EQ(out.rows.weight(0, 2), 25535u);
  EXPECT_EQ(out.sum(), 65535u);
}

TEST(Rows, MixingIsBetweenBoth) {
  const OneRow bound({{0, 65535}});
  for (const double share : {0.0, 0.25, 1.0}) {
    const OneRow carried({{1, 65535}});
    mix_rows(bound.rows, share, 0, carried.rows);
    EXPECT_NEAR(static_cast<double>(carried.rows.weight(0, 1)) / carried.sum(), share, 1e-4) << share;
    EXPECT_NEAR(carried.sum(), static_cast<double>(kWholeRow), 2);
  }
}

}  // namespace
}  // namespace sinew::transferring
