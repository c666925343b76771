// SPDX-License-Identifier: MIT
// Partners across the mirror plane, and rows of partners that become mirror images.
#include "weights/symmetry.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "hand_rows.hpp"
#include "heat_scene.hpp"

namespace sinew {
namespace {

using sinew_test::HandRows;
using sinew_test::HeatRun;
using sinew_test::HeatScene;
using sinew_test::run_measured;

// A capsule whose rings are symmetric in x, two joints on its axis (0 and 1) and one on each side (2 and 3).
HeatScene two_sided() {
  HeatScene scene = sinew_test::capsule(9, 12, 2);
  scene.add_joint(0.3, 2.0, 0, 0);
  scene.add_joint(-0.3, 2.0, 0, 0);
  return scene;
}

struct Found {
  explicit Found(const HeatScene& scene) : run(scene, false), joint(scene.joint_count()), vertex(scene.vertex_count()) {
    symmetry.joint = joint.data();
    symmetry.vertex = vertex.data();
    EXPECT_EQ(run.status, SINEW_OK);
    EXPECT_EQ(find(), SINEW_OK);
  }
  sinew_status find(size_t missing = 0) {
    return run_measured(
        [&](Arena& arena) { return find_symmetry(run.mesh, run.skeleton, run.counts, arena, &symmetry); }, missing);
  }
  // A welded vertex on the left whose partner is another one.
  uint32_t left() const {
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
      if (symmetry.vertex[v] != kNoPartner && symmetry.vertex[v] > v) return v;
    }
    return kNoPartner;
  }
  HeatRun run;
  std::vector<uint16_t> joint;
  std::vector<uint32_t> vertex;
  Symmetry symmetry;
};

TEST(Symmetry, PairsVerticesAndJointsAcrossThePlane) {
  Found found(two_sided());
  EXPECT_TRUE(found.symmetry.symmetric);
  EXPECT_EQ(found.symmetry.plane, 0);
  EXPECT_EQ(found.symmetry.paired_count, found.run.mesh.welded_count);
  EXPECT_EQ(found.joint, (std::vector<uint16_t>{0, 1, 3, 2}));
  for (uint32_t v = 0; v < found.run.mesh.welded_count; ++v) {
    const uint32_t partner = found.symmetry.vertex[v];
    ASSERT_LT(partner, found.run.mesh.welded_count);
    EXPECT_EQ(found.symmetry.vertex[partner], v);
    EXPECT_NEAR(found.run.mesh.positions[v].x, -found.run.mesh.positions[partner].x, kSide / 512);
    EXPECT_NEAR(found.run.mesh.positions[v].y, found.run.mesh.positions[partner].y, kSide / 512);
  }
}

TEST(Symmetry, IsNotFoundWithoutPartners) {
  HeatScene scene = two_sided();
  for (size_t i = 0; i < scene.positions.size(); i += 3) {
    if (scene.positions[i] > 0) scene.positions[i] *= 1.5f;
  }
  EXPECT_FALSE(Found(scene).symmetry.symmetric);
  HeatScene lame = two_sided();
  for (size_t j = 0; j < lame.joint_count(); ++j) lame.joints[3 * j] += 0.05f * static_cast<float>(j + 1);
  EXPECT_FALSE(Found(lame).symmetry.symmetric);
}

TEST(Symmetry, TooSmallABlockIsAStatus) {
  Found found(two_sided());
  EXPECT_EQ(found.find(64), SINEW_ERROR_WORKSPACE);
}

TEST(Symmetry, MirrorsAGivenRowOntoAFreePartner) {
  Found found(two_sided());
  HandRows rows(found.run.mesh.welded_count);
  const uint32_t left = found.left(), right = found.symmetry.vertex[left];
  rows.give(left, GivenKind::kSteers, {{2, 50000}, {1, 15535}});
  mirror_given_rows(found.run.mesh, found.symmetry, &rows.given);
  EXPECT_EQ(rows.given.kind[right], GivenKind::kSteers);
  EXPECT_EQ(rows.rows.weight(right, 3), 50000u);
  EXPECT_EQ(rows.rows.weight(right, 1), 15535u);

  rows.give(right, GivenKind::kKept, {{3, 65535}});  // given itself: stays
  mirror_given_rows(found.run.mesh, found.symmetry, &rows.given);
  EXPECT_EQ(rows.given.kind[right], GivenKind::kKept);
  EXPECT_EQ(rows.rows.weight(right, 3), 65535u);
}

TEST(Symmetry, RowsOfAPairBecomeTheMeanOfOneAndTheOthersImage) {
  Found found(two_sided());
  HandRows rows(found.run.mesh.welded_count), nothing(found.run.mesh.welded_count);
  for (uint32_t v = 0; v < found.run.mesh.welded_count; ++v) rows.set(v, {{0, kWholeRow}});
  const uint32_t left = found.left(), right = found.symmetry.vertex[left];
  rows.set(left, {{2, kWholeRow}});
  rows.set(right, {{1, kWholeRow}});
  mirror_rows(found.run.mesh, nothing.given, 4, &rows.rows, &found.symmetry);
  EXPECT_EQ(rows.rows.weight(left, 2), rows.rows.weight(left, 1));
  EXPECT_EQ(rows.rows.weight(right, 3), rows.rows.weight(left, 2));
  EXPECT_EQ(rows.rows.weight(right, 1), rows.rows.weight(left, 1));
  EXPECT_EQ(found.symmetry.vertex[left], right);
}

TEST(Symmetry, AVertexOnThePlaneKeepsWholePairsOfJoints) {
  Found found(two_sided());
  uint32_t middle = 0;
  while (found.symmetry.vertex[middle] != middle) ++middle;
  HandRows rows(found.run.mesh.welded_count), nothing(found.run.mesh.welded_count);
  for (uint32_t v = 0; v < found.run.mesh.welded_count; ++v) rows.set(v, {{0, kWholeRow}});
  rows.set(middle, {{0, 30000}, {1, 20000}, {2, 10000}, {3, 5536}});
  mirror_rows(found.run.mesh, nothing.given, 3, &rows.rows, &found.symmetry);
  EXPECT_GT(rows.rows.weight(middle, 0), 0u);
  EXPECT_GT(rows.rows.weight(middle, 1), 0u);
  EXPECT_EQ(rows.rows.weight(middle, 2), 0u);  // of two partners both or none
  EXPECT_EQ(rows.rows.weight(middle, 3), 0u);
}

TEST(Symmetry, APairWithAGivenRowLosesItsPartners) {
  Found found(two_sided());
  HandRows rows(found.run.mesh.welded_count), given(found.run.mesh.welded_count);
  for (uint32_t v = 0; v < found.run.mesh.welded_count; ++v) rows.set(v, {{0, kWholeRow}});
  const uint32_t left = found.left(), right = found.symmetry.vertex[left];
  given.give(left, GivenKind::kKept, {{1, 65535}});
  mirror_rows(found.run.mesh, given.given, 4, &rows.rows, &found.symmetry);
  EXPECT_EQ(found.symmetry.vertex[left], kNoPartner);
  EXPECT_EQ(found.symmetry.vertex[right], kNoPartner);
  EXPECT_EQ(rows.rows.weight(left, 1), 65535u);
  EXPECT_EQ(rows.rows.weight(right, 0), kWholeRow);
}

TEST(Symmetry, MirroredInfluencesAreSortedAgain) {
  uint16_t partner[4] = {0, 3, 2, 1};
  Symmetry symmetry;
  symmetry.joint = partner;
  uint16_t joints[4] = {0, 2, 3, 0}, weights[4] = {40000, 12767, 12767, 1};
  mirror_influences(symmetry, 4, joints, weights);
  EXPECT_EQ(joints[0], 0);
  EXPECT_EQ(joints[1], 1);  // 3's partner, before 2 of the same weight
  EXPECT_EQ(joints[2], 2);
  EXPECT_EQ(weights[3], 1);
}

}  // namespace
}  // namespace sinew
