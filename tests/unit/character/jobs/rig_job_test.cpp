// SPDX-License-Identifier: MIT
// A bare mesh and a known skeleton become a rig: what is kept, edited, fitted and refused. Hands: lone_hand_test.cpp.
#include "sinew_character/jobs/rig_job.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "expect_error.hpp"
#include "sinew/rig.h"
#include "sinew_character/models/models.hpp"

namespace sinew {
namespace {

void add_box(Character* c, Vec3 low, Vec3 high) {
  const auto first = static_cast<uint32_t>(c->vertices.size());
  for (uint32_t i = 0; i < 8; ++i)
    c->vertices.push_back(
        {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z});
  const uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    for (const uint32_t corner : f) c->face_vertices.push_back(first + corner);
    c->face_offsets.push_back(static_cast<uint32_t>(c->face_vertices.size()));
  }
}

// A trunk with two arms, of boxes that overlap.
Character tee() {
  Character c;
  c.name = "tee";
  add_box(&c, {-0.1f, 0, -0.1f}, {0.1f, 1.8f, 0.1f});
  add_box(&c, {-0.8f, 1.35f, -0.08f}, {0.8f, 1.5f, 0.08f});
  return c;
}

// What a network would say of it, mirrored.
PredictedSkeleton known_skeleton() {
  PredictedSkeleton s;
  const auto add = [&](const char* name, Vec3 at, int parent, uint8_t joint_class, int32_t partner, bool end = false) {
    s.joints.push_back({name, at, parent, !end});
    s.classes.push_back(joint_class);
    s.ends.push_back(end ? 1 : 0);
    s.partners.push_back(partner);
    s.confidence.push_back(1);
    s.parent_confidence.push_back(1);
  };
  add("Hips", {0, 0.9f, 0}, -1, SINEW_CLASS_PELVIS, 0);
  add("Spine", {0, 1.2f, 0}, 0, SINEW_CLASS_SPINE, 1);
  add("Neck", {0, 1.5f, 0}, 1, SINEW_CLASS_NECK, 2);
  add("Head", {0, 1.6f, 0}, 2, SINEW_CLASS_HEAD, 3);
  add("Head_end", {0, 1.8f, 0}, 3, SINEW_CLASS_HEAD, 4, true);
  add("LeftArm", {0.15f, 1.42f, 0}, 1, SINEW_CLASS_UPPER_ARM, 8);
  add("LeftForeArm", {0.4f, 1.42f, 0}, 5, SINEW_CLASS_FOREARM, 9);
  add("LeftHand", {0.65f, 1.42f, 0}, 6, SINEW_CLASS_HAND, 10);
  add("RightArm", {-0.15f, 1.42f, 0}, 1, SINEW_CLASS_UPPER_ARM, 5);
  add("RightForeArm", {-0.4f, 1.42f, 0}, 8, SINEW_CLASS_FOREARM, 6);
  add("RightHand", {-0.65f, 1.42f, 0}, 9, SINEW_CLASS_HAND, 7);
  s.mirrored = true;
  s.facing = 0;
  return s;
}

RigJobOptions unbound() {
  RigJobOptions job;
  job.bind = false;
  return job;
}

const Joint* joint_named(const Character& c, const std::string& name) {
  for (const Joint& joint : c.joints)
    if (joint.name == name) return &joint;
  return nullptr;
}

bool is_noted(const Character& c, const std::string& part) {
  return std::any_of(c.notes.begin(), c.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

TEST(RigJob, TheMeshGetsTheSkeletonAndLosesItsOwn) {
  Character mesh = tee();
  mesh.joints = {{"old", {0, 0, 0}, -1}, {"older", {0, 1, 0}, 0}};
  mesh.influences.assign(mesh.vertices.size(), {{1, 1.0f}});
  const RiggedCharacter rigged = rig_character(mesh, known_skeleton(), false, unbound(), {});
  ASSERT_EQ(rigged.character.joints.size(), known_skeleton().joints.size());
  for (size_t j = 0; j < rigged.character.joints.size(); ++j) {
    EXPECT_EQ(rigged.character.joints[j].name, known_skeleton().joints[j].name);
    EXPECT_EQ(rigged.character.joints[j].parent, known_skeleton().joints[j].parent);
  }
  EXPECT_TRUE(rigged.character.influences.empty());
  EXPECT_FALSE(rigged.fitted);
  EXPECT_TRUE(is_noted(rigged.character, "own skeleton of 2 joints was left out"));
  EXPECT_EQ(rigged.character.vertices.size(), mesh.vertices.size());
  EXPECT_TRUE(rig_character(tee(), known_skeleton(), false, unbound(), {}).character.notes.empty())
      << "nothing to say of a bare mesh";
}

TEST(RigJob, WhatNeedsWeightsIsRefusedWithoutThem) {
  RigJobOptions pose = unbound(), cut = unbound();
  pose.to_pose = "t";
  cut.cut = true;
  EXPECT_ERROR((void)rig_character(tee(), known_skeleton(), false, pose, {}), "rest pose", "leave out --no-bind");
  EXPECT_ERROR((void)rig_character(tee(), known_skeleton(), false, cut, {}), "seams", "leave out --no-bind");
}

TEST(RigJob, EditsAreMadeOnBothSides) {
  RigJobOptions job = unbound();
  job.edits = {parse_edit(EditKind::kRemove, "LeftHand"), parse_edit(EditKind::kRename, "LeftForeArm=LeftElbow")};
  const RiggedCharacter both = rig_character(tee(), known_skeleton(), false, job, {});
  EXPECT_EQ(joint_named(both.character, "RightHand"), nullptr);
  EXPECT_NE(joint_named(both.character, "RightElbow"), nullptr);
  job.mirror = SINEW_MIRROR_NEVER;
  const RiggedCharacter one = rig_character(tee(), known_skeleton(), false, job, {});
  EXPECT_EQ(joint_named(one.character, "LeftHand"), nullptr);
  EXPECT_NE(joint_named(one.character, "RightHand"), nullptr);
  job.edits = {parse_edit(EditKind::kRemove, "Tail")};
  EXPECT_ERROR((void)rig_character(tee(), known_skeleton(), false, job, {}), "Tail");
}

// A skeleton half as large by other names, which stands where it does not matter.
std::vector<Joint> own_joints() {
  std::vector<Joint> own;
  const std::vector<std::pair<std::string, std::string>> names = {
      {"Hips", "pelvis"},     {"Spine", "spine_01"},      {"Neck", "neck"},
      {"Head", "head"},       {"LeftArm", "upperarm_l"},  {"LeftForeArm", "lowerarm_l"},
      {"LeftHand", "hand_l"}, {"RightArm", "upperarm_r"}, {"RightForeArm", "lowerarm_r"},
      {"RightHand", "hand_r"}};
  const PredictedSkeleton known = known_skeleton();
  std::vector<int> number(known.joints.size(), -1);
  for (size_t j = 0; j < known.joints.size(); ++j) {
    for (const auto& [theirs, name] : names) {
      if (known.joints[j].name != theirs) continue;
      number[j] = static_cast<int>(own.size());
      const Vec3 p = known.joints[j].position;
      const int parent = known.joints[j].parent;
      own.push_back(
          {name, {0.5f * p.x + 3, 0.5f * p.y, 0.5f * p.z}, parent < 0 ? -1 : number[static_cast<size_t>(parent)]});
    }
  }
  return own;
}

TEST(RigJob, AnOwnSkeletonStandsWhereThePredictedOneDoes) {
  RigJobOptions job = unbound();
  job.skeleton = "mine.glb";
  job.own = own_joints();
  const RiggedCharacter rigged = rig_character(tee(), known_skeleton(), false, job, {});
  ASSERT_TRUE(rigged.fitted);
  EXPECT_GT(2 * rigged.fitted->matched, rigged.fitted->matchable);
  ASSERT_EQ(rigged.character.joints.size(), job.own.size());
  for (const auto& [name, like] : {std::pair{"pelvis", 0}, {"hand_l", 7}, {"lowerarm_r", 9}, {"head", 3}}) {
    const Joint* const joint = joint_named(rigged.character, name);
    ASSERT_NE(joint, nullptr) << name;
    const Vec3 wanted = known_skeleton().joints[static_cast<size_t>(like)].position;
    EXPECT_NEAR(joint->position.x, wanted.x, 0.02f) << name;
    EXPECT_NEAR(joint->position.y, wanted.y, 0.02f) << name;
  }
  EXPECT_FALSE(is_noted(rigged.character, "match nothing in this mesh"));
}

TEST(RigJob, AnOwnSkeletonOfAnotherKindIsAWarning) {
  RigJobOptions job = unbound();
  job.skeleton = "mine.glb";
  job.own = own_joints();
  const auto hips = static_cast<int>(job.own.size());
  job.own.push_back({"thigh_l", {3.05f, 0.4f, 0}, 0});
  for (const char* const name : {"calf_l", "foot_l", "toe_l", "tail_01", "tail_02", "tail_03", "tail_04", "tail_05",
                                 "tail_06", "tail_07", "tail_08", "tail_09"}) {
    const Vec3 above = job.own.back().position;
    const bool is_tail = std::string(name) == "tail_01";
    job.own.push_back({name, is_tail ? Vec3{3, 0.45f, -0.05f} : Vec3{above.x, above.y - 0.03f, above.z - 0.01f},
                       is_tail ? 0 : static_cast<int>(job.own.size()) - 1});
  }
  ASSERT_EQ(job.own[static_cast<size_t>(hips)].name, "thigh_l");
  const RiggedCharacter rigged = rig_character(tee(), known_skeleton(), false, job, {});
  ASSERT_TRUE(rigged.fitted);
  EXPECT_LT(2 * rigged.fitted->matched, rigged.fitted->matchable);
  EXPECT_TRUE(is_noted(rigged.character, "warning: most joints of mine.glb match nothing in this mesh"));
}

TEST(RigJob, GateAndDoubtsAreToldInTheNotes) {
  RigJobOptions job = unbound();
  job.gate = true;
  PredictedSkeleton sure = known_skeleton(), unsure = known_skeleton();
  sure.usable = 0.95f;
  sure.front_confidence = unsure.front_confidence = 0.95f;
  unsure.usable = 0.1f;
  for (float& c : unsure.confidence) c = 0.01f;
  for (float& c : unsure.parent_confidence) c = 0.001f;
  unsure.spread = 0.2f;
  const RiggedCharacter good = rig_character(tee(), sure, false, job, {});
  EXPECT_TRUE(good.gate.empty());
  const RiggedCharacter bad = rig_character(tee(), unsure, false, job, {});
  ASSERT_FALSE(bad.gate.empty());
  for (const std::string& line : bad.gate) EXPECT_TRUE(is_noted(bad.character, "gate: " + line)) << line;
  ASSERT_FALSE(bad.doubtful.empty());
  EXPECT_TRUE(is_noted(bad.character, bad.doubtful[0].name));
  unsure.usable.reset();
  EXPECT_TRUE(rig_character(tee(), unsure, false, job, {}).doubtful.empty()) << "votes alone are doubted";
}

TEST(RigJob, AHandIsAskedForWhereVotesKnowLittleAndNobodySaysMore) {
  PredictedSkeleton known = known_skeleton(), unknown = known;
  known.spread = 0.02f;
  unknown.spread = 0.2f;
  RigJobOptions job;
  EXPECT_FALSE(may_be_lone_hand(job, known));
  EXPECT_TRUE(may_be_lone_hand(job, unknown));
  for (const RigMethod method : {RigMethod::kVotes, RigMethod::kShape, RigMethod::kRegions, RigMethod::kSlots}) {
    job.method = method;
    EXPECT_FALSE(may_be_lone_hand(job, unknown));
  }
  job.method = RigMethod::kAuto;
  job.category = SINEW_CATEGORY_BIPED;
  EXPECT_FALSE(may_be_lone_hand(job, unknown));
}

TEST(RigJob, TheShapeNeedsNoModel) {
  RigJobOptions job = unbound();
  job.method = RigMethod::kShape;
  job.up = Axis::kY;
  job.front = SINEW_FRONT_PLUS_Z;
  const RiggedCharacter rigged = rig_character(tee(), job, {});
  ASSERT_GT(rigged.character.joints.size(), 4u);
  EXPECT_FALSE(is_noted(rigged.character, "uncertain")) << "both were said";
  for (size_t j = 0; j < rigged.character.joints.size(); ++j) {
    const Joint& joint = rigged.character.joints[j];
    EXPECT_LT(joint.parent, static_cast<int>(j));
    EXPECT_EQ(joint.parent < 0, j == 0);
    EXPECT_EQ(rigged.skeleton.classes[j], SINEW_CLASS_OTHER);
    EXPECT_LT(std::abs(joint.position.x), 0.85f);
    EXPECT_LT(std::abs(joint.position.z), 0.12f);
  }
  const RiggedCharacter again = rig_character(tee(), job, {});
  ASSERT_EQ(again.character.joints.size(), rigged.character.joints.size());
  for (size_t j = 0; j < again.character.joints.size(); ++j)
    EXPECT_EQ(again.character.joints[j].position.x, rigged.character.joints[j].position.x);
}

TEST(RigJob, BoundByTheModelEveryVertexHasWeightOfJointsThatDeform) {
  const auto model = load_model("");
  RigModels models;
  models.bind = &model->model;
  RigJobOptions job;
  job.influence_count = 2;
  const RiggedCharacter rigged = rig_character(tee(), known_skeleton(), false, job, models);
  ASSERT_EQ(rigged.character.influences.size(), rigged.character.vertices.size());
  for (const auto& row : rigged.character.influences) {
    float sum = 0;
    for (const Influence& i : row) {
      sum += i.weight;
      EXPECT_NE(rigged.character.joints[i.joint].name, "Head_end") << "an end of a bone";
    }
    EXPECT_NEAR(sum, 1, 1e-4f);
    EXPECT_LE(row.size(), 2u);
  }
  ASSERT_FALSE(rigged.character.notes.empty());
  EXPECT_EQ(rigged.character.notes.back().rfind("checked: ", 0), 0u) << rigged.character.notes.back();
}

}  // namespace
}  // namespace sinew
