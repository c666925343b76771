// SPDX-License-Identifier: MIT
// Pedestals that are one surface with their figures are found; feet, robes and boxes are none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sinew_character/predict/scenery.hpp"

namespace sinew {
namespace {

struct Ring {
  float height, radius, x = 0;
};

// A lathe: rings of 24 vertices, one after the other, with a lid at both ends.
void add_lathe(const std::vector<Ring>& rings, Axis up, Character* mesh) {
  constexpr uint32_t kAround = 24;
  const auto first = static_cast<uint32_t>(mesh->vertices.size());
  for (const Ring& ring : rings)
    for (uint32_t i = 0; i < kAround; ++i) {
      const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kAround;
      const float a = ring.x + ring.radius * std::cos(angle), b = ring.radius * std::sin(angle);
      mesh->vertices.push_back(up == Axis::kZ ? Vec3{a, b, ring.height} : Vec3{a, ring.height, b});
    }
  const auto face = [&](const std::vector<uint32_t>& corners) {
    for (const uint32_t c : corners) mesh->face_vertices.push_back(first + c);
    mesh->face_offsets.push_back(static_cast<uint32_t>(mesh->face_vertices.size()));
  };
  for (uint32_t r = 0; r + 1 < rings.size(); ++r)
    for (uint32_t i = 0; i < kAround; ++i) {
      const uint32_t j = (i + 1) % kAround;
      face({r * kAround + i, r * kAround + j, (r + 1) * kAround + j, (r + 1) * kAround + i});
    }
  for (const uint32_t ring : {0u, static_cast<uint32_t>(rings.size() - 1)}) {
    std::vector<uint32_t> lid;
    for (uint32_t i = 0; i < kAround; ++i) lid.push_back(ring * kAround + i);
    face(lid);
  }
}

TEST(FusedBase, ADiscUnderAFigureIsFoundWhicheverAxisIsUp) {
  for (const Axis up : {Axis::kY, Axis::kZ}) {
    Character statue;
    add_lathe({{0, 0.4f}, {0.1f, 0.4f}, {0.1f, 0.1f}, {0.9f, 0.1f}, {1, 0.15f}}, up, &statue);
    const std::vector<uint8_t> base = find_fused_base(statue, up);
    ASSERT_EQ(base.size(), statue.vertices.size());
    for (size_t v = 0; v < base.size(); ++v) {
      const float height = up == Axis::kZ ? statue.vertices[v].z : statue.vertices[v].y;
      EXPECT_EQ(base[v], height < 0.13f ? 1 : 0) << height;
    }
  }
}

TEST(FusedBase, FeetRobesAndColumnsAreNone) {
  Character feet;  // under legs
  for (const float x : {-0.15f, 0.15f})
    add_lathe({{0, 0.12f, x}, {0.06f, 0.12f, x}, {0.07f, 0.05f, x}, {1, 0.05f, x}}, Axis::kY, &feet);
  EXPECT_TRUE(find_fused_base(feet, Axis::kY).empty());
  Character robe;
  add_lathe({{0, 0.4f}, {0.5f, 0.2f}, {0.8f, 0.1f}, {1, 0.1f}}, Axis::kY, &robe);
  EXPECT_TRUE(find_fused_base(robe, Axis::kY).empty());
  Character column;
  add_lathe({{0, 0.2f}, {1, 0.2f}}, Axis::kY, &column);
  EXPECT_TRUE(find_fused_base(column, Axis::kY).empty());
  EXPECT_TRUE(find_fused_base(Character(), Axis::kY).empty());
}

}  // namespace
}  // namespace sinew
