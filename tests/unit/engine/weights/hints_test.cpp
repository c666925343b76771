// SPDX-License-Identifier: MIT
// What hints change and what they leave alone, on a capsule and a sleeve around it.
#include <gtest/gtest.h>

#include <vector>

#include "hand_rows.hpp"
#include "heat_scene.hpp"
#include "weights/users_say.hpp"

namespace sinew {
namespace {

using sinew_test::HandRows;
using sinew_test::HeatRun;
using sinew_test::run_measured;

// All rows are of joint 0 before; the mesh's lowest vertex is hinted to be joint 1's.
struct Steered {
  explicit Steered(sinew_test::HeatScene scene)
      : run((sinew_test::add_sleeve(&scene, 0.6, 1.0, 2.0, 5, 12), scene), false),
        rows(run.mesh.welded_count),
        given(run.mesh.welded_count) {
    EXPECT_EQ(run.status, SINEW_OK);
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
      rows.set(v, {{0, kWholeRow}});
      if (run.mesh.positions[v].y < run.mesh.positions[hinted].y) hinted = v;
    }
  }
  sinew_status steer(const Progress& progress = {}, size_t missing = 0) {
    return run_measured(
        [&](Arena& arena) {
          return steer_rows(run.mesh, run.skeleton, given.given, run.counts, progress, arena, &rows.rows);
        },
        missing);
  }
  HeatRun run;
  HandRows rows, given;
  uint32_t hinted = 0;
};

TEST(Hints, TheGivenRowComesIntoPlaceAndItsNeighborsFollow) {
  Steered s(sinew_test::capsule(15, 16, 2));
  s.given.give(s.hinted, GivenKind::kSteers, {{1, 65535}});
  ASSERT_EQ(s.steer(), SINEW_OK);
  EXPECT_EQ(s.rows.row(s.hinted), s.given.row(s.hinted));
  const Mesh& mesh = s.run.mesh;
  ASSERT_LT(mesh.row_offsets[s.hinted], mesh.row_offsets[s.hinted + 1]);
  for (uint32_t e = mesh.row_offsets[s.hinted]; e < mesh.row_offsets[s.hinted + 1]; ++e) {
    EXPECT_GT(s.rows.rows.weight(mesh.col_indices[e], 1), kWholeRow / 10);
  }
}

TEST(Hints, AnotherPartKeepsItsRowsBitByBit) {
  Steered s(sinew_test::capsule(15, 16, 2));
  s.given.give(s.hinted, GivenKind::kSteers, {{1, 65535}});
  ASSERT_EQ(s.steer(), SINEW_OK);
  uint32_t others = 0;
  for (uint32_t v = 0; v < s.run.mesh.welded_count; ++v) {
    if (s.run.mesh.part[v] == s.run.mesh.part[s.hinted]) continue;
    EXPECT_EQ(s.rows.rows.weight(v, 0), kWholeRow);
    EXPECT_EQ(s.rows.sum(v), kWholeRow);
    ++others;
  }
  EXPECT_EQ(others, 60u);
}

TEST(Hints, AHintThatSaysWhatIsThereChangesNothing) {
  Steered s(sinew_test::capsule(15, 16, 2));
  s.given.give(s.hinted, GivenKind::kSteers, {{0, kWholeRow}});
  ASSERT_EQ(s.steer(), SINEW_OK);
  for (uint32_t v = 0; v < s.run.mesh.welded_count; ++v) EXPECT_EQ(s.rows.rows.weight(v, 0), kWholeRow) << v;
}

TEST(Hints, AJointThatMayGetNoWeightIsLeftOut) {
  sinew_test::HeatScene scene = sinew_test::capsule(15, 16, 2);
  scene.flags = {0, SINEW_JOINT_NEVER};
  Steered s(scene);
  s.given.give(s.hinted, GivenKind::kSteers, {{1, 65535}});
  ASSERT_EQ(s.steer(), SINEW_OK);
  for (uint32_t v = 0; v < s.run.mesh.welded_count; ++v) {
    const uint32_t expected = v == s.hinted ? 65535 : 0;
    EXPECT_EQ(s.rows.rows.weight(v, 1), expected) << v;
  }
}

TEST(Hints, TooSmallABlockAndCancelingAreStatuses) {
  Steered s(sinew_test::capsule(15, 16, 2));
  s.given.give(s.hinted, GivenKind::kSteers, {{1, 65535}});
  EXPECT_EQ(s.steer({}, 64), SINEW_ERROR_WORKSPACE);
  Progress progress;
  progress.callback = [](void*, uint32_t) { return 1; };
  EXPECT_EQ(s.steer(progress), SINEW_ERROR_CANCELLED);
}

}  // namespace
}  // namespace sinew
