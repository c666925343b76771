// SPDX-License-Identifier: MIT
// Garments without joints get chains: what encloses both legs, what hangs behind the trunk; nothing else does.
#include "sinew_character/springs/make_chains.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "expect_error.hpp"
#include "hairy_person.hpp"

namespace sinew {
namespace {

using sinew_test::HairyPerson;

struct Dressed : HairyPerson {
  size_t first_vertex = 0, last_vertex = 0;  // of the garment

  void skirt(double hem_height, double hem_radius) {
    first_vertex = character.vertices.size();
    cone(index("Hips"), {0, 1, 0}, {0, hem_height, 0}, 0.18, hem_radius);
    last_vertex = character.vertices.size();
  }
  // Quads from the shoulders down, behind the trunk, `wide` to each side.
  void cape(double wide, double hem_height) {
    first_vertex = character.vertices.size();
    const auto first = static_cast<uint32_t>(first_vertex);
    for (int row = 0; row <= 8; ++row)
      for (int k = 0; k <= 6; ++k) {
        const double down = row / 8.0, x = wide * (k / 3.0 - 1);
        character.vertices.push_back(
            to_vec3({x * (1 + 0.5 * down), 1.48 + down * (hem_height - 1.48), -0.2 - 0.1 * down}));
        character.influences.push_back({{static_cast<uint32_t>(index("Spine1")), 1.0f}});
      }
    for (uint32_t row = 0; row < 8; ++row)
      for (uint32_t k = 0; k < 6; ++k)
        quad(first + 7 * row + k, first + 7 * row + k + 1, first + 7 * (row + 1) + k + 1, first + 7 * (row + 1) + k);
    last_vertex = character.vertices.size();
  }
};

void expect_whole_rows(const Character& character) {
  for (const auto& row : character.influences) {
    double sum = 0;
    std::set<uint32_t> joints;
    for (const Influence& one : row) {
      sum += static_cast<double>(one.weight);
      EXPECT_LT(one.joint, character.joints.size());
      EXPECT_TRUE(joints.insert(one.joint).second);
    }
    EXPECT_NEAR(sum, 1, 1e-5);
    EXPECT_LE(row.size(), 4u);
  }
}

TEST(MakeChains, SkirtGetsARingThatItsVerticesFollow) {
  Dressed person;
  person.skirt(0.5, 0.4);
  const Character before = person.character;
  const std::vector<MadeChains> made = make_chains(4, &person.character);
  const Character& c = person.character;
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made[0].kind, SpringKind::kSkirt);
  EXPECT_EQ(c.joints[made[0].on].name, "Hips");
  EXPECT_TRUE(made[0].closed);
  EXPECT_GE(made[0].chains, 6u);
  EXPECT_LE(made[0].chains, 12u);
  EXPECT_EQ(made[0].joints, 3 * made[0].chains);
  ASSERT_EQ(c.joints.size(), before.joints.size() + made[0].joints);
  expect_whole_rows(c);
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    const bool of_skirt = v >= person.first_vertex && v < person.last_vertex;
    double laid = 0;
    for (const Influence& one : c.influences[v])
      if (one.joint >= before.joints.size()) laid += static_cast<double>(one.weight);
    const double y = static_cast<double>(c.vertices[v].y);
    if (!of_skirt || y > 0.96) {
      EXPECT_EQ(laid, 0) << v;
    } else if (y < 0.8) {
      EXPECT_NEAR(laid, 0.4 * ((0.95 - y) / 0.45 - 0.15) / 0.85, 0.05) << v;
    }
  }
  // Chains go down along the cloth, left ones on the left.
  for (size_t j = before.joints.size(); j < c.joints.size(); ++j) {
    const Vec3& p = c.joints[j].position;
    const double radius = std::hypot(p.x, p.z), wide = 0.18 + (1 - static_cast<double>(p.y)) / 0.5 * 0.22;
    EXPECT_NEAR(radius, wide, 0.1 * wide) << c.joints[j].name;
    const auto begins = [&](const char* with) { return c.joints[j].name.rfind(with, 0) == 0; };
    if (begins("Left")) {
      EXPECT_GT(p.x, 0.01f) << c.joints[j].name;
    }
    if (begins("Right")) {
      EXPECT_LT(p.x, -0.01f) << c.joints[j].name;
    }
    if (begins("SkirtFront")) {
      EXPECT_GT(p.z, 0.1f);
    }
    if (begins("LeftSkirt2_1")) {
      EXPECT_EQ(c.joints[static_cast<size_t>(c.joints[j].parent)].name, "LeftUpLeg");
    }
  }
}

TEST(MakeChains, ChainsAreFoundAsSpringsAndNotMadeTwice) {
  Dressed person;
  person.skirt(0.5, 0.4);
  const std::vector<MadeChains> made = make_chains(4, &person.character);
  ASSERT_EQ(made.size(), 1u);
  const std::vector<FoundChain> found = find_springs(person.character);
  EXPECT_EQ(found.size(), made[0].chains);
  for (const FoundChain& one : found) {
    EXPECT_TRUE(one.kept) << one.chain.name;
    EXPECT_EQ(one.kind, SpringKind::kSkirt) << one.chain.name;
    EXPECT_EQ(one.chain.turning_joints(), 3u) << one.chain.name;
  }
  const size_t joints = person.character.joints.size();
  EXPECT_TRUE(make_chains(4, &person.character).empty());
  EXPECT_EQ(person.character.joints.size(), joints);
}

TEST(MakeChains, CapeHangsOnTheChest) {
  Dressed person;
  person.cape(0.25, 0.4);
  const size_t joints = person.character.joints.size();
  const std::vector<MadeChains> made = make_chains(4, &person.character);
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made[0].kind, SpringKind::kCape);
  EXPECT_FALSE(made[0].closed);
  EXPECT_EQ(person.character.joints[made[0].on].name, "Spine1");
  EXPECT_GE(made[0].chains, 3u);
  expect_whole_rows(person.character);
  for (size_t j = joints; j < person.character.joints.size(); ++j)
    EXPECT_LT(person.character.joints[j].position.z, -0.15f) << person.character.joints[j].name;
}

TEST(MakeChains, BodiesAloneGetNone) {
  HairyPerson bare;
  EXPECT_TRUE(make_chains(4, &bare.character).empty());
  // A pack is as deep as it is wide.
  HairyPerson pack;
  pack.tube(pack.index("Spine1"), {0, 1.45, -0.35}, {0, 0.95, -0.35}, 0.16);
  EXPECT_TRUE(make_chains(4, &pack.character).empty());
  // A skirt whose joints swing already.
  Dressed rigged;
  rigged.skirt(0.5, 0.4);
  const auto chain = static_cast<uint32_t>(rigged.add("Skirt1", {0, 0.9, 0.2}, static_cast<int>(rigged.index("Hips"))));
  (void)rigged.add("Skirt2", {0, 0.6, 0.3}, static_cast<int>(chain));
  for (size_t v = rigged.first_vertex; v < rigged.last_vertex; ++v) rigged.character.influences[v] = {{chain, 1.0f}};
  EXPECT_TRUE(make_chains(4, &rigged.character).empty());
}

TEST(MakeChains, WhatCannotHaveThemIsSaid) {
  Character unbound = HairyPerson().character;
  unbound.influences.clear();
  EXPECT_ERROR((void)make_chains(4, &unbound), "no skin weights");
}

}  // namespace
}  // namespace sinew
