// SPDX-License-Identifier: MIT
// sinew_simplify(): which joints become part of which.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "sinew/sinew.hpp"
#include "skeleton_of.hpp"

namespace {

struct Tree {
  std::vector<float> positions;
  std::vector<int32_t> parents;
  std::vector<float> areas;
  std::vector<uint8_t> keep;
  std::vector<std::string> names;  // none, or [J]

  uint32_t add(float x, float y, float z, int32_t parent) {
    positions.insert(positions.end(), {x, y, z});
    parents.push_back(parent);
    return static_cast<uint32_t>(parents.size() - 1);
  }
  sinew_status run(const sinew_simplify_options& options, std::vector<uint32_t>* into) const {
    into->assign(parents.size(), 77777);
    sinew::Workspace workspace;
    std::vector<const char*> texts;
    for (const std::string& name : names) texts.push_back(name.c_str());
    sinew_skeleton skeleton = sinew_test::skeleton_of(positions, parents);
    if (!names.empty()) skeleton.names = texts.data();
    return sinew::simplify(skeleton, areas.empty() ? nullptr : areas.data(), keep.empty() ? nullptr : keep.data(),
                           options, &workspace, into);
  }
  std::vector<uint32_t> simplify(uint32_t level, uint32_t joints = 0) const {
    sinew_simplify_options options = SINEW_INIT(sinew_simplify_options);
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

// A man with what rigs hang on one. Body joints begin with a capital letter.
Tree man() {
  Tree t;
  const auto add = [&](const std::string& name, float x, float y, float z, uint32_t parent) {
    t.names.push_back(name);
    return t.add(x, y, z, t.parents.empty() ? -1 : static_cast<int32_t>(parent));
  };
  const uint32_t hips = add("Hips", 0, 1, 0, 0), spine = add("Spine", 0, 1.1f, 0, hips);
  const uint32_t middle = add("spine_01", 0, 1.25f, 0, spine), chest = add("Spine_02", 0, 1.4f, 0, middle);
  const uint32_t neck = add("neck", 0, 1.55f, 0, chest), head = add("Head", 0, 1.65f, 0, neck);
  add("head_end", 0, 1.85f, 0, head);
  add("jaw", 0, 1.68f, 0.06f, head);
  for (const std::string side : {"_l", "_r"}) {
    const float x = side == "_l" ? 1.0f : -1.0f;
    add("eye" + side, 0.03f * x, 1.75f, 0.08f, head);
    add("breast" + side, 0.1f * x, 1.35f, 0.15f, chest);
    const uint32_t clavicle = add("clavicle" + side, 0.03f * x, 1.5f, 0, chest);
    const uint32_t arm = add("Upperarm" + side, 0.18f * x, 1.5f, 0, clavicle);
    add("upperarm_twist" + side, 0.3f * x, 1.5f, 0, arm);
    const uint32_t forearm = add("Lowerarm" + side, 0.45f * x, 1.5f, -0.02f, arm);
    add("lowerarm_twist" + side, 0.58f * x, 1.5f, 0, forearm);
    const uint32_t hand = add("Hand" + side, 0.7f * x, 1.5f, 0, forearm);
    for (const std::string finger : {"thumb", "index", "middle", "ring", "pinky"}) {
      const float z = finger == "thumb" ? 0.06f : 0.02f - 0.015f * static_cast<float>(finger.size());
      uint32_t at = hand;
      for (const int k : {1, 2, 3})
        at = add(finger + "_0" + std::to_string(k) + side, (0.76f + 0.03f * static_cast<float>(k)) * x, 1.5f, z, at);
    }
    const uint32_t thigh = add("Thigh" + side, 0.1f * x, 0.95f, 0, hips);
    add("thigh_twist" + side, 0.1f * x, 0.7f, 0, thigh);
    const uint32_t calf = add("Calf" + side, 0.1f * x, 0.5f, 0.02f, thigh);
    const uint32_t foot = add("Foot" + side, 0.1f * x, 0.08f, 0, calf);
    add("ball" + side, 0.1f * x, 0.02f, 0.12f, foot);
  }
  return t;
}

bool is_body(const std::string& name) { return name[0] >= 'A' && name[0] <= 'Z'; }

TEST(Simplify, TheBodyGoesLast) {
  const Tree t = man();
  const size_t body = static_cast<size_t>(std::count_if(t.names.begin(), t.names.end(), is_body));
  ASSERT_EQ(body, 16u);
  for (uint32_t wanted = 1; wanted <= t.parents.size(); ++wanted) {
    const std::vector<uint32_t> into = t.simplify(SINEW_SIMPLIFY_LOW, wanted);
    EXPECT_EQ(left(into), wanted);
    size_t stays = 0;
    for (size_t j = 0; j < into.size(); ++j) stays += into[j] == j && is_body(t.names[j]) ? 1 : 0;
    EXPECT_EQ(stays, std::min<size_t>(wanted, body)) << wanted;
  }
  for (const uint32_t level : {SINEW_SIMPLIFY_HIGH, SINEW_SIMPLIFY_LOW}) {
    const std::vector<uint32_t> into = t.simplify(level);
    for (size_t j = 0; j < into.size(); ++j) {
      EXPECT_TRUE(into[j] == j || !is_body(t.names[j])) << t.names[j];
      const bool detail = t.names[j].find("twist") != std::string::npos || t.names[j] == "jaw" ||
                          t.names[j].find("eye") == 0 || t.names[j].find("breast") == 0 || t.names[j] == "head_end";
      EXPECT_TRUE(into[j] != j || !detail) << t.names[j];
    }
    EXPECT_EQ(left(into) > 40, level == SINEW_SIMPLIFY_HIGH) << "fingers stay at the high level alone";
  }
}

TEST(Simplify, ABodyWithoutNamesStaysToo) {
  Tree t = man();
  const std::vector<std::string> names = std::move(t.names);
  t.names.clear();
  const std::vector<uint32_t> into = t.simplify(SINEW_SIMPLIFY_LOW);
  for (size_t j = 0; j < into.size(); ++j) {
    const bool limb = names[j].find("Thigh") == 0 || names[j].find("Calf") == 0 || names[j].find("Upperarm") == 0 ||
                      names[j].find("Lowerarm") == 0;
    EXPECT_TRUE(into[j] == j || !limb) << names[j];
  }
}

TEST(Simplify, SamplesOfTheSurfaceSayWhatIsNear) {
  Tree t;
  t.add(0, 0, 0, -1);
  for (int i = 1; i < 6; ++i) t.add(0, static_cast<float>(i), 0, i - 1);  // straight: only the samples' distances count
  sinew_simplify_options options = SINEW_INIT(sinew_simplify_options);
  options.joint_count = 5;
  std::vector<uint32_t> into;
  std::vector<float> centroids = t.positions;
  centroids[3 * 3 + 1] = 2.1f;  // what moves with joint 3 lies beside what moves with joint 2
  options.centroids = centroids.data();
  ASSERT_EQ(t.run(options, &into), SINEW_OK);
  EXPECT_EQ(into[3], 2u);
  centroids[3 * 3 + 1] = 3;
  centroids[3 * 4 + 1] = 3.1f;
  ASSERT_EQ(t.run(options, &into), SINEW_OK);
  EXPECT_EQ(into[4], 3u);
  centroids[5] = NAN;
  EXPECT_EQ(t.run(options, &into), SINEW_ERROR_NOT_FINITE);
}

TEST(Simplify, ShortBonesGoAndWhatHangsOnThemStays) {
  EXPECT_EQ(left(figure().simplify(SINEW_SIMPLIFY_HIGH)), 11u) << "by their degree alone";
  const std::vector<uint32_t> into = figure().simplify(SINEW_SIMPLIFY_LOW);
  EXPECT_EQ(into, (std::vector<uint32_t>{0, 1, 2, 3, 3, 5, 6, 7, 7, 9, 10}));
}

TEST(Simplify, JointsThatMoveNothingGoAndThoseThatAreKeptStay) {
  Tree t = figure();
  t.areas.assign(t.parents.size(), 1.0f);
  t.areas[2] = 0;
  t.areas[6] = t.areas[10] = 0.002f;  // 0.02 % of the whole
  EXPECT_EQ(t.simplify(SINEW_SIMPLIFY_LOW), (std::vector<uint32_t>{0, 1, 1, 3, 3, 5, 5, 7, 7, 9, 9}));
  t.keep.assign(t.parents.size(), 0);
  t.keep[2] = t.keep[4] = 1;
  EXPECT_EQ(t.simplify(SINEW_SIMPLIFY_LOW), (std::vector<uint32_t>{0, 1, 2, 3, 4, 5, 5, 7, 7, 9, 9}));
}

TEST(Simplify, LeavesOfACrowdGoUntilItIsNone) {
  // Nine small leaves beside a long bone.
  const auto crowd = [](float size) {
    Tree t;
    t.add(0, 0, 0, -1);
    t.add(0, -20, 0, 0);
    for (int i = 0; i < 9; ++i) {
      const float turn = 0.7f * static_cast<float>(i);
      t.add(size * std::cos(turn), size * std::sin(turn), 0.1f * size * static_cast<float>(i), 0);
    }
    return t;
  };
  EXPECT_EQ(left(crowd(0.15f).simplify(SINEW_SIMPLIFY_HIGH)), 3u);
  EXPECT_EQ(left(crowd(1.2f).simplify(SINEW_SIMPLIFY_HIGH)), 11u);
  EXPECT_EQ(left(crowd(1.2f).simplify(SINEW_SIMPLIFY_LOW)), 3u);
  EXPECT_EQ(left(crowd(5).simplify(SINEW_SIMPLIFY_LOW)), 11u) << "by its degree alone no limb goes";
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

// One bone a little below the limit of length, its mirror image a little above.
TEST(Simplify, AMirrorImageGoesThoughItIsALittleLonger) {
  Tree t;
  t.add(0, 0, 0, -1);
  t.add(0, 1, 0, 0);
  for (const float side : {0.0396f, -0.0397f}) {
    const uint32_t arm = t.add(side < 0 ? -0.5f : 0.5f, 1, 0, 1);
    t.add((side < 0 ? -0.5f : 0.5f) + 1.4142f * side, 1, 0, static_cast<int32_t>(arm));
  }
  const std::vector<uint32_t> into = t.simplify(SINEW_SIMPLIFY_LOW);
  EXPECT_EQ(into[3] == 3, into[5] == 5);
}

// As published: whatever a joint is called, so that arms go at the chest where three bones meet.
TEST(Simplify, AsDrawnNamesSayNothing) {
  const Tree t = man();
  Tree unnamed = t;
  unnamed.names.clear();
  sinew_simplify_options options = SINEW_INIT(sinew_simplify_options);
  options.as_drawn = 1;
  std::vector<uint32_t> into, same;
  ASSERT_EQ(t.run(options, &into), SINEW_OK);
  ASSERT_EQ(unnamed.run(options, &same), SINEW_OK);
  EXPECT_EQ(into, same);
  size_t body = 0;
  for (size_t j = 0; j < into.size(); ++j) {
    body += into[j] == j && is_body(t.names[j]) ? 1 : 0;
    if (into[j] != j) continue;
    size_t bones = t.parents[j] >= 0 ? 1 : 0;  // of what is left: no joint has three
    for (size_t k = 0; k < into.size(); ++k)
      if (into[k] == k && t.parents[k] >= 0 && into[static_cast<size_t>(t.parents[k])] == j) ++bones;
    EXPECT_LT(bones, 3u) << t.names[j];
  }
  EXPECT_LT(body, 12u) << "limbs go";
  options.level = SINEW_SIMPLIFY_LOW;
  ASSERT_EQ(t.run(options, &same), SINEW_OK);
  EXPECT_LE(left(same), left(into));
}

TEST(Simplify, LargeAndOddTrees) {
  Tree star, chain, points;
  for (int32_t i = 0; i < 4096; ++i) {
    const float a = static_cast<float>(i);
    star.add(std::sin(a), std::cos(a), a / 4096, i == 0 ? -1 : 0);
    chain.add(a, std::sin(a), 0, i - 1);
    points.add(1, 2, 3, i == 0 ? -1 : i / 2);
  }
  EXPECT_GT(left(star.simplify(SINEW_SIMPLIFY_HIGH)), 4000u) << "what lies on the root goes";
  EXPECT_EQ(left(star.simplify(SINEW_SIMPLIFY_HIGH, 100)), 100u);
  EXPECT_LT(left(chain.simplify(SINEW_SIMPLIFY_LOW)), 200u);
  EXPECT_EQ(left(points.simplify(SINEW_SIMPLIFY_LOW)), 1u);
  Tree one;
  one.add(1e30f, -1e30f, 0, -1);
  EXPECT_EQ(one.simplify(SINEW_SIMPLIFY_LOW), std::vector<uint32_t>{0});
}

TEST(Simplify, WrongCallsAreRefused) {
  const sinew_simplify_options plain = SINEW_INIT(sinew_simplify_options);
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
  EXPECT_EQ(with([](Tree&, Options& o) { o.as_drawn = 2; }), SINEW_ERROR_ARGUMENT);
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
  sinew_skeleton skeleton = sinew_test::skeleton_of(t.positions.data(), t.parents.data(), 11);
  EXPECT_EQ(sinew_simplify(&skeleton, nullptr, nullptr, nullptr, workspace.data(), bytes - 1, into.data()),
            SINEW_ERROR_WORKSPACE);
}

}  // namespace
