// SPDX-License-Identifier: MIT
// What mapping by branches was published for, on samples of the repository and on two animals of one build: joints find
// their like without names, whichever skeleton is first.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "map_rig.hpp"
#include "sinew/published.h"
#include "sinew_character/motion/map_skeleton.hpp"

namespace sinew {
namespace {

using sinew_test::MapCall;
using sinew_test::TestRig;

const std::string kSamples = std::string(SINEW_SOURCE_DIR) + "/samples/data/";

MapSkeletonOptions by_branches() {
  MapSkeletonOptions options;
  options.method = SINEW_MAP_BRANCHES;
  options.names = false;
  return options;
}

const std::string& source_name(const MapRig& source, const MappedSkeleton& map, size_t target) {
  static const std::string none = "-";
  const int32_t s = map.sources[target];
  return s < 0 ? none : source.joints[static_cast<size_t>(s)].name;
}

bool is_of_side(const std::string& name, const char* side) { return name.find(side) != std::string::npos; }

// On two legs and with a long tail; as some tools write it, the hind feet hang on the root, beside the body.
TestRig dinosaur(float size, float neck, float arms, float tail) {
  TestRig rig;
  rig.add("root", -1, 0, 0, 0);
  const int32_t body = rig.add("Body", 0, 0, 5 * size, 0.8f);
  const auto above = [&](const std::string& name, int32_t parent, float y, float z) {
    return rig.add(name, parent, 0, size * y, size * z);
  };
  int32_t last = above("Torso", above("Hips", body, 4.1f, 0.5f), 4.2f, 1.4f);
  last = above("Shoulders", last, 4.2f + 0.7f * neck, 2.4f);
  last = above("Neck", last, 4.2f + 1.1f * neck, 3.2f);
  last = above("Head", last, 4.2f + 1.5f * neck, 4.0f);
  rig.add("Head_end", last, 0, size * (4.2f + 1.5f * neck), size * 5.6f, true);
  last = above("Back", body, 4.1f, 0.3f);
  for (int k = 1; k <= 5; ++k)
    last = above("Tail" + std::to_string(k), last, 4.1f - 0.05f * static_cast<float>(k),
                 -0.5f - tail * static_cast<float>(k));
  rig.add("Tail5_end", last, 0, 3.9f * size, size * (-1 - 6 * tail), true);
  for (const float s : {1.0f, -1.0f}) {
    const std::string side = s > 0 ? ".L" : ".R";
    const auto limb = [&](const std::string& name, int32_t parent, float x, float y, float z, bool end = false) {
      return rig.add(name + side, parent, s * size * x, size * y, size * z, end);
    };
    int32_t leg = limb("BackLeg", body, 0.3f, 3.9f, 0.2f);
    leg = limb("BackUpLeg", leg, 1.4f, 3.9f, 0.2f);
    leg = limb("BackLowLeg", leg, 1.2f, 1.5f, -0.6f);
    limb("BackLowLeg_end", leg, 1.2f, 0.1f, -0.3f, true);
    limb("BackFoot_end", limb("BackFoot", 0, 1.25f, 0.1f, -0.3f), 1.25f, 0.1f, 0.9f, true);
    int32_t arm = limb("FrontLeg", body, 0.25f, 4.2f, 2.0f);
    arm = limb("FrontUpLeg", arm, 0.8f, 4.2f, 2.0f);
    arm = limb("FrontLowLeg", arm, 0.85f, 4.2f - 0.7f * arms, 2.2f);
    arm = limb("FrontFoot", arm, 0.7f, 4.2f - arms, 2.7f);
    limb("FrontFoot_end", arm, 0.7f, 4.2f - 1.6f * arms, 2.6f, true);
  }
  return rig;
}

// As T-Rex and velociraptor are: 37 joints each, and every one finds its own, from either side.
TEST(PublishedMapping, TwoDinosaursFindEveryJoint) {
  const TestRig large = dinosaur(2.2f, 1.0f, 0.9f, 1.3f), small = dinosaur(1.0f, 1.5f, 1.5f, 1.0f);
  ASSERT_EQ(large.count(), 37u);
  for (const uint32_t first : {SINEW_BRANCHES_BOTH, SINEW_BRANCHES_TARGET, SINEW_BRANCHES_SOURCE}) {
    MapCall call;
    call.method = SINEW_MAP_BRANCHES;
    call.first = first;
    call.run(large, small);
    for (const std::string& name : large.names) EXPECT_EQ(call.source_of(large, small, name), name) << first;
    call.run(small, large);
    for (const std::string& name : small.names) EXPECT_EQ(call.source_of(small, large, name), name) << first;
  }
}

// People of two builds, of whom one has shoulders, a longer spine, toes or a tail more; no names, weights tell ends and
// surface.
TEST(PublishedMapping, SamplesFindTheirLike) {
  const MapRig robed = read_map_rig(kSamples + "biped__robed.obj"), robot = read_map_rig(kSamples + "biped__robot.obj");
  EXPECT_EQ(robed.surfaces.shares.size(), robed.joints.size());
  for (const auto& [target, source] : {std::pair(&robed, &robot), std::pair(&robot, &robed)}) {
    const MappedSkeleton map = map_skeleton(*target, *source, by_branches());
    size_t limbs = 0;
    for (size_t t = 0; t < target->joints.size(); ++t) {
      const std::string &name = target->joints[t].name, &found = source_name(*source, map, t);
      EXPECT_FALSE(is_of_side(name, ".L") && is_of_side(found, ".R")) << name << " from " << found;
      EXPECT_FALSE(is_of_side(name, ".R") && is_of_side(found, ".L")) << name << " from " << found;
      if (!is_of_side(name, ".L") && !is_of_side(name, ".R")) {
        EXPECT_FALSE(is_of_side(found, ".L") || is_of_side(found, ".R")) << name << " from " << found;
      }
      for (const char* part : {"hips", "head", "upper_arm", "forearm", "hand", "thigh", "shin"}) {
        if (name.rfind(part, 0) != 0 || name.find("end") != std::string::npos) continue;
        EXPECT_EQ(found, name) << target->name;
        ++limbs;
      }
    }
    EXPECT_EQ(limbs, 12u);
  }
}

TEST(PublishedMapping, ASkeletonIsItself) {
  for (const char* name : {"biped__robed.obj", "biped__robot.obj", "quadruped__tailed.obj", "bird__winged.obj",
                           "many-legged__plated.obj", "snake__long.obj"}) {
    const MapRig rig = read_map_rig(kSamples + name);
    for (const uint32_t cost : {SINEW_BRANCHES_MEAN, SINEW_BRANCHES_SUM}) {
      MapSkeletonOptions options = by_branches();
      options.branches_cost = cost;
      const MappedSkeleton map = map_skeleton(rig, rig, options);
      for (size_t j = 0; j < rig.joints.size(); ++j)
        EXPECT_EQ(map.sources[j], static_cast<int32_t>(j)) << name << " " << rig.joints[j].name;
    }
  }
}

}  // namespace
}  // namespace sinew
