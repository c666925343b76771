// SPDX-License-Identifier: MIT
// Filled-in rows: known ones are held, the others are smooth between them, sum to a whole, and parts without any stay as they are.
#include "transfer/inpaint.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "transfer_scene.hpp"

namespace sinew::transferring {
namespace {

using sinew_test::MeshRun;
using sinew_test::MeshScene;

struct Inpainted {
  MeshRun run;
  std::vector<uint16_t> joints;
  std::vector<uint32_t> weights;
  std::vector<uint8_t> known;
  Rows rows;
  size_t measured = 0;

  explicit Inpainted(const MeshScene& scene) : run(scene) {
    const size_t count = run.mesh.welded_count;
    joints.resize(count * kRowSlots);
    weights.resize(count * kRowSlots);
    known.resize(count, 0);
    rows.joints = joints.data();
    rows.weights = weights.data();
    for (uint32_t v = 0; v < count; ++v) {
      rows.clear(v);
      rows.add(v, 2, kWholeRow);  // the guess
    }
  }
  double height(uint32_t v) const { return static_cast<double>(run.mesh.positions[v].y) / kSide; }
  void hold(uint32_t v, uint16_t joint) {
    known[v] = 1;
    rows.clear(v);
    rows.add(v, joint, kWholeRow);
  }
  sinew_status fill(size_t missing = 0) {
    Arena measuring;
    (void)inpaint(run.mesh, known.data(), 3, run.counts, measuring, &rows);
    measured = measuring.high_water();
    sinew::Workspace block(measured);
    Arena arena(block.data(), measured - missing);
    return inpaint(run.mesh, known.data(), 3, run.counts, arena, &rows);
  }
  double share(uint32_t v, uint16_t joint) const { return rows.weight(v, joint) / static_cast<double>(kWholeRow); }
};

TEST(Inpaint, GoesSmoothlyFromOneEndToTheOther) {
  Inpainted i(sinew_test::limb(31, 10, 3, 0.2));
  for (uint32_t v = 0; v < i.run.mesh.welded_count; ++v) {
    if (i.height(v) < 0.1) i.hold(v, 0);
    if (i.height(v) > 0.9) i.hold(v, 1);
  }
  ASSERT_EQ(i.fill(), SINEW_OK);
  for (uint32_t v = 0; v < i.run.mesh.welded_count; ++v) {
    EXPECT_EQ(i.rows.weight(v, 2), 0u) << "the guess is gone";
    EXPECT_NEAR(i.share(v, 0) + i.share(v, 1), 1, 1e-4);
    if (i.height(v) < 0.1) {
      EXPECT_EQ(i.share(v, 0), 1);
    }
    if (i.height(v) > 0.9) {
      EXPECT_EQ(i.share(v, 1), 1);
    }
    if (i.height(v) > 0.45 && i.height(v) < 0.55) {
      EXPECT_NEAR(i.share(v, 0), 0.5, 0.12) << i.height(v);
    }
    if (i.height(v) > 0.6 && i.height(v) < 0.7) {
      EXPECT_GT(i.share(v, 1), 0.5);
    }
  }
}

TEST(Inpaint, PartsWithoutAKnownVertexKeepTheirRows) {
  MeshScene scene = sinew_test::limb(9, 6, 3, 0.2);
  sinew_test::add_cube(&scene, 2, 0, 0);
  Inpainted i(scene);
  for (uint32_t v = 0; v < i.run.mesh.welded_count; ++v)
    if (i.height(v) < 0.01 && i.run.mesh.positions[v].x < 0) i.hold(v, 0);
  ASSERT_EQ(i.fill(), SINEW_OK);
  uint32_t kept = 0, filled = 0;
  for (uint32_t v = 0; v < i.run.mesh.welded_count; ++v) {
    kept += i.share(v, 2) == 1 ? 1u : 0u;
    filled += i.share(v, 0) == 1 ? 1u : 0u;
  }
  EXPECT_EQ(kept, 8u);
  EXPECT_EQ(filled, i.run.mesh.welded_count - 8);
}

TEST(Inpaint, AllOrNothingKnownChangesNothing) {
  for (const bool all : {true, false}) {
    Inpainted i(sinew_test::limb(9, 6, 3, 0.2));
    for (uint32_t v = 0; v < i.run.mesh.welded_count && all; ++v) i.hold(v, static_cast<uint16_t>(v % 3));
    const std::vector<uint32_t> before = i.weights;
    ASSERT_EQ(i.fill(), SINEW_OK);
    EXPECT_EQ(i.weights, before);
  }
}

TEST(Inpaint, AFullWorkspaceIsAStatus) {
  Inpainted i(sinew_test::limb(9, 6, 3, 0.2));
  i.hold(0, 1);
  EXPECT_EQ(i.fill(64), SINEW_ERROR_WORKSPACE);
}

}  // namespace
}  // namespace sinew::transferring
