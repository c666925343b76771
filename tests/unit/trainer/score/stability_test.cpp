// SPDX-License-Identifier: MIT
// What goes with the surface is at rest where it was, what stands still in space is not; joints are told by place, not by number.
#include "sinew_trainer/stability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sinew_data_sets/synthesize.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

using Rows = std::vector<std::vector<Influence>>;

const Character& toy() {
  static const Character c = [] {
    SynthesizeOptions options;
    options.resolution = 32;
    options.clothing = false;
    Character made = synthesize(options);
    made.name = "toys__biped";
    return made;
  }();
  return c;
}

Rows all_on(const Character& c, uint32_t joint) { return Rows(c.vertices.size(), {{joint, 1}}); }

// The topmost vertex of a mesh at rest, by its number.
size_t top(const Character& c) {
  return static_cast<size_t>(
      std::max_element(c.vertices.begin(), c.vertices.end(), [](const Vec3& a, const Vec3& b) { return a.y < b.y; }) -
      c.vertices.begin());
}

Joint joint_at(const Vec3& place) {
  Joint joint;
  joint.position = place;
  return joint;
}

TEST(Stability, WhatGoesWithTheHeadDoesNotMoveAndWhatStandsStillDoes) {
  size_t crown = SIZE_MAX;
  Vec3 still;
  const auto bound = [&](const Character& c, const Vec3& place) { return FoundRig{{joint_at(place)}, all_on(c, 0)}; };
  const auto on_head = [&](const Character& mesh) {
    if (crown == SIZE_MAX) {
      crown = top(mesh);
      still = mesh.vertices[crown];
    }
    EXPECT_TRUE(mesh.joints.empty());
    return bound(mesh, mesh.vertices[crown]);
  };
  const auto own = [&](const Character& c) { return all_on(c, 0); };
  const StabilityFigures good = measure_stability(toy(), 6, on_head, own);
  EXPECT_LT(good.worst_spread, 1e-3);
  EXPECT_EQ(good.flips, 0);
  EXPECT_EQ(good.own_flips, 0);
  const auto in_space = [&](const Character& mesh) { return bound(mesh, still); };
  const StabilityFigures bad = measure_stability(toy(), 6, in_space, own);
  EXPECT_GT(bad.spread, 0.01);
  EXPECT_GE(bad.worst_spread, bad.spread);
}

TEST(Stability, FlipsCountOtherJointsNotOtherNumbers) {
  unsigned call = 0;
  size_t crown = SIZE_MAX, toe = 0;
  const auto find = [&](const Character& mesh) {
    if (crown == SIZE_MAX) {
      crown = top(mesh);
      toe = crown == 0 ? 1 : 0;
    }
    // Head and some other place, in the other order with every call; all vertices belong to the head.
    const bool second = call++ % 2 == 1;
    FoundRig rig{{joint_at(mesh.vertices[crown]), joint_at(mesh.vertices[toe])}, all_on(mesh, second ? 1 : 0)};
    if (second) std::swap(rig.joints[0], rig.joints[1]);
    return rig;
  };
  unsigned turn = 0;  // one vertex in ten changes its joint in every pose
  const auto own = [&](const Character& c) {
    EXPECT_EQ(c.joints.size(), toy().joints.size());
    Rows rows = all_on(c, 0);
    for (size_t v = 0; v < rows.size() && turn > 0; v += 10) rows[v][0].joint = 1;
    ++turn;
    return rows;
  };
  const StabilityFigures figures = measure_stability(toy(), 4, find, own);
  EXPECT_EQ(figures.flips, 0);
  EXPECT_NEAR(figures.own_flips, 0.1, 0.001);
}

TEST(Stability, MeansAndMediansOfCharactersAndFamilies) {
  StabilityRows rows;
  for (const double spread : {0.01, 0.03})
    rows.emplace_back("a__" + std::to_string(spread), StabilityFigures{spread, 0, 0, 0});
  rows.emplace_back("b__one", StabilityFigures{0.08, 0, 0, 0});
  const auto json = nlohmann::json::parse(stability_json(rows));
  EXPECT_NEAR(json["mean_of_characters"]["spread"].get<double>(), 0.04, 1e-12);
  EXPECT_NEAR(json["median_of_characters"]["spread"].get<double>(), 0.03, 1e-12);
  EXPECT_NEAR(json["mean_of_families"]["spread"].get<double>(), 0.05, 1e-12);
  EXPECT_NEAR(json["families"]["a"]["spread"].get<double>(), 0.02, 1e-12);
  EXPECT_NE(stability_markdown(rows).find("| mean of families | 2 | 5.00 |"), std::string::npos)
      << stability_markdown(rows);
}

TEST(Stability, AMeshWithoutFacesIsRefused) {
  Character bare = toy();
  bare.face_offsets = {0};
  bare.face_vertices.clear();
  const auto find = [](const Character&) { return FoundRig{}; };
  EXPECT_THROW(measure_stability(bare, 1, find, [](const Character&) { return Rows(); }), Error);
}

}  // namespace
}  // namespace sinew
