// SPDX-License-Identifier: MIT
// Roles of joints: words in names, places in the hierarchy, and what stands in the air beside the mesh.
#include "sinew_character/joint_roles.hpp"

#include <gtest/gtest.h>

#include "rig/joint_words.hpp"

namespace sinew {
namespace {

using Words = std::vector<std::string>;

TEST(JointWords, AreCutAtCapitalsAndAtWhatIsNoLetter) {
  EXPECT_EQ(words_of("LeftHandIK"), (Words{"left", "hand", "ik"}));
  EXPECT_EQ(words_of("mixamorig:HeadTop_End"), (Words{"mixamorig", "head", "top", "end"}));
  EXPECT_EQ(words_of("IKFoot.L.001"), (Words{"ik", "foot", "l"}));
  EXPECT_EQ(words_of("左足ＩＫ"), (Words{"左足", "ik"}));
  EXPECT_EQ(words_of("42"), Words{});
}

TEST(JointWords, NumbersThatToolsAppendAreNone) {
  EXPECT_EQ(number_at_end("LeftHandIndex4"), 4);
  EXPECT_EQ(number_at_end("spine_03_021"), 3);
  EXPECT_EQ(number_at_end("finger2.001"), 2);
  EXPECT_EQ(number_at_end("head"), -1);
  EXPECT_EQ(number_at_end(""), -1);
}

struct Rig {
  std::vector<Joint> joints;
  int add(const char* name, int parent, Vec3 at) {
    joints.push_back({name, at, parent});
    return static_cast<int>(joints.size()) - 1;
  }
  // A body with arms: what every rig of these tests has.
  Rig() {
    const int root = add("root", -1, {0, 0, 0}), hips = add("hips", root, {0, 1, 0}),
              chest = add("chest", hips, {0, 1.4f, 0}), head = add("head", chest, {0, 1.7f, 0});
    add("head_end", head, {0, 1.9f, 0});
    for (const float side : {-1.0f, 1.0f}) {
      const int upper = add("upperarm", chest, {0.2f * side, 1.4f, 0});
      const int lower = add("lowerarm", upper, {0.5f * side, 1.4f, 0});
      add("hand", lower, {0.8f * side, 1.4f, 0});
    }
  }
  JointRole role(const std::string& name) const {
    const std::vector<JointRole> roles = joint_roles(joints);
    for (size_t j = 0; j < joints.size(); ++j)
      if (joints[j].name == name) return roles[j];
    ADD_FAILURE() << name;
    return JointRole::kDeforms;
  }
};

TEST(JointRoles, RootsAndTips) {
  Rig rig;
  EXPECT_EQ(rig.role("root"), JointRole::kRoot);
  EXPECT_EQ(rig.role("head_end"), JointRole::kTip);
  for (const char* name : {"hips", "chest", "head", "upperarm", "hand"})
    EXPECT_EQ(rig.role(name), JointRole::kDeforms) << name;
  rig.add("tail_end", rig.add("backend", 1, {0, 1, -1}), {0, 1, -2});
  EXPECT_EQ(rig.role("backend"), JointRole::kDeforms);  // neither the word nor a leaf
}

TEST(JointRoles, AnEndWithAStartIsABoneAndATipMayHaveATip) {
  Rig rig;
  rig.add("tail_end", rig.add("tail_start", 1, {0, 1, -1}), {0, 1, -2});
  rig.add("thumb_null_end", rig.add("thumb_null", 7, {-0.9f, 1.4f, 0}), {-1, 1.4f, 0});
  EXPECT_EQ(rig.role("tail_end"), JointRole::kDeforms);
  EXPECT_EQ(rig.role("thumb_null"), JointRole::kTip);
  EXPECT_EQ(rig.role("thumb_null_end"), JointRole::kTip);
}

TEST(JointRoles, ARigOfTwoJointsDeformsWithItsRoot) {
  Rig rig;
  rig.joints = {{"root", {0, 0, 0}, -1}, {"lid", {0, 1, 0}, 0}};
  EXPECT_EQ(rig.role("root"), JointRole::kDeforms);
}

TEST(JointRoles, TheFourthOfAFingerIsATip) {
  Rig rig;
  int at = 7;
  for (const char* name : {"Index1", "Index2", "Index3", "Index4"}) at = rig.add(name, at, {-0.9f, 1.4f, 0.1f});
  EXPECT_EQ(rig.role("Index4"), JointRole::kTip);
  EXPECT_EQ(rig.role("Index3"), JointRole::kDeforms);
  Rig longer;  // a spine of four is no finger
  at = 1;
  for (const char* name : {"Tail1", "Tail2", "Tail3", "Tail4"}) at = longer.add(name, at, {0, 1, -1});
  EXPECT_EQ(longer.role("Tail4"), JointRole::kDeforms);
}

TEST(JointRoles, ControlsHangBesideTheLimbs) {
  Rig rig;
  rig.add("handIK.l", 0, {-0.8f, 1.4f, 0});
  rig.add("elbowIK.l", 0, {-0.5f, 1.4f, -0.5f});
  rig.add("PoleTarget.R", -1, {0.5f, 1.4f, -0.5f});
  const int roll = rig.add("control-heel-roll.l", 0, {0, 0, 0});
  rig.add("IK-toe.l", roll, {0, 0, 0.1f});
  for (const char* name : {"handIK.l", "elbowIK.l", "PoleTarget.R", "control-heel-roll.l", "IK-toe.l"})
    EXPECT_EQ(rig.role(name), JointRole::kControl) << name;
}

TEST(JointRoles, AControlInTheMiddleOfALimbIsALimb) {
  Rig rig;
  const int thigh = rig.add("thigh", 1, {0.1f, 0.9f, 0}), leg = rig.add("IKLeg", thigh, {0.1f, 0.5f, 0});
  rig.add("foot", leg, {0.1f, 0.1f, 0});
  EXPECT_EQ(rig.role("IKLeg"), JointRole::kDeforms);
  rig.add("foot_ctrl", leg, {0.1f, 0.1f, 0});  // stands where the foot is
  EXPECT_EQ(rig.role("foot_ctrl"), JointRole::kControl);
}

TEST(JointRoles, AWordInEveryNameSaysNothing) {
  Rig rig;
  for (Joint& joint : rig.joints) joint.name = "CTRL_" + joint.name;
  EXPECT_EQ(rig.role("CTRL_head"), JointRole::kDeforms);
  EXPECT_EQ(rig.role("CTRL_hand"), JointRole::kDeforms);
}

TEST(JointRoles, SlotsAreLeaves) {
  Rig rig;
  rig.add("handslot.l", 7, {-0.9f, 1.4f, 0});
  rig.add("socket_hat", 3, {0, 2, 0});
  rig.add("LeftEyeSocket", 3, {0.05f, 1.8f, 0.1f});
  const int mount = rig.add("wing_mount", 2, {0, 1.4f, -0.2f});
  rig.add("wing", mount, {0, 1.4f, -0.6f});
  EXPECT_EQ(rig.role("handslot.l"), JointRole::kSlot);
  EXPECT_EQ(rig.role("socket_hat"), JointRole::kSlot);
  EXPECT_EQ(rig.role("LeftEyeSocket"), JointRole::kDeforms);
  EXPECT_EQ(rig.role("wing_mount"), JointRole::kDeforms);
}

TEST(JointRoles, OfARigifyRigTheDefJointsDeform) {
  Rig rig;
  for (Joint& joint : rig.joints)
    if (joint.name != "root") joint.name = "DEF-" + joint.name;
  const int torso = rig.add("torso", 0, {0, 1, 0}), mch = rig.add("MCH-spine", torso, {0, 1.2f, 0});
  rig.add("ORG-head", mch, {0, 1.7f, 0});
  EXPECT_EQ(rig.role("torso"), JointRole::kControl);
  EXPECT_EQ(rig.role("MCH-spine"), JointRole::kControl);
  EXPECT_EQ(rig.role("ORG-head"), JointRole::kControl);
  EXPECT_EQ(rig.role("DEF-chest"), JointRole::kDeforms);
}

TEST(JointsBesideMesh, PolesWithoutAName) {
  Character c;  // a box from 0 to 1
  for (const float x : {0.0f, 1.0f})
    for (const float y : {0.0f, 1.0f})
      for (const float z : {0.0f, 1.0f}) c.vertices.push_back({x, y, z});
  for (const auto& quad : std::vector<std::vector<uint32_t>>{
           {0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
    c.face_vertices.insert(c.face_vertices.end(), quad.begin(), quad.end());
    c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
  }
  c.joints = {{"a", {0.5f, 0.5f, 0.5f}, -1},
              {"b", {0.5f, 0.9f, 0.5f}, 0},
              {"knee", {0.5f, 0.5f, 2}, -1},
              {"antenna", {0.5f, 2, 0.5f}, 1},
              {"c", {0.5f, 0.2f, 0.5f}, 0}};
  std::vector<JointRole> roles = joint_roles(c.joints);
  find_joints_beside_mesh(c, &roles);
  EXPECT_EQ(roles[0], JointRole::kDeforms);  // far from every vertex, but inside
  EXPECT_EQ(roles[2], JointRole::kControl);
  EXPECT_EQ(roles[3], JointRole::kDeforms);  // hangs on a limb
}

}  // namespace
}  // namespace sinew
