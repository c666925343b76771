// SPDX-License-Identifier: MIT
// What an arm's search finds is what looking at every vertex and every triangle finds.
#include "motion/arm_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "motion/contacts.hpp"
#include "motion_clip.hpp"
#include "with_asan.hpp"

namespace {

using namespace sinew_test;
using sinew::motion::BodyPart;

// A scene that is open and searched, over a clip that plays on boxes.
class Searched {
 public:
  explicit Searched(uint32_t frames, uint32_t most = UINT32_MAX)
      : clip_(body(20), body(35, 0.9)), boxes_(clip_.target, 0.22, 0.9), body_(boxes_.view()) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (uint32_t f = 0; f < frames; ++f) {
      Pose pose = rest_pose(clip_.source);
      for (const uint32_t j : {kSpine, kLeftUpperArm, kLeftForearm, kRightUpperArm, kRightForearm, kLeftThigh}) {
        const sinew::motion::Quat q = sinew::motion::normalized({any(random), any(random), any(random), 0.8});
        pose.set(j, q, vec(&pose.translations[3 * j]));
      }
      clip_.add(pose);
    }
    const auto allocate = [&](sinew::Arena& arena) {
      return scene.allocate_all(arena, clip_.source.count(), clip_.target.count(), body_.vertex_count,
                                body_.triangle_count, frames);
    };
    sinew::Arena measuring;
    (void)allocate(measuring);
    memory_ = sinew::Workspace(measuring.high_water());
    sinew::Arena arena(memory_.data(), memory_.size());
    EXPECT_TRUE(allocate(arena));
    inputs_.frames = frames;
    inputs_.source_rotations = clip_.from_rotations.data();
    inputs_.source_translations = clip_.from_translations.data();
    inputs_.rotations = clip_.rotations.data();
    inputs_.translations = clip_.translations.data();
    EXPECT_EQ(scene.open(clip_.plan, nullptr, body_, inputs_), SINEW_OK);
    scene.search.open(scene, most);
  }

  Vec3d position(uint32_t v) const { return scene.target.vertices[v]; }
  const uint32_t* corners(uint32_t t) const { return body_.triangles + size_t{3} * t; }
  Vec3d middle(uint32_t t) const {
    return (1.0 / 3.0) * (position(corners(t)[0]) + position(corners(t)[1]) + position(corners(t)[2]));
  }
  uint32_t limb_of(uint32_t v) const { return scene.limb_of[v]; }
  bool is_of_arm(uint32_t v, uint32_t arm) const { return limb_of(v) == scene.search.limb(arm); }
  bool is_of_any_arm(uint32_t v) const { return is_of_arm(v, 0) || is_of_arm(v, 1); }
  // Triangles without a vertex for which `is_left_out`, near ones first.
  template <class LeftOut>
  std::vector<std::pair<double, uint32_t>> by_distance(Vec3d p, LeftOut is_left_out) const {
    std::vector<std::pair<double, uint32_t>> all;
    for (uint32_t t = 0; t < body_.triangle_count; ++t) {
      if (std::none_of(corners(t), corners(t) + 3, is_left_out))
        all.emplace_back(sinew::motion::squared(p - middle(t)), t);
    }
    std::sort(all.begin(), all.end());
    return all;
  }
  // How deep a point lies in one of the boxes that are no arm's; negative outside of all.
  double depth_in_boxes(Vec3d p) const {
    double most = -9;
    for (uint32_t j = 0; j < clip_.target.count(); ++j) {
      const uint32_t limb = scene.joint_limbs[j];
      if (limb < sinew::motion::kMostLimbs && !scene.limbs.limbs[limb].leg) continue;
      const Vec3d at = rotate(conjugate(scene.plan->target_rotations[j]), p - scene.plan->target_positions[j]);
      const double half = 0.9 * (j == kSpine ? 0.22 : 0.04);
      most = std::max(most, half - std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}));
    }
    return most;
  }
  Vec3d spine(Vec3d p) const {
    return scene.plan->target_positions[kSpine] + rotate(scene.plan->target_rotations[kSpine], p);
  }
  std::vector<uint32_t> vertices(uint32_t arm, bool hand_alone) const {
    std::vector<uint32_t> all;
    for (uint32_t v = 0; v < body_.vertex_count; ++v) {
      const BodyPart part = scene.parts[v];
      if (is_of_arm(v, arm) && (part == BodyPart::kHand || (!hand_alone && part == BodyPart::kForearm)))
        all.push_back(v);
    }
    return all;
  }

  sinew::motion::ContactScene scene;

 private:
  PlayedClip clip_;
  BoxBody boxes_;
  sinew_motion_body body_;
  sinew::Workspace memory_;
  sinew::motion::ClipInputs inputs_;
};

TEST(ArmSearch, TheDeepestPointIsThatOfAllVerticesAndTriangles) {
  Searched own(60);
  const double reach = sinew::motion::kFar * own.scene.target.height;
  int deep = 0, shallow = 0, left_out = 0;
  for (uint32_t f = 0; f < 60; f += sinew_test::kEveryWithAsan) {
    own.scene.search_target(f, true);
    for (uint32_t arm = 0; arm < 2; ++arm) {
      for (const Vec3d moved : {Vec3d{0, 0, 0}, Vec3d{0.03, -0.02, 0.05}}) {
        double wanted = 0;
        for (const uint32_t v : own.vertices(arm, false)) {
          const Vec3d p = own.position(v) + moved;
          const auto near = own.by_distance(p, [&](uint32_t c) { return own.is_of_any_arm(c); }).front();
          const double depth = dot(own.middle(near.second) - p, own.scene.target.normal(own.corners(near.second)));
          if (near.first <= reach * reach) wanted = std::max(wanted, depth);
        }
        const sinew::motion::ArmDepth found = own.scene.search.deepest(&own.scene.target_tree, arm, moved, 0);
        EXPECT_LE(found.depth, wanted);
        left_out += found.depth < wanted ? 1 : 0;
        ++(wanted > 0 ? deep : shallow);
        // What was found the last time changes nothing.
        const double half = 0.5 * found.depth;
        EXPECT_EQ(own.scene.search.deepest(&own.scene.target_tree, arm, moved, half).depth, found.depth);
        EXPECT_EQ(own.scene.search.deepest(&own.scene.target_tree, arm, moved, wanted + 0.01).depth, wanted + 0.01);
      }
    }
  }
  EXPECT_LE(left_out, 2) << "groups that seem to be outside, beside large triangles";
  EXPECT_GT(deep, 30 / static_cast<int>(sinew_test::kEveryWithAsan));
  EXPECT_GT(shallow, 30 / static_cast<int>(sinew_test::kEveryWithAsan));
}

// 13 of 48 and 72 vertices: an edge of a box is missed at most.
TEST(ArmSearch, AThinnedOutArmIsSeenByAFewOfItsVertices) {
  Searched own(60), few(60, 13);
  double seen = 0, all = 0;
  for (uint32_t arm = 0; arm < 2; ++arm) {
    std::set<uint32_t> listed;
    const std::vector<uint32_t> known = own.vertices(arm, false);
    for (uint32_t f = 0; f < 60; ++f) {
      own.scene.search_target(f, true);
      few.scene.search_target(f, true);
      const sinew::motion::ArmDepth most = own.scene.search.deepest(&own.scene.target_tree, arm, {0, 0, 0}, 0);
      const sinew::motion::ArmDepth found = few.scene.search.deepest(&few.scene.target_tree, arm, {0, 0, 0}, 0);
      EXPECT_LE(found.depth, most.depth);
      all += most.depth;
      seen += found.depth;
      if (found.depth > 0) listed.insert(found.vertex);
    }
    EXPECT_GT(listed.size(), 2u);
    EXPECT_LE(listed.size(), 13u);
    for (const uint32_t v : listed) EXPECT_EQ(std::count(known.begin(), known.end(), v), 1) << v;
  }
  EXPECT_GT(seen, 0.7 * all);
  EXPECT_LT(seen, all);
}

TEST(ArmSearch, WhatIsInsideIsAsDeepAsItIs) {
  Searched own(200);
  int inside = 0;
  for (uint32_t f = 0; f < 200; ++f) {
    own.scene.search_target(f, true);
    for (uint32_t arm = 0; arm < 2; ++arm) {
      const sinew::motion::ArmDepth all = own.scene.search.deepest(&own.scene.target_tree, arm, {0, 0, 0}, 0);
      const sinew::motion::ArmDepth found = own.scene.search.deepest_inside(&own.scene.target_tree, arm, {0, 0, 0}, 0);
      if (all.depth > 0 && own.depth_in_boxes(own.position(all.vertex)) < 0.01) continue;
      EXPECT_EQ(found.depth, all.depth) << f;
      inside += all.depth > 0.02 * own.scene.target.height ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 20);
}

TEST(ArmSearch, TheWayOutIsAcrossASurfaceAndTurnsSlowly) {
  Searched own(1);
  own.scene.search_target(0, true);
  const auto way = [&](Vec3d p) { return own.scene.search.way_out(own.scene.target_tree, own.spine(p), 0.2); };
  const auto across = [&](Vec3d axis) { return rotate(own.scene.plan->target_rotations[kSpine], axis); };
  EXPECT_GT(dot(way({0.19, 0.02, 0.01}), across({1, 0, 0})), 0.8);
  EXPECT_GT(dot(way({0, 0.02, -0.19}), across({0, 0, -1})), 0.8);
  EXPECT_LT(length(way({0, 0, 0})), 0.1) << "every way is as good";
  Vec3d before = way({-0.25, 0.03, 0.02});
  for (double x = -0.24; x < 0.25; x += 0.01) {
    const Vec3d now = way({x, 0.03, 0.02});
    EXPECT_LT(length(now - before), 0.15) << x;
    before = now;
  }
}

TEST(ArmSearch, TheNearestPointAndItsNeighborsAreThoseOfAll) {
  Searched own(60);
  const double reach = sinew::motion::kFar * own.scene.target.height;
  int near_ones = 0;
  for (uint32_t f = 0; f < 60; ++f) {
    own.scene.search_target(f, false);
    for (uint32_t arm = 0; arm < 2; ++arm) {
      const auto is_left_out = [&](uint32_t c) { return own.is_of_arm(c, arm); };
      double wanted = reach * reach;
      uint32_t vertex = UINT32_MAX;
      Vec3d low = {9, 9, 9}, high = {-9, -9, -9};
      for (const uint32_t v : own.vertices(arm, true)) {
        const Vec3d p = own.position(v);
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        const double square = own.by_distance(p, is_left_out).front().first;
        if (square < wanted) {
          wanted = square;
          vertex = v;
        }
      }
      const sinew::motion::HandReach found = own.scene.search.nearest(own.scene.target_tree, arm);
      ASSERT_EQ(found.near, vertex != UINT32_MAX);
      if (!found.near) continue;
      ++near_ones;
      EXPECT_EQ(found.vertex, vertex);
      EXPECT_EQ(found.square, wanted);
      EXPECT_EQ(own.scene.search.distance(own.scene.target_tree, arm, vertex), sinew::root(wanted));
      uint32_t triangles[24];
      double squares[24];
      const uint32_t count = own.scene.search.neighbors(own.scene.target_tree, arm, vertex, 24, triangles, squares);
      uint32_t at = 0;
      for (const auto& [square, t] : own.by_distance(own.position(vertex), is_left_out)) {
        const Vec3d m = own.middle(t), below = low - m, above = m - high;
        if (at == 24 || std::max({below.x, below.y, below.z, above.x, above.y, above.z}) > reach) continue;
        ASSERT_LT(at, count);
        EXPECT_EQ(triangles[at], t);
        EXPECT_EQ(squares[at++], square);
      }
      EXPECT_EQ(at, count);
    }
  }
  EXPECT_GT(near_ones, 20);
}

}  // namespace
