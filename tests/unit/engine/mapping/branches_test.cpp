// SPDX-License-Identifier: MIT
// sinew_map() by branches: every step that the published method has, and every option.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "map_rig.hpp"
#include "sinew/published.h"

namespace {

using sinew_test::humanoid;
using sinew_test::MapCall;
using sinew_test::TestRig;

MapCall by_branches() {
  MapCall call;
  call.method = SINEW_MAP_BRANCHES;
  return call;
}

size_t own_names(const MapCall& call, const TestRig& target, const TestRig& source) {
  size_t own = 0;
  for (const std::string& name : target.names) own += call.source_of(target, source, name) == name ? 1 : 0;
  return own;
}

TEST(Branches, LimbsFindTheirLikeWhicheverRigIsFirst) {
  const TestRig a = humanoid(3, true), b = humanoid(3, false);
  for (const uint32_t first : {SINEW_BRANCHES_BOTH, SINEW_BRANCHES_TARGET, SINEW_BRANCHES_SOURCE}) {
    for (const uint32_t cost : {SINEW_BRANCHES_MEAN, SINEW_BRANCHES_SUM}) {
      MapCall call = by_branches();
      call.first = first;
      call.cost = cost;
      call.run(a, b);
      ASSERT_EQ(call.status, SINEW_OK);
      EXPECT_EQ(own_names(call, a, b), a.names.size()) << first << " " << cost;
    }
  }
}

// The front of each rig decides what its left is, so that a half turn changes nothing.
TEST(Branches, DirectionsAreUnifiedBefore) {
  const TestRig a = humanoid(3, true);
  TestRig b = humanoid(3, true);
  for (size_t i = 0; i < b.names.size(); ++i) {
    b.positions[3 * i] = -b.positions[3 * i];
    b.positions[3 * i + 2] = -b.positions[3 * i + 2];
  }
  MapCall call = by_branches();
  call.run(a, b);
  EXPECT_EQ(own_names(call, a, b), a.names.size());
}

// A sword in the left hand is as far out as the finger of that hand, but nothing on the right is its image.
TEST(Branches, MirroredOnesOnlyGetMirroredOnes) {
  TestRig a = humanoid(2, true), b = humanoid(2, true);
  for (const float s : {1.0f, -1.0f}) {
    const std::string side = s > 0 ? "Left" : "Right";
    a.add(side + "Finger", a.find(side + "Hand"), 0.78f * s, 1.42f, 0.0f);
    b.add(side + "Finger", b.find(side + "Hand"), 0.78f * s, 1.30f, 0.2f);
  }
  b.add("Sword", b.find("LeftHand"), 0.78f, 1.42f, 0.0f);
  MapCall call = by_branches();
  call.run(a, b);
  EXPECT_EQ(call.source_of(a, b, "LeftFinger"), "LeftFinger");
  EXPECT_EQ(call.source_of(a, b, "RightFinger"), "RightFinger");
}

TEST(Branches, EndsFollowWhatTheyEnd) {
  TestRig a = humanoid(2, true), b = humanoid(2, true);
  a.add("FirstEnd", a.find("Head"), 0.1f, 1.75f, 0.1f, true);
  b.add("FirstEnd", b.find("Head"), 0.1f, 1.75f, 0.1f, true);
  a.add("AloneEnd", a.find("Neck"), 0, 1.5f, 0.2f, true);
  MapCall call = by_branches();
  call.run(a, b);
  EXPECT_EQ(call.source_of(a, b, "FirstEnd"), "FirstEnd");
  EXPECT_EQ(call.source_of(a, b, "HeadEnd"), "HeadEnd");
  EXPECT_EQ(call.source_of(a, b, "AloneEnd"), "-");
}

// A stub beside a tail of four bones: few pairs of joints have a small sum.
TEST(Branches, TheSumFavorsShortBranches) {
  const auto body = [](bool stub, float lift) {
    TestRig rig = humanoid(2, true);
    for (int k = 1, last = 0; k <= 4; ++k) {
      const float along = static_cast<float>(k);
      last = rig.add("Tail" + std::to_string(k), last, 0, 1 + lift * along, -0.15f * along);
    }
    if (stub) rig.add("Stub", 0, 0, 1, -0.3f);
    return rig;
  };
  const TestRig a = body(false, 0), b = body(true, 0.02f);
  MapCall call = by_branches();
  call.first = SINEW_BRANCHES_TARGET;
  call.run(a, b);
  EXPECT_EQ(call.source_of(a, b, "Tail1"), "Tail1");
  EXPECT_EQ(call.source_of(a, b, "Tail4"), "Tail4");
  call.cost = SINEW_BRANCHES_SUM;
  call.run(a, b);
  EXPECT_EQ(call.source_of(a, b, "Tail1"), "Stub");
}

// Two joints that nothing but the surface that moves with them tells apart.
TEST(Branches, SurfaceCountsWhereBothHaveOne) {
  TestRig a = humanoid(2, true), b = humanoid(2, true);
  a.add("Small", a.find("Head"), 0, 1.8f, 0.10f);
  a.add("Large", a.find("Head"), 0, 1.8f, 0.12f);
  b.add("Large", b.find("Head"), 0, 1.8f, 0.10f);
  b.add("Small", b.find("Head"), 0, 1.8f, 0.12f);
  MapCall call = by_branches();
  call.run(a, b);
  EXPECT_EQ(call.source_of(a, b, "Small"), "Large");
  const auto areas = [](const TestRig& rig) {
    std::vector<float> each(rig.count(), 0.01f);
    each[static_cast<size_t>(rig.find("Large"))] = 0.4f;
    return each;
  };
  call.target_areas = areas(a);
  call.run(a, b);
  EXPECT_EQ(call.source_of(a, b, "Small"), "Large") << "one alone says nothing";
  call.source_areas = areas(b);
  call.run(a, b);
  EXPECT_EQ(call.source_of(a, b, "Small"), "Small");
  EXPECT_EQ(call.source_of(a, b, "Large"), "Large");
}

// The target has a spine less; where the source's wings hang is not left out for that, if it moves.
TEST(Branches, CrossroadsThatMoveGetATarget) {
  TestRig a = humanoid(2, true), b = humanoid(3, true);
  const int32_t spine = b.find("Spine2");
  for (const float s : {1.0f, -1.0f}) b.add(s > 0 ? "LeftWing" : "RightWing", spine, 0.2f * s, 1.3f, -0.3f);
  MapCall call = by_branches();
  const auto served = [&] { return std::count(call.sources.begin(), call.sources.end(), spine); };
  call.animated.assign(b.count(), 1);
  call.animated[static_cast<size_t>(spine)] = 0;
  call.run(a, b);
  const long without = served();
  call.animated.clear();
  call.run(a, b);
  EXPECT_EQ(without, 0);
  EXPECT_EQ(served(), 1);
}

TEST(Branches, WrongCallsAreRefused) {
  const TestRig a = humanoid(1, true);
  const auto with = [&](const auto& change) {
    MapCall call = by_branches();
    change(call);
    call.run(a, a);
    EXPECT_TRUE(call.status == SINEW_OK || call.sources[0] == -7);
    return call.status;
  };
  const std::vector<float> even(a.count(), 0.1f);
  const auto but = [&](float wrong) {
    std::vector<float> areas = even;
    areas[2] = wrong;
    return areas;
  };
  EXPECT_EQ(with([](MapCall& c) { c.first = 3; }), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(with([](MapCall& c) { c.cost = 2; }), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(with([&](MapCall& c) { c.target_areas = but(NAN); }), SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(with([&](MapCall& c) { c.source_areas = but(std::numeric_limits<float>::infinity()); }),
            SINEW_ERROR_NOT_FINITE);
  EXPECT_EQ(with([&](MapCall& c) { c.source_areas = but(-1); }), SINEW_ERROR_RANGE);
  EXPECT_EQ(with([&](MapCall& c) { c.target_areas = c.source_areas = std::vector<float>(a.count(), 0.0f); }), SINEW_OK);
  EXPECT_EQ(with([&](MapCall& c) { c.target_areas = c.source_areas = std::vector<float>(a.count(), 3e38f); }),
            SINEW_OK);
}

}  // namespace
