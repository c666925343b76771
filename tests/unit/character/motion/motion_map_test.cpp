// SPDX-License-Identifier: MIT
// What fits a body and what does not.
#include "sinew_character/motion/motion_map.hpp"

#include <gtest/gtest.h>

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

TEST(MapCover, HalvesAndOtherBodiesDoNotFit) {
  const MapRig person = map_rig_of(walking_person());
  const auto expect = [&](const MapRig& target, const MapRig& source, const char* missing) {
    const MapCover cover = cover_of(target, source);
    EXPECT_LT(cover.share, kLeastCover);
    EXPECT_EQ(cover.missing, missing);
  };
  const MapRig bust = without(person, {"UpLeg"}), legs = without(person, {"Shoulder", "Neck"});
  expect(person, bust, "no legs");
  expect(bust, person, "no legs");
  expect(person, legs, "no arms and no head");
  EXPECT_GE(cover_of(person, without(person, {"Shoulder"})).share, kLeastCover) << "a head is enough";
  expect(on_four_legs(walking_person()), person, "one goes upright, the other does not");
}

}  // namespace
}  // namespace sinew
