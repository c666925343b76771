// SPDX-License-Identifier: MIT
// Volumes of bends: known ones of a tube, and what has none.
#include "sinew_character/pose/bend_volume.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "expect_error.hpp"
#include "sinew_character/pose/pose.hpp"

namespace sinew {
namespace {

constexpr uint32_t kRings = 9;

// A square tube along y of side 1, from 0 to 8; the upper joint at the middle takes over along four rings. Open at both ends.
Character tube() {
  Character c;
  c.name = "tube";
  c.joints = {{"lower", {0.5f, 0, 0.5f}, -1}, {"upper", {0.5f, 4, 0.5f}, 0}};
  for (uint32_t ring = 0; ring < kRings; ++ring) {
    const float y = static_cast<float>(ring), share = std::clamp((y - 2) / 4, 0.0f, 1.0f);
    for (const Vec3& p : {Vec3{0, y, 0}, Vec3{0, y, 1}, Vec3{1, y, 1}, Vec3{1, y, 0}}) {
      c.vertices.push_back(p);
      c.influences.push_back({{0, 1 - share}, {1, share}});
    }
  }
  for (uint32_t ring = 0; ring + 1 < kRings; ++ring)
    for (uint32_t side = 0; side < 4; ++side) {
      const uint32_t a = 4 * ring + side, b = 4 * ring + (side + 1) % 4;
      c.face_vertices.insert(c.face_vertices.end(), {a, b, b + 4, a + 4});
      c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
    }
  return c;
}

std::vector<float> positions_of(const Character& c) {
  std::vector<float> positions;
  for (const Vec3& p : c.vertices) positions.insert(positions.end(), {p.x, p.y, p.z});
  return positions;
}

TEST(BendVolumes, AtRestAllIsKept) {
  const Character c = tube();
  BendVolumes bends(c);
  EXPECT_NEAR(bends.kept(1, positions_of(c)).value(), 1, 1e-12);
}

TEST(BendVolumes, TheBendIsWhatMovesInPartAndTheFacesAround) {
  const Character c = tube();
  BendVolumes bends(c);
  std::vector<float> positions = positions_of(c);
  // Rings 3 to 5 move in part; faces around them reach from ring 1 to 7: 6 of volume 1. The ring in the middle at half its
  // size makes two pieces of 1 prismatoids of (1 + 1/4 + sqrt(1/4)) / 3 = 7/12.
  for (uint32_t v = 4 * 4; v < 4 * 5; ++v) {
    positions[3 * v] = 0.5f + (positions[3 * v] - 0.5f) / 2;
    positions[3 * v + 2] = 0.5f + (positions[3 * v + 2] - 0.5f) / 2;
  }
  EXPECT_NEAR(bends.kept(1, positions).value(), (4 + 2 * 7.0 / 12) / 6, 1e-6);
  for (float& x : positions) x += 1000;  // wherever it is
  EXPECT_NEAR(bends.kept(1, positions).value(), (4 + 2 * 7.0 / 12) / 6, 1e-3);
  // What lies beside the bend has no say.
  positions = positions_of(c);
  for (uint32_t v = 0; v < 4; ++v) positions[3 * v + 1] -= 5;
  EXPECT_NEAR(bends.kept(1, positions).value(), 1, 1e-12);
}

TEST(BendVolumes, LinearSkinningLosesWhatAHalfTurnTwists) {
  const Character c = tube();
  BendVolumes bends(c);
  const auto kept = [&](bool dual_quaternion) {
    return bends.kept(1, positions_of(apply_pose(c, pose_palette(c, {{1, 0, 175, 0}}), dual_quaternion))).value();
  };
  EXPECT_LT(kept(false), 0.6);
  EXPECT_GT(kept(true), kept(false) + 0.2);
}

TEST(BendVolumes, SeamsAreNoHoles) {
  const Character whole = tube();
  Character cut = whole;  // the last side of each ring has vertices of its own
  for (uint32_t ring = 0; ring < kRings; ++ring) {
    cut.vertices.push_back(whole.vertices[4 * ring]);
    cut.influences.push_back(whole.influences[4 * ring]);
  }
  for (uint32_t ring = 0; ring + 1 < kRings; ++ring) {
    uint32_t* const face = &cut.face_vertices[cut.face_offsets[4 * ring + 3]];
    face[1] = 4 * kRings + ring;
    face[2] = 4 * kRings + ring + 1;
  }
  BendVolumes one(whole), other(cut);
  const std::vector<Affine> palette = pose_palette(whole, {{1, 0, 0, 80}});
  EXPECT_NEAR(one.kept(1, positions_of(apply_pose(whole, palette))).value(),
              other.kept(1, positions_of(apply_pose(cut, palette))).value(), 1e-9);
}

TEST(BendVolumes, ClothAndJointsWithoutABendHaveNone) {
  Character c = tube();
  c.joints.push_back({"idle", {0, 0, 0}, 0});
  BendVolumes bends(c);
  EXPECT_FALSE(bends.kept(0, positions_of(c)).has_value());  // all of the mesh moves with it
  EXPECT_FALSE(bends.kept(2, positions_of(c)).has_value());
  Character flat = tube();
  for (Vec3& p : flat.vertices) p.z *= 0.001f;
  BendVolumes cloth(flat);
  EXPECT_FALSE(cloth.kept(1, positions_of(flat)).has_value());
  c.joints[0].parent = 1;
  EXPECT_ERROR(BendVolumes(c).kept(1, positions_of(c)), "tube", "cycle");
}

}  // namespace
}  // namespace sinew
