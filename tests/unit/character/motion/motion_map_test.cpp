// SPDX-License-Identifier: MIT
// What fits a body and what does not.
#include "sinew_character/motion/motion_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sinew_character/clips/builtin_motion.hpp"
#include "walking_motion.hpp"

namespace sinew {
namespace {

MapCover cover_of(const MapRig& target, const MapRig& source) {
  MapSkeletonOptions options;
  options.target_up = options.source_up = std::nullopt;
  const MappedSkeleton map = map_skeleton(target, source, options);
  return map_cover(target, {}, source, {}, {map.sources.begin(), map.sources.end()});
}
// Without the joints whose names hold one of these words, and what hangs on them.
MapRig without(const MapRig& rig, const std::vector<std::string>& words) {
  MapRig out = rig;
  out.joints.clear();
  out.ends.clear();
  std::vector<int> kept(rig.joints.size(), -1);
  for (size_t j = 0; j < rig.joints.size(); ++j) {
    Joint joint = rig.joints[j];
    bool gone = joint.parent >= 0 && kept[static_cast<size_t>(joint.parent)] < 0;
    for (const std::string& word : words) gone = gone || joint.name.find(word) != std::string::npos;
    if (gone) continue;
    if (joint.parent >= 0) joint.parent = kept[static_cast<size_t>(joint.parent)];
    kept[j] = static_cast<int>(out.joints.size());
    out.joints.push_back(joint);
    out.ends.push_back(rig.ends[j]);
  }
  out.animated.clear();
  return out;
}
// Bent forward at the spine, so that arms are front legs.
MapRig on_four_legs(const Motion& person) {
  MapRig rig = map_rig_of(person);
  const std::vector<Joint> rest = rest_joints(with_axes(person, [&](size_t j) {
    const std::string& name = person.joints[j].name;
    const bool body = name == "Hips" || name.find("Leg") != std::string::npos || name.find("Foot") != std::string::npos;
    return body ? kNoRotation4 : axis_rotation(0, 1.5708);
  }));
  for (size_t j = 0; j < rest.size(); ++j) rig.joints[j].position = rest[j].position;
  return rig;
}

TEST(MapCover, APersonFitsAPerson) {
  const MapRig person = map_rig_of(walking_person());
  const MapCover cover = cover_of(person, person);
  EXPECT_FLOAT_EQ(cover.share, 1);
  EXPECT_EQ(cover.missing, "");
}

TEST(MapCover, HalvesFitAndTellWhatDoesNotMove) {
  const MapRig person = map_rig_of(walking_person());
  const MapRig bust = without(person, {"UpLeg"}), legs = without(person, {"Shoulder", "Neck"});
  const MapCover to_person = cover_of(person, bust), to_bust = cover_of(bust, person),
                 from_legs = cover_of(person, legs);
  for (const MapCover& cover : {to_person, to_bust, from_legs}) EXPECT_GE(cover.share, kLeastCover) << cover.missing;
  EXPECT_EQ(to_person.warnings, std::vector<std::string>{"the legs have no motion in the source"});
  EXPECT_EQ(to_bust.warnings, std::vector<std::string>{});
  EXPECT_TRUE(to_bust.legless);
  EXPECT_FALSE(to_person.legless || from_legs.legless);
  EXPECT_EQ(from_legs.warnings, std::vector<std::string>{"the arms have no motion in the source"});
}

TEST(MapCover, WhatGoesOnFourLegsIsNoPerson) {
  const MapCover cover = cover_of(on_four_legs(walking_person()), map_rig_of(walking_person()));
  EXPECT_LT(cover.share, kLeastCover);
  EXPECT_EQ(cover.missing, "one is upright, the other is not");
}

// A body of eight legs that says what it is, and one of which only where its limbs stand tells it.
MapRig many_legs(const std::string& name, int pairs) {
  MapRig rig;
  const auto add = [&](const std::string& joint, int parent, Vec3 position) {
    rig.joints.push_back({joint, position, parent});
    rig.ends.push_back(0);
    return static_cast<int>(rig.joints.size()) - 1;
  };
  const int body = add("Hips", -1, {0, 0.4f, 0}), chest = add("Spine", body, {0, 0.4f, 0.5f});
  (void)add("Head", chest, {0, 0.45f, 0.8f});
  for (int k = 0; k < pairs; ++k)
    for (const float side : {1.0f, -1.0f}) {
      const std::string end = std::to_string(k + 1) + (side > 0 ? ".L" : ".R");
      const float z = 0.2f * static_cast<float>(k) - 0.3f;
      const int upper = add(name.empty() ? "b" + end : "UpperLeg" + end, body, {0.2f * side, 0.4f, z});
      const int lower = add(name.empty() ? "c" + end : "LowerLeg" + end, upper, {0.6f * side, 0.7f, 1.5f * z});
      (void)add(name.empty() ? "d" + end : "Foot" + end, lower, {1.1f * side, 0, 2 * z});
    }
  return rig;
}

TEST(MapCover, AnotherKindOfBodyIsTold) {
  const MapRig person = map_rig_of(walking_person());
  EXPECT_EQ(cover_of(person, person).kinds_apart, 0u);
  for (const char* name : {"Leg", ""}) {
    const MapRig spider = many_legs(name, 4);
    EXPECT_EQ(cover_of(spider, many_legs("Leg", 4)).kinds_apart, 0u) << name;
    const MapCover cover = cover_of(spider, person);
    EXPECT_GT(cover.kinds_apart, 6u) << name;
    ASSERT_FALSE(cover.warnings.empty());
    EXPECT_EQ(cover.warnings[0], "the motion is that of an upright body on 2 legs, the character is a body on 8 legs");
  }
  EXPECT_EQ(cover_of(many_legs("Leg", 4), many_legs("Leg", 3)).kinds_apart, 2u);
}

TEST(MapCover, ChainsOfALongSkirtAreNoLegs) {
  const MapRig person = map_rig_of(walking_person());
  MapRig skirted = person;
  const auto named = [&](const std::string& name) {
    return std::find_if(person.joints.begin(), person.joints.end(),
                        [&](const Joint& joint) { return joint.name.find(name) != std::string::npos; });
  };
  const Vec3 hips = named("Hips")->position, foot = named("LeftFoot")->position;
  for (int k = 0; k < 4; ++k)
    for (const float side : {1.0f, -1.0f}) {
      const float z = 0.1f * static_cast<float>(k) - 0.15f;
      const std::string end = std::to_string(k) + (side > 0 ? "_L" : "_R");
      const auto above = static_cast<int>(skirted.joints.size());
      skirted.joints.push_back(
          {"Skirt" + end, {0.3f * side, hips.y, z}, static_cast<int>(named("Hips") - person.joints.begin())});
      skirted.joints.push_back({"SkirtEnd" + end, {0.4f * side, foot.y, 3 * z}, above});
      skirted.ends.insert(skirted.ends.end(), {0, 0});
    }
  EXPECT_EQ(cover_of(skirted, person).kinds_apart, 0u);
}

// By hand, what a map that went wrong would say.
TEST(MapCover, PartsThatFollowOthersAreTold) {
  MapRig person = map_rig_of(walking_person());
  person.animated.assign(person.joints.size(), 1);
  const auto number = [&](const std::string& name) {
    for (size_t j = 0; j < person.joints.size(); ++j)
      if (person.joints[j].name == name) return static_cast<int>(j);
    ADD_FAILURE() << name;
    return -1;
  };
  const auto warnings = [&](const std::vector<std::pair<std::string, std::string>>& changed) {
    std::vector<int> sources;
    for (size_t j = 0; j < person.joints.size(); ++j) sources.push_back(static_cast<int>(j));
    for (const auto& [to, from] : changed) sources[static_cast<size_t>(number(to))] = from.empty() ? -1 : number(from);
    return map_cover(person, {}, person, {}, sources).warnings;
  };
  EXPECT_EQ(warnings({}), std::vector<std::string>{});
  EXPECT_EQ(warnings({{"LeftUpLeg", ""}, {"LeftLeg", ""}, {"LeftFoot", ""}}),
            std::vector<std::string>{"the left leg does not move"});
  EXPECT_EQ(warnings({{"LeftUpLeg", ""}, {"LeftLeg", ""}}),
            std::vector<std::string>{"the left leg hardly moves, 1 of its 3 joints"});
  EXPECT_EQ(warnings({{"Head", "LeftFoot"}, {"Neck", "LeftLeg"}}),
            std::vector<std::string>{"the head follows the left leg"});
  EXPECT_EQ(warnings({{"LeftUpLeg", "RightUpLeg"},
                      {"LeftLeg", "RightLeg"},
                      {"LeftFoot", "RightFoot"},
                      {"LeftToeBase", "RightToeBase"}}),
            std::vector<std::string>{"the left leg follows the right leg"});
  for (const char* name : {"LeftUpLeg", "LeftLeg", "LeftFoot"}) person.animated[static_cast<size_t>(number(name))] = 0;
  EXPECT_EQ(warnings({{"LeftUpLeg", ""}, {"LeftLeg", ""}, {"LeftFoot", ""}}),
            std::vector<std::string>{"the left leg has no motion in the source"});
}

// A head that carries wings and a tail, and nothing else.
MapRig bird_of_wings() {
  MapRig rig;
  const auto add = [&](const std::string& name, int parent, Vec3 position) {
    Joint joint;
    joint.name = name;
    joint.parent = parent;
    joint.position = position;
    rig.joints.push_back(joint);
    rig.ends.push_back(0);
    return static_cast<int>(rig.joints.size()) - 1;
  };
  const int head = add("head", -1, {0, 1, 0.4f});
  for (const float side : {-1.0f, 1.0f}) {
    int above = head;
    for (int k = 1; k <= 4; ++k)
      above = add("wing0" + std::to_string(k) + (side > 0 ? ".L" : ".R"), above,
                  {side * (0.05f + 0.1f * static_cast<float>(k)), 1, 0.05f});
  }
  int above = head;
  for (int k = 1; k <= 4; ++k)
    above = add("tail0" + std::to_string(k), above, {0, 1, 0.1f - 0.12f * static_cast<float>(k)});
  return rig;
}

TEST(MapCover, WingsAloneFitABirdWithLegs) {
  const MapRig bird = map_rig_of(builtin_motions("builtin:flap")[0]);
  const MapCover cover = cover_of(bird_of_wings(), bird);
  EXPECT_GE(cover.share, kLeastCover) << cover.missing;
  EXPECT_EQ(cover.warnings, std::vector<std::string>{});
}

TEST(MapCover, WhatStaysRigidIsTold) {
  const MapRig person = map_rig_of(walking_person());
  MapRig tailed = person;
  const auto chain = [&](const std::string& name, int count, float z) {
    int parent = 0;
    for (int k = 1; k <= count; ++k) {
      Joint joint;
      joint.name = name + std::to_string(k);
      joint.parent = parent;
      joint.position = {0, 0.1f, z * static_cast<float>(k)};
      parent = static_cast<int>(tailed.joints.size());
      tailed.joints.push_back(joint);
      tailed.ends.push_back(0);
    }
  };
  chain("Tail", 3, -0.1f);
  chain("Rope", 4, 0.1f);
  std::vector<int> sources;
  for (size_t j = 0; j < tailed.joints.size(); ++j)
    sources.push_back(j < person.joints.size() ? static_cast<int>(j) : -1);
  const MapCover cover = map_cover(tailed, {}, person, {}, sources);
  EXPECT_EQ(cover.warnings, std::vector<std::string>{});
  EXPECT_EQ(cover.rigid, "tail and 4 other joints");
}

}  // namespace
}  // namespace sinew
