// SPDX-License-Identifier: MIT
// Templates in a mesh: which of their joints take weight.
#include "sinew_character/predict/own_skeleton.hpp"

#include <gtest/gtest.h>

#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_character/predict/skeleton_template.hpp"

namespace sinew {
namespace {

// Joints that never take weight, of a template put into a mesh where `found` was found.
size_t resting(const std::vector<Joint>& found, const std::string& source) {
  Character mesh;
  for (const Joint& joint : found) mesh.vertices.push_back(joint.position);
  PredictedSkeleton skeleton = skeleton_from_joints(found);
  const FittedSkeleton fitted =
      fit_own_skeleton(skeleton_template("vrm"), source, label_skeleton(found), {}, mesh, &skeleton);
  size_t count = 0;
  for (const Joint& joint : fitted.joints) count += joint.deforms == false ? 1 : 0;
  size_t said = 0;
  for (const Joint& joint : skeleton.joints) said += joint.deforms == false ? 1 : 0;
  EXPECT_EQ(said, count);
  return count;
}

TEST(OwnSkeleton, EyesOfATemplateRestWhereTheMeshShowsNone) {
  std::vector<Joint> with_eyes = skeleton_template("vrm"), without;
  for (const Joint& joint : with_eyes)
    if (joint.name.find("Eye") == std::string::npos) without.push_back(joint);
  ASSERT_EQ(without.size() + 2, with_eyes.size());
  std::vector<int> index(with_eyes.size(), -1);
  size_t next = 0;
  for (size_t j = 0; j < with_eyes.size(); ++j) {
    if (with_eyes[j].name.find("Eye") != std::string::npos) continue;
    index[j] = static_cast<int>(next);
    if (without[next].parent >= 0) without[next].parent = index[static_cast<size_t>(without[next].parent)];
    ++next;
  }
  EXPECT_EQ(resting(without, "template:vrm"), 2u);
  EXPECT_EQ(resting(with_eyes, "template:vrm"), 0u);
  EXPECT_EQ(resting(without, "mine.rig.txt"), 0u) << "a file's own joints are as it says";
}

}  // namespace
}  // namespace sinew
