// SPDX-License-Identifier: MIT
// Which joints of a file get weight, what is left alone, and who takes the weight of tips.
#include "sinew_character/bind/bind_character.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "expect_error.hpp"
#include "sinew_character/jobs/bind_job.hpp"

namespace sinew {
namespace {

// Two bars, each with a chain of three joints of its own inside; the joints a* lie in mesh 0, the joints b* in mesh 1,
// and a control lies between them.
Character two_bars() {
  Character c;
  c.name = "bars";
  for (uint32_t mesh = 0; mesh < 2; ++mesh) {
    const uint32_t base = static_cast<uint32_t>(c.vertices.size());
    for (uint32_t r = 0; r < 9; ++r)
      for (const auto& [y, z] : {std::pair{0.1f, 0.1f}, {-0.1f, 0.1f}, {-0.1f, -0.1f}, {0.1f, -0.1f}}) {
        c.vertices.push_back({static_cast<float>(r) / 4, y + static_cast<float>(mesh) * 0.5f, z});
        c.vertex_meshes.push_back(mesh);
      }
    for (uint32_t r = 0; r + 1 < 9; ++r)
      for (uint32_t i = 0; i < 4; ++i) {
        const uint32_t a = base + 4 * r + i, b = base + 4 * r + (i + 1) % 4;
        c.face_vertices.insert(c.face_vertices.end(), {a, b, b + 4, a + 4});
        c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
      }
    c.meshes.push_back({mesh == 0 ? "low" : "high", true, -1});
  }
  c.joints = {{"a1", {0, 0, 0}, -1},   {"a2", {1, 0, 0}, 0},       {"a3", {2, 0, 0}, 1},        {"b1", {0, 0.5f, 0}, 0},
              {"b2", {1, 0.5f, 0}, 3}, {"b_end", {2, 0.5f, 0}, 4}, {"handIK", {1, 0.25f, 0}, 0}};
  return c;
}

void give_own_weights(Character* c) {
  c->influences.assign(c->vertices.size(), {});
  for (size_t v = 0; v < c->vertices.size(); ++v) {
    const uint32_t near = c->vertices[v].x < 0.5f ? 0 : 1;
    c->influences[v] = {{c->vertex_meshes[v] == 0 ? near : 3 + near, 1.0f}};
  }
}

CharacterBind bound(const Character& c, JointsFrom from = JointsFrom::kAuto,
                    const std::vector<uint8_t>& joint_flags = {}, CharacterBindOptions options = {}) {
  return bind_character(c, choose_joints(c, from, joint_flags), options);
}

std::vector<double> weight_of_joints(const Character& c, const CharacterBind& result, uint32_t mesh) {
  std::vector<double> sums(c.joints.size(), 0);
  for (size_t v = 0; v < c.vertices.size(); ++v)
    if (c.vertex_meshes[v] == mesh)
      for (const Influence& i : result.influences[v]) sums[i.joint] += static_cast<double>(i.weight);
  return sums;
}

std::string why(const JointChoice& choice, size_t joint) {
  for (const LeftOutJoint& left : choice.left_out)
    if (left.joint == joint) return left.why;
  return "";
}

TEST(ChooseJoints, ByOwnWeightsMeshByMesh) {
  Character c = two_bars();
  give_own_weights(&c);
  const JointChoice choice = choose_joints(c, JointsFrom::kAuto);
  EXPECT_EQ(choice.from, JointsFrom::kOwn);
  EXPECT_EQ(choice.sets, (std::vector<std::vector<size_t>>{{0, 1}, {3, 4}}));
  EXPECT_EQ(why(choice, 2), "no weight in the file");
  EXPECT_EQ(choice.left_out.size(), 3u);
  const CharacterBind result = bound(c);
  const std::vector<double> low = weight_of_joints(c, result, 0), high = weight_of_joints(c, result, 1);
  EXPECT_GT(low[0], 1);
  EXPECT_GT(low[1], 1);
  EXPECT_EQ(low[3] + low[4] + low[2] + low[6], 0);
  EXPECT_GT(high[3], 1);
  EXPECT_EQ(high[0] + high[1] + high[5] + high[6], 0);
}

TEST(ChooseJoints, ByNamesWithoutWeights) {
  const Character c = two_bars();
  const JointChoice choice = choose_joints(c, JointsFrom::kAuto);
  EXPECT_EQ(choice.from, JointsFrom::kNames);
  EXPECT_EQ(why(choice, 6), "control");
  EXPECT_EQ(choice.left_out.size(), 1u);
  EXPECT_EQ(choice.tips, std::vector<size_t>{5});
  EXPECT_EQ(choose_joints(c, JointsFrom::kOwn).from, JointsFrom::kNames);  // it has none
}

TEST(ChooseJoints, AJointThatIsForbiddenKeepsNoOtherFromComingBack) {
  const Character c = two_bars();
  std::vector<uint8_t> joint_flags(c.joints.size(), 0);
  joint_flags[6] = SINEW_JOINT_NEVER;
  JointChoice choice = choose_joints(c, JointsFrom::kAuto, joint_flags);
  EXPECT_EQ(choice.tips, std::vector<size_t>{5});
  restore_joints({5, 6}, joint_flags, &choice);
  EXPECT_TRUE(choice.tips.empty());
  EXPECT_EQ(why(choice, 6), "control");
}

// An editor binds again and again: the weights of now are its own, and its user switches joints on and off.
TEST(BindJob, AChoiceOfBeforeStaysWhateverTheWeightsAreNow) {
  Character c = two_bars();
  give_own_weights(&c);
  const JointChoice before = prepare_joints(JointsFrom::kAuto, false, &c);
  c.influences.clear();
  BindJobOptions options;
  options.choice = &before;
  options.restored_joints = {2, 6};
  options.joint_flags.assign(c.joints.size(), 0);
  options.joint_flags[6] = SINEW_JOINT_NEVER;
  BindJob job(options, {}, &c);
  const CharacterBind result = job.bind({}, 0);
  EXPECT_EQ(job.choice().from, JointsFrom::kOwn);
  EXPECT_EQ(why(job.choice(), 2), "");
  EXPECT_EQ(why(job.choice(), 6), "excluded");
  EXPECT_EQ(why(job.choice(), 5), "no weight in the file");
  const std::vector<double> low = weight_of_joints(c, result, 0);
  EXPECT_GT(low[2], 1);
  EXPECT_EQ(low[3] + low[4] + low[6], 0);
}

TEST(ChooseJoints, AllMeansAll) {
  Character c = two_bars();
  give_own_weights(&c);
  const JointChoice choice = choose_joints(c, JointsFrom::kAll);
  EXPECT_TRUE(choice.left_out.empty());
  EXPECT_TRUE(choice.sets.empty());
  EXPECT_TRUE(choice.tips.empty());
}

TEST(ChooseJoints, TheUserHasTheLastWord) {
  Character c = two_bars();
  give_own_weights(&c);
  std::vector<uint8_t> joint_flags(c.joints.size(), 0);
  joint_flags[2] = joint_flags[6] = SINEW_JOINT_DEFORMS;
  const JointChoice deform = choose_joints(c, JointsFrom::kAuto, joint_flags);
  EXPECT_EQ(deform.flags, joint_flags);
  EXPECT_TRUE(deform.sets.empty());
  EXPECT_EQ(deform.left_out.size(), 5u);
  joint_flags.assign(c.joints.size(), 0);
  joint_flags[1] = SINEW_JOINT_NEVER;
  const JointChoice never = choose_joints(c, JointsFrom::kAuto, joint_flags);
  EXPECT_EQ(why(never, 1), "excluded");
  EXPECT_EQ(weight_of_joints(c, bound(c, JointsFrom::kAuto, joint_flags), 0)[1], 0);
}

TEST(ChooseJoints, TheFileMaySayWhatDeforms) {
  Character c = two_bars();
  c.joints[4].deforms = false;
  c.joints[5].deforms = true;
  c.joints[6].deforms = true;
  const JointChoice choice = choose_joints(c, JointsFrom::kAuto);
  EXPECT_EQ(why(choice, 4), "does not deform in the file");
  EXPECT_EQ(choice.left_out.size(), 1u);
  EXPECT_TRUE(choice.tips.empty());
}

TEST(ChooseJoints, ARigOfControlsKeepsThemAll) {
  Character c = two_bars();
  for (Joint& joint : c.joints) joint.deforms = false;
  EXPECT_TRUE(choose_joints(c, JointsFrom::kAuto).left_out.empty());
}

TEST(BindCharacter, TipsGiveTheirWeightToTheirParents) {
  const Character c = two_bars();
  CharacterBindOptions keep;
  keep.keep_tips = true;
  const CharacterBind folded = bound(c), kept = bound(c, JointsFrom::kAuto, {}, keep);
  const std::vector<double> f = weight_of_joints(c, folded, 1), k = weight_of_joints(c, kept, 1);
  EXPECT_GT(k[5], 1);
  EXPECT_EQ(kept.folded_tips, 0u);
  EXPECT_EQ(f[5], 0);
  EXPECT_NEAR(f[4], k[4] + k[5], 1e-3);
  EXPECT_EQ(folded.folded_tips, 1u);
  for (const std::vector<Influence>& row : folded.influences)
    for (size_t i = 1; i < row.size(); ++i) EXPECT_LE(row[i].weight, row[i - 1].weight);
}

TEST(BindCharacter, ATipWithAPartOfItsOwnKeepsIt) {
  Character c = two_bars();
  c.joints[5].position = {3, 0.5f, 0};
  for (const Vec3& p : {Vec3{3.1f, 0.5f, 0}, {3.3f, 0.5f, 0}, {3.2f, 0.6f, 0}, {3.2f, 0.5f, 0.1f}}) {
    c.vertices.push_back(p);
    c.vertex_meshes.push_back(1);
  }
  const uint32_t a = static_cast<uint32_t>(c.vertices.size()) - 4;
  for (const auto& face : std::vector<std::vector<uint32_t>>{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}) {
    for (const uint32_t corner : face) c.face_vertices.push_back(a + corner);
    c.face_offsets.push_back(static_cast<uint32_t>(c.face_vertices.size()));
  }
  const CharacterBind result = bound(c);
  EXPECT_EQ(result.folded_tips, 0u);
  EXPECT_EQ(result.influences[a].front().joint, 5u);
}

TEST(BindCharacter, ATipInTheMiddleOfItsParentsPartDoesNot) {
  Character c = two_bars();
  c.joints[4].position = {0.4f, 0.5f, 0};
  c.joints[5].position = {0.6f, 0.5f, 0};  // the far end of the bar, most of it, is b_end's; b2 has hardly any without
  const CharacterBind result = bound(c);
  EXPECT_EQ(result.folded_tips, 1u);
  EXPECT_EQ(weight_of_joints(c, result, 1)[5], 0);
}

TEST(BindCharacter, AttachedMeshesStay) {
  Character c = two_bars();
  c.meshes[1].skinned = false;
  c.meshes[1].carrier = 4;
  const CharacterBind result = bound(c, JointsFrom::kAll);
  EXPECT_EQ(result.kept_meshes, 1u);
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    if (c.vertex_meshes[v] == 0) continue;
    ASSERT_EQ(result.influences[v].size(), 1u);
    EXPECT_EQ(result.influences[v][0].joint, 4u);
  }
  // The bind does not see them: the other mesh gets what it gets alone.
  Character alone = c;
  alone.vertices.resize(36);
  alone.vertex_meshes.resize(36);
  alone.meshes.resize(1);
  alone.face_offsets.resize(33);
  alone.face_vertices.resize(alone.face_offsets.back());
  const CharacterBind one = bound(alone, JointsFrom::kAll);
  for (size_t v = 0; v < 36; ++v)
    for (size_t i = 0; i < one.influences[v].size(); ++i) {
      EXPECT_EQ(one.influences[v][i].joint, result.influences[v][i].joint);
      EXPECT_EQ(one.influences[v][i].weight, result.influences[v][i].weight);
    }
  CharacterBindOptions props;
  props.bind_props = true;
  EXPECT_EQ(bound(c, JointsFrom::kAll, {}, props).kept_meshes, 0u);
  c.meshes[0].skinned = false;
  c.meshes[0].carrier = 0;
  EXPECT_ERROR((void)bound(c), "bars", "attached", "--bind-props");
}

TEST(BindCharacter, AMeshOfOneJointFollowsIt) {
  Character c = two_bars();
  give_own_weights(&c);
  for (size_t v = 0; v < c.vertices.size(); ++v)
    if (c.vertex_meshes[v] == 1) c.influences[v] = {{4, 1.0f}};
  const CharacterBind result = bound(c);
  for (size_t v = 0; v < c.vertices.size(); ++v)
    if (c.vertex_meshes[v] == 1) {
      ASSERT_EQ(result.influences[v].size(), 1u);
      EXPECT_EQ(result.influences[v][0].joint, 4u);
    }
}

TEST(BindCharacter, NobodyIsAskedAboutTheWholeBody) {
  Character c = two_bars();
  CharacterBindOptions options;
  options.bind.question_count = 8;
  for (size_t v = 0; v < c.vertices.size(); ++v)
    if (c.vertex_meshes[v] == 1) c.vertices[v].z *= 3;  // parts alike are one question
  EXPECT_FALSE(bound(c, JointsFrom::kAuto, {}, options).questions.empty());
  c.vertices.resize(c.vertices.size() / 2);
  c.vertex_meshes.resize(c.vertices.size());
  c.face_vertices.resize(c.face_vertices.size() / 2);
  c.face_offsets.resize(1 + c.face_count() / 2);
  c.meshes.resize(1);
  const CharacterBind one = bound(c, JointsFrom::kAuto, {}, options);
  EXPECT_TRUE(one.questions.empty());
  for (const uint32_t question : one.vertex_questions) EXPECT_EQ(question, SINEW_NO_QUESTION);
}

}  // namespace
}  // namespace sinew
