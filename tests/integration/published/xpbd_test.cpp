// SPDX-License-Identifier: MIT
// What the published correction promises, on a sample: elbows bent by 150 and by 90 degrees keep more volume than linear skinning,
// small bends change nothing, and the mesh at rest is the mesh at rest.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sinew/published.h"
#include "sinew_character/pose/bend_volume.hpp"
#include "sinew_character/pose/deform.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

const std::string kRobed = std::string(SINEW_SOURCE_DIR) + "/samples/data/biped__robed.obj";

size_t joint_named(const Character& character, const std::string& name) {
  size_t j = 0;
  while (j < character.joints.size() && character.joints[j].name != name) ++j;
  EXPECT_LT(j, character.joints.size()) << name;
  return j;
}

std::vector<float> corrected(const Character& character, const std::vector<Affine>& palette) {
  sinew_deform_options options = SINEW_INIT(sinew_deform_options);
  options.method = SINEW_DEFORM_XPBD;
  return CharacterDeformer(character, options).pose(palette);
}

std::vector<float> flat(const Character& character) {
  std::vector<float> out;
  for (const auto& v : character.vertices) out.insert(out.end(), {v.x, v.y, v.z});
  return out;
}

TEST(PublishedXpbd, BendsKeepMoreVolumeThanLinearSkinning) {
  const Character character = read_character(kRobed);
  BendVolumes volumes(character);
  for (const auto& [name, turn] : {std::pair<const char*, double>{"forearm.L", -150}, {"forearm.R", 90}}) {
    JointRotation rotation;
    rotation.joint = joint_named(character, name);
    rotation.y = turn;
    const std::vector<Affine> palette = pose_palette(character, {rotation});
    const double linear = *volumes.kept(rotation.joint, flat(apply_pose(character, palette)));
    const double kept = *volumes.kept(rotation.joint, corrected(character, palette));
    EXPECT_LT(linear, 0.97) << name;
    EXPECT_LT(std::abs(kept - 1), 0.5 * std::abs(linear - 1)) << name << ' ' << linear << ' ' << kept;
  }
}

TEST(PublishedXpbd, SmallBendsAndTheRestPoseAreKept) {
  const Character character = read_character(kRobed);
  EXPECT_EQ(corrected(character, pose_palette(character, {})), flat(character));
  JointRotation rotation;
  rotation.joint = joint_named(character, "forearm.L");
  rotation.y = -0.1;
  const std::vector<Affine> palette = pose_palette(character, {rotation});
  EXPECT_NEAR(*BendVolumes(character).kept(rotation.joint, corrected(character, palette)), 1, 1e-3);
}

}  // namespace
}  // namespace sinew
