// SPDX-License-Identifier: MIT
// Classes, roles, sides and partners of whole skeletons: the names that the usual makers give, positions in the hierarchy, and
// what follows them.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "names/words.hpp"
#include "sinew/names.h"
#include "sinew/sinew.hpp"
#include "skeleton_of.hpp"

namespace sinew {
namespace {

struct Point {
  float x, y, z;
};
struct Joint {
  std::string name;
  Point position;
  int parent;
};

// Calls with arrays of `joints`.
struct Verdicts {
  std::vector<uint8_t> classes, roles;
  std::vector<int8_t> sides;
  std::vector<int32_t> numbers, partners, images;
  sinew_joint_verdicts out = SINEW_INIT(sinew_joint_verdicts);
  sinew_status status = SINEW_OK;

  explicit Verdicts(const std::vector<Joint>& joints, const std::vector<uint8_t>& follows = {}) {
    const size_t n = joints.size();
    std::vector<const char*> names;
    std::vector<int32_t> parents;
    std::vector<float> positions;
    for (const Joint& joint : joints) {
      names.push_back(joint.name.c_str());
      parents.push_back(joint.parent);
      positions.insert(positions.end(), {joint.position.x, joint.position.y, joint.position.z});
    }
    sinew_skeleton named = sinew_test::skeleton_of(positions.data(), parents.data(), static_cast<uint32_t>(n));
    named.names = names.data();
    classes.resize(n);
    roles.resize(n);
    sides.resize(n);
    numbers.resize(n);
    partners.resize(n);
    images.resize(n);
    out.classes = classes.data();
    out.roles = roles.data();
    out.sides = sides.data();
    out.numbers = numbers.data();
    out.partners = partners.data();
    out.images = images.data();
    size_t bytes = 0;
    EXPECT_EQ(sinew_joint_classes_workspace_size(named.joint_count, &bytes), SINEW_OK);
    Workspace workspace;
    EXPECT_TRUE(workspace.reserve(bytes));
    status = sinew_joint_classes(&named, follows.empty() ? nullptr : follows.data(), workspace.data(), workspace.size(),
                                 &out);
  }
};

const char* text_of(uint8_t joint_class) {
  constexpr const char* kTexts[] = {"pelvis",  "spine", "neck", "head",  "clavicle", "upperarm",
                                    "forearm", "hand",  "hip",  "thigh", "calf",     "foot",
                                    "toe",     "tail",  "wing", "ear",   "hair",     "other"};
  return joint_class < 18 ? kTexts[joint_class] : "detail";
}

using Below = std::vector<std::string>;

// "detail" where the joint belongs to the one above it. Something follows every joint.
std::string class_text(const std::string& name, const Below& below = {}) {
  std::vector<Joint> joints = {{name, {0, 0, 0}, -1}};
  for (const std::string& one : below) joints.push_back({one, {0, static_cast<float>(joints.size()), 0}, 0});
  const Verdicts got(joints, std::vector<uint8_t>(joints.size(), SINEW_FOLLOWS_SOME));
  return got.roles[0] > SINEW_ROLE_END ? "detail" : text_of(got.classes[0]);
}

// Name and class; a joint that stands in a limb has something below it.
using Named = std::vector<std::pair<std::string, std::string>>;
void expect_classes(const Named& rig, const Below& below) {
  for (const auto& [name, expected] : rig) EXPECT_EQ(class_text(name, below), expected) << name;
}

TEST(JointClasses, Mixamo) {
  expect_classes({{"mixamorig:Hips", "pelvis"},
                  {"mixamorig:Spine2", "spine"},
                  {"mixamorig:Neck", "neck"},
                  {"mixamorig:Head", "head"},
                  {"mixamorig:HeadTop_End", "head"},
                  {"mixamorig:LeftShoulder", "clavicle"},
                  {"mixamorig:LeftArm", "upperarm"},
                  {"mixamorig:RightForeArm", "forearm"},
                  {"mixamorig:RightHand", "hand"},
                  {"mixamorig:RightHandThumb1", "detail"},
                  {"mixamorig:LeftHandMiddle1", "detail"},
                  {"mixamorig:LeftUpLeg", "thigh"},
                  {"mixamorig:LeftLeg", "calf"},
                  {"mixamorig:LeftFoot", "foot"},
                  {"mixamorig:LeftToeBase", "toe"},
                  {"LeftLeg", "calf"}},
                 {"LeftFoot"});
}

TEST(JointClasses, Unreal) {
  expect_classes({{"root", "pelvis"},
                  {"pelvis", "pelvis"},
                  {"spine_03", "spine"},
                  {"neck_01", "neck"},
                  {"clavicle_l", "clavicle"},
                  {"upperarm_l", "upperarm"},
                  {"upperarm_twist_01_l", "detail"},
                  {"lowerarm_r", "forearm"},
                  {"hand_r", "hand"},
                  {"index_01_r", "detail"},
                  {"thigh_l", "thigh"},
                  {"calf_l", "calf"},
                  {"foot_l", "foot"},
                  {"ball_l", "toe"}},
                 {"ball_l"});
}

TEST(JointClasses, Rigify) {
  expect_classes({{"DEF-spine.003", "spine"},
                  {"DEF-shoulder.L", "clavicle"},
                  {"DEF-upper_arm.L.001", "upperarm"},
                  {"DEF-forearm.R", "forearm"},
                  {"DEF-hand.R", "hand"},
                  {"DEF-f_index.01.L", "detail"},
                  {"DEF-thumb.01.L", "detail"},
                  {"DEF-breast.L", "detail"},
                  {"DEF-thigh.L", "thigh"},
                  {"DEF-shin.L", "calf"},
                  {"DEF-foot.L", "foot"},
                  {"DEF-toe.L", "toe"}},
                 {"DEF-toe.L"});
}

TEST(JointClasses, MakeHuman) {
  expect_classes({{"root", "pelvis"},
                  {"spine05", "spine"},
                  {"neck02", "neck"},
                  {"pelvis.L", "detail"},
                  {"clavicle.L", "clavicle"},
                  {"shoulder01.L", "detail"},
                  {"upperarm01.L", "upperarm"},
                  {"upperarm02.L", "detail"},
                  {"lowerarm01.R", "forearm"},
                  {"lowerarm02.R", "detail"},
                  {"wrist.R", "hand"},
                  {"metacarpal2.R", "detail"},
                  {"finger3-1.R", "detail"},
                  {"upperleg01.L", "thigh"},
                  {"upperleg02.L", "detail"},
                  {"lowerleg01.L", "calf"},
                  {"foot.L", "foot"},
                  {"toe1-1.L", "detail"},
                  {"orbicularis03.L", "detail"},
                  {"jaw", "detail"},
                  {"eye.R", "detail"}},
                 {"x"});
}

TEST(JointClasses, Quaternius) {
  expect_classes(
      {{"Body", "pelvis"},         {"Hips", "pelvis"},         {"Abdomen", "spine"},      {"Torso", "spine"},
       {"Shoulder.L", "clavicle"}, {"UpperArm.L", "upperarm"}, {"LowerArm.L", "forearm"}, {"Palm.L", "hand"},
       {"Middle1.L", "detail"},    {"MiddleHand.L", "hand"},   {"UpperLeg.R", "thigh"},   {"LowerLeg.R", "calf"},
       {"Foot.R", "foot"},         {"Tail1", "tail"},          {"Tailor", "other"},       {"Ear.L", "ear"},
       {"Wing.R", "wing"},         {"TopFin", "wing"},         {"Finial", "other"},       {"Hair3", "hair"},
       {"Bone.003", "other"}},
      {"x"});
}

TEST(JointClasses, LegsDependOnWhatIsBoundBelow) {
  EXPECT_EQ(class_text("FrontLeg.L", {"FrontUpLeg.L"}), "clavicle");
  EXPECT_EQ(class_text("FrontLeg.L", {"FrontLowLeg.L"}), "upperarm");
  EXPECT_EQ(class_text("BackLeg.R", {"BackLowLeg.R", "BackUPLEG.R"}), "hip");
  EXPECT_EQ(class_text("BackLeg.R"), "thigh");
  EXPECT_EQ(class_text("FrontUpLeg.L", {"x"}), "upperarm");
  EXPECT_EQ(class_text("FrontLowerLeg.L"), "forearm");
  EXPECT_EQ(class_text("FrontFoot.L"), "hand");
  EXPECT_EQ(class_text("BackShoulder.L"), "hip");
  EXPECT_EQ(class_text("leg.L", {"foot.L"}), "calf");
  EXPECT_EQ(class_text("leg.L"), "thigh") << "a leg of one bone";
  EXPECT_EQ(class_text("leg", {"foot"}), "thigh") << "no side: nobody says that it is the lower one";
  EXPECT_EQ(class_text("Shoulders"), "spine");
}

TEST(JointClasses, AHipOfOneSideBeginsALeg) {
  EXPECT_EQ(class_text("LeftHip", {"LeftKnee"}), "thigh");
  EXPECT_EQ(class_text("hip.R", {"upleg.R"}), "hip");
  EXPECT_EQ(class_text("hip", {"LeftKnee"}), "pelvis");
}

TEST(JointClasses, JointsBelowACollarAreArms) {
  std::vector<Joint> joints;
  for (const char* name : {"Chest", "LeftCollar", "LeftShoulder", "LeftElbow", "LeftWrist"})
    joints.push_back({name, {static_cast<float>(joints.size()), 0, 0}, static_cast<int>(joints.size()) - 1});
  const Verdicts got(joints);
  EXPECT_STREQ(text_of(got.classes[1]), "clavicle");
  EXPECT_STREQ(text_of(got.classes[2]), "upperarm");
  EXPECT_STREQ(text_of(got.classes[3]), "forearm");
  EXPECT_STREQ(text_of(got.classes[4]), "hand");
}

TEST(JointClasses, WordsThatMapsKnewAreKnownToAll) {
  expect_classes({{"LeftElbow", "forearm"},
                  {"RightKnee", "calf"},
                  {"femur.L", "thigh"},
                  {"R_Humerus", "upperarm"},
                  {"lCollar", "clavicle"},
                  {"rButtock", "hip"},
                  {"lShldr", "upperarm"},
                  {"ankle_l", "foot"}},
                 {"x"});
}

TEST(JointClasses, FingersAreNamedOrNumbered) {
  const std::vector<std::pair<std::string, int>> named = {{"mixamorig:LeftHandThumb1", SINEW_CLASS_THUMB},
                                                          {"index_01_l", SINEW_CLASS_INDEX},
                                                          {"MiddleFinger2.L", SINEW_CLASS_MIDDLE},
                                                          {"f_ring.03.R", SINEW_CLASS_RING},
                                                          {"Little_Distal_L", SINEW_CLASS_PINKY},
                                                          {"finger1-2.L", SINEW_CLASS_THUMB},
                                                          {"Thumb_Metacarpal_L", SINEW_CLASS_THUMB},
                                                          {"Index_Metacarpal_L", SINEW_CLASS_OTHER},
                                                          {"Fingers.L", SINEW_CLASS_OTHER}};
  for (const auto& [name, expected] : named) {
    const Verdicts got({{name, {0, 0, 0}, -1}});
    EXPECT_EQ(got.classes[0], expected) << name;
    EXPECT_EQ(got.roles[0], SINEW_ROLE_FINGER) << name;
  }
  for (const char* none : {"LeftHand", "MMiddleEyebrow", "FootFinger1_L", "string", "ring_toe_L", "EarRing"})
    EXPECT_NE(Verdicts({{none, {0, 0, 0}, -1}}).roles[0], SINEW_ROLE_FINGER) << none;
  // 3ds Max counts from 0, and a finger's joints within one number.
  std::vector<Joint> joints = {{"Bip01_L_Hand", {0, 0, 0}, -1}};
  for (const char* name : {"Bip01_L_Finger0", "Bip01_L_Finger01", "Bip01_L_Finger02"})
    joints.push_back({name, {static_cast<float>(joints.size()), 0, 0}, static_cast<int>(joints.size()) - 1});
  joints.push_back({"Bip01_L_Finger4", {1, 1, 0}, 0});
  joints.push_back({"Bip01_L_Finger42", {2, 1, 0}, 4});
  const Verdicts got(joints);
  EXPECT_EQ(got.classes, (std::vector<uint8_t>{SINEW_CLASS_HAND, SINEW_CLASS_THUMB, SINEW_CLASS_THUMB,
                                               SINEW_CLASS_THUMB, SINEW_CLASS_PINKY, SINEW_CLASS_PINKY}));
  EXPECT_EQ(std::vector<int32_t>(got.numbers.begin() + 1, got.numbers.end()), (std::vector<int32_t>{1, 2, 3, 1, 2}));
}

// Of every part that a row names a class or a detail's role comes out, whoever asks.
TEST(JointClasses, EveryRowOfTheTableIsSeen) {
  int count = 0;
  const names::Word* const all = names::words(&count);
  for (int i = 0; i < count; ++i) {
    if (all[i].part == names::Part::kNone) continue;
    const Verdicts got({{"chest", {0, 0, 0}, -1}, {all[i].text, {0, 1, 0}, 0}, {"x", {0, 2, 0}, 1}},
                       {SINEW_FOLLOWS_SOME, SINEW_FOLLOWS_SOME, SINEW_FOLLOWS_SOME});
    EXPECT_TRUE(got.classes[1] != SINEW_CLASS_OTHER || got.roles[1] > SINEW_ROLE_END) << all[i].text;
  }
}

TEST(JointClasses, PartnersAndImages) {
  std::vector<Joint> joints = {{"root", {0.25f, 0, 0}, -1},
                               {"arm_l", {1.25f, 1, 0}, 0},
                               {"ARM_R", {-0.75f, 1, 0}, 0},
                               {"hand one", {2.25f, 1, 0}, 1},
                               {"hand other", {-1.75f, 1, 0}, 2}};
  Verdicts got(joints);
  EXPECT_EQ(got.partners, (std::vector<int32_t>{-1, 2, 1, -1, -1}));
  EXPECT_EQ(got.images, (std::vector<int32_t>{0, 2, 1, 4, 3}));
  EXPECT_EQ(got.out.mirrored, 1u);
  EXPECT_EQ(got.out.mirror_axis, 0u);
  EXPECT_FLOAT_EQ(got.out.mirror_planes[0], 0.25f);
  EXPECT_EQ(got.sides, (std::vector<int8_t>{0, 1, -1, 0, 0}));
  joints[2].position.y = 2;
  got = Verdicts(joints);
  EXPECT_EQ(got.partners[1], 2) << "a partner by name, wherever it is";
  EXPECT_EQ(got.images[1], -1);
  EXPECT_EQ(got.out.mirrored, 0u);
}

TEST(JointClasses, TheCallersFaults) {
  const char* names[2] = {"a", nullptr};
  int32_t parents[2] = {-1, 0};
  float positions[6] = {};
  uint8_t follows[2] = {0, 3};
  alignas(64) char memory[8192];
  sinew_skeleton joints = SINEW_INIT(sinew_skeleton);
  joints.joint_count = 2;
  joints.names = names;
  sinew_joint_verdicts out = SINEW_INIT(sinew_joint_verdicts);
  EXPECT_EQ(sinew_joint_classes(&joints, nullptr, memory, sizeof memory, &out), SINEW_OK) << "names alone are enough";
  joints.parents = parents;
  joints.positions = positions;
  EXPECT_EQ(sinew_joint_classes(&joints, nullptr, memory, sizeof memory, &out), SINEW_OK);
  EXPECT_EQ(sinew_joint_classes(&joints, nullptr, memory, 64, &out), SINEW_ERROR_WORKSPACE);
  EXPECT_EQ(sinew_joint_classes(&joints, nullptr, memory + 1, sizeof memory - 1, &out), SINEW_ERROR_WORKSPACE);
  EXPECT_EQ(sinew_joint_classes(nullptr, nullptr, memory, sizeof memory, &out), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_joint_classes(&joints, nullptr, memory, sizeof memory, nullptr), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_joint_classes(&joints, follows, memory, sizeof memory, &out), SINEW_ERROR_ARGUMENT);
  parents[0] = 1;
  EXPECT_EQ(sinew_joint_classes(&joints, nullptr, memory, sizeof memory, &out), SINEW_ERROR_HIERARCHY);
  parents[0] = 2;
  EXPECT_EQ(sinew_joint_classes(&joints, nullptr, memory, sizeof memory, &out), SINEW_ERROR_INDEX);
  parents[0] = -1;
  positions[4] = NAN;
  EXPECT_EQ(sinew_joint_classes(&joints, nullptr, memory, sizeof memory, &out), SINEW_ERROR_NOT_FINITE);
  positions[4] = 0;
  joints.joint_count = 0;
  EXPECT_EQ(sinew_joint_classes(&joints, nullptr, memory, sizeof memory, &out), SINEW_ERROR_COUNT);
  joints.struct_size = 1;
  EXPECT_EQ(sinew_joint_classes(&joints, nullptr, memory, sizeof memory, &out), SINEW_ERROR_ARGUMENT);
  size_t bytes = 1;
  EXPECT_EQ(sinew_joint_classes_workspace_size(SINEW_MAX_JOINTS + 1, &bytes), SINEW_ERROR_COUNT);
  EXPECT_EQ(bytes, 0u);
  EXPECT_EQ(sinew_joint_classes_workspace_size(1, nullptr), SINEW_ERROR_ARGUMENT);
}

struct Rig {
  std::vector<Joint> joints;
  int add(const char* name, int parent, Point at) {
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
  uint8_t role(const std::string& name) const {
    const std::vector<uint8_t> roles = Verdicts(joints).roles;
    for (size_t j = 0; j < joints.size(); ++j)
      if (joints[j].name == name) return roles[j];
    ADD_FAILURE() << name;
    return SINEW_ROLE_DEFORMS;
  }
};

TEST(JointRoles, RootsAndEnds) {
  Rig rig;
  EXPECT_EQ(rig.role("root"), SINEW_ROLE_ROOT);
  EXPECT_EQ(rig.role("head_end"), SINEW_ROLE_END);
  for (const char* name : {"hips", "chest", "head", "upperarm", "hand"})
    EXPECT_EQ(rig.role(name), SINEW_ROLE_DEFORMS) << name;
  rig.add("tail_end", rig.add("backend", 1, {0, 1, -1}), {0, 1, -2});
  EXPECT_EQ(rig.role("backend"), SINEW_ROLE_DEFORMS);  // neither the word nor a leaf
}

TEST(JointRoles, AnEndWithAStartIsABoneAndAnEndMayHaveAnEnd) {
  Rig rig;
  rig.add("tail_end", rig.add("tail_start", 1, {0, 1, -1}), {0, 1, -2});
  rig.add("thumb_null_end", rig.add("thumb_null", 7, {-0.9f, 1.4f, 0}), {-1, 1.4f, 0});
  EXPECT_EQ(rig.role("tail_end"), SINEW_ROLE_DEFORMS);
  EXPECT_EQ(rig.role("thumb_null"), SINEW_ROLE_END);
  EXPECT_EQ(rig.role("thumb_null_end"), SINEW_ROLE_END);
}

TEST(JointRoles, ARigOfTwoJointsDeformsWithItsRoot) {
  Rig rig;
  rig.joints = {{"root", {0, 0, 0}, -1}, {"lid", {0, 1, 0}, 0}};
  EXPECT_EQ(rig.role("root"), SINEW_ROLE_DEFORMS);
}

TEST(JointRoles, TheFourthOfAFingerIsAnEnd) {
  Rig rig;
  int at = 7;
  for (const char* name : {"Index1", "Index2", "Index3", "Index4"}) at = rig.add(name, at, {-0.9f, 1.4f, 0.1f});
  EXPECT_EQ(rig.role("Index4"), SINEW_ROLE_END);
  EXPECT_EQ(rig.role("Index3"), SINEW_ROLE_FINGER);
  Rig longer;  // a spine of four is no finger
  at = 1;
  for (const char* name : {"Tail1", "Tail2", "Tail3", "Tail4"}) at = longer.add(name, at, {0, 1, -1});
  EXPECT_EQ(longer.role("Tail4"), SINEW_ROLE_DEFORMS);
}

TEST(JointRoles, ControlsHangBesideTheLimbs) {
  Rig rig;
  rig.add("handIK.l", 0, {-0.8f, 1.4f, 0});
  rig.add("elbowIK.l", 0, {-0.5f, 1.4f, -0.5f});
  rig.add("PoleTarget.R", -1, {0.5f, 1.4f, -0.5f});
  const int roll = rig.add("control-heel-roll.l", 0, {0, 0, 0});
  rig.add("IK-toe.l", roll, {0, 0, 0.1f});
  for (const char* name : {"handIK.l", "elbowIK.l", "PoleTarget.R", "control-heel-roll.l", "IK-toe.l"})
    EXPECT_EQ(rig.role(name), SINEW_ROLE_CONTROL) << name;
}

TEST(JointRoles, AControlInTheMiddleOfALimbIsALimb) {
  Rig rig;
  const int thigh = rig.add("thigh", 1, {0.1f, 0.9f, 0}), leg = rig.add("IKLeg", thigh, {0.1f, 0.5f, 0});
  rig.add("foot", leg, {0.1f, 0.1f, 0});
  EXPECT_EQ(rig.role("IKLeg"), SINEW_ROLE_DEFORMS);
  rig.add("foot_ctrl", leg, {0.1f, 0.1f, 0});  // stands where the foot is
  EXPECT_EQ(rig.role("foot_ctrl"), SINEW_ROLE_CONTROL);
}

TEST(JointRoles, AWordInEveryNameSaysNothing) {
  Rig rig;
  for (Joint& joint : rig.joints) joint.name = "CTRL_" + joint.name;
  EXPECT_EQ(rig.role("CTRL_head"), SINEW_ROLE_DEFORMS);
  EXPECT_EQ(rig.role("CTRL_hand"), SINEW_ROLE_DEFORMS);
}

TEST(JointRoles, SlotsAreLeaves) {
  Rig rig;
  rig.add("handslot.l", 7, {-0.9f, 1.4f, 0});
  rig.add("socket_hat", 3, {0, 2, 0});
  rig.add("LeftEyeSocket", 3, {0.05f, 1.8f, 0.1f});
  const int mount = rig.add("wing_mount", 2, {0, 1.4f, -0.2f});
  rig.add("wing", mount, {0, 1.4f, -0.6f});
  EXPECT_EQ(rig.role("handslot.l"), SINEW_ROLE_SLOT);
  EXPECT_EQ(rig.role("socket_hat"), SINEW_ROLE_SLOT);
  EXPECT_EQ(rig.role("LeftEyeSocket"), SINEW_ROLE_FACE);
  EXPECT_EQ(rig.role("wing_mount"), SINEW_ROLE_DEFORMS);
}

TEST(JointRoles, OfARigifyRigTheDefJointsDeform) {
  Rig rig;
  for (Joint& joint : rig.joints)
    if (joint.name != "root") joint.name = "DEF-" + joint.name;
  const int torso = rig.add("torso", 0, {0, 1, 0}), mch = rig.add("MCH-spine", torso, {0, 1.2f, 0});
  rig.add("ORG-head", mch, {0, 1.7f, 0});
  EXPECT_EQ(rig.role("torso"), SINEW_ROLE_CONTROL);
  EXPECT_EQ(rig.role("MCH-spine"), SINEW_ROLE_CONTROL);
  EXPECT_EQ(rig.role("ORG-head"), SINEW_ROLE_CONTROL);
  EXPECT_EQ(rig.role("DEF-chest"), SINEW_ROLE_DEFORMS);
}

TEST(JointRoles, ATipIsAJointUnlessWeightsSayNo) {
  Rig rig;
  for (const char* name : {"horn_tip", "ear_leaf", "toe_nub", "tail_ends", "End Site"}) rig.add(name, 3, {0, 2, 0});
  EXPECT_EQ(rig.role("horn_tip"), SINEW_ROLE_DEFORMS);
  EXPECT_EQ(rig.role("ear_leaf"), SINEW_ROLE_DEFORMS);
  for (const char* name : {"toe_nub", "tail_ends", "End Site"}) EXPECT_EQ(rig.role(name), SINEW_ROLE_END) << name;
  std::vector<uint8_t> follows(rig.joints.size(), SINEW_FOLLOWS_NONE);
  EXPECT_EQ(Verdicts(rig.joints, follows).roles[rig.joints.size() - 5], SINEW_ROLE_END);
  follows.assign(rig.joints.size(), SINEW_FOLLOWS_SOME);
  for (const uint8_t role : Verdicts(rig.joints, follows).roles) EXPECT_NE(role, SINEW_ROLE_END) << "they own weight";
}

}  // namespace
}  // namespace sinew
