// SPDX-License-Identifier: MIT
// Questions about parts and their answers, through the interface: a column with a badge, and a block on either side.
#include "sinew/questions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "mesh_scene.hpp"
#include "sinew/sinew.hpp"
#include "weights/alike_parts.hpp"

namespace {

using sinew_test::MeshScene;

constexpr uint32_t kColumn = 9 * 4, kBlock = 3 * 4, kBadge = 4;
constexpr uint32_t kRight = kColumn, kLeft = kRight + kBlock, kFirstOfBadge = kLeft + kBlock;
enum Joint : uint16_t { kRoot, kMiddle, kTop, kRightArm, kRightHand, kLeftArm, kLeftHand };

// `rings` squares of half a side `half` along y from (x, y, 0), closed at both ends.
void add_bar(MeshScene* scene, uint32_t rings, float x, float y, float step, float half, bool mirrored) {
  const uint32_t first = static_cast<uint32_t>(scene->positions.size() / 3);
  const float s = mirrored ? -1.0f : 1.0f;
  for (uint32_t r = 0; r < rings; ++r) {
    const float at = y + step * static_cast<float>(r);
    scene->add_vertex(x - s * half, at, -half);
    scene->add_vertex(x + s * half, at, -half);
    scene->add_vertex(x + s * half, at, half);
    scene->add_vertex(x - s * half, at, half);
  }
  const auto face = [&](std::vector<uint32_t> f) {
    if (mirrored) std::reverse(f.begin(), f.end());
    scene->add_face(f);
  };
  for (uint32_t r = 0; r + 1 < rings; ++r) {
    for (uint32_t side = 0; side < 4; ++side) {
      const uint32_t a = first + 4 * r + side, b = first + 4 * r + (side + 1) % 4;
      face({a, a + 4, b + 4, b});
    }
  }
  const uint32_t top = first + 4 * (rings - 1);
  face({first, first + 1, first + 2, first + 3});
  face({top + 3, top + 2, top + 1, top});
}

MeshScene doll() {
  MeshScene scene;
  add_bar(&scene, 9, 0, 0, 0.5f, 0.5f, false);
  add_bar(&scene, 3, 1.5f, 2.8f, 0.3f, 0.3f, false);
  add_bar(&scene, 3, -1.5f, 2.8f, 0.3f, 0.3f, true);
  for (const float x : {-0.1f, 0.1f}) {  // a badge in front of the column
    scene.add_vertex(x, 3.1f, 0.52f);
    scene.add_vertex(x, 3.45f, 0.52f);
  }
  scene.add_face({kFirstOfBadge, kFirstOfBadge + 2, kFirstOfBadge + 3, kFirstOfBadge + 1});
  scene.add_joint(0, 0.1f, 0, -1);
  scene.add_joint(0, 2, 0, kRoot);
  scene.add_joint(0, 3.5f, 0, kMiddle);
  for (const float s : {1.0f, -1.0f}) {
    scene.add_joint(s * 0.8f, 3, 0, kMiddle);
    scene.add_joint(s * 1.4f, 3, 0, static_cast<int32_t>(scene.parents.size()) - 1);
  }
  return scene;
}

struct Bound {
  sinew_status status = SINEW_OK;
  size_t bytes = 0;
  std::vector<uint16_t> joints, weights;  // [V x 4]
  std::vector<sinew_question> questions;
  std::vector<uint32_t> vertex_questions, vertex_parts;

  uint32_t weight(uint32_t vertex, uint16_t joint) const {
    for (size_t i = size_t{vertex} * 4; i < size_t{vertex} * 4 + 4; ++i)
      if (joints[i] == joint) return weights[i];
    return 0;
  }
  void expect_rigid(uint32_t first, uint32_t count, uint16_t joint) const {
    for (uint32_t v = first; v < first + count; ++v) EXPECT_EQ(weight(v, joint), 65535u) << v;
  }
  void expect_row_of(uint32_t vertex, const Bound& other, uint32_t from) const {
    for (size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(joints[size_t{vertex} * 4 + i], other.joints[size_t{from} * 4 + i]) << vertex;
      EXPECT_EQ(weights[size_t{vertex} * 4 + i], other.weights[size_t{from} * 4 + i]) << vertex;
    }
  }
  void expect_as(const Bound& other, uint32_t first, uint32_t count) const {
    for (uint32_t v = first; v < first + count; ++v) expect_row_of(v, other, v);
  }
};

Bound bind(const MeshScene& scene, const std::vector<sinew_answer>& answers = {}, uint32_t questions = 8,
           sinew_bind_options options = SINEW_INIT(sinew_bind_options)) {
  Bound bound;
  const sinew_mesh mesh = scene.mesh_view();
  const sinew_skeleton skeleton = scene.skeleton_view();
  options.method = SINEW_METHOD_HEAT;
  options.answers = answers.empty() ? nullptr : answers.data();
  options.answer_count = static_cast<uint32_t>(answers.size());
  options.question_count = questions;
  bound.joints.assign(size_t{mesh.vertex_count} * 4, 9);
  bound.weights.assign(size_t{mesh.vertex_count} * 4, 9);
  bound.questions.resize(questions);
  bound.vertex_questions.assign(mesh.vertex_count, 9);
  bound.vertex_parts.assign(mesh.vertex_count, 9);
  bound.status = sinew_bind_workspace_size(nullptr, mesh.vertex_count, mesh.face_count, mesh.corner_count,
                                           skeleton.joint_count, &options, &bound.bytes);
  if (bound.status != SINEW_OK) return bound;
  const sinew::Workspace block(bound.bytes);
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = bound.joints.data();
  outputs.weights = bound.weights.data();
  outputs.questions = questions > 0 ? bound.questions.data() : nullptr;
  outputs.vertex_questions = bound.vertex_questions.data();
  outputs.vertex_parts = bound.vertex_parts.data();
  bound.status = sinew_bind(nullptr, &mesh, &skeleton, &options, block.data(), bound.bytes, &outputs);
  bound.questions.resize(outputs.questions_written);
  return bound;
}

sinew_answer rigid(uint32_t vertex, uint16_t joint, uint32_t alone = 0) {
  return {vertex, SINEW_ANSWER_RIGID, joint, alone};
}
sinew_answer say(uint32_t vertex, sinew_answer_kind kind) { return {vertex, static_cast<uint16_t>(kind), 0, 0}; }

TEST(Questions, MirroredPartsAreOneAndTheOrderIsByGain) {
  const Bound bound = bind(doll());
  ASSERT_EQ(bound.status, SINEW_OK);
  ASSERT_EQ(bound.questions.size(), 3u);
  for (size_t q = 0; q + 1 < bound.questions.size(); ++q)
    EXPECT_GE(bound.questions[q].gain, bound.questions[q + 1].gain);
  const uint32_t blocks = bound.vertex_questions[kRight];
  ASSERT_LT(blocks, 3u);
  const sinew_question& question = bound.questions[blocks];
  EXPECT_TRUE(question.vertex == kRight || question.vertex == kLeft) << question.vertex;
  EXPECT_EQ(question.part_count, 2u);
  EXPECT_EQ(question.vertex_count, 2 * kBlock);
  EXPECT_GT(question.doubt, 0u);
  EXPECT_EQ(question.joint, bound.joints[size_t{question.vertex} * 4]);
  ASSERT_GT(question.alternative_count, 1u);
  EXPECT_EQ(question.alternatives[0].kind, SINEW_ANSWER_RIGID);
  EXPECT_EQ(question.alternatives[0].joint, question.joint);
  for (uint32_t a = 0; a < question.alternative_count; ++a) {
    EXPECT_GT(question.alternatives[a].change, 0u);
    EXPECT_LE(question.alternatives[a].change, 131072u);
    EXPECT_NE(question.alternatives[a].kind, SINEW_ANSWER_SOFT) << "the method is heat: soft changes nothing";
  }
  for (uint32_t v = 0; v < kFirstOfBadge + kBadge; ++v) {
    EXPECT_EQ(bound.vertex_questions[v] == blocks, v >= kRight && v < kFirstOfBadge) << v;
    const uint32_t part = v < kRight ? 0 : v < kFirstOfBadge ? bound.vertex_parts[v] : 3;
    EXPECT_EQ(bound.vertex_parts[v], part) << v;
  }
  EXPECT_NE(bound.vertex_parts[kRight], bound.vertex_parts[kLeft]);
}

TEST(Questions, ChangeIsWhatTheAnswerChanges) {
  const MeshScene scene = doll();
  const Bound before = bind(scene);
  for (const sinew_question& question : before.questions) {
    for (uint32_t a = 0; a < question.alternative_count; ++a) {
      const sinew_alternative& alternative = question.alternatives[a];
      const Bound after = bind(scene, {{question.vertex, alternative.kind, alternative.joint, 0}});
      double change = 0;
      uint32_t vertices = 0;
      for (uint32_t v = 0; v < before.vertex_parts.size(); ++v) {
        if (&before.questions[before.vertex_questions[v]] != &question) continue;
        ++vertices;
        for (uint16_t j = 0; j <= kLeftHand; ++j)
          change += std::abs(static_cast<double>(before.weight(v, j)) - static_cast<double>(after.weight(v, j)));
      }
      ASSERT_EQ(vertices, question.vertex_count);
      EXPECT_NEAR(change / vertices / 65535, alternative.change / 65536.0, 0.03)
          << "part " << question.vertex << " kind " << alternative.kind << " joint " << alternative.joint;
    }
  }
}

TEST(Questions, AsManyAsWereAskedForAndNoneAboutWhatWasAnswered) {
  const MeshScene scene = doll();
  EXPECT_EQ(bind(scene, {}, 1).questions.size(), 1u);
  const Bound answered = bind(scene, {rigid(kRight, kRightHand), say(0, SINEW_ANSWER_PROPOSED)});
  ASSERT_EQ(answered.status, SINEW_OK);
  ASSERT_EQ(answered.questions.size(), 1u);
  EXPECT_EQ(answered.questions[0].vertex, kFirstOfBadge);
  EXPECT_EQ(answered.vertex_questions[kRight], SINEW_NO_QUESTION);
  EXPECT_EQ(answered.vertex_questions[0], SINEW_NO_QUESTION);
}

TEST(Answers, RigidGivesPartsAlikeTheirOwnJoint) {
  const MeshScene scene = doll();
  const Bound plain = bind(scene);
  const Bound both = bind(scene, {rigid(kRight + 5, kRightHand)});
  both.expect_rigid(kRight, kBlock, kRightHand);
  both.expect_rigid(kLeft, kBlock, kLeftHand);
  both.expect_as(plain, 0, kColumn);
  both.expect_as(plain, kFirstOfBadge, kBadge);
  const Bound same = bind(scene, {rigid(kRight, kTop)});  // as far from both
  same.expect_rigid(kRight, 2 * kBlock, kTop);
  const Bound alone = bind(scene, {rigid(kRight, kRightHand, 1)});
  alone.expect_rigid(kRight, kBlock, kRightHand);
  alone.expect_as(plain, kLeft, kBlock);
  ASSERT_EQ(alone.questions.size(), 3u);
  EXPECT_EQ(alone.questions[alone.vertex_questions[kLeft]].part_count, 1u) << "the other block is still a question";
  const Bound later = bind(scene, {rigid(kRight, kTop), rigid(kLeft, kRoot, 1)});
  later.expect_rigid(kRight, kBlock, kTop);
  later.expect_rigid(kLeft, kBlock, kRoot);
}

TEST(Answers, HardSofterAndHost) {
  const MeshScene scene = doll();
  const Bound plain = bind(scene);
  const Bound hard = bind(scene, {say(0, SINEW_ANSWER_HARD)});
  for (uint32_t v = 0; v < kColumn; ++v) EXPECT_EQ(hard.weight(v, plain.joints[size_t{v} * 4]), 65535u) << v;
  const Bound softer = bind(scene, {say(0, SINEW_ANSWER_SOFTER)});
  uint32_t blended = 0;
  for (uint32_t v = 0; v < kColumn; ++v) {
    const uint32_t was = plain.weights[size_t{v} * 4], is = softer.weights[size_t{v} * 4];
    EXPECT_LE(is, was) << v;
    blended += is < was ? 1 : 0;
  }
  EXPECT_GT(blended, 0u);
  const Bound host = bind(scene, {say(kFirstOfBadge, SINEW_ANSWER_HOST), rigid(0, kMiddle)});
  host.expect_rigid(kFirstOfBadge, kBadge, kMiddle);  // the answer about the host comes first
  const Bound on_column = bind(scene, {say(kFirstOfBadge, SINEW_ANSWER_HOST)});
  on_column.expect_row_of(kFirstOfBadge, plain, 6 * 4 + 3);  // (-0.5, 3, 0.5) is nearest to (-0.1, 3.1, 0.52)
  const Bound largest = bind(scene, {say(0, SINEW_ANSWER_HOST)});
  largest.expect_as(plain, 0, kColumn);
}

TEST(Answers, SoftIsTheHeatOfAModelsBind) {
  const MeshScene scene = doll();
  bind(scene, {say(0, SINEW_ANSWER_SOFT)}).expect_as(bind(scene), 0, kFirstOfBadge + kBadge);
}

TEST(Answers, LockedVerticesHaveTheLastWord) {
  MeshScene scene = doll();
  std::vector<uint8_t> locked(kFirstOfBadge + kBadge, 0);
  locked[kRight] = 1;
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.locked = locked.data();
  const sinew_mesh mesh = scene.mesh_view();
  const sinew_skeleton skeleton = scene.skeleton_view();
  const sinew_answer answer = rigid(kRight, kRightHand);
  options.method = SINEW_METHOD_HEAT;
  options.answers = &answer;
  options.answer_count = 1;
  sinew::Workspace workspace;
  sinew::Skin<uint16_t> skin{4, std::vector<uint16_t>(locked.size() * 4, 0),
                             std::vector<uint16_t>(locked.size() * 4, 0), 0};
  skin.joint_indices[size_t{kRight} * 4] = kRoot;
  skin.weights[size_t{kRight} * 4] = 65535;
  ASSERT_EQ(sinew::bind(nullptr, mesh, skeleton, options, &workspace, &skin), SINEW_OK);
  EXPECT_EQ(skin.joint_indices[size_t{kRight} * 4], kRoot);
  EXPECT_EQ(skin.joint_indices[size_t{kRight} * 4 + 4], kRightHand);
}

TEST(Answers, WhatIsWrongIsAStatusAndTouchesNothing) {
  MeshScene scene = doll();
  const uint32_t vertices = kFirstOfBadge + kBadge;
  const auto refused = [&](const sinew_answer& answer, sinew_status status) {
    const Bound bound = bind(scene, {answer});
    EXPECT_EQ(bound.status, status);
    EXPECT_EQ(bound.joints, std::vector<uint16_t>(size_t{vertices} * 4, 9));
    EXPECT_EQ(bound.vertex_parts, std::vector<uint32_t>(vertices, 9));
  };
  refused({0, 6, 0, 0}, SINEW_ERROR_ARGUMENT);
  refused({0, SINEW_ANSWER_HARD, 0, 2}, SINEW_ERROR_ARGUMENT);
  refused({vertices, SINEW_ANSWER_HARD, 0, 0}, SINEW_ERROR_RANGE);
  refused(rigid(0, kLeftHand + 1), SINEW_ERROR_RANGE);
  scene.flags.assign(kLeftHand + 1, 0);
  scene.flags[kTop] = SINEW_JOINT_NEVER;
  refused(rigid(0, kTop), SINEW_ERROR_RANGE);
  scene.flags.assign(kLeftHand + 1, SINEW_JOINT_DEFORMS);
  scene.flags[kTop] = 0;
  refused(rigid(0, kTop), SINEW_ERROR_RANGE);
  EXPECT_EQ(bind(scene, {rigid(0, kMiddle)}).status, SINEW_OK);

  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.method = SINEW_METHOD_HEAT;
  size_t bytes = 0;
  options.question_count = SINEW_MAX_QUESTIONS + 1;
  EXPECT_EQ(sinew_bind_workspace_size(nullptr, 4, 1, 4, 1, &options, &bytes), SINEW_ERROR_ARGUMENT);
  options.question_count = 0;
  options.answer_count = 1;  // without answers
  EXPECT_EQ(sinew_bind_workspace_size(nullptr, 4, 1, 4, 1, &options, &bytes), SINEW_ERROR_ARGUMENT);
}

TEST(Answers, NoneChangesNothingAndAsksOfNobody) {
  const MeshScene scene = doll();
  const Bound plain = bind(scene, {}, 0), asked = bind(scene);
  EXPECT_EQ(plain.joints, asked.joints);
  EXPECT_EQ(plain.weights, asked.weights);
  EXPECT_EQ(plain.vertex_parts[0], 9u) << "only with questions or answers";
}

}  // namespace
