// SPDX-License-Identifier: MIT
// Edits of a predicted skeleton: both sides alike, parents first, errors that leave it as it was.
#include "sinew_character/predict/edit_skeleton.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "expect_error.hpp"

namespace sinew {
namespace {

// Hips, Spine, Head on the plane x = 0.5, arms of two joints with bone ends.
PredictedSkeleton small_body() {
  PredictedSkeleton s;
  s.mirrored = true;
  s.plane = 0.5f;
  const auto add = [&](const char* name, Vec3 position, int parent, bool end, int partner) {
    s.joints.push_back({name, position, parent, !end});
    s.classes.push_back(SINEW_CLASS_SPINE);
    s.ends.push_back(end ? 1 : 0);
    s.partners.push_back(partner);
    s.confidence.push_back(0.5f);
    s.parent_confidence.push_back(0.5f);
  };
  add("Hips", {0.5f, 1, 0}, -1, false, 0);
  add("Spine", {0.5f, 1.5f, 0}, 0, false, 1);
  add("Head", {0.5f, 2, 0}, 1, false, 2);
  add("LeftArm", {1, 1.5f, 0}, 1, false, 6);
  add("LeftHand", {2, 1.5f, 0}, 3, false, 7);
  add("LeftHand_end", {2.25f, 1.5f, 0}, 4, true, 8);
  add("RightArm", {0, 1.5f, 0}, 1, false, 3);
  add("RightHand", {-1, 1.5f, 0}, 6, false, 4);
  add("RightHand_end", {-1.25f, 1.5f, 0}, 7, true, 5);
  return s;
}

size_t index_of(const PredictedSkeleton& s, const std::string& name) {
  for (size_t j = 0; j < s.joints.size(); ++j)
    if (s.joints[j].name == name) return j;
  ADD_FAILURE() << "no joint " << name;
  return 0;
}
const Joint& joint(const PredictedSkeleton& s, const std::string& name) { return s.joints[index_of(s, name)]; }
std::string parent(const PredictedSkeleton& s, const std::string& name) {
  const int p = joint(s, name).parent;
  return p < 0 ? "" : s.joints[static_cast<size_t>(p)].name;
}
bool has(const PredictedSkeleton& s, const std::string& name) {
  for (const Joint& one : s.joints)
    if (one.name == name) return true;
  return false;
}
void expect_at(const PredictedSkeleton& s, const std::string& name, Vec3 position) {
  const Vec3 p = joint(s, name).position;
  EXPECT_EQ(p.x, position.x) << name;
  EXPECT_EQ(p.y, position.y) << name;
  EXPECT_EQ(p.z, position.z) << name;
}
void expect_sound(const PredictedSkeleton& s) {
  const size_t count = s.joints.size();
  ASSERT_EQ(s.classes.size(), count);
  ASSERT_EQ(s.ends.size(), count);
  ASSERT_EQ(s.partners.size(), count);
  ASSERT_EQ(s.confidence.size(), count);
  ASSERT_EQ(s.parent_confidence.size(), count);
  for (size_t j = 0; j < count; ++j) {
    EXPECT_LT(s.joints[j].parent, static_cast<int>(j));
    const int32_t partner = s.partners[j];
    if (partner >= 0) {
      EXPECT_EQ(s.partners[static_cast<size_t>(partner)], static_cast<int32_t>(j)) << s.joints[j].name;
    }
    EXPECT_EQ(s.joints[j].deforms, s.ends[j] == 0);
  }
}
PredictedSkeleton edited(EditKind kind, const std::string& text, bool mirror = true) {
  PredictedSkeleton s = small_body();
  edit_skeleton({parse_edit(kind, text)}, mirror, &s);
  expect_sound(s);
  return s;
}

TEST(EditSkeleton, MoveTakesThePartnerAndBoneEndsAlong) {
  const PredictedSkeleton s = edited(EditKind::kMove, "RightHand=-2,1.25,0.5");
  expect_at(s, "RightHand", {-2, 1.25f, 0.5f});
  expect_at(s, "LeftHand", {3, 1.25f, 0.5f});
  expect_at(s, "RightHand_end", {-2.25f, 1.25f, 0.5f});
  expect_at(s, "LeftHand_end", {3.25f, 1.25f, 0.5f});
  expect_at(s, "LeftArm", {1, 1.5f, 0});
  const PredictedSkeleton arm = edited(EditKind::kMove, "LeftArm=1,1,0");
  expect_at(arm, "LeftHand", {2, 1.5f, 0});
}

TEST(EditSkeleton, MoveKeepsWhatIsOnThePlaneThere) {
  expect_at(edited(EditKind::kMove, "Head=0.7,3,0.25"), "Head", {0.5f, 3, 0.25f});
  expect_at(edited(EditKind::kMove, "Head=0.7,3,0.25", false), "Head", {0.7f, 3, 0.25f});
}

TEST(EditSkeleton, WithoutMirrorOnlyOneSideChanges) {
  const PredictedSkeleton s = edited(EditKind::kMove, "RightHand=-2,1.25,0.5", false);
  expect_at(s, "LeftHand", {2, 1.5f, 0});
  expect_at(s, "RightHand_end", {-2.25f, 1.25f, 0.5f});
  const PredictedSkeleton removed = edited(EditKind::kRemove, "RightHand", false);
  EXPECT_TRUE(has(removed, "LeftHand"));
  EXPECT_FALSE(has(removed, "RightHand"));
}

TEST(EditSkeleton, ATurnedSkeletonIsMirroredAcrossZ) {
  PredictedSkeleton s = small_body();
  s.facing = 1;
  s.front = {1, 0, 0};
  for (Joint& one : s.joints) one.position = {one.position.z, one.position.y, one.position.x};
  edit_skeleton({parse_edit(EditKind::kMove, "RightHand=0.5,1.25,-2")}, true, &s);
  expect_at(s, "LeftHand", {0.5f, 1.25f, 3});
}

TEST(EditSkeleton, AddMakesAPair) {
  const PredictedSkeleton s = edited(EditKind::kAdd, "LeftWing=Spine:1,1.75,-1");
  expect_at(s, "LeftWing", {1, 1.75f, -1});
  expect_at(s, "RightWing", {0, 1.75f, -1});
  EXPECT_EQ(parent(s, "RightWing"), "Spine");
  EXPECT_EQ(s.partners[index_of(s, "LeftWing")], static_cast<int32_t>(index_of(s, "RightWing")));
  EXPECT_EQ(s.confidence[index_of(s, "RightWing")], 1);
  const PredictedSkeleton finger = edited(EditKind::kAdd, "thumb_r=RightHand:-1.2,1.4,0");
  EXPECT_EQ(parent(finger, "thumb_l"), "LeftHand");
  const PredictedSkeleton tail = edited(EditKind::kAdd, "Tail=Hips:0.501,1,-1");
  expect_at(tail, "Tail", {0.5f, 1, -1});
  EXPECT_EQ(tail.partners[index_of(tail, "Tail")], static_cast<int32_t>(index_of(tail, "Tail")));
  const PredictedSkeleton sword = edited(EditKind::kAdd, "Sword=Hips:1.5,1,0");
  EXPECT_EQ(sword.partners[index_of(sword, "Sword")], -1);
  const PredictedSkeleton end = edited(EditKind::kAdd, "Head_end=Head:0.5,2.5,0");
  EXPECT_EQ(end.ends[index_of(end, "Head_end")], 1);
}

TEST(EditSkeleton, RemoveHandsChildrenUp) {
  const PredictedSkeleton s = edited(EditKind::kRemove, "LeftArm");
  EXPECT_EQ(s.joints.size(), 7u);
  EXPECT_EQ(parent(s, "LeftHand"), "Spine");
  EXPECT_EQ(parent(s, "RightHand"), "Spine");
  const PredictedSkeleton hand = edited(EditKind::kRemove, "LeftHand");
  EXPECT_FALSE(has(hand, "LeftHand_end"));
  EXPECT_FALSE(has(hand, "RightHand_end"));
  const PredictedSkeleton root = edited(EditKind::kRemove, "Hips");
  EXPECT_EQ(parent(root, "Spine"), "");
  EXPECT_EQ(root.joints.size(), 8u);
}

TEST(EditSkeleton, RemovingARootWithSeveralChildrenLeavesOneRoot) {
  PredictedSkeleton s = small_body();
  edit_skeleton({parse_edit(EditKind::kRemove, "Hips"), parse_edit(EditKind::kRemove, "Head"),
                 parse_edit(EditKind::kAdd, "Crown=Spine:0.5,2,0"), parse_edit(EditKind::kRemove, "Spine")},
                true, &s);
  expect_sound(s);
  EXPECT_EQ(parent(s, "Crown"), "") << "the child on the plane, though the arms come before it";
  EXPECT_EQ(parent(s, "LeftArm"), "Crown");
  EXPECT_EQ(parent(s, "RightArm"), "Crown");
}

TEST(EditSkeleton, ParentFollowsOnTheOtherSide) {
  const PredictedSkeleton s = edited(EditKind::kParent, "LeftHand=Hips");
  EXPECT_EQ(parent(s, "LeftHand"), "Hips");
  EXPECT_EQ(parent(s, "RightHand"), "Hips");
  PredictedSkeleton back = s;
  edit_skeleton({parse_edit(EditKind::kParent, "RightHand=RightArm")}, true, &back);
  EXPECT_EQ(parent(back, "LeftHand"), "LeftArm");
}

TEST(EditSkeleton, ParentsComeFirstAfterwards) {
  PredictedSkeleton s = small_body();
  edit_skeleton({parse_edit(EditKind::kAdd, "Root=Hips:0.5,0,0"), parse_edit(EditKind::kParent, "Spine=Root")}, true,
                &s);
  expect_sound(s);
  EXPECT_EQ(parent(s, "LeftArm"), "Spine");
  EXPECT_EQ(parent(s, "Spine"), "Root");
}

TEST(EditSkeleton, RenameKeepsBothSidesAlike) {
  const PredictedSkeleton s = edited(EditKind::kRename, "LeftHand=wrist.L");
  EXPECT_TRUE(has(s, "wrist.L") && has(s, "wrist.R") && has(s, "wrist.L_end") && has(s, "wrist.R_end"));
  EXPECT_FALSE(has(s, "RightHand"));
}

TEST(EditSkeleton, EditsApplyInTheirOrder) {
  PredictedSkeleton s = small_body();
  edit_skeleton({parse_edit(EditKind::kAdd, "Hat=Head:0.5,2.5,0"), parse_edit(EditKind::kMove, "Hat=0.5,3,0"),
                 parse_edit(EditKind::kRename, "Hat=Crown")},
                true, &s);
  expect_at(s, "Crown", {0.5f, 3, 0});
}

TEST(EditSkeleton, ErrorsSayWhatIsWrongAndChangeNothing) {
  const auto refused = [](EditKind kind, const std::string& text, const std::string& first,
                          const std::string& other = "") {
    PredictedSkeleton s = small_body();
    EXPECT_ERROR(edit_skeleton({parse_edit(EditKind::kMove, "Head=0.5,9,0"), parse_edit(kind, text)}, true, &s), first,
                 other);
    expect_at(s, "Head", {0.5f, 2, 0});
    EXPECT_EQ(s.joints.size(), 9u);
  };
  refused(EditKind::kMove, "LeftHnd=0,0,0", "unknown joint 'LeftHnd'", "LeftHand");
  refused(EditKind::kMove, "righthand=0,0,0", "near it: RightHand");
  refused(EditKind::kMove, "LeftHand=0,zero,0", "three numbers", "'zero'");
  refused(EditKind::kMove, "LeftHand=0,0", "three numbers");
  refused(EditKind::kMove, "LeftHand=0,0,0,0", "three numbers");
  refused(EditKind::kMove, "LeftHand=0,nan,0", "three numbers");
  refused(EditKind::kMove, "LeftHand", "expected --move JOINT=X,Y,Z");
  refused(EditKind::kAdd, "Tail=0,0,0", "expected --add NAME=PARENT:X,Y,Z");
  refused(EditKind::kAdd, "Tail=Hip:0,0,0", "unknown joint 'Hip'", "Hips");
  refused(EditKind::kAdd, "Head=Hips:0,0,0", "already");
  refused(EditKind::kAdd, "Thumb=LeftHand:2,1,0", "both sides");
  refused(EditKind::kAdd, "a b=Hips:0,0,0", "contains a space");
  refused(EditKind::kAdd, "Nail=LeftHand_end:0,0,0", "bone end", "'LeftHand'");
  refused(EditKind::kParent, "Spine=LeftHand", "cycle");
  refused(EditKind::kParent, "Spine=Spine", "cycle");
  refused(EditKind::kParent, "LeftArm=RightHand", "cycle");
  refused(EditKind::kParent, "Head=LeftArm", "mirror plane");
  refused(EditKind::kRename, "Head=Hips", "already");
}

TEST(EditSkeleton, TheLastJointStays) {
  PredictedSkeleton s = small_body();
  edit_skeleton({parse_edit(EditKind::kRemove, "LeftArm"), parse_edit(EditKind::kRemove, "LeftHand"),
                 parse_edit(EditKind::kRemove, "Head"), parse_edit(EditKind::kRemove, "Spine")},
                true, &s);
  EXPECT_EQ(s.joints.size(), 1u);
  EXPECT_ERROR(edit_skeleton({parse_edit(EditKind::kRemove, "Hips")}, true, &s), "no joint");
  EXPECT_EQ(s.joints.size(), 1u);
}

TEST(EditSkeleton, AMarkerMovesAJointOrMakesTheChainThatIsMissing) {
  PredictedSkeleton s = small_body();
  edit_skeleton({parse_edit(EditKind::kAt, "LeftHand=2.5,1,0")}, true, &s);
  expect_at(s, "LeftHand", {2.5f, 1, 0});
  expect_at(s, "RightHand", {-1.5f, 1, 0});

  edit_skeleton({parse_edit(EditKind::kAt, "LeftFoot=1,0,0")}, true, &s);
  EXPECT_EQ(parent(s, "LeftFoot"), "LeftLeg");
  EXPECT_EQ(parent(s, "LeftLeg"), "LeftUpLeg");
  EXPECT_EQ(parent(s, "LeftUpLeg"), "Hips");
  EXPECT_NEAR(joint(s, "LeftUpLeg").position.y, 0.88f, 1e-5f);
  EXPECT_NEAR(joint(s, "RightFoot").position.x, 0, 1e-5f);
  EXPECT_EQ(s.partners[index_of(s, "LeftLeg")], static_cast<int>(index_of(s, "RightLeg")));
  EXPECT_EQ(s.classes[index_of(s, "RightLeg")], SINEW_CLASS_CALF);

  edit_skeleton({parse_edit(EditKind::kAt, "LeftToeBase=1,0,0.3")}, true, &s);
  EXPECT_EQ(parent(s, "LeftToeBase"), "LeftFoot");
  expect_at(s, "LeftToeBase", {1, 0, 0.3f});
  const size_t before = s.joints.size();
  EXPECT_ERROR(edit_skeleton({parse_edit(EditKind::kAt, "LeftClaw=0,0,0")}, true, &s), "LeftClaw", "--add");
  EXPECT_EQ(s.joints.size(), before);
}

}  // namespace
}  // namespace sinew
