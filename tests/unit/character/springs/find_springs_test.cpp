// SPDX-License-Identifier: MIT
// What hangs on a person is found by names and without, and what is part of it is not.
#include "sinew_character/springs/find_springs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "expect_error.hpp"
#include "hairy_person.hpp"
#include "sinew_character/profile/profile.hpp"
#include "sinew_formats/document_form.hpp"
#include "sinew_formats/io.hpp"
#include "springs/swing_words.hpp"

namespace sinew {
namespace {

using sinew_test::HairyPerson;

std::map<std::string, FoundChain> found_in(const Character& character) {
  std::map<std::string, FoundChain> out;
  for (FoundChain& one : find_springs(character)) out[one.chain.name] = std::move(one);
  return out;
}

TEST(FindSprings, AnUndressedPersonHasNone) { EXPECT_TRUE(find_springs(HairyPerson().character).empty()); }

TEST(FindSprings, NamesTellKinds) {
  HairyPerson person;
  const int head = static_cast<int>(person.index("Head")), hips = static_cast<int>(person.index("Hips"));
  person.chain("J_Sec_Hair1_0", head, {0, 1.75, -0.12}, {0, -0.05, -0.01}, 4);
  person.chain("BackHair", head, {0, 1.7, -0.13}, {0, -0.15, -0.01}, 5);
  person.chain("J_Sec_L_CoatSkirtBack1_0", hips, {0.1, 0.98, -0.18}, {0, -0.15, -0.02}, 3);
  person.chain("Tail", hips, {0, 1, -0.16}, {0, -0.08, -0.1}, 4);
  person.chain("LeftEar", head, {0.08, 1.78, 0}, {0.01, 0.09, 0}, 2);
  person.chain("Cape_", static_cast<int>(person.index("Spine1")), {0, 1.48, -0.18}, {0, -0.2, -0.02}, 4);
  person.chain("髪", head, {0.1, 1.7, 0}, {0.01, -0.08, 0}, 3);
  const std::map<std::string, FoundChain> found = found_in(person.character);
  const std::map<std::string, SpringKind> kinds = {{"J_Sec_Hair1_01", SpringKind::kHair},
                                                   {"BackHair1", SpringKind::kLongHair},
                                                   {"J_Sec_L_CoatSkirtBack1_01", SpringKind::kSkirt},
                                                   {"Tail1", SpringKind::kTail},
                                                   {"LeftEar1", SpringKind::kEar},
                                                   {"Cape_1", SpringKind::kCape},
                                                   {"髪1", SpringKind::kHair}};
  EXPECT_EQ(found.size(), kinds.size());
  for (const auto& [name, kind] : kinds) {
    ASSERT_TRUE(found.count(name)) << name;
    EXPECT_EQ(found.at(name).kind, kind) << name;
    EXPECT_TRUE(found.at(name).kept) << name;
    EXPECT_FALSE(found.at(name).reason.empty());
  }
  const FoundChain& hair = found.at("J_Sec_Hair1_01");
  EXPECT_EQ(hair.chain.turning_joints(), 4u);
  EXPECT_NEAR(hair.length, 4 * 0.051, 0.01);  // the last bone ends where its skin does
  for (size_t i = 1; i < 4; ++i) EXPECT_LT(hair.chain.joints[i].stiffness, hair.chain.joints[i - 1].stiffness);
  for (const SpringJoint& joint : hair.chain.joints) {
    EXPECT_GT(joint.hit_radius, 0.005);
    EXPECT_LT(joint.hit_radius, 0.016);
    EXPECT_GT(joint.limit, 0);
  }
  EXPECT_EQ(found.at("Tail1").chain.joints[0].gravity_power, 0);
}

// "Hips.001" reads as a pelvis; in a VRM, whose humanoid does not have it, it is a tail.
TEST(FindSprings, AVrmsHumanoidSaysWhatIsBody) {
  HairyPerson person;
  person.chain("Hips.00", static_cast<int>(person.index("Hips")), {0, 1, -0.16}, {0, -0.06, -0.1}, 4);
  EXPECT_EQ(found_in(person.character).size(), 0u);
  VrmData vrm;
  vrm.title = "Tailed";
  vrm.authors = {"somebody"};
  vrm.bones = vrm_bones(HairyPerson().character.joints, "person");
  vrm.bones.resize(person.character.joints.size());
  DocumentForm form;
  form.vrm = &vrm;
  const std::string path = testing::TempDir() + "find_springs.vrm";
  (void)write_gltf_form(path, person.character, {}, {}, form);
  const Character read = read_character(path);
  EXPECT_EQ(vrm_file_bones(read)[person.index("Hips")], "hips");
  EXPECT_TRUE(vrm_file_bones(person.character).empty());
  const std::map<std::string, FoundChain> found = found_in(read);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.begin()->second.kind, SpringKind::kTail);
  EXPECT_TRUE(found.begin()->second.kept);
}

TEST(FindSprings, WhatHasNoNameHangsOffAKnownBody) {
  HairyPerson person;
  const int head = static_cast<int>(person.index("Head")), hips = static_cast<int>(person.index("Hips"));
  person.chain("Bone.0", head, {0, 1.75, -0.12}, {0, -0.06, -0.01}, 4);
  person.chain("Bone.1", hips, {0, 1, -0.16}, {0, -0.06, -0.1}, 4);
  person.chain("Sword", static_cast<int>(person.index("RightHand")), {-0.8, 1.45, 0}, {0, 0.2, 0}, 3);
  person.chain("Bag", static_cast<int>(person.index("Spine1")), {0, 1.45, -0.16}, {0, -0.1, 0}, 3);
  (void)person.bone("Brow", {0.03, 1.7, 0.1}, head, {0.05, 1.7, 0.1}, 0.005);
  const std::map<std::string, FoundChain> found = found_in(person.character);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found.at("Bone.01").kind, SpringKind::kHair);
  EXPECT_EQ(found.at("Bone.11").kind, SpringKind::kTail);
  for (const auto& [name, chain] : found) {
    EXPECT_TRUE(chain.kept) << name;
    EXPECT_LT(chain.certainty, 0.7f) << name;
    EXPECT_NE(chain.reason.find("with a free end"), std::string::npos);
  }
}

TEST(FindSprings, WhatIsDoubtfulIsProposedAndNotKept) {
  HairyPerson person;
  const int head = static_cast<int>(person.index("Head"));
  person.chain("Left_Ear", head, {0.1, 1.68, 0}, {0.01, 0.05, 0}, 1);  // a person's
  for (int i = 1; i <= 3; ++i)                                         // a chain that nothing is bound to
    (void)person.add("Ribbon" + std::to_string(i), {0, 1.7 - 0.1 * i, -0.15},
                     i == 1 ? head : static_cast<int>(person.character.joints.size()) - 1);
  const std::map<std::string, FoundChain> found = found_in(person.character);
  for (const auto& [name, chain] : found) EXPECT_FALSE(chain.kept) << name;
  EXPECT_TRUE(found.count("Left_Ear1"));
}

TEST(FindSprings, BranchesBeginChainsOfTheirOwn) {
  HairyPerson person;
  const int head = static_cast<int>(person.index("Head"));
  person.chain("HairA", head, {0, 1.75, -0.12}, {0, -0.06, 0}, 5);
  person.chain("HairB", static_cast<int>(person.index("HairA2")), {0.05, 1.6, -0.12}, {0.01, -0.06, 0}, 2);
  const std::map<std::string, FoundChain> found = found_in(person.character);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found.at("HairA1").chain.turning_joints(), 5u);
  EXPECT_EQ(found.at("HairB1").chain.turning_joints(), 2u);
}

TEST(FindSprings, ABaseOfSeveralChainsHoldsStill) {
  HairyPerson person;
  const int head = static_cast<int>(person.index("Head"));
  const int base = static_cast<int>(person.bone("HairRoot", {0, 1.75, 0}, head, {0, 1.78, 0}, 0.1));
  person.chain("HairFront", base, {0, 1.78, 0.1}, {0, -0.05, 0.01}, 3);
  person.chain("Hairback", base, {0, 1.78, -0.1}, {0, -0.05, -0.01}, 3);
  const std::map<std::string, FoundChain> found = found_in(person.character);
  EXPECT_EQ(found.size(), 2u);
  EXPECT_TRUE(found.count("HairFront1"));
  EXPECT_TRUE(found.count("Hairback1"));
}

TEST(FindSprings, SkinMayBeSharedWithTheBody) {
  HairyPerson person;
  const int hips = static_cast<int>(person.index("Hips"));
  const size_t first = person.character.vertices.size();
  person.chain("Strap", hips, {0.2, 1, 0}, {0, -0.08, 0}, 2);
  const auto strap = static_cast<uint32_t>(person.index("Strap1"));
  for (size_t v = first; v < person.character.vertices.size(); ++v)
    person.character.influences[v] = {{static_cast<uint32_t>(hips), 0.7f}, {strap, 0.3f}};
  const std::map<std::string, FoundChain> found = found_in(person.character);
  ASSERT_TRUE(found.count("Strap1"));
  EXPECT_TRUE(found.at("Strap1").kept) << found.at("Strap1").reason;
}

TEST(FindSprings, PanelsOfASkirtAreHinged) {
  HairyPerson person;
  person.chain("SkirtFront", static_cast<int>(person.index("Hips")), {0, 0.98, 0.2}, {0, -0.15, 0.02}, 3);
  const std::map<std::string, FoundChain> found = found_in(person.character);
  ASSERT_TRUE(found.count("SkirtFront1"));
  for (const SpringJoint& joint : found.at("SkirtFront1").chain.joints) {
    EXPECT_NEAR(std::abs(joint.hinge[0]), 1, 1e-6);  // across: it moves out and in
    EXPECT_NEAR(joint.hinge[2], 0, 1e-6);
  }
}

TEST(FindSprings, RefusesWhatHasNothingToSwing) {
  Character bare = HairyPerson().character;
  bare.influences.clear();
  EXPECT_ERROR((void)find_springs(bare), "person", "sinew bind");
  bare.joints.clear();
  EXPECT_ERROR((void)find_springs(bare), "person", "sinew rig");
}

TEST(SwingWords, AreWholeWords) {
  EXPECT_EQ(swing_word("J_Sec_R_CoatSkirtFront2_01")->kind, SpringKind::kSkirt);
  EXPECT_EQ(swing_word("hair_tail.003")->kind, SpringKind::kHair);
  EXPECT_EQ(swing_word("Bangs")->kind, SpringKind::kHair);
  EXPECT_EQ(swing_word("左スカート前")->kind, SpringKind::kSkirt);
  EXPECT_FALSE(swing_word("LeftForeArm"));
  EXPECT_FALSE(swing_word("landscape"));
  EXPECT_EQ(swing_word("Hairfront1.L")->kind, SpringKind::kHair);
  EXPECT_EQ(swing_word("backhair")->kind, SpringKind::kHair);
  EXPECT_FALSE(swing_word("hairy"));
  EXPECT_FALSE(swing_word("tailor"));
  EXPECT_FALSE(swing_word("detail_ctl"));
  EXPECT_TRUE(names_stiff_thing("Back_Sword.L"));
  EXPECT_FALSE(names_stiff_thing("Swordfish"));
}

}  // namespace
}  // namespace sinew
