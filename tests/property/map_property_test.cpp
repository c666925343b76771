// SPDX-License-Identifier: MIT
// sinew_map() on random and broken rigs: every map names joints that exist, each once by our method, none crosses, within the
// workspace it asked for. SINEW_MAP_RIGS=10000 in the environment runs as many.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <utility>

#include "draw.hpp"
#include "map_rig.hpp"
#include "sinew/published.h"

namespace {

using sinew_test::Draw;
using sinew_test::MapCall;
using sinew_test::TestRig;

const char* const kNames[] = {"Hips",     "Spine_01", "neck", "Head",  "hand.L",     "LeftUpLeg", "toe_end",
                              "IndexR 1", "Tail",     "",     "J\xFF", "mixa:Arm.R", "jaw",       "thumb_02_l"};

// A body, mirrored or not, with limbs of any number at any joint of the trunk, each of any number of joints.
TestRig random_body(Draw& draw) {
  TestRig rig;
  std::vector<int32_t> trunk = {rig.add("root", -1, 0, draw.range(0, 1), 0)};
  const bool lying = draw.chance(30);
  for (uint32_t n = draw.below(9); n > 0; --n) {
    const float* const p = &rig.positions[3 * static_cast<size_t>(trunk.back())];
    const float x = p[0], y = p[1], z = p[2], step = draw.chance(10) ? 0 : draw.range(0.05f, 0.3f);
    trunk.push_back(rig.add(kNames[draw.below(14)], trunk.back(), x, y + (lying ? 0 : step), z + (lying ? step : 0)));
  }
  for (uint32_t n = draw.below(7); n > 0; --n) {
    const int32_t at = trunk[draw.below(static_cast<uint32_t>(trunk.size()))];
    const uint32_t joints = 1 + draw.below(6);
    const float dx = draw.range(0, 0.3f), dy = draw.range(-0.4f, 0.2f), dz = draw.range(-0.2f, 0.2f);
    const uint32_t fingers = draw.chance(30) ? 1 + draw.below(6) : 0;
    for (const float side : {1.0f, -1.0f}) {
      if (side < 0 && draw.chance(8)) break;  // a limb without its like
      int32_t last = at;
      const float* const p = &rig.positions[3 * static_cast<size_t>(at)];
      float x = p[0], y = p[1], z = p[2];
      for (uint32_t j = 0; j < joints; ++j) {
        x += side * dx;
        y += dy;
        z += dz;
        last = rig.add(kNames[draw.below(14)], last, x, y, z, j + 1 == joints && draw.chance(30));
      }
      for (uint32_t f = 0; f < fingers; ++f) {
        int32_t finger = last;
        for (uint32_t k = 0; k < 1 + f % 3; ++k)
          finger =
              rig.add("f", finger, x + side * 0.03f * static_cast<float>(k + 1), y, z + 0.02f * static_cast<float>(f));
      }
    }
  }
  return rig;
}

// Any tree at any positions.
TestRig random_tree(Draw& draw, uint32_t joints, int kind) {
  TestRig rig;
  const float flat = draw.chance(20) ? 0.0f : 1.0f;
  for (uint32_t i = 0; i < joints; ++i) {
    int32_t parent = static_cast<int32_t>(i) - 1;                               // a chain
    if (kind == 1) parent = i == 0 ? -1 : 0;                                    // a star
    if (kind == 2 && i > 0) parent = static_cast<int32_t>(draw.below(i));       // bushes
    if (kind == 3) parent = i % 2 == 0 ? static_cast<int32_t>(i) - 2 : parent;  // a comb
    if (kind == 4) parent = draw.chance(50) || i == 0 ? -1 : parent;            // many roots
    if (kind == 3 && i == 0) parent = -1;
    const bool again = i > 0 && draw.chance(15);  // a bone without length
    const float x = draw.range(-1, 1), y = flat * draw.range(-1, 1), z = draw.range(-1, 1);
    const float* const p = again ? &rig.positions[3 * static_cast<size_t>(i - 1)] : nullptr;
    const float at[3] = {again ? p[0] : x, again ? p[1] : y, again ? p[2] : z};
    rig.add(kNames[draw.below(14)], parent, at[0], at[1], at[2], draw.chance(10));
  }
  return rig;
}

// Whether a joint is below another, without walking up.
class Below {
 public:
  explicit Below(const TestRig& rig) : first_(rig.count()), last_(rig.count()) {
    std::vector<std::vector<size_t>> kids(rig.count());
    std::vector<std::pair<size_t, size_t>> open;  // joint, next child
    for (size_t i = 0; i < rig.count(); ++i)
      if (rig.parents[i] >= 0) kids[static_cast<size_t>(rig.parents[i])].push_back(i);
    size_t time = 0;
    for (size_t root = 0; root < rig.count(); ++root) {
      if (rig.parents[root] >= 0) continue;
      open.push_back({root, 0});
      first_[root] = time++;
      while (!open.empty()) {
        auto& [joint, next] = open.back();
        if (next == kids[joint].size()) {
          last_[joint] = time;
          open.pop_back();
          continue;
        }
        const size_t kid = kids[joint][next++];
        first_[kid] = time++;
        open.push_back({kid, 0});
      }
    }
  }
  bool operator()(int32_t joint, int32_t above) const {
    const size_t j = static_cast<size_t>(joint), a = static_cast<size_t>(above);
    return j != a && first_[a] <= first_[j] && first_[j] < last_[a];
  }

 private:
  std::vector<size_t> first_, last_;
};

void expect_sound(const TestRig& target, const TestRig& source, const MapCall& call, uint32_t seed) {
  ASSERT_EQ(call.status, SINEW_OK) << "seed " << seed;
  const Below is_below(source);
  std::set<int32_t> used;
  uint32_t mapped = 0;
  for (int32_t i = 0; i < static_cast<int32_t>(target.count()); ++i) {
    const int32_t s = call.sources[static_cast<size_t>(i)];
    ASSERT_GE(s, -1) << "seed " << seed;
    ASSERT_LT(s, static_cast<int32_t>(source.count())) << "seed " << seed;
    ASSERT_LE(call.confidence[static_cast<size_t>(i)], 32768) << "seed " << seed;
    ASSERT_EQ(s >= 0, call.reasons[static_cast<size_t>(i)] == SINEW_MAP_FOUND) << "seed " << seed;
    if (s < 0) continue;
    ++mapped;
    if (call.outputs.method == SINEW_MAP_SINEW) {
      ASSERT_TRUE(used.insert(s).second) << "seed " << seed << ": a source twice";
    }
    for (int32_t up = target.parents[static_cast<size_t>(i)]; up >= 0; up = target.parents[static_cast<size_t>(up)]) {
      const int32_t above = call.sources[static_cast<size_t>(up)];
      if (above >= 0) {
        ASSERT_FALSE(is_below(above, s)) << "seed " << seed << ": " << i << " crosses " << up;
      }
    }
  }
  EXPECT_EQ(call.outputs.mapped, mapped);
  EXPECT_GE(mapped, 1u) << "seed " << seed;
}

TEST(MapProperty, RandomRigsGiveSoundMaps) {
  const char* const asked = std::getenv("SINEW_MAP_RIGS");
  const uint32_t count = asked != nullptr ? static_cast<uint32_t>(std::atoi(asked)) : 1200;
  for (uint32_t seed = 0; seed < count; ++seed) {
    Draw draw(seed);
    const auto rig = [&] {
      return draw.chance(70) ? random_body(draw)
                             : random_tree(draw, 1 + draw.below(40), static_cast<int>(draw.below(5)));
    };
    const TestRig target = rig(), source = rig();
    MapCall call;
    call.names = draw.chance(50);
    call.ends = draw.chance(50);
    call.up_known = draw.chance(70);
    call.method = draw.below(3);
    call.run(target, source);
    ASSERT_NO_FATAL_FAILURE(expect_sound(target, source, call, seed));
    if (seed % 4 != 0) continue;
    MapCall again = call;
    again.fill = 0x11;
    again.run(target, source);
    ASSERT_EQ(again.sources, call.sources) << "seed " << seed << ": what the workspace held matters";
    ASSERT_EQ(again.confidence, call.confidence) << "seed " << seed;
    ASSERT_EQ(again.reasons, call.reasons) << "seed " << seed;
  }
}

// People of several conventions, random bodies and trees: each one mapped from each.
TEST(MapProperty, EveryPairOfFiftyRigs) {
  std::vector<TestRig> rigs;
  for (int spines = 1; spines <= 5; ++spines)
    for (const bool t_pose : {true, false})
      rigs.push_back(sinew_test::humanoid(spines, t_pose, spines % 2 ? "a:" : ""));
  for (uint32_t seed = 0; rigs.size() < 50; ++seed) {
    Draw draw(seed + 40000);
    rigs.push_back(seed % 4 == 3 ? random_tree(draw, 1 + draw.below(60), static_cast<int>(draw.below(5)))
                                 : random_body(draw));
  }
  uint32_t pair = 0;
  for (const TestRig& target : rigs) {
    for (const TestRig& source : rigs) {
      MapCall call;
      call.names = pair % 2 == 0;
      call.ends = pair % 3 != 0;
      call.up_known = pair % 5 != 0;
      call.run(target, source);
      ASSERT_NO_FATAL_FAILURE(expect_sound(target, source, call, pair));
      ++pair;
    }
  }
}

TEST(MapProperty, PinsAreKeptAndNothingCrossesThem) {
  for (uint32_t seed = 0; seed < 400; ++seed) {
    Draw draw(seed + 9000);
    const TestRig target = random_body(draw), source = random_body(draw);
    const Below is_below(source);
    MapCall call;
    call.method = SINEW_MAP_SINEW;
    std::set<uint32_t> targets;
    std::set<int32_t> sources;
    for (uint32_t k = 1 + draw.below(3); k > 0; --k) {
      const sinew_map_pin pin = {draw.below(target.count()), static_cast<int32_t>(draw.below(source.count() + 1)) - 1};
      if (!targets.insert(pin.target).second || (pin.source >= 0 && !sources.insert(pin.source).second)) continue;
      call.pins.push_back(pin);
    }
    call.run(target, source);
    ASSERT_EQ(call.status, SINEW_OK) << "seed " << seed;
    for (const sinew_map_pin& pin : call.pins) ASSERT_EQ(call.sources[pin.target], pin.source) << "seed " << seed;
    std::set<int32_t> used;
    for (int32_t i = 0; i < static_cast<int32_t>(target.count()); ++i) {
      const int32_t s = call.sources[static_cast<size_t>(i)];
      if (s < 0) continue;
      ASSERT_TRUE(used.insert(s).second) << "seed " << seed;
      for (int32_t up = target.parents[static_cast<size_t>(i)]; up >= 0; up = target.parents[static_cast<size_t>(up)]) {
        const int32_t above = call.sources[static_cast<size_t>(up)];
        const bool both = targets.count(static_cast<uint32_t>(i)) + targets.count(static_cast<uint32_t>(up)) == 2;
        if (above >= 0 && !both) {  // pins may cross each other
          ASSERT_FALSE(is_below(above, s)) << "seed " << seed << ": " << i;
        }
      }
    }
  }
}

TEST(MapProperty, ARigIsItselfToItself) {
  for (uint32_t seed = 0; seed < 200; ++seed) {
    Draw draw(seed);
    const TestRig rig = random_body(draw);
    MapCall call;
    call.method = SINEW_MAP_SINEW;
    call.ends = false;
    call.run(rig, rig);
    ASSERT_EQ(call.status, SINEW_OK);
    uint32_t own = 0;
    for (size_t i = 0; i < call.sources.size(); ++i) own += call.sources[i] == static_cast<int32_t>(i) ? 1 : 0;
    EXPECT_EQ(own, call.outputs.mapped) << "seed " << seed;
  }
}

TEST(MapProperty, LargestRigsOfEveryShape) {
  for (int kind = 0; kind < 5; ++kind) {
    Draw draw(static_cast<uint32_t>(kind) + 77);
    const TestRig target = random_tree(draw, SINEW_MAX_JOINTS, kind);
    const TestRig source = random_tree(draw, kind == 0 ? SINEW_MAX_JOINTS : 900, kind);
    MapCall call;
    call.method = SINEW_MAP_SINEW;
    call.run(target, source);
    ASSERT_NO_FATAL_FAILURE(expect_sound(target, source, call, static_cast<uint32_t>(kind)));
    call.method = SINEW_MAP_BRANCHES;
    call.run(target, source);
    if (call.status == SINEW_ERROR_COUNT) continue;  // more branches than are compared
    ASSERT_NO_FATAL_FAILURE(expect_sound(target, source, call, static_cast<uint32_t>(kind)));
  }
}

}  // namespace
