// SPDX-License-Identifier: MIT
// sinew_simplify(): which joints become part of which.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "sinew/sinew.hpp"

namespace {

struct Tree {
  std::vector<float> positions;
  std::vector<int32_t> parents;
  std::vector<float> areas;
  std::vector<uint8_t> keep;

  uint32_t add(float x, float y, float z, int32_t parent) {
    positions.insert(positions.end(), {x, y, z});
    parents.push_back(parent);
    return static_cast<uint32_t>(parents.size() - 1);
  }
  sinew_status run(const sinew_simplify_options& options, std::vector<uint32_t>* into) const {
    into->assign(parents.size(), 77777);
    sinew::Workspace workspace;
    return sinew::simplify(sinew_skeleton_init(positions.data(), parents.data(), static_cast<uint32_t>(parents.size())),
                           areas.empty() ? nullptr : areas.data(), keep.empty() ? nullptr : keep.data(), options,
                           &workspace, into);
  }
  std::vector<uint32_t> simplify(uint32_t level, uint32_t joints = 0) const {
    sinew_simplify_options options = sinew_simplify_options_init();
    options.level = level;
    options.joint_count = joints;
    std::vector<uint32_t> into;
    EXPECT_EQ(run(options, &into), SINEW_OK);
    for (size_t j = 0; j < into.size(); ++j) {
      EXPECT_LT(into[j], into.size());
      EXPECT_EQ(into[into[j]], into[j]) << "what a joint is part of stays";
      bool above = false;
      for (int32_t at = static_cast<int32_t>(j); at >= 0; at = parents[static_cast<size_t>(at)])
        above = above || static_cast<uint32_t>(at) == into[j];
      EXPECT_TRUE(above) << "joint " << j << " became part of one that is not above it";
    }
    return into;
  }
};

size_t left(const std::vector<uint32_t>& into) {
  size_t count = 0;
  for (size_t j = 0; j < into.size(); ++j) count += into[j] == j ? 1 : 0;
  return count;
}

// A trunk of three, two arms of two bones and, on each, a helper that hardly has a length.
Tree figure() {
  Tree t;
  const uint32_t hips = t.add(0, 0, 0, -1), chest = t.add(0, 1, 0.1f, static_cast<int32_t>(hips));
  t.add(0, 2, 0, static_cast<int32_t>(chest));
  for (const float side : {1.0f, -1.0f}) {
    const uint32_t arm = t.add(side * 0.4f, 1, 0, static_cast<int32_t>(chest));
    const uint32_t helper = t.add(side * 0.41f, 1, 0, static_cast<int32_t>(arm));
    const uint32_t elbow = t.add(side * 1.2f, 0.9f, 0, static_cast<int32_t>(helper));
    t.add(side * 2, 1, 0, static_cast<int32_t>(elbow));
  }
  return t;
}

TEST(Simplify, ShortBonesGoAndWhatHangsOnThemStays) {
  const std::vector<uint32_t> into = figure().simplify(SINEW_SIMPLIFY_HIGH);
  EXPECT_EQ(into, (std::vector<uint32_t>{0, 1, 2, 3, 3, 5, 6, 7, 7, 9, 10}));
}

TEST(Simplify, JointsThatMoveNothingGoAndThoseThatAreKeptStay) {
  Tree t = figure();
  t.areas.assign(t.parents.size(), 1.0f);
  t.areas[2] = 0;
  t.areas[6] = t.areas[10] = 0.002f;  // 0.02 % of the whole
  EXPECT_EQ(t.simplify(SINEW_SIMPLIFY_HIGH), (std::vector<uint32_t>{0, 1, 1, 3, 3, 5, 5, 7, 7, 9, 9}));
  t.keep.assign(t.parents.size(), 0);
  t.keep[2] = t.keep[4] = 1;
  EXPECT_EQ(t.simplify(SINEW_SIMPLIFY_HIGH), (std::vector<uint32_t>{0, 1, 2, 3, 4, 5, 5, 7, 7, 9, 9}));
}

TEST(Simplify, LeavesOfACrowdGoUntilItIsNone) {
  Tree t;
  t.add(0, 0, 0, -1);
  for (int i = 0; i < 9; ++i)
    t.add(std::cos(0.7f * static_cast<float>(i)), std::sin(0.7f * static_cast<float>(i)), 0.1f * static_cast<float>(i),
          0);
  const size_t high = left(t.simplify(SINEW_SIMPLIFY_HIGH)), low = left(t.simplify(SINEW_SIMPLIFY_LOW));
  EXPECT_EQ(high, 6u);
  EXPECT_EQ(low, 5u);
}

TEST(Simplify, AStraightJointGoesBeforeABentOne) {
  Tree t;
  t.add(0, 0, 0, -1);
  t.add(0, 1, 0, 0);
  t.add(0, 2, 0, 1);  // straight
  t.add(1, 2, 0, 2);  // a corner
  t.add(1, 3, 0, 3);
  const std::vector<uint32_t> into = t.simplify(SINEW_SIMPLIFY_HIGH, 4);
  EXPECT_EQ(left(into), 4u);
  EXPECT_EQ(into[1], 0u);
}

TEST(Simplify, ToANumberAndNotBelowRoots) {
  const Tree t = figure();
  for (uint32_t wanted = 1; wanted <= 12; ++wanted)
    EXPECT_EQ(left(t.simplify(SINEW_SIMPLIFY_LOW, wanted)), std::min<size_t>(wanted, t.parents.size()));
  Tree two = t;
  two.add(5, 0, 0, -1);
  two.keep.assign(two.parents.size(), 0);
  two.keep[3] = 1;
  EXPECT_EQ(left(two.simplify(SINEW_SIMPLIFY_HIGH, 1)), 3u);
}

TEST(Simplify, BothSidesStayAlike) {
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round) {
    Tree t;
    t.add(0, 0, 0, -1);
    const auto draw = [&] { return static_cast<float>(random() % 1000) / 1000; };
    std::vector<std::pair<uint32_t, uint32_t>> pairs = {{0, 0}};
    for (int i = 0; i < 20; ++i) {
      const auto [l, r] = pairs[random() % pairs.size()];
      const float dx = 0.01f + 0.3f * draw() * draw(), dy = 0.3f * draw(), dz = 0.3f * draw();
      const auto at = [&](uint32_t j, float side) {
        const float* const p = &t.positions[3 * size_t{j}];
        return t.add(p[0] + side * dx, p[1] + dy, p[2] + dz, static_cast<int32_t>(j));
      };
      const uint32_t a = at(l, 1), b = at(r, -1);
      pairs.emplace_back(a, b);
    }
    for (const uint32_t level : {SINEW_SIMPLIFY_HIGH, SINEW_SIMPLIFY_LOW}) {
      const std::vector<uint32_t> into = t.simplify(level);
      for (const auto& [a, b] : pairs) EXPECT_EQ(into[a] == a, into[b] == b) << round;
    }
  }
}

TEST(Simplify, LargeAndOddTrees) {
  Tree star, chain, points;
  for (int32_t i = 0; i < 4096; ++i) {
    const float a = static_cast<float>(i);
    star.add(std::sin(a), std::cos(a), a / 4096, i == 0 ? -1 : 0);
    chain.add(a, std::sin(a), 0, i - 1);
    points.add(1, 2, 3, i == 0 ? -1 : i / 2);
  }
  EXPECT_EQ(left(star.simplify(SINEW_SIMPLIFY_HIGH)), 6u);
  EXPECT_EQ(left(star.simplify(SINEW_SIMPLIFY_HIGH, 100)), 100u);
  EXPECT_LT(left(chain.simplify(SINEW_SIMPLIFY_HIGH)), 200u);
  EXPECT_EQ(left(points.simplify(SINEW_SIMPLIFY_HIGH)), 1u);
  Tree one;
  one.add(1e30f, -1e30f, 0, -1);
  EXPECT_EQ(one.simplify(SINEW_SIMPLIFY_LOW), std::vector<uint32_t>{0});
}

TEST(Simplify, WrongCallsAreRefused) {
  const sinew_simplify_options plain = sinew_simplify_options_init();
  std::vector<uint32_t> into;
  const auto with = [&](const auto& change) {
    Tree t = figure();
    sinew_simplify_options options = plain;
    change(t, options);
    const sinew_status status = t.run(options, &into);
    for (const uint32_t i : into) EXPECT_TRUE(status == SINEW_OK || i == 77777u);
    return status;
  };
  using Options = sinew_simplify_options;
  EXPECT_EQ(with([](Tree&, Options&) {}), SINEW_OK);
  EXPECT_EQ(with([](Tree& t, Options&) { t.positions[4] = NAN; }), SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(with([](Tree& t, Options&) { t.areas.assign(11, INFINITY); }), SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(with([](Tree& t, Options&) { t.areas.assign(11, -1); }), SINEW_ERROR_RANGE);
  EXPECT_EQ(with([](Tree& t, Options&) { t.parents[3] = 11; }), SINEW_ERROR_INDEX);
  EXPECT_EQ(with([](Tree& t, Options&) { t.parents[0] = 5; }), SINEW_ERROR_HIERARCHY);
  EXPECT_EQ(with([](Tree&, Options& o) { o.level = 2; }), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(with([](Tree&, Options& o) { o.reserved = 1; }), SINEW_ERROR_VERSION);
  EXPECT_EQ(with([](Tree&, Options& o) { o.struct_size = 4; }), SINEW_ERROR_ARGUMENT);
  size_t bytes = 1;
  EXPECT_EQ(sinew_simplify_workspace_size(0, &bytes), SINEW_ERROR_COUNT);
  EXPECT_EQ(bytes, 0u);
  EXPECT_EQ(sinew_simplify_workspace_size(SINEW_MAX_JOINTS + 1, &bytes), SINEW_ERROR_COUNT);
  EXPECT_EQ(sinew_simplify_workspace_size(3, nullptr), SINEW_ERROR_ARGUMENT);
  const Tree t = figure();
  ASSERT_EQ(sinew_simplify_workspace_size(11, &bytes), SINEW_OK);
  const sinew::Workspace workspace(bytes);
  into.assign(11, 0);
  const sinew_skeleton skeleton = sinew_skeleton_init(t.positions.data(), t.parents.data(), 11);
  EXPECT_EQ(sinew_simplify(&skeleton, nullptr, nullptr, nullptr, workspace.data(), bytes - 1, into.data()),
            SINEW_ERROR_WORKSPACE);
}

}  // namespace
